package carom.sim;

import carom.physics.Body;
import carom.physics.Poses;
import carom.physics.archive.Archive;
import carom.physics.geometry.Shape;
import carom.physics.math.Transform;
import carom.sim.level.Archetype;
import java.util.Arrays;
import java.util.List;

/**
 * Where every entity's body was in the last quarter of a second, to answer what a player saw: poses
 * by tick and body slot, and how far bodies have moved at most since each of these ticks. Part of
 * the simulation's state, though not of its hash, which follows from the states before.
 *
 * <p>A tick costs one pass over the entities; memory 16 bytes per body slot and tick.
 */
final class PoseHistory implements Poses {
  /** How far back one can look, seconds. */
  static final float SECONDS = 0.25f;

  /** Farther in one tick than this, metres, and a body has not moved but been put elsewhere. */
  private static final float JUMP = 3;

  private static final int FLOATS = 4;
  private static final int NEVER = Integer.MAX_VALUE;
  private static final int MOST_BODIES = 1 << 22;

  private final Simulation simulation;
  private final int size;
  private final int[] tickAt;
  private final float[][] poses;
  private final float[] moved; // at most, by any point of any body, in the step to that tick
  private int[] bornAt = {}; // by body slot: the first tick with a pose
  private float[] reachOf = {}; // by archetype
  private int newest = -1; // tick
  private float sinceNewest; // moved at most since then
  private long moves; // of the world, when that was known

  // The question's time.
  private int low;
  private float share; // of the tick after low
  private float reach;

  PoseHistory(Simulation simulation) {
    this.simulation = simulation;
    size = (int) Math.ceil(SECONDS * simulation.tickRate()) + 2;
    tickAt = new int[size];
    Arrays.fill(tickAt, -1);
    poses = new float[size][0];
    moved = new float[size];
  }

  /** Remembers the state after a step, or at tick 0. */
  void capture() {
    int tick = simulation.tick();
    int slot = tick % size;
    int before = newest >= 0 && newest == tick - 1 ? newest % size : -1;
    int slots = simulation.world().slotCount();
    if (poses[slot].length < slots * FLOATS) {
      poses[slot] = new float[Math.max(64, slots * 2) * FLOATS];
    }
    if (bornAt.length < slots) {
      int old = bornAt.length;
      bornAt = Arrays.copyOf(bornAt, Math.max(64, slots * 2));
      Arrays.fill(bornAt, old, bornAt.length, NEVER);
    }
    moved[slot] = before < 0 ? 0 : farthest(poses[before], tick);
    float[] now = poses[slot];
    for (int id = 0, limit = simulation.entityCapacity(); id < limit; id++) {
      Entity e = simulation.entity(id);
      if (e != null) {
        Body<Entity> body = e.body();
        int at = body.index() * FLOATS;
        now[at] = body.x();
        now[at + 1] = body.y();
        now[at + 2] = body.cos();
        now[at + 3] = body.sin();
        bornAt[body.index()] = Math.min(bornAt[body.index()], tick);
      }
    }
    tickAt[slot] = tick;
    newest = tick;
    sinceNewest = 0;
    moves = simulation.world().moves();
  }

  /**
   * How far any point of any body has come at most from where it was to where it is now.
   *
   * @param then where bodies were that were there before the tick
   */
  private float farthest(float[] then, int tick) {
    float farthest = 0;
    for (int id = 0, limit = simulation.entityCapacity(); id < limit; id++) {
      Entity e = simulation.entity(id);
      if (e != null && e.body().index() < bornAt.length && bornAt[e.body().index()] < tick) {
        Body<Entity> body = e.body();
        int at = body.index() * FLOATS;
        float way = Math.abs(body.x() - then[at]) + Math.abs(body.y() - then[at + 1]);
        float turn = Math.abs(body.cos() - then[at + 2]) + Math.abs(body.sin() - then[at + 3]);
        farthest = Math.max(farthest, way + turn * reachOf(e.archetype()));
      }
    }
    return farthest;
  }

  /** A body has come or gone: what was in its slot before is somebody else's. */
  void forget(int body) {
    if (body < bornAt.length) {
      bornAt[body] = NEVER;
    }
  }

  private float reachOf(Archetype archetype) {
    int index = archetype.index();
    if (index >= reachOf.length) {
      int old = reachOf.length;
      reachOf = Arrays.copyOf(reachOf, Math.max(16, index * 2));
      Arrays.fill(reachOf, old, reachOf.length, -1);
    }
    if (reachOf[index] < 0) {
      List<Shape> shapes = archetype.shapes();
      float farthest = 0;
      for (int i = 0; i < shapes.size(); i++) {
        farthest = Math.max(farthest, shapes.get(i).reach());
      }
      reachOf[index] = farthest;
    }
    return reachOf[index];
  }

