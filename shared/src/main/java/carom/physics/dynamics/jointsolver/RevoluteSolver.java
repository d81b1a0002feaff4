package carom.physics.dynamics.jointsolver;

import static carom.physics.dynamics.domain.SolverBodies.COS;
import static carom.physics.dynamics.domain.SolverBodies.DX;
import static carom.physics.dynamics.domain.SolverBodies.DY;
import static carom.physics.dynamics.domain.SolverBodies.SIN;
import static carom.physics.dynamics.domain.SolverBodies.VX;
import static carom.physics.dynamics.domain.SolverBodies.VY;
import static carom.physics.dynamics.domain.SolverBodies.W;

import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.jointtree.JointFrame;
import carom.physics.dynamics.store.ParallelFor;
import carom.physics.simd.VectorModule;
import java.util.Arrays;

/**
 * Solves plain revolute joints (hinges): those without limit, motor or spring, of which most
 * chains, nets and figures are made. They are the point constraint of {@link JointVisit} in blocks
 * of {@link #LANES}, so that vectors solve them side by side and workers share them.
 *
 * <p>The joints of one block share no body that can be moved; {@link JointSolver} sees to it by
 * colours. Their lever arms are those after bodies last moved, so {@link #relax}, which comes right
 * after that, finds them, and {@link #warmStart} and {@link #applyBiasedImpulses} of the next
 * substep find them where it left them, with the inverse of the mass; in the first substep {@link
 * #ready} did.
 *
 * <p>Laid out as {@code ContactBlocks} lays out contacts: all quantities of a block follow each
 * other, each for all its lanes.
 */
public final class RevoluteSolver {
  /** Joints in a block. */
  public static final int LANES = VectorModule.LANES;

  /** Most gap between anchors that counts, m, as in {@link ConstraintRow#MAX_ERROR}. */
  public static final float MAX_ERROR = 4;

  // Quantities of a joint: offsets in its block of data.

  /** Inverse mass of A, 1/kg, 0 if it cannot be moved. */
  public static final int MASS_A = 0;

  /** Inverse mass of B, 1/kg. */
  public static final int MASS_B = MASS_A + LANES;

  /** Inverse moment of inertia of A, 1/(kg m^2). */
  public static final int INERTIA_A = MASS_B + LANES;

  /** Inverse moment of inertia of B, 1/(kg m^2). */
  public static final int INERTIA_B = INERTIA_A + LANES;

  /** Impulse of the last substep on B, x, N s. */
  public static final int PX = INERTIA_B + LANES;

  /** Impulse of the last substep on B, y, N s. */
  public static final int PY = PX + LANES;

  /** Lever arm of A now, at which impulses act, x, m. */
  public static final int RAX = PY + LANES;

  /** Lever arm of A now, y, m. */
  public static final int RAY = RAX + LANES;

  /** Lever arm of B now, x, m. */
  public static final int RBX = RAY + LANES;

  /** Lever arm of B now, y, m. */
  public static final int RBY = RBX + LANES;

  /** Bias: speed at which the anchors are drawn together, x, m/s. */
  public static final int BIAS_X = RBY + LANES;

  /** Bias, y, m/s. */
  public static final int BIAS_Y = BIAS_X + LANES;

  /** Effective mass of a point, xx / determinant of the 2x2 matrix of inverse masses, kg. */
  public static final int XX = BIAS_Y + LANES;

  /** Effective mass of a point, xy / determinant, kg. */
  public static final int XY = XX + LANES;

  /** Effective mass of a point, yy / determinant, kg. */
  public static final int YY = XY + LANES;

  /** Lever arm of A when the step began, x, m. */
  public static final int ARM_AX = YY + LANES;

  /** Lever arm of A when the step began, y, m. */
  public static final int ARM_AY = ARM_AX + LANES;

  /** Lever arm of B when the step began, x, m. */
  public static final int ARM_BX = ARM_AY + LANES;

  /** Lever arm of B when the step began, y, m. */
  public static final int ARM_BY = ARM_BX + LANES;

  /** Centre of B relative to that of A when the step began, x, m. */
  public static final int GAP_X = ARM_BY + LANES;

  /** Centre of B relative to that of A when the step began, y, m. */
  public static final int GAP_Y = GAP_X + LANES;

  /** Floats of a block. */
  public static final int RECORD = GAP_Y + LANES;

