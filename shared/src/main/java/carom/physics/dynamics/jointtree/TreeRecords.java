package carom.physics.dynamics.jointtree;

import static carom.physics.dynamics.domain.SolverBodies.VX;
import static carom.physics.dynamics.domain.SolverBodies.VY;
import static carom.physics.dynamics.domain.SolverBodies.W;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.joint.JointStore;

/**
 * The numbers that {@link TreeSolver} computes with: a record of {@value #JOINT} doubles for each
 * joint of a tree and one of {@value #BODY} for each body, in the order of {@link JointTrees}.
 */
final class TreeRecords {
  /** Softness where a tree is held several times, in inverse masses of a joint's bodies. */
  static final double CLOSED_SOFTNESS = 1e-4;

  /**
   * Mass along a locked axis, in masses; moment of inertia of what doesn't turn, in masses, m^2.
   * With 1e9 elimination lost the digits of the others: four welded bodies, one of which could only
   * turn, flew 1,000 m apart.
   */
  private static final double LOCKED = 1e6;

  /** Least distance of a rod's ends at which it has a direction, m. */
  static final double LEAST_LENGTH = 1e-9;

  // Numbers of a joint.
  static final int ARM_AX = 0;
  static final int ARM_AY = 1;
  static final int ARM_BX = 2;
  static final int ARM_BY = 3;
  static final int GAP_X = 4;
  static final int GAP_Y = 5;

  /** Lever arms now: of A, then of B. */
  static final int RAX = 6;

  static final int RAY = 7;
  static final int RBX = 8;
  static final int RBY = 9;

  /** Speed at which the anchors are drawn together. */
  static final int BIAS_X = 10;

  static final int BIAS_Y = 11;

  /** The matrix S. */
  static final int SXX = 12;

  static final int SXY = 13;
  static final int SYY = 14;

  /** The softness c. */
  static final int SOFT = 15;

  /** Impulse of the substep on B. */
  static final int PX = 16;

  static final int PY = 17;

  /** Impulse of this visit on B, as far as it follows from what is beyond the joint. */
  static final int QX = 18;

  static final int QY = 19;

  /** Direction of a rod, from A to B. */
  static final int NX = 20;

  static final int NY = 21;

  /** Impulse across a rod per speed across it, kg. */
  static final int ACROSS = 22;

  /** Length of a rod, m. */
  static final int LENGTH = 23;

  static final int JOINT = 24;

  // Numbers of a body. A and its inverse are symmetric: xx, xy, xw, yy, yw, ww.

  static final int MASS_X = 0;

  /** Mass along y; along a locked axis nothing can be moved. */
  static final int MASS_Y = 1;

  static final int INERTIA = 2;
  static final int A = 3;
  static final int INVERSE = 9;

  /** Impulse on the body of this visit; then the change of its velocity. */
  static final int Z = 15;

  /** Moment of inertia that impulses of the joints feel. */
  static final int TURNING = 18;

  static final int BODY = 19;

  /** Numbers that welds have beside these. */
  final TreeWelds welds;

  private final JointTrees trees;
  private final JointFrame frame = new JointFrame();

  /** Per joint: offset of A in {@code SolverBodies.state}. */
  int[] bodyA = new int[0];

  /** Per joint: offset of B. */
  int[] bodyB = new int[0];

  /** Per joint: whether B is the child. */
  boolean[] childIsB = new boolean[0];

  /** Per joint: whether it is a rod. */
  boolean[] rod = new boolean[0];

  /** Per joint: whether it is a weld. */
  boolean[] weld = new boolean[0];

  /** Per tree: whether it has a rod. */
  boolean[] hasRods = new boolean[0];

  /** Per tree: whether it has a weld. */
  boolean[] hasWelds = new boolean[0];

  /** Tells whether any tree has a weld. */
  boolean anyWelds;

  /** Per body: its offset in the solver's state. */
  int[] offset = new int[0];

  /** Per body: whether it can turn. */
  boolean[] turns = new boolean[0];

  /** Records of the joints. */
  double[] joint = new double[0];

  /** Records of the bodies. */
  double[] body = new double[0];

  /** Makes records of these trees. */
  TreeRecords(JointTrees trees) {
    this.trees = trees;
    welds = new TreeWelds(trees, this);
  }

  /** Loads the joints and bodies of all trees as a step begins. */
  void load(JointStore j, BodyStore bodies, int[] slotOf, float[] state) {
    ensure(trees.start[trees.count], trees.bodyStart[trees.count]);
    welds.begin(trees.start[trees.count], state);
    anyWelds = false;
    for (int t = 0; t < trees.count; t++) {
      hasRods[t] = false;
      hasWelds[t] = false;
      for (int i = trees.start[t]; i < trees.start[t + 1]; i++) {
        frame.load(trees.slot[i], j, bodies, slotOf);
        pack(i, j, bodies, trees.closed[t]);
        hasRods[t] |= rod[i];
        hasWelds[t] |= weld[i];
      }
      anyWelds |= hasWelds[t];
    }
  }

