package carom.physics.dynamics.jointsolver;

import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.jointtree.JointFrame;
import carom.physics.dynamics.jointtree.TreeSolver;
import carom.physics.dynamics.solverbody.SolverBodies;

/**
 * The joints that aren't plain revolutes as the solver visits them: in the order of their colours,
 * each with what stays the same during a step as one record of {@value #RECORD} floats.
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

  /** Floats of a record: a cache line. */
  static final int RECORD = 16;

  /** Per joint: its slot. */
  int[] joint = new int[0];

  /** Per joint: offsets of its bodies in {@link SolverBodies#state}. */
  int[] bodyA = new int[0];

  int[] bodyB = new int[0];

  /** Per joint: whether {@link TreeSolver} solves its point. */
  boolean[] inTree = new boolean[0];

  /** Records of all joints. */
  float[] data = new float[0];

  /** Per joint: whether its group isn't watched, see {@link JointGroups}. */
  boolean[] plain = new boolean[0];

  /** Per joint: whether its anchors were far apart in this step, so that all else has to wait. */
  boolean[] torn = new boolean[0];

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
      inTree = new boolean[n];
      plain = new boolean[n];
      torn = new boolean[n];
      stretchX = new float[n];
      stretchY = new float[n];
      stretchW = new float[n];
      data = new float[n * RECORD];
    }
  }

  /** Fills in joint k, as the step begins. */
  void pack(int k, JointFrame f, JointStore j, boolean tree, boolean isPlain) {
    float[] d = data;
    int at = k * RECORD;
    int slot = f.slot;
    joint[k] = slot;
    bodyA[k] = f.offsetA;
    bodyB[k] = f.offsetB;
    inTree[k] = tree;
    plain[k] = isPlain;
    torn[k] = false;
    d[at + MASS_A] = f.massA;
    d[at + MASS_B] = f.massB;
    d[at + INERTIA_A] = f.inertiaA;
    d[at + INERTIA_B] = f.inertiaB;
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
}
