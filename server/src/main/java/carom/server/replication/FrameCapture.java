package carom.server.replication;

import carom.net.codec.Quantizer;
import carom.net.field.FieldTables;
import carom.net.protocol.ProtocolLimits;
import carom.net.snapshot.Deltas;
import carom.net.snapshot.frame.EventRecord;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.Ownership;
import carom.net.snapshot.table.Tables;
import carom.physics.World;
import carom.physics.math.Trig;
import carom.sim.Game;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.JointTable;
import carom.sim.event.Audience;
import carom.sim.outbox.Event;
import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Quantises the whole world once per tick into the ring of frame states that all sessions share.
 *
 * <p>The room's thread; no allocation but for frames that grow with the highest entity id.
 */
public final class FrameCapture {
  private static final int TEAM_SHIFT = 3;

  private static final int NOBODY = -1;

  /**
   * Least number of bodies quantised at a time, if there are so many; the most is nearly twice
   * that.
   */
  private static final int BLOCK = Quantizer.LONG;

  private static final Audience[] AUDIENCES = Audience.values();

  private final SimulationHost simulation;
  private final FrameRing ring;
  private final ThinEvents thinEvents;
  private final Deltas deltas;
  private final InterestIndex index;
  private final FieldCapture fields;
  private final JointCapture joints;
  private final PoolCapture pools;
  private final Tables tables;
  private final EventRecord record = new EventRecord();
  private final Consumer<Event> takeEvent = this::take;

  /** Motion of a block of bodies, column by column: small enough to stay in near caches. */
  private final float[][] numbers = new float[World.MOTION][2 * BLOCK];

  /** The block of {@link #numbers} quantised: x, y, angle, and whether it stands still. */
  private final int[][] steps = new int[4][2 * BLOCK];

  /** The ids of all entities, as of {@link #roster}. */
  private int[] ids = {};

  /** The id of each body's entity, or {@link #NOBODY}; by body. */
  private int[] slots = {};

  private int bodyCount;

  private int entityCount;
  private long roster = -1;
  private boolean teamSecrets;

  /** Creates an empty ring for a simulation's entities, which starts from the level's bodies. */
  public FrameCapture(SimulationHost simulation) {
    this.simulation = simulation;
    this.ring = new FrameRing(ProtocolLimits.MAX_ENTITIES);
    this.thinEvents = new ThinEvents(ring.events());
    this.index = new InterestIndex(simulation);
    ring.gravity(simulation.level().gravityX(), simulation.level().gravityY());
    ring.level(
        FrameState.of(
            ProtocolLimits.MAX_ENTITIES, frame -> simulation.level().forEachBody(frame::put)));
    deltas = new Deltas(ring, simulation.tickRate());
    fields = new FieldCapture(simulation);
    joints = new JointCapture(simulation);
    tables = fields.with(joints.table());
    pools = new PoolCapture(simulation, tables.get(FieldTables.POOLS));
  }

  /** Returns the deltas that the room's sessions share. */
  public Deltas deltas() {
    return deltas;
  }

  /**
   * Sets whether players are told only of what they show, because the room is too busy for more. A
   * player that {@linkplain carom.sim.Game#seesAll sees all} is sent all.
   */
  public void narrowViews(boolean narrow) {
    index.narrowViews(narrow);
  }

  /** Returns whether any entity or event so far was one that a team alone may know of. */
  public boolean hasTeamSecrets() {
    return teamSecrets;
  }

  /** Captures the state after the simulation's last step. */
  public FrameState capture() {
    FrameState last = ring.newest();
    FrameState frame = ring.begin(simulation.tick());
    if (last != null && roster == simulation.rosterVersion()) {
      frame.identifyAs(last);
    } else {
      identify(frame);
    }
    putAudiences(frame);
    putPoses(frame);
    for (int id = 0, count = simulation.playerCapacity(); id < count; id++) {
      HostPlayer player = simulation.player(id);
      if (player != null) {
        frame.putInput(id, player.input().pack());
      }
    }
    ring.end();
    fields.capture();
    joints.capture();
    pools.capture();
    simulation.outbox().drainEvents(takeEvent);
    return frame;
  }