  /** Blocks with fewer joints are solved one by one. */
  private static final int FEWEST = 1 + LANES / 4;

  /** Steps with fewer blocks don't use vectors. */
  private static final int FEWEST_BLOCKS = 256 / LANES;

  /** Blocks that make a piece of work for a worker. */
  private static final int GRAIN = 64 / LANES;

  private final RevoluteLanes lanes;
  private final ParallelFor parallel;

  /** Scratch arrays of the kernels, one per worker. */
  private float[][] scratch = new float[0][];

  private int blocks;

  /** Per block: how many joints it has. */
  private byte[] used = new byte[0];

  /** Per block: whether all its bodies can be moved. */
  public boolean[] loose = new boolean[0];

  /** Per block: whether vectors solve it. */
  private boolean[] wide = new boolean[0];

  /** Per lane: slot of the joint. */
  private int[] joint = new int[0];

  /** Per lane: offset of body A in the solver's state. */
  public int[] bodyA = new int[0];

  /** Per lane: offset of body B in the solver's state. */
  public int[] bodyB = new int[0];

  /** Quantities of all joints. */
  public float[] data = new float[0];

  /** State of the bodies. */
  private float[] v = new float[0];

  /** Share of an error that goes away per second, 1/s. */
  public float biasRate;

  /** Share of the effective mass that counts. */
  public float massScale;

  /** Share of the impulse so far that is taken back. */
  public float impulseScale;

  // The stages, made once so that a step allocates nothing.
  private final ParallelFor.Range measuring = this::measureBlocks;
  private final ParallelFor.Range warming = this::warmBlocks;
  private final ParallelFor.Range biasing = this::biasBlocks;
  private final ParallelFor.Range relaxing = this::relaxBlocks;
  private final ParallelFor.Range storing = (from, to, worker) -> storeBlocks(from, to);

  /** Receives the impulses when a step ends. */
  private JointStore store;

  /** Substeps per second. */
  private float inverseH;

  /**
   * Makes a solver.
   *
   * @param lanes kernels for whole blocks, null for none
   * @param parallel does blocks
   */
  RevoluteSolver(RevoluteLanes lanes, ParallelFor parallel) {
    this.lanes = lanes;
    this.parallel = parallel;
  }

  /** Begins a step, which has no joints yet. */
  void begin(float[] state, float biasRate, float massScale, float impulseScale) {
    v = state;
    this.biasRate = biasRate;
    this.massScale = massScale;
    this.impulseScale = impulseScale;
    blocks = 0;
    if (lanes != null && scratch.length != parallel.count()) {
      scratch = new float[parallel.count()][lanes.scratchSize()];
    }
  }

  /** Returns the number of blocks so far. */
  int blocks() {
    return blocks;
  }

  /** Adds blocks for some joints of one colour, and returns the first lane. */
  int reserve(int joints) {
    int first = blocks;
    blocks += (joints + LANES - 1) / LANES;
    if (used.length < blocks) {
      grow(Math.max(blocks, 2 * used.length));
    }
    for (int block = first; block < blocks; block++) {
      int n = Math.min(joints - (block - first) * LANES, LANES);
      used[block] = (byte) n;
      loose[block] = n == LANES;
      if (n < LANES) {
        Arrays.fill(data, block * RECORD, (block + 1) * RECORD, 0);
        Arrays.fill(bodyA, block * LANES, (block + 1) * LANES, 0);
        Arrays.fill(bodyB, block * LANES, (block + 1) * LANES, 0);
      }
    }
    return first * LANES;
  }

  private void grow(int capacity) {
    used = Arrays.copyOf(used, capacity);
    loose = Arrays.copyOf(loose, capacity);
    wide = new boolean[capacity];
    joint = Arrays.copyOf(joint, capacity * LANES);
    bodyA = Arrays.copyOf(bodyA, capacity * LANES);
    bodyB = Arrays.copyOf(bodyB, capacity * LANES);
    data = Arrays.copyOf(data, capacity * RECORD);
  }

  /** Decides what vectors solve, and finds lever arms. Must be called when all lanes are filled. */
  void ready() {
    int most = 0;
    if (lanes != null && blocks >= FEWEST_BLOCKS) {
      most = lanes.grant(blocks, blocks * LANES);
    }
    for (int block = 0; block < blocks; block++) {
      wide[block] = block < most && used[block] >= FEWEST;
    }
    parallel.run(0, blocks, GRAIN, measuring);
  }

