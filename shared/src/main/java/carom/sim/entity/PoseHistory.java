package carom.sim.entity;

import carom.physics.Body;
import carom.physics.Poses;
import carom.physics.World;
import carom.physics.archive.Archive;
import carom.physics.geometry.Shape;
import carom.physics.math.Transform;
import carom.sim.level.Archetype;
import java.util.Arrays;
import java.util.List;

/**
 * Remembers where tracked bodies were in the last quarter of a second, to answer what a player saw.
 * It holds the poses by tick and body slot, and an upper bound of how far any body has moved since
 * each tick. It is part of a simulation's state, but not of its hash, because it follows from the
 * states before.
 *
 * <p>One thread. {@link #capture} makes one pass over the bodies. The memory is 16 bytes per body
 * slot and tick.
 *
 * @param <T> the world's user type
 */
public final class PoseHistory<T> implements Poses {
  /** Number of equal parts into which {@link #look} divides a tick. */
  public static final int STEPS_PER_TICK = 16;

  /** Length of the history, in seconds. */
  private static final float SECONDS = 0.25f;

  /** Longest way of a body in one tick, in metres. A longer one is taken for a teleport. */
  private static final float MAX_MOVE = 3;

  private static final int FLOATS = 4;
  private static final int NEVER = Integer.MAX_VALUE;
  private static final int MAX_BODIES = 1 << 22;

  private final World<T> world;
  private final TrackedBodies<T> bodies;
  private final int tickRate;
  private final int size;
  private final int[] tickAt;
  private final float[][] poses;

  /** Upper bound of the way of any point of any body in the step to the tick. */
  private final float[] moved;

  /** First tick with a pose, by body slot. */
  private int[] bornAt = {};

  /** Reach of an archetype's shapes, by archetype index; -1 until it is asked for. */
  private float[] reachOf = {};

  private int newest = -1;

  /** Upper bound of the way of any point of any body since the newest tick. */
  private float sinceNewest;

  /** Value of {@link World#moves} when {@link #sinceNewest} was computed. */
  private long moves;

  // The time of the questions: a tick, and the fraction of the way to the tick after it.
  private int low;
  private float fraction;
  private float reach;

  /**
   * Creates an empty history.
   *
   * @param world the world of the bodies
   * @param bodies says which bodies are remembered
   * @param tickRate ticks per second
   */
  public PoseHistory(World<T> world, TrackedBodies<T> bodies, int tickRate) {
    this.world = world;
    this.bodies = bodies;
    this.tickRate = tickRate;
    size = (int) Math.ceil(SECONDS * tickRate) + 2;
    tickAt = new int[size];
    Arrays.fill(tickAt, -1);
    poses = new float[size][0];
    moved = new float[size];
  }