  /**
   * Puts all entities into a frame, and keeps the list for later frames until one comes or goes.
   */
  private void identify(FrameState frame) {
    roster = simulation.rosterVersion();
    entityCount = 0;
    int capacity = simulation.entityCapacity();
    if (ids.length < capacity) {
      ids = new int[2 * capacity];
    }
    bodyCount = simulation.world().slotCount();
    if (slots.length < bodyCount) {
      slots = new int[2 * bodyCount];
    }
    Arrays.fill(slots, 0, bodyCount, NOBODY);
    for (int id = 0; id < capacity; id++) {
      HostEntity entity = simulation.entity(id);
      if (entity != null) {
        ids[entityCount++] = id;
        slots[entity.bodySlot()] = id;
        frame.identify(id, entity.generation(), entity.archetype().index(), ownership(entity));
        frame.setTeleports(id, entity.teleports());
      }
    }
  }

  /** Returns whose an entity is, as frames have it. */
  private int ownership(HostEntity entity) {
    HostPlayer owner = entity.owner();
    if (owner == null) {
      return entity.ownerId();
    }
    return owner.entity() == entity ? owner.id() : owner.id() | Ownership.NOT_BODY;
  }

  private void putAudiences(FrameState frame) {
    Game game = simulation.game();
    for (int i = 0; i < entityCount; i++) {
      HostEntity entity = simulation.entity(ids[i]);
      Audience audience = game.audience(simulation, entity.root());
      if (audience != Audience.NEAR) {
        HostPlayer owner = entity.owner();
        int team = audience == Audience.TEAM && owner != null ? owner.team() : 0;
        teamSecrets |= audience == Audience.TEAM;
        frame.setAudience(ids[i], recipients(audience, team));
      }
    }
  }

  /** Quantises column by column, in loops that compilers turn into vector instructions. */
  private void putPoses(FrameState frame) {
    World<HostEntity> world = simulation.world();
    int blocks = Math.max(1, bodyCount / BLOCK);
    for (int block = 0, from = 0; block < blocks; block++) {
      int count = (bodyCount - from) / (blocks - block);
      world.readMotions(from, count, numbers);
      Quantizer.positions(numbers[0], count, steps[0]);
      Quantizer.positions(numbers[1], count, steps[1]);
      turn(numbers[2], numbers[3], count, steps[2]);
      Quantizer.stills(numbers[4], numbers[5], numbers[6], count, steps[3]);
      frame.putPoses(count, slots, from, steps);
      from += count;
    }
  }

  /** Quantises angles. All digits are computed only where an estimate might round either way. */
  private static void turn(float[] cos, float[] sin, int n, int[] to) {
    int done = Quantizer.anglesOfTurns(cos, sin, n, Trig.ROUGH, to);
    for (int i = done; i < n; i++) {
      to[i] = Quantizer.angleOfTurn(Trig.roughTurn(sin[i], cos[i]), Trig.ROUGH);
    }
    for (int i = 0; i < n; i++) {
      if (to[i] < 0) {
        to[i] = Quantizer.angle(Trig.atan2(sin[i], cos[i]));
      }
    }
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
    HostPlayer by = simulation.player(e.player());
    int team = e.audience() == Audience.TEAM && by != null ? by.team() : 0;
    teamSecrets |= e.audience() == Audience.TEAM;
    ring.events().add(record, recipients(e.audience(), team));
  }

  /** Returns the joints of the simulation, by index. */
  JointTable<HostEntity> joints() {
    return simulation.joints();
  }

  /** Returns the room's tables: what clients are told apart from how entities move. */
  public Tables tables() {
    return tables;
  }

  /** Returns the captured frames. */
  public FrameRing frames() {
    return ring;
  }

  /** Returns the captured events, for thin clients. */
  ThinEvents thinEvents() {
    return thinEvents;
  }

  private static int recipients(Audience audience, int team) {
    return team << TEAM_SHIFT | audience.ordinal();
  }

  /** Returns who is told of a captured event or entity. */
  static Audience audienceOf(int recipients) {
    return AUDIENCES[recipients & ((1 << TEAM_SHIFT) - 1)];
  }

  /** Returns the team if the audience is {@link Audience#TEAM}. */
  static int teamOf(int recipients) {
    return recipients >> TEAM_SHIFT;
  }

  /** Returns who is told of an entity of a captured frame. */
  static Audience audience(FrameState frame, int slot) {
    return audienceOf(frame.audience(slot));
  }

  /** Returns the team if the audience of an entity is {@link Audience#TEAM}. */
  static int team(FrameState frame, int slot) {
    return teamOf(frame.audience(slot));
  }

  /** Returns what clients are told of pools. */
  PoolCapture pools() {
    return pools;
  }

  /** Returns the fields of the newest frame. */
  FieldCapture fields() {
    return fields;
  }

  /** Returns the index of where the entities of the newest frame are. */
  InterestIndex index() {
    return index;
  }
}