  /** Fills a lane with a joint as the step begins, and its impulse of the last step. */
  void pack(int lane, JointFrame f, JointStore j) {
    float[] d = data;
    int at = lane / LANES * RECORD + lane % LANES;
    joint[lane] = f.slot;
    bodyA[lane] = f.offsetA;
    bodyB[lane] = f.offsetB;
    d[at + MASS_A] = f.massA;
    d[at + MASS_B] = f.massB;
    d[at + INERTIA_A] = f.inertiaA;
    d[at + INERTIA_B] = f.inertiaB;
    d[at + PX] = j.impulseX[f.slot];
    d[at + PY] = j.impulseY[f.slot];
    d[at + ARM_AX] = f.armAx;
    d[at + ARM_AY] = f.armAy;
    d[at + ARM_BX] = f.armBx;
    d[at + ARM_BY] = f.armBy;
    d[at + GAP_X] = f.gapX;
    d[at + GAP_Y] = f.gapY;
    if (f.massA == 0 || f.massB == 0) {
      loose[lane / LANES] = false;
    }
  }

  /** Scales the impulse that a lane's joint starts with. */
  void scale(int lane, float share) {
    int at = lane / LANES * RECORD + lane % LANES;
    data[at + PX] *= share;
    data[at + PY] *= share;
  }

  /** Visits the joint of a lane once more. */
  void visit(int lane, boolean bias) {
    int at = lane / LANES * RECORD + lane % LANES;
    if (bias) {
      solve(lane, at, massScale, impulseScale, data[at + BIAS_X], data[at + BIAS_Y]);
    } else {
      solve(lane, at, 1, 0, 0, 0);
    }
  }

  /** Applies the impulses of the last substep, or the last step. */
  void warmStart(int from, int to) {
    parallel.run(from, to, GRAIN, warming);
  }

  /** Visits each joint once before bodies move, with bias, which draws anchors together. */
  void applyBiasedImpulses(int from, int to) {
    parallel.run(from, to, GRAIN, biasing);
  }

  /** Visits each joint once after bodies moved, rigid. */
  void relax(int from, int to) {
    parallel.run(from, to, GRAIN, relaxing);
  }

