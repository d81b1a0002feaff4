package carom.physics.dynamics.jointsolver;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.jointtree.JointFrame;

/**
 * The joints that aren't plain revolutes as the solver visits them: in the order of their colours,
 * each with one record of {@value #RECORD} floats. The first ones stay the same during a step, the
 * others until bodies move. Many visits fall into that time, so they are worth keeping.
 */
final class JointRecords {
  // Offsets in a record.

  /** Inverse masses of the bodies, 1/kg. */
  static final int MASS_A = 0;

  static final int MASS_B = 1;

  /** Inverse moments of inertia, 1/(kg m^2). */
  static final int INERTIA_A = 2;

  static final int INERTIA_B = 3;

  /** Lever arms when the step began, m. */
  static final int ARM_AX = 4;

  static final int ARM_AY = 5;
  static final int ARM_BX = 6;
  static final int ARM_BY = 7;

  /** Centre of B relative to that of A when the step began, m. */
  static final int GAP_X = 8;

  static final int GAP_Y = 9;

  /** Axis when the step began. */
  static final int AXIS_X = 10;

  static final int AXIS_Y = 11;

  /** Angle of the joint as a rotation, when the step began. */
  static final int ANGLE_COS = 12;

  static final int ANGLE_SIN = 13;

  /** Effective mass of the angle, kg m^2. */
  static final int ANGULAR = 14;

  // What follows from the poses of bodies: the same until they move again.

  /** Lever arms now, m. */
  static final int NOW_AX = 16;

  static final int NOW_AY = 17;
  static final int NOW_BX = 18;
  static final int NOW_BY = 19;

  /** Gap from A's anchor to B's now, m. */
  static final int NOW_DX = 20;

  static final int NOW_DY = 21;

  /** Angle now, rad. */
  static final int NOW_ANGLE = 22;

  /** The row of a length, or along an axis: {@value #ROW} floats. */
  static final int FIRST_ROW = 23;

  /** The row across an axis. */
  static final int SECOND_ROW = 29;

  /** Inverse mass of the point, of joints without axis and length, 1/kg: a symmetric matrix. */
  static final int POINT_XX = 23;

  static final int POINT_XY = 24;
  static final int POINT_YY = 25;

  /** Inverse of its determinant, less softness, kg^2; see {@link ConstraintRow#pointRow}. */
  static final int POINT_SOFT = 26;

  /** The same without softness, kg^2. */
  static final int POINT_RIGID = 27;

  /** Lever arm of A at which the impulse of the point acts, m. */
  static final int POINT_AX = 28;

  static final int POINT_AY = 29;

  /** The mass by which the spring of the coordinate has its stiffness, kg or kg m^2. */
  static final int SPRING_MASS = 35;

  /** Change of speed that the spring makes in a substep per stretch, 1/s. */
  static final int SPRING_PULL = 36;

  /** The same per speed. */
  static final int SPRING_SOFT = 37;

  /** Divisor of each visit of the spring. */
  static final int SPRING_SHARE = 38;

  /** Angle over all turns now, rad, of hinges with limits. */
  static final int NOW_TURNED = 39;

  /** Gap of anchors, m, that only a teleport leaves. */
  private static final float TORN = 16;

  /** Floats of a record. */
  static final int RECORD = 40;

  // Offsets in a row: its direction, its arms, its effective mass, and its coordinate.

  static final int ROW_X = 0;
  static final int ROW_Y = 1;
  static final int ROW_A = 2;
  static final int ROW_B = 3;
  static final int ROW_MASS = 4;
  static final int ROW_VALUE = 5;

  /** Floats of a row. */
  static final int ROW = 6;

  // Bits of locked axes.

  static final byte LOCK_AX = 1;
  static final byte LOCK_AY = 2;
  static final byte LOCK_BX = 4;
  static final byte LOCK_BY = 8;

  // Kinds of joints by what a visit does.

  /** Kind: any joint. */
  static final byte ANY = 0;

  /** Kind: a hinge without limit, motor, teeth or turns to count. It may have a spring. */
  static final byte HINGE = 1;

  /** Kind: a distance joint of bodies without locks that is a spring and nothing else. */
  static final byte SPRING = 2;

  /** Kind: a hinge that has two limits and is nothing else. */
  static final byte LIMITED = 3;

  /** Number of times that bodies moved in this step, from 1 on. */
  private int poses;

  /** Per joint: its slot. */
  int[] joint = new int[0];

  /** Per joint: offsets of its bodies in {@code SolverBodies.state}. */
  int[] bodyA = new int[0];

  int[] bodyB = new int[0];

  /** Per joint: bits of the axes along which its bodies are locked, which have no inverse mass. */
  byte[] locks = new byte[0];

  /** Per joint: whether {@code TreeSolver} solves its point. */
  boolean[] inTree = new boolean[0];

  /** Records of all joints. */
  float[] data = new float[0];

  /** Per joint: whether its group isn't watched, see {@link JointGroups}. */
  boolean[] plain = new boolean[0];

  /** Per joint: whether it holds a point, so that its anchors belong together. */
  private boolean[] pointed = new boolean[0];

  /** Per joint: whether its anchors were far apart in this step, so that all else has to wait. */
  boolean[] torn = new boolean[0];