  /**
   * Sets the time of the questions that follow.
   *
   * @param viewDelay in 1/16 tick before the simulation's tick; later than the newest state means
   *     the newest, before the oldest kept or {@link #SECONDS} ago means that
   */
  void look(int viewDelay) {
    int longest = (int) (SECONDS * simulation.tickRate() * Player.VIEW_STEPS);
    int now = simulation.tick() * Player.VIEW_STEPS;
    int time = Math.min(newest * Player.VIEW_STEPS, now - Math.min(viewDelay, longest));
    low = Math.floorDiv(time, Player.VIEW_STEPS);
    share = (time - low * Player.VIEW_STEPS) / (float) Player.VIEW_STEPS;
    int oldest = newest;
    reach = sinceNewest();
    while (oldest > low && oldest > 0 && tickAt[(oldest - 1) % size] == oldest - 1) {
      reach += moved[oldest % size];
      oldest--;
    }
    if (low < oldest) {
      low = oldest;
      share = 0;
    }
  }

  /** The step may be over, and games put bodies elsewhere: looked for only when something moved. */
  private float sinceNewest() {
    long present = simulation.world().moves();
    if (present != moves) {
      moves = present;
      sinceNewest = farthest(poses[newest % size], Integer.MAX_VALUE);
    }
    return sinceNewest;
  }

  @Override
  public float reach() {
    return reach;
  }

  @Override
  public boolean place(int index, Transform out) {
    Body<Entity> body = simulation.world().body(index);
    if (body.user() == null || body.user().isLevel()) {
      out.set(body.x(), body.y(), body.cos(), body.sin());
      return true;
    }
    if (index >= bornAt.length || bornAt[index] > low) {
      return false; // nobody had seen it then
    }
    float[] a = poses[low % size];
    int at = index * FLOATS;
    if (share == 0) {
      out.set(a[at], a[at + 1], a[at + 2], a[at + 3]);
      return true;
    }
    float[] b = poses[(low + 1) % size];
    float dx = b[at] - a[at];
    float dy = b[at + 1] - a[at + 1];
    if (dx * dx + dy * dy > JUMP * JUMP) {
      out.set(a[at], a[at + 1], a[at + 2], a[at + 3]);
      return true;
    }
    float cos = a[at + 2] + share * (b[at + 2] - a[at + 2]);
    float sin = a[at + 3] + share * (b[at + 3] - a[at + 3]);
    float length = (float) Math.sqrt(cos * cos + sin * sin);
    if (length < 0.1f) { // half a turn in a tick
      out.set(a[at] + share * dx, a[at + 1] + share * dy, a[at + 2], a[at + 3]);
    } else {
      out.set(a[at] + share * dx, a[at + 1] + share * dy, cos / length, sin / length);
    }
    return true;
  }

  /** Overwrites another history of the same simulation. */
  void copyTo(PoseHistory to) {
    System.arraycopy(tickAt, 0, to.tickAt, 0, size);
    System.arraycopy(moved, 0, to.moved, 0, size);
    for (int i = 0; i < size; i++) {
      if (to.poses[i].length < poses[i].length) {
        to.poses[i] = new float[poses[i].length];
      }
      System.arraycopy(poses[i], 0, to.poses[i], 0, poses[i].length);
    }
    if (to.bornAt.length < bornAt.length) {
      to.bornAt = new int[bornAt.length];
    }
    System.arraycopy(bornAt, 0, to.bornAt, 0, bornAt.length);
    Arrays.fill(to.bornAt, bornAt.length, to.bornAt.length, NEVER);
    to.newest = newest;
    to.moves = -1;
  }

  /** Passes the history through an archive; poses as what differs from the newest ones' bits. */
  void pass(Archive a, int tick) {
    int slots = bornAt.length;
    while (slots > 0 && bornAt[slots - 1] == NEVER) {
      slots--;
    }
    slots = a.count("remembered bodies", slots, MOST_BODIES, Integer.BYTES);
    if (a.reads()) {
      bornAt = new int[slots];
    }
    a.integers("first tick of body", bornAt, slots, 0, NEVER);
    a.integers("remembered tick", tickAt, size, -1, tick);
    a.numbers("way in a tick", moved, size, Float.MAX_VALUE);
    newest = a.integer("newest remembered tick", newest, 0, tick);
    int[] differences = new int[slots * FLOATS];
    float[] last = poses[newest % size];
    for (int back = 0; back < size; back++) {
      int at = Math.floorMod(newest - back, size);
      int held = Math.min(poses[at].length, differences.length);
      int n = a.count("remembered poses", held, differences.length, Integer.BYTES);
      boolean own = at != newest % size;
      for (int i = 0; !a.reads() && i < n; i++) {
        int before = own && i < last.length ? Float.floatToRawIntBits(last[i]) : 0;
        differences[i] = Float.floatToRawIntBits(poses[at][i]) ^ before;
      }
      a.integers("remembered pose", differences, n, Integer.MIN_VALUE, Integer.MAX_VALUE);
      if (a.reads()) {
        poses[at] = new float[slots * FLOATS];
        last = poses[newest % size];
        for (int i = 0; i < n; i++) {
          int before = own ? Float.floatToRawIntBits(last[i]) : 0;
          poses[at][i] = Float.intBitsToFloat(differences[i] ^ before);
          a.require(Math.abs(poses[at][i]) < 1e30f, "remembered pose=" + poses[at][i]);
        }
      }
    }
    moves = -1;
  }
}