  private void measureBlocks(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if (wide[block]) {
        lanes.measure(this, v, scratch[worker], block);
        continue;
      }
      for (int i = 0; i < used[block]; i++) {
        int lane = block * LANES + i;
        measure(block * RECORD + i, bodyA[lane], bodyB[lane]);
      }
    }
  }

  private void warmBlocks(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if (wide[block]) {
        lanes.warmStart(this, v, scratch[worker], block);
        continue;
      }
      for (int i = 0; i < used[block]; i++) {
        int at = block * RECORD + i;
        applyImpulse(block * LANES + i, at, data[at + PX], data[at + PY]);
      }
    }
  }

  private void biasBlocks(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if (wide[block]) {
        lanes.applyBiasedImpulses(this, v, scratch[worker], block);
        continue;
      }
      for (int i = 0; i < used[block]; i++) {
        int at = block * RECORD + i;
        solve(block * LANES + i, at, massScale, impulseScale, data[at + BIAS_X], data[at + BIAS_Y]);
      }
    }
  }

  private void relaxBlocks(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if (wide[block]) {
        lanes.relax(this, v, scratch[worker], block);
        continue;
      }
      for (int i = 0; i < used[block]; i++) {
        int lane = block * LANES + i;
        int at = block * RECORD + i;
        measure(at, bodyA[lane], bodyB[lane]);
        solve(lane, at, 1, 0, 0, 0);
      }
    }
  }

  /**
   * Finds lever arms, bias and mass with the bodies where they are now. Both impulses act at one
   * point, B's anchor: at both ends of a gap they would be a torque out of nothing, which made
   * overloaded nets tremble (the net of 10,000 opened by up to 1.07 m while it fell, and by 0.53 m
   * like this).
   */
  private void measure(int at, int a, int b) {
    float[] d = data;
    float cosA = v[a + COS];
    float sinA = v[a + SIN];
    float cosB = v[b + COS];
    float sinB = v[b + SIN];
    float ax = cosA * d[at + ARM_AX] - sinA * d[at + ARM_AY];
    float ay = sinA * d[at + ARM_AX] + cosA * d[at + ARM_AY];
    float bx = cosB * d[at + ARM_BX] - sinB * d[at + ARM_BY];
    float by = sinB * d[at + ARM_BX] + cosB * d[at + ARM_BY];
    float dx = d[at + GAP_X] + (v[b + DX] - v[a + DX]) + (bx - ax);
    float dy = d[at + GAP_Y] + (v[b + DY] - v[a + DY]) + (by - ay);
    float far = Math.abs(dx) + Math.abs(dy);
    float rate = far > MAX_ERROR ? biasRate * MAX_ERROR / far : biasRate;
    ax = far <= MAX_ERROR ? ax + dx : ax;
    ay = far <= MAX_ERROR ? ay + dy : ay;
    d[at + RAX] = ax;
    d[at + RAY] = ay;
    d[at + RBX] = bx;
    d[at + RBY] = by;
    d[at + BIAS_X] = rate * dx;
    d[at + BIAS_Y] = rate * dy;
    float masses = d[at + MASS_A] + d[at + MASS_B];
    float inertiaA = d[at + INERTIA_A];
    float inertiaB = d[at + INERTIA_B];
    float xx = masses + (inertiaA * (ay * ay) + inertiaB * (by * by));
    float xy = inertiaA * (ax * ay) + inertiaB * (bx * by);
    float yy = masses + (inertiaA * (ax * ax) + inertiaB * (bx * bx));
    float determinant = xx * yy - xy * xy;
    float inverse = determinant > 0 ? 1 / determinant : 0;
    d[at + XX] = xx * inverse;
    d[at + XY] = xy * inverse;
    d[at + YY] = yy * inverse;
  }

  private void solve(int lane, int at, float scale, float leak, float biasX, float biasY) {
    float[] d = data;
    int a = bodyA[lane];
    int b = bodyB[lane];
    float wa = v[a + W];
    float wb = v[b + W];
    float partX = (v[b + VX] - v[a + VX]) + (wa * d[at + RAY] - wb * d[at + RBY]) + biasX;
    float partY = (v[b + VY] - v[a + VY]) + (wb * d[at + RBX] - wa * d[at + RAX]) + biasY;
    float oldX = d[at + PX];
    float oldY = d[at + PY];
    float px = -(d[at + YY] * partX + d[at + XY] * partY) * scale - leak * oldX;
    float py = -(d[at + XX] * partY + d[at + XY] * partX) * scale - leak * oldY;
    d[at + PX] = oldX + px;
    d[at + PY] = oldY + py;
    applyImpulse(lane, at, px, py);
  }

  /** Applies an impulse to B and its opposite to A. Writes nothing to what can't be moved. */
  private void applyImpulse(int lane, int at, float px, float py) {
    float[] d = data;
    float massA = d[at + MASS_A];
    float massB = d[at + MASS_B];
    if (massA != 0) {
      int a = bodyA[lane];
      v[a + VX] -= massA * px;
      v[a + VY] -= massA * py;
      v[a + W] -= d[at + INERTIA_A] * (d[at + RAX] * py - d[at + RAY] * px);
    }
    if (massB != 0) {
      int b = bodyB[lane];
      v[b + VX] += massB * px;
      v[b + VY] += massB * py;
      v[b + W] += d[at + INERTIA_B] * (d[at + RBX] * py - d[at + RBY] * px);
    }
  }

  /** Stores what the joints exerted, and forgets what isn't a number. */
  void store(JointStore j, float rate) {
    store = j;
    inverseH = rate;
    parallel.run(0, blocks, GRAIN, storing);
  }

  private void storeBlocks(int from, int to) {
    JointStore j = store;
    for (int block = from; block < to; block++) {
      for (int i = 0; i < used[block]; i++) {
        int slot = joint[block * LANES + i];
        float x = data[block * RECORD + i + PX];
        float y = data[block * RECORD + i + PY];
        if (!(Math.abs(x) + Math.abs(y) <= Float.MAX_VALUE)) {
          j.forget(slot);
          continue;
        }
        j.impulseX[slot] = x;
        j.impulseY[slot] = y;
        j.forceX[slot] = x * inverseH;
        j.forceY[slot] = y * inverseH;
        j.torque[slot] = 0;
      }
    }
  }
}
