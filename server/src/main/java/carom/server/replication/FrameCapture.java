package carom.server.replication;

import carom.net.codec.Quantizer;
import carom.net.protocol.Limits;
import carom.net.snapshot.EventRecord;
import carom.net.snapshot.FrameRing;
import carom.net.snapshot.FrameState;
import carom.physics.World;
import carom.physics.math.Trig;
import carom.sim.Audience;
import carom.sim.Entity;
import carom.sim.Event;
import carom.sim.Player;
import carom.sim.Simulation;
import java.util.function.Consumer;

/**
 * Quantises the whole world once per tick into the ring of frame states that all sessions share.
 *
 * <p>The room's thread; no allocation but for frames that grow with the highest entity id.
 */
public final class FrameCapture {
  private static final int TEAM_SHIFT = 3;
  private static final Audience[] AUDIENCES = Audience.values();

  private final Simulation simulation;
  private final FrameRing ring;
  private final InterestIndex index;
  private final EventRecord record = new EventRecord();
  private final Consumer<Event> takeEvent = this::take;
  private float[] motions = {};

  /** Creates an empty ring for a simulation's entities, which starts from the level's bodies. */
  public FrameCapture(Simulation simulation) {
    this.simulation = simulation;
    this.ring = new FrameRing(Limits.MAX_ENTITIES);
    this.index = new InterestIndex(simulation);
    ring.gravity(simulation.level().gravityX(), simulation.level().gravityY());
    ring.level(
        FrameState.of(Limits.MAX_ENTITIES, frame -> simulation.level().forEachBody(frame::put)));
  }

  /** Captures the state after the simulation's last step. */
  public FrameState capture() {
    FrameState frame = ring.begin(simulation.tick());
    float[] motion = readMotions();
    for (int id = 0, count = simulation.entityCapacity(); id < count; id++) {
      Entity entity = simulation.entity(id);
      if (entity == null) {
        continue;
      }
      int at = entity.body().index() * World.MOTION;
      frame.putTurned(
          id,
          entity.generation(),
          entity.archetype().index(),
          entity.ownerId(),
          motion[at],
          motion[at + 1],
          angle(motion[at + 2], motion[at + 3]),
          motion[at + 4],
          motion[at + 5],
          motion[at + 6]);
      frame.setTeleports(id, entity.teleports());
      Audience audience = simulation.game().audience(simulation, entity);
      if (audience != Audience.NEAR) {
        Player owner = simulation.owner(entity);
        int team = audience == Audience.TEAM && owner != null ? owner.team() : 0;
        frame.setAudience(id, whom(audience, team));
      }
    }
    for (int id = 0, count = simulation.playerCapacity(); id < count; id++) {
      Player player = simulation.player(id);
      if (player != null) {
        frame.putInput(id, player.input().pack());
      }
    }
    ring.end();
    simulation.drainEvents(takeEvent);
    return frame;
  }

  private void take(Event e) {
    record.kind = e.kind().index();
    record.tick = simulation.tick();
    record.player = e.player();
    record.first = e.first();
    record.second = e.second();
    record.place(e.x(), e.y());
    record.strength(e.strength());
    record.data = e.data();
    Player by = simulation.player(e.player());
    int team = e.audience() == Audience.TEAM && by != null ? by.team() : 0;
    ring.events().add(record, whom(e.audience(), team));
  }

  private float[] readMotions() {
    World<Entity> world = simulation.world();
    if (motions.length < world.slotCount() * World.MOTION) {
      motions = new float[2 * world.slotCount() * World.MOTION];
    }
    world.readMotions(motions);
    return motions;
  }

  /** The angle in steps; all digits are computed only where it might round either way. */
  private static int angle(float cos, float sin) {
    int steps = Quantizer.angleOfTurn(Trig.roughTurn(sin, cos), Trig.ROUGH);
    return steps >= 0 ? steps : Quantizer.angle(Trig.atan2(sin, cos));
  }

  /** The captured frames. */
  public FrameRing frames() {
    return ring;
  }

  private static int whom(Audience audience, int team) {
    return team << TEAM_SHIFT | audience.ordinal();
  }

  /** Who is told, of a captured event or entity. */
  static Audience audienceOf(int whom) {
    return AUDIENCES[whom & ((1 << TEAM_SHIFT) - 1)];
  }

  /** The team of {@link Audience#TEAM}. */
  static int teamOf(int whom) {
    return whom >> TEAM_SHIFT;
  }

  /** Who is told about an entity of a captured frame. */
  static Audience audience(FrameState frame, int slot) {
    return audienceOf(frame.audience(slot));
  }

  /** The team of {@link Audience#TEAM}. */
  static int team(FrameState frame, int slot) {
    return teamOf(frame.audience(slot));
  }

  /** Where the entities of the newest frame are. */
  InterestIndex index() {
    return index;
  }
}