  /** Per joint: its kind. */
  byte[] kind = new byte[0];

  /** Per joint: whether it has a spring on its coordinate. */
  boolean[] sprung = new boolean[0];

  /** Per joint: the poses that its record is of, as {@link #poses} counts them. */
  int[] measured = new int[0];

  /** Per joint: the poses that its angle is of. */
  int[] turned = new int[0];

  /** Per joint: how far its spring is stretched as the substep begins, m or rad; y of points. */
  float[] stretchX = new float[0];

  float[] stretchY = new float[0];

  /** Per joint: how far its angular spring is turned as the substep begins, rad. */
  float[] stretchW = new float[0];

  /** Makes room; what was there is gone. */
  void ensure(int least) {
    if (joint.length < least) {
      int n = Math.max(least, 2 * joint.length);
      joint = new int[n];
      bodyA = new int[n];
      bodyB = new int[n];
      locks = new byte[n];
      inTree = new boolean[n];
      plain = new boolean[n];
      pointed = new boolean[n];
      torn = new boolean[n];
      kind = new byte[n];
      sprung = new boolean[n];
      measured = new int[n];
      turned = new int[n];
      stretchX = new float[n];
      stretchY = new float[n];
      stretchW = new float[n];
      data = new float[n * RECORD];
    }
  }

  /** Begins a step. Joints are packed after that. */
  void begin() {
    poses = 1;
  }

  /** Forgets what follows from poses, because bodies moved. */
  void posesChanged() {
    poses++;
  }

  /** Returns the number of the present poses. */
  int poses() {
    return poses;
  }

  /** Fills in joint k, as the step begins. */
  void pack(int k, JointFrame f, JointStore j, boolean tree, boolean isPlain) {
    float[] d = data;
    int at = k * RECORD;
    int slot = f.slot;
    joint[k] = slot;
    bodyA[k] = f.offsetA;
    bodyB[k] = f.offsetB;
    locks[k] = 0;
    locks[k] |= (f.locksA & BodyStore.LOCK_X) != 0 ? LOCK_AX : 0;
    locks[k] |= (f.locksA & BodyStore.LOCK_Y) != 0 ? LOCK_AY : 0;
    locks[k] |= (f.locksB & BodyStore.LOCK_X) != 0 ? LOCK_BX : 0;
    locks[k] |= (f.locksB & BodyStore.LOCK_Y) != 0 ? LOCK_BY : 0;
    inTree[k] = tree;
    plain[k] = isPlain;
    pointed[k] = j.type[slot] == JointStore.REVOLUTE || j.type[slot] == JointStore.WELD;
    torn[k] = false;
    sprung[k] = (j.flags[slot] & JointStore.SPRUNG) != 0;
    kind[k] = kindOf(j, slot, tree);
    kind[k] = kind[k] == SPRING && locks[k] != 0 ? ANY : kind[k];
    measured[k] = 0;
    turned[k] = 0;
    d[at + MASS_A] = f.massA;
    d[at + MASS_B] = f.massB;
    d[at + INERTIA_A] = f.inertiaA;
    d[at + INERTIA_B] = f.inertiaB;
    float turning = f.inertiaA + f.inertiaB;
    d[at + ANGULAR] = turning > 0 ? 1 / turning : 0;
    d[at + ARM_AX] = f.armAx;
    d[at + ARM_AY] = f.armAy;
    d[at + ARM_BX] = f.armBx;
    d[at + ARM_BY] = f.armBy;
    d[at + GAP_X] = f.gapX;
    d[at + GAP_Y] = f.gapY;
    d[at + AXIS_X] = f.cosA * j.axisX[slot] - f.sinA * j.axisY[slot];
    d[at + AXIS_Y] = f.sinA * j.axisX[slot] + f.cosA * j.axisY[slot];
    float relativeCos = f.cosB * f.cosA + f.sinB * f.sinA;
    float relativeSin = f.sinB * f.cosA - f.cosB * f.sinA;
    d[at + ANGLE_COS] = relativeCos * j.refCos[slot] + relativeSin * j.refSin[slot];
    d[at + ANGLE_SIN] = relativeSin * j.refCos[slot] - relativeCos * j.refSin[slot];
  }

  /**
   * Returns whether the anchors of a joint, which is measured, are where only a teleport moves.
   * What moves them as far within a step isn't one.
   */
  boolean isTorn(int k) {
    int at = k * RECORD;
    boolean begins = poses == 1 && pointed[k];
    return begins && Math.abs(data[at + NOW_DX]) + Math.abs(data[at + NOW_DY]) > TORN;
  }

  private static byte kindOf(JointStore j, int slot, boolean tree) {
    int acting = j.flags[slot] & (JointStore.LIMITED | JointStore.DRIVEN | JointStore.SPRUNG);
    boolean freely = (acting & ~JointStore.SPRUNG) == 0;
    if (j.type[slot] == JointStore.REVOLUTE && !tree && !j.isRatchet(slot)) {
      boolean limited = acting == JointStore.LIMITED && j.lower[slot] < j.upper[slot];
      return limited ? LIMITED : freely && !j.winds(slot) ? HINGE : ANY;
    }
    boolean spring = freely && acting != 0;
    return j.type[slot] == JointStore.DISTANCE && spring ? SPRING : ANY;
  }
}
