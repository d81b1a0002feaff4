package carom.physics.dynamics.joint;

import static carom.physics.dynamics.solver.SolverBodies.COS;
import static carom.physics.dynamics.solver.SolverBodies.DX;
import static carom.physics.dynamics.solver.SolverBodies.DY;
import static carom.physics.dynamics.solver.SolverBodies.SIN;
import static carom.physics.dynamics.solver.SolverBodies.VX;
import static carom.physics.dynamics.solver.SolverBodies.VY;
import static carom.physics.dynamics.solver.SolverBodies.W;

import carom.physics.dynamics.parallel.ParallelFor;
import carom.physics.dynamics.solver.ContactBlocks;
import carom.physics.simd.VectorModule;
import java.util.Arrays;

/**
 * Pins: hinges without limit, motor or spring, of which most chains, nets and figures are made. The
 * point constraint of {@link JointVisit} in blocks of {@link #LANES}, so that vectors can solve
 * them side by side and workers share them.
 *
 * <p>The pins of one block share no body that can be moved; {@link JointSolver} sees to it by
 * colours. Their lever arms are those after bodies last moved, so {@link #relax}, which comes right
 * after that, finds them, and {@link #warmStart} and {@link #push} of the next substep find them
 * where it left them, with the inverse of the mass; in the first substep {@link #ready} did.
 *
 * <p>Laid out as {@link ContactBlocks} lays out contacts: all quantities of a block follow each
 * other, each for all its lanes.
 */
public final class RevoluteSolver {
  /** Pins in a block. */
  public static final int LANES = VectorModule.LANES;

  /** As in {@link JointVisit}: what is further apart than this, m, was torn. */
  public static final float MAX_ERROR = 4;

  // Offsets of the quantities of a block: of the bodies,
  public static final int MASS_A = 0;
  public static final int MASS_B = MASS_A + LANES;
  public static final int INERTIA_A = MASS_B + LANES;
  public static final int INERTIA_B = INERTIA_A + LANES;

  /** impulse of the last substep on B, N s, */
  public static final int PX = INERTIA_B + LANES;

  public static final int PY = PX + LANES;

  /** lever arms now, at which impulses act, m, */
  public static final int RAX = PY + LANES;

  public static final int RAY = RAX + LANES;
  public static final int RBX = RAY + LANES;
  public static final int RBY = RBX + LANES;

  /** speed at which the anchors are to be drawn together, m/s, */
  public static final int BIAS_X = RBY + LANES;

  public static final int BIAS_Y = BIAS_X + LANES;

  /** inverse of the mass matrix: K = (YY, -XY; -XY, XX), kg, */
  public static final int XX = BIAS_Y + LANES;

  public static final int XY = XX + LANES;
  public static final int YY = XY + LANES;

  /** lever arms when the step began, and B's centre relative to A's, m. */
  public static final int ARM_AX = YY + LANES;

  public static final int ARM_AY = ARM_AX + LANES;
  public static final int ARM_BX = ARM_AY + LANES;
  public static final int ARM_BY = ARM_BX + LANES;
  public static final int GAP_X = ARM_BY + LANES;
  public static final int GAP_Y = GAP_X + LANES;
  public static final int RECORD = GAP_Y + LANES;

  /** Blocks with fewer pins are solved one by one. */
  private static final int FEWEST = 1 + LANES / 4;

  /** Steps with fewer blocks don't use vectors. */
  private static final int FEWEST_BLOCKS = 256 / LANES;

  /** Blocks that make a piece of work for a worker. */
  private static final int GRAIN = 64 / LANES;

  private final RevoluteLanes lanes;
  private final ParallelFor parallel;

  /** Of each worker. */
  private float[][] scratch = new float[0][];

  private int blocks;

  /** Per block: how many pins it has; whether all bodies can be moved; solved by vectors. */
  private byte[] used = new byte[0];

  public boolean[] loose = new boolean[0];
  private boolean[] wide = new boolean[0];

  /** Per lane: slot of the joint; offsets of the two bodies in the solver's state. */
  private int[] joint = new int[0];

  public int[] bodyA = new int[0];
  public int[] bodyB = new int[0];
  public float[] data = new float[0];

  // Constants of the step.
  private float[] v = new float[0];
  public float biasRate;
  public float massScale;
  public float impulseScale;

  // The stages, made once so that a step allocates nothing.
  private final ParallelFor.Range measuring = this::measureBlocks;
  private final ParallelFor.Range warming = this::warmBlocks;
  private final ParallelFor.Range pushing = this::pushBlocks;
  private final ParallelFor.Range relaxing = this::relaxBlocks;
  private final ParallelFor.Range storing = (from, to, worker) -> storeBlocks(from, to);

  /** Where impulses are written when a step ends, and the inverse of its substeps' length, 1/s. */
  private JointStore store;

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

  /** Begins a step: no pins yet. */
  void begin(float[] state, float rate, float scale, float leak) {
    v = state;
    biasRate = rate;
    massScale = scale;
    impulseScale = leak;
    blocks = 0;
    if (lanes != null && scratch.length != parallel.count()) {
      scratch = new float[parallel.count()][lanes.scratchSize()];
    }
  }

  /** The number of blocks so far. */
  int blocks() {
    return blocks;
  }

  /** Adds blocks for some pins, all of one colour; answers the first lane. */
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

  /** Must be called when all lanes are filled: decides what vectors solve, and finds lever arms. */
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

  /** Fills a lane with a joint as the step begins, and what the last one left behind. */
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

  /** Applies the impulses of the last substep, or the last step. */
  void warmStart(int from, int to) {
    parallel.run(from, to, GRAIN, warming);
  }

  /** One visit of each pin before bodies move, which draws anchors together. */
  void push(int from, int to) {
    parallel.run(from, to, GRAIN, pushing);
  }

  /** One visit of each pin after bodies moved, rigid. */
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

  private void pushBlocks(int from, int to, int worker) {
    for (int block = from; block < to; block++) {
      if (wide[block]) {
        lanes.push(this, v, scratch[worker], block);
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
   * Lever arms, bias and mass with the bodies where they are now. Both impulses act at one point,
   * B's anchor: at both ends of a gap they would be a torque out of nothing, which made overloaded
   * nets tremble (the net of 10,000 opened by up to 1.07 m while it fell, and by 0.53 m like this).
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

  /** Gives B an impulse, and A its opposite. Writes nothing to what can't be moved. */
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

  /** Writes down what the pins exerted; of what isn't a number nothing is kept. */
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
