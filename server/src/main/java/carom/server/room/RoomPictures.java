package carom.server.room;

import carom.physics.Body;
import carom.physics.Joint;
import carom.physics.World;
import carom.physics.particles.Particles;
import carom.server.match.MatchInfo;
import carom.server.session.PlayerInfo;
import carom.server.session.Session;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.pool.Pools;
import carom.sim.pool.ShownParticles;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The pictures of a room. Any thread {@linkplain #ask asks} for one, the room's thread makes it
 * after its next tick, and any thread {@linkplain #poll takes} it. Without a viewer, this costs a
 * room one read of a variable per turn and no allocation.
 */
public final class RoomPictures {
  private static final Logger LOG = LoggerFactory.getLogger(RoomPictures.class);
  private static final int MAX_CELLS = 20_000;
  private static final int MAX_CONTACTS = 20_000;

  private final Runnable asked;
  private final AtomicReference<Picture.Request> wanted = new AtomicReference<>();
  private final AtomicReference<Picture> made = new AtomicReference<>();
  private final AtomicLong count = new AtomicLong();

  // The room's thread only.
  private final Floats cells = new Floats(Picture.CELL * MAX_CELLS);
  private final Floats contacts = new Floats(Picture.CONTACT * MAX_CONTACTS);
  private World<HostEntity> world;
  private BodyLook[] looks = {};
  private int[] generations = {};
  private boolean broken;

  /**
   * Creates the pictures of a room without viewers.
   *
   * @param asked runs after each request, on the thread that asks
   */
  public RoomPictures(Runnable asked) {
    this.asked = asked;
  }

  /** Asks for a picture. It replaces a request that waits. Any thread. */
  public void ask(Picture.Request request) {
    wanted.set(request);
    asked.run();
  }

  /** Returns the picture that was made last, once, or null. Any thread. */
  public Picture poll() {
    return made.getAndSet(null);
  }

  /**
   * Returns the number of pictures that the room has made, at most one for each tick. Any thread.
   */
  public long count() {
    return count.getAcquire();
  }

  /** Returns whether a viewer waits for a picture. */
  public boolean isWanted() {
    return wanted.get() != null;
  }

  /**
   * Makes the picture that is wanted. An exception is logged once, and then there are no more
   * pictures: watching must not hurt a room. The room's thread, between two ticks.
   */
  public void take(MatchInfo match, SimulationHost simulation, Session[] bySeat) {
    Picture.Request request = wanted.getAndSet(null);
    if (request == null || broken) {
      return;
    }
    try {
      made.set(draw(request, match, simulation, bySeat));
      count.setRelease(count.getPlain() + 1);
    } catch (RuntimeException e) {
      broken = true;
      LOG.error("a picture of the room can't be made; nobody can watch it any longer", e);
    }
  }

  private Picture draw(
      Picture.Request request, MatchInfo match, SimulationHost simulation, Session[] bySeat) {
    if (world != simulation.world()) {
      world = simulation.world();
      Arrays.fill(looks, null);
    }
    int slots = world.slotCount();
    if (looks.length < slots) {
      looks = Arrays.copyOf(looks, slots);
      generations = Arrays.copyOf(generations, slots);
    }
    BodyLook[] bodies = new BodyLook[world.bodyCount()];
    float[] poses = new float[Picture.POSE * bodies.length];
    boolean[] awake = new boolean[bodies.length];
    int count = 0;
    for (int slot = 0; slot < slots && count < bodies.length; slot++) {
      Body<HostEntity> body = world.body(slot);
      if (body != null) {
        bodies[count] = look(body);
        poses[Picture.POSE * count] = body.x();
        poses[Picture.POSE * count + 1] = body.y();
        poses[Picture.POSE * count + 2] = body.angle();
        awake[count] = body.awake();
        count++;
      }
    }
    return new Picture(
        match,
        simulation.tick(),
        List.of(bodies),
        poses,
        awake,
        joints(),
        request.cells() ? cells() : new float[0],
        request.contacts() ? contacts() : new float[0],
        priorities(request, bodies, bySeat),
        particles(simulation.pools()),
        playerBodies(bySeat),
        request.players() ? players(bySeat) : null);
  }

  private BodyLook look(Body<HostEntity> body) {
    int slot = body.index();
    BodyLook look = looks[slot];
    if (look == null || generations[slot] != body.generation() || !look.isOf(body)) {
      look = BodyLook.of(body);
      looks[slot] = look;
      generations[slot] = body.generation();
    }
    return look;
  }

  private float[] joints() {
    float[] values = new float[Picture.JOINT * world.jointCount()];
    int at = 0;
    for (int i = 0; i < world.jointSlotCount() && at < values.length; i++) {
      Joint<HostEntity> joint = world.joint(i);
      if (joint != null) {
        values[at++] = joint.type().ordinal();
        values[at++] = joint.bodyA() == null ? -1 : joint.bodyA().index();
        values[at++] = joint.bodyB() == null ? -1 : joint.bodyB().index();
        values[at++] = joint.anchorAX();
        values[at++] = joint.anchorAY();
        values[at++] = joint.anchorBX();
        values[at++] = joint.anchorBY();
      }
    }
    return Arrays.copyOf(values, at);
  }

  private static List<Picture.Pool> particles(Pools pools) {
    List<Picture.Pool> all = new ArrayList<>(pools.shown().size());
    for (ShownParticles some : pools.shown()) {
      Particles particles = some.particles();
      if (particles.count() > 0) {
        float[] xy = new float[2 * particles.count()];
        particles.copyPositions(xy);
        all.add(new Picture.Pool(some.rgb(), particles.spacing(), xy));
      }
    }
    return List.copyOf(all);
  }

  private float[] cells() {
    cells.clear();
    world.forEachTreeCell(cells::add);
    return cells.toArray();
  }

  private float[] contacts() {
    contacts.clear();
    world.forEachContact(
        (x, y, normalX, normalY, separation, impulse) ->
            contacts.add(x, y, normalX, normalY, impulse));
    return contacts.toArray();
  }

  private static Map<Integer, float[]> priorities(
      Picture.Request request, BodyLook[] bodies, Session[] bySeat) {
    Map<Integer, float[]> all = new TreeMap<>();
    for (int player : request.priorityOf()) {
      if (player < 0
          || player >= bySeat.length
          || bySeat[player] == null
          || all.size() == Picture.Request.MAX_PRIORITIES) {
        continue;
      }
      float[] values = new float[bodies.length];
      for (int i = 0; i < bodies.length; i++) {
        int entity = bodies[i].entity();
        values[i] = entity < 0 ? 0 : bySeat[player].replication().collectedPriority(entity);
      }
      all.put(player, values);
    }
    return all;
  }

  private static int[] playerBodies(Session[] bySeat) {
    int[] pairs = new int[2 * bySeat.length];
    int at = 0;
    for (Session session : bySeat) {
      if (session != null && session.player().entity() != null) {
        pairs[at++] = session.player().id();
        pairs[at++] = session.player().entity().body().index();
      }
    }
    return Arrays.copyOf(pairs, at);
  }

  private static List<Picture.Player> players(Session[] bySeat) {
    List<Picture.Player> players = new ArrayList<>();
    for (Session session : bySeat) {
      if (session != null) {
        players.add(new Picture.Player(PlayerInfo.of(session), session.inputs().missing()));
      }
    }
    return players;
  }
}