  /** Remembers the present poses as those of a tick. Call it after each step, and at tick 0. */
  public void capture(int tick) {
    int slot = tick % size;
    int before = newest >= 0 && newest == tick - 1 ? newest % size : -1;
    int slots = world.slotCount();
    if (poses[slot].length < slots * FLOATS) {
      poses[slot] = new float[Math.max(64, slots * 2) * FLOATS];
    }
    if (bornAt.length < slots) {
      int old = bornAt.length;
      bornAt = Arrays.copyOf(bornAt, Math.max(64, slots * 2));
      Arrays.fill(bornAt, old, bornAt.length, NEVER);
    }
    moved[slot] = before < 0 ? 0 : longestWay(poses[before], tick);
    float[] now = poses[slot];
    for (int id = 0, limit = bodies.limit(); id < limit; id++) {
      Body<T> body = bodies.body(id);
      if (body != null) {
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
    moves = world.moves();
  }

  /**
   * Returns an upper bound of the way of any point of any body from an earlier pose to the present.
   *
   * @param then the earlier poses
   * @param tick bodies that are younger than this tick don't count
   */
  private float longestWay(float[] then, int tick) {
    float longest = 0;
    for (int id = 0, limit = bodies.limit(); id < limit; id++) {
      Body<T> body = bodies.body(id);
      if (body != null && body.index() < bornAt.length && bornAt[body.index()] < tick) {
        int at = body.index() * FLOATS;
        float way = Math.abs(body.x() - then[at]) + Math.abs(body.y() - then[at + 1]);
        float turn = Math.abs(body.cos() - then[at + 2]) + Math.abs(body.sin() - then[at + 3]);
        longest = Math.max(longest, way + turn * reachOf(bodies.archetype(id)));
      }
    }
    return longest;
  }

  /** Forgets the past of a body slot, because its body is about to be destroyed. */
  public void forget(int slot) {
    if (slot < bornAt.length) {
      bornAt[slot] = NEVER;
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
   * Sets the time of the questions that follow. A time after the newest remembered tick counts as
   * that tick. A time before the oldest one, or more than a quarter of a second ago, counts as the
   * earliest time allowed.
   *
   * @param tick the present tick
   * @param viewDelay how long before it, in 1/{@value #STEPS_PER_TICK} ticks
   */
  public void look(int tick, int viewDelay) {
    int longest = (int) (SECONDS * tickRate * STEPS_PER_TICK);
    int now = tick * STEPS_PER_TICK;
    int time = Math.min(newest * STEPS_PER_TICK, now - Math.min(viewDelay, longest));
    low = Math.floorDiv(time, STEPS_PER_TICK);
    fraction = (time - low * STEPS_PER_TICK) / (float) STEPS_PER_TICK;
    int oldest = newest;
    reach = sinceNewest();
    while (oldest > low && oldest > 0 && tickAt[(oldest - 1) % size] == oldest - 1) {
      reach += moved[oldest % size];
      oldest--;
    }
    if (low < oldest) {
      low = oldest;
      fraction = 0;
    }
  }

  /** Updates the bound only if a body has moved, as a game may move one after the step. */
  private float sinceNewest() {
    long present = world.moves();
    if (present != moves) {
      moves = present;
      sinceNewest = longestWay(poses[newest % size], Integer.MAX_VALUE);
    }
    return sinceNewest;
  }

  @Override
  public float reach() {
    return reach;
  }

  @Override
  public boolean place(int index, Transform out) {
    Body<T> body = world.body(index);
    if (!bodies.isTracked(body)) {
      out.set(body.x(), body.y(), body.cos(), body.sin());
      return true;
    }
    if (index >= bornAt.length || bornAt[index] > low) {
      return false; // it did not exist then
    }
    float[] a = poses[low % size];
    int at = index * FLOATS;
    if (fraction == 0) {
      out.set(a[at], a[at + 1], a[at + 2], a[at + 3]);
      return true;
    }
    float[] b = poses[(low + 1) % size];
    float dx = b[at] - a[at];
    float dy = b[at + 1] - a[at + 1];
    if (dx * dx + dy * dy > MAX_MOVE * MAX_MOVE) {
      out.set(a[at], a[at + 1], a[at + 2], a[at + 3]);
      return true;
    }
    float cos = a[at + 2] + fraction * (b[at + 2] - a[at + 2]);
    float sin = a[at + 3] + fraction * (b[at + 3] - a[at + 3]);
    float length = (float) Math.sqrt(cos * cos + sin * sin);
    if (length < 0.1f) { // half a turn in one tick: no direction in between
      out.set(a[at] + fraction * dx, a[at + 1] + fraction * dy, a[at + 2], a[at + 3]);
    } else {
      out.set(a[at] + fraction * dx, a[at + 1] + fraction * dy, cos / length, sin / length);
    }
    return true;
  }

  /** Overwrites another history of the same world. */
  public void copyTo(PoseHistory<T> to) {
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

  /**
   * Passes the history through an archive. Poses before the newest tick are passed as the
   * difference of their bits from the newest ones.
   *
   * @param tick the tick of the state that is passed
   */
  public void pass(Archive a, int tick) {
    int slots = bornAt.length;
    while (slots > 0 && bornAt[slots - 1] == NEVER) {
      slots--;
    }
    slots = a.count("remembered bodies", slots, MAX_BODIES, Integer.BYTES);
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
      boolean older = at != newest % size;
      for (int i = 0; !a.reads() && i < n; i++) {
        int before = older && i < last.length ? Float.floatToRawIntBits(last[i]) : 0;
        differences[i] = Float.floatToRawIntBits(poses[at][i]) ^ before;
      }
      a.integers("remembered pose", differences, n, Integer.MIN_VALUE, Integer.MAX_VALUE);
      if (a.reads()) {
        poses[at] = new float[slots * FLOATS];
        last = poses[newest % size];
        for (int i = 0; i < n; i++) {
          int before = older ? Float.floatToRawIntBits(last[i]) : 0;
          poses[at][i] = Float.intBitsToFloat(differences[i] ^ before);
          a.require(Math.abs(poses[at][i]) < 1e30f, "remembered pose=" + poses[at][i]);
        }
      }
    }
    moves = -1;
  }
}