  private void ensure(int joints, int bodyCount) {
    if (hasRods.length < trees.count) {
      hasRods = new boolean[Math.max(trees.count, 2 * hasRods.length)];
      hasWelds = new boolean[hasRods.length];
    }
    if (bodyA.length < joints) {
      int capacity = Math.max(joints, 2 * bodyA.length);
      bodyA = new int[capacity];
      bodyB = new int[capacity];
      childIsB = new boolean[capacity];
      rod = new boolean[capacity];
      weld = new boolean[capacity];
      joint = new double[capacity * JOINT];
    }
    if (offset.length < bodyCount) {
      int capacity = Math.max(bodyCount, 2 * offset.length);
      offset = new int[capacity];
      turns = new boolean[capacity];
      body = new double[capacity * BODY];
    }
  }

  private void pack(int i, JointStore j, BodyStore bodies, boolean closed) {
    JointFrame f = frame;
    double[] d = joint;
    int at = i * JOINT;
    bodyA[i] = f.offsetA;
    bodyB[i] = f.offsetB;
    int c = trees.child[i];
    int p = trees.parent[i];
    childIsB[i] = c >= 0 ? f.bodyB == trees.body[c] : f.bodyB != trees.body[p];
    d[at + ARM_AX] = f.armAx;
    d[at + ARM_AY] = f.armAy;
    d[at + ARM_BX] = f.armBx;
    d[at + ARM_BY] = f.armBy;
    d[at + GAP_X] = f.gapX;
    d[at + GAP_Y] = f.gapY;
    rod[i] = j.isRod(f.slot);
    if (rod[i]) {
      packRod(at, j);
    } else {
      d[at + PX] = j.impulseX[f.slot];
      d[at + PY] = j.impulseY[f.slot];
    }
    weld[i] = j.isRigidWeld(f.slot);
    if (weld[i]) {
      welds.pack(i, f, j, closed);
    }
    d[at + SOFT] = closed ? CLOSED_SOFTNESS * ((double) f.massA + f.massB) : 0;
    loadBody(childIsB[i] ? p : c, f.offsetA, f.massA, f.inertiaA, bodies);
    loadBody(childIsB[i] ? c : p, f.offsetB, f.massB, f.inertiaB, bodies);
  }

  private void packRod(int at, JointStore j) {
    JointFrame f = frame;
    double x = (double) f.gapX + ((double) f.armBx - f.armAx);
    double y = (double) f.gapY + ((double) f.armBy - f.armAy);
    point(at, x, y, Math.sqrt(x * x + y * y));
    double p = j.rodImpulse(f.slot);
    joint[at + LENGTH] = j.rodLength(f.slot);
    joint[at + PX] = p * joint[at + NX];
    joint[at + PY] = p * joint[at + NY];
  }

  /** Points a rod from A to B, which are that far apart. */
  void point(int at, double x, double y, double length) {
    boolean apart = length > LEAST_LENGTH;
    joint[at + NX] = apart ? x / length : 1;
    joint[at + NY] = apart ? y / length : 0;
  }

  private void loadBody(int b, int at, float inverseMass, float inverseInertia, BodyStore bodies) {
    if (b >= 0) {
      double mass = 1.0 / inverseMass;
      int locks = bodies.linearLocks(trees.body[b]);
      offset[b] = at;
      body[b * BODY + MASS_X] = (locks & BodyStore.LOCK_X) != 0 ? LOCKED * mass : mass;
      body[b * BODY + MASS_Y] = (locks & BodyStore.LOCK_Y) != 0 ? LOCKED * mass : mass;
      turns[b] = inverseInertia > 0;
      body[b * BODY + INERTIA] = inverseInertia > 0 ? 1.0 / inverseInertia : LOCKED * mass;
    }
  }

  /** Applies an impulse to a body alone. */
  void push(int b, double px, double py, double turn, float[] v) {
    int at = b * BODY;
    int o = offset[b];
    v[o + VX] += (float) (px / body[at + MASS_X]);
    v[o + VY] += (float) (py / body[at + MASS_Y]);
    if (turns[b]) {
      v[o + W] += (float) (turn / body[at + TURNING]);
    }
  }

  /** Sets the impulses on bodies to zero. */
  void clearImpulses(int from, int to) {
    for (int z = from * BODY + Z; z < to * BODY; z += BODY) {
      body[z] = 0;
      body[z + 1] = 0;
      body[z + 2] = 0;
    }
  }

  /** Stores what the joints exerted, and forgets what isn't a number. */
  void store(JointStore j, float inverseH) {
    for (int i = 0; i < trees.start[trees.count]; i++) {
      int slot = trees.slot[i];
      float x = (float) joint[i * JOINT + PX];
      float y = (float) joint[i * JOINT + PY];
      float w = weld[i] ? (float) welds.impulse(i) : 0;
      if (!(Math.abs(x) + Math.abs(y) + Math.abs(w) <= Float.MAX_VALUE)) {
        j.forget(slot);
        continue;
      }
      if (rod[i]) {
        double nx = joint[i * JOINT + NX];
        double ny = joint[i * JOINT + NY];
        float p = (float) (x * nx + y * ny);
        j.setRodImpulse(slot, p);
        x = (float) (p * nx);
        y = (float) (p * ny);
      } else {
        j.impulseX[slot] = x;
        j.impulseY[slot] = y;
        if (weld[i]) {
          j.impulseW[slot] = w;
        }
      }
      j.forceX[slot] = x * inverseH;
      j.forceY[slot] = y * inverseH;
      j.torque[slot] = w * inverseH;
    }
  }
}
