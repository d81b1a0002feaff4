package carom.physics.dynamics.jointsolver;

import static carom.physics.dynamics.domain.SolverBodies.COS;
import static carom.physics.dynamics.domain.SolverBodies.DX;
import static carom.physics.dynamics.domain.SolverBodies.DY;
import static carom.physics.dynamics.domain.SolverBodies.SIN;
import static carom.physics.dynamics.domain.SolverBodies.VX;
import static carom.physics.dynamics.domain.SolverBodies.VY;
import static carom.physics.dynamics.domain.SolverBodies.W;
import static carom.physics.dynamics.jointsolver.JointRecords.ANGLE_COS;
import static carom.physics.dynamics.jointsolver.JointRecords.ANGLE_SIN;
import static carom.physics.dynamics.jointsolver.JointRecords.ANGULAR;
import static carom.physics.dynamics.jointsolver.JointRecords.ARM_AX;
import static carom.physics.dynamics.jointsolver.JointRecords.ARM_AY;
import static carom.physics.dynamics.jointsolver.JointRecords.ARM_BX;
import static carom.physics.dynamics.jointsolver.JointRecords.ARM_BY;
import static carom.physics.dynamics.jointsolver.JointRecords.AXIS_X;
import static carom.physics.dynamics.jointsolver.JointRecords.AXIS_Y;
import static carom.physics.dynamics.jointsolver.JointRecords.FIRST_ROW;
import static carom.physics.dynamics.jointsolver.JointRecords.GAP_X;
import static carom.physics.dynamics.jointsolver.JointRecords.GAP_Y;
import static carom.physics.dynamics.jointsolver.JointRecords.INERTIA_A;
import static carom.physics.dynamics.jointsolver.JointRecords.INERTIA_B;
import static carom.physics.dynamics.jointsolver.JointRecords.MASS_A;
import static carom.physics.dynamics.jointsolver.JointRecords.MASS_B;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_ANGLE;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_AX;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_AY;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_BX;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_BY;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_DX;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_DY;
import static carom.physics.dynamics.jointsolver.JointRecords.RECORD;
import static carom.physics.dynamics.jointsolver.JointRecords.ROW_A;
import static carom.physics.dynamics.jointsolver.JointRecords.ROW_B;
import static carom.physics.dynamics.jointsolver.JointRecords.ROW_MASS;
import static carom.physics.dynamics.jointsolver.JointRecords.ROW_VALUE;
import static carom.physics.dynamics.jointsolver.JointRecords.ROW_X;
import static carom.physics.dynamics.jointsolver.JointRecords.ROW_Y;
import static carom.physics.dynamics.jointsolver.JointRecords.SECOND_ROW;
import static carom.physics.dynamics.jointsolver.JointRecords.SPRING_MASS;
import static carom.physics.dynamics.jointsolver.JointRecords.SPRING_PULL;
import static carom.physics.dynamics.jointsolver.JointRecords.SPRING_SHARE;
import static carom.physics.dynamics.jointsolver.JointRecords.SPRING_SOFT;

import carom.physics.math.Trig;

/**
 * One coordinate of a joint as a constraint row, with the two bodies at hand; one worker's scratch.
 *
 * <p><b>Rows.</b> Everything a joint does to one coordinate q (a length, a translation along an
 * axis u, an angle) is a row: with the speed {@code q' = u . (vB - vA) + sB wB - sA wA} an impulse
 * p changes velocities by {@code -p u / mA, -p sA / IA, p u / mB, p sB / IB}, hence q' by p / m
 * with {@code 1 / m = 1/mA + 1/mB + sA^2 / IA + sB^2 / IB}. For an angle u = 0 and sA = sB = 1; for
 * a direction u with the anchors' lever arms rA, rB and the gap d between them, {@code sA = (rA +
 * d) x u, sB = rB x u}. Two coordinates that share a lever arm (a point, or the perpendicular and
 * the angle of a slider) are one block with a 2x2 mass.
 *
 * <p><b>Locked axes.</b> Along an axis of the world on which a body is locked it has no inverse
 * mass. So {@code 1/mA} is one number per axis: {@code 1 / m = u (1/mA + 1/mB) u + ...}. Where all
 * that is left of a point's 2x2 mass is one direction, the point is held in that one alone.
 *
 * <p><b>Rigid</b> coordinates (q = 0) are a rigid row. Before positions move, the error is fed back
 * into the velocity as in contacts (see {@code ContactSolver}), {@code p = -m M (q' + b q) - I P},
 * with the joint's own hertz; after that the row is solved again without (relax), so that no energy
 * enters.
 *
 * <p><b>Limits</b> are contacts: {@code P >= 0}; a gap may just be closed in a substep.
 *
 * <p><b>Motors</b> drive q' to a speed, {@code |P| <= h max}.
 *
 * <p><b>Springs</b> are forces: their stretch counts once per substep, and later visits only follow
 * the velocities. With k = m o^2, c = 2 m z o (o = 2 pi hertz, z the damping ratio) and the
 * velocity v' at the end of the substep, the impulse of the substep is
 *
 * <pre>
 *   P = -h (k (q + t h v') + c v')
 * </pre>
 *
 * and with v' = v + p / m one visit, which knows v and the sum so far, is
 *
 * <pre>
 *   p = -(m (h o^2 q + a v) + P) / (1 + a)     a = h o (t h o + 2 z)
 * </pre>
 *
 * <p>Where the stiffness is that of another mass n, {@code p = -(n (h o^2 q + a v) + P) / (1 + a n
 * / m)}.
 *
 * <p>With t = 0 the spring is symplectic: an undamped one keeps its amplitude for ever, its
 * frequency is exact up to (o h)^2 / 24. That is stable while o h is well below 2; springs with o h
 * beyond {@value #SYMPLECTIC_LIMIT} (19 hertz at 60 ticks and 4 substeps) use t = 1, implicit
 * Euler, which is stable always and damps by itself. The stretch q is that from before bodies moved
 * in all visits of a substep.
 *
 * <p>The row for the spring follows Erin Catto's GDC 2011 talk; written from the algebra above.
 */
abstract class ConstraintRow {
  static final float TWO_PI = 6.2831855f;

  /**
   * Most error that counts, m. Anchors that are further apart were moved by a teleport or by absurd
   * forces. They are drawn together as if they were that far apart, at some 100 m/s, and each
   * impulse acts at its own anchor. At full speed and with arms that long, a chain of which one
   * link is teleported by 80 m blows up instead of closing.
   */
  static final float MAX_ERROR = 4;

  /** Most angle per substep of a spring, o h. Beyond it a spring is integrated implicitly. */
  static final float SYMPLECTIC_LIMIT = 0.5f;

  /**
   * Most frequency of a spring, as a fraction of the substeps per second: 60 hertz at 60 ticks and
   * 4 substeps. Visits of the joints around it can't follow stiffer ones.
   */
  static final float MAX_HERTZ_PER_RATE = 0.25f;

  /** Determinant of what is locked, in squares of the trace, that counts as 0. */
  private static final float SINGULAR = 1e-6f;

  /** Joints to visit. */
  final JointRecords joints;

  /** State of the bodies: {@code SolverBodies.state}. */
  float[] v = new float[0];

  /** Length of a substep, s. */
  float h;

  /** Inverse of that length, 1/s. */
  float inverseH;

  /** Softness of rigid rows: the share of an error that goes away per second, 1/s. */
  float biasRate;

  /** Softness of rigid rows: the share of the effective mass that counts. */
  float massScale;

  /** Softness of rigid rows: the share of the impulse so far that is taken back. */
  float impulseScale;

  /** Offset of body A in {@link #v}. */
  int a;

  /** Offset of body B. */
  int b;

  /** Inverse masses, 1/kg; 0 for what can't be moved. */
  float mA;

  float mB;

  /** The same along the axes of the world: 0 where a body is locked. */
  private float mAx;

  private float mAy;
  private float mBx;
  private float mBy;

  /** True if a body is locked along an axis. */
  private boolean locked;

  /** Inverse moments of inertia, 1/(kg m^2). */
  float iA;

  float iB;

  /** Effective mass of the angle, kg m^2. */
  private float angular;

  /** Lever arm of A's anchor, m. */
  float rAx;

  float rAy;

  /** Lever arm of B's anchor, m. */
  float rBx;

  float rBy;

  /** Gap from A's anchor to B's, m. */
  float dx;

  float dy;

  /** Direction of the row. */
  float ux;

  float uy;

  /** Lever arms of the row, m or 1. */
  float sA;

  float sB;

  /** Effective mass of the row. */
  float mass;

  /** Inverse mass of two coordinates, K, a symmetric matrix. */
  float kxx;

  float kxy;
  float kyy;

  /** Determinant of K; 0 where nothing can be moved. */
  float determinant;

  /** Direction in which a pulley's row pushes A back; u is the one for B. */
  private float wx;

  private float wy;

  /** Tells whether the row has a direction for A of its own. */
  private boolean split;

  /** Makes rows of these joints. */
  ConstraintRow(JointRecords joints) {
    this.joints = joints;
  }

  /** Begins a step. */
  final void beginRows(
      float[] state, float substep, float biasRate, float massScale, float impulseScale) {
    v = state;
    h = substep;
    inverseH = 1 / substep;
    this.biasRate = biasRate;
    this.massScale = massScale;
    this.impulseScale = impulseScale;
  }

  /** Gives the row a direction for A of its own. */
  final void splitRow(float x, float y) {
    wx = x;
    wy = y;
    split = true;
  }

  final void row(float x, float y, float armA, float armB, float inverseMass) {
    ux = x;
    uy = y;
    sA = armA;
    sB = armB;
    mass = inverseMass > 0 ? 1 / inverseMass : 0;
    split = false;
  }

  final void angleRow() {
    split = false;
    ux = 0;
    uy = 0;
    sA = 1;
    sB = 1;
    mass = angular;
  }

  /** Makes the row along the line of the anchors, and returns their distance, m. */
  final float lengthRow() {
    float length = (float) Math.sqrt(dx * dx + dy * dy);
    if (length > 1e-9f) {
      direction(dx / length, dy / length);
    } else {
      direction(1, 0);
    }
    return length;
  }

  final void direction(float x, float y) {
    split = false;
    ux = x;
    uy = y;
    sA = (rAx + dx) * y - (rAy + dy) * x;
    sB = rBx * y - rBy * x;
    float inverse = massesAlong(x, y) + iA * sA * sA + iB * sB * sB;
    mass = inverse > 0 ? 1 / inverse : 0;
  }

  /** Returns the sum of the bodies' inverse masses along a unit vector, 1/kg. */
  final float massesAlong(float x, float y) {
    return locked ? (mAx + mBx) * (x * x) + (mAy + mBy) * (y * y) : mA + mB;
  }

  /** Returns the mean of these sums over all directions, 1/kg. */
  final float meanOfMasses() {
    return locked ? 0.5f * ((mAx + mBx) + (mAy + mBy)) : mA + mB;
  }

  /** Returns the inverse masses of both ends of a row with a direction of A of its own, 1/kg. */
  final float massesAlong(float backX, float backY, float x, float y) {
    return locked
        ? (mAx * (backX * backX) + mAy * (backY * backY)) + (mBx * (x * x) + mBy * (y * y))
        : mA * (backX * backX + backY * backY) + mB * (x * x + y * y);
  }

  final float rowSpeed() {
    if (split) {
      return (ux * v[b + VX] + uy * v[b + VY])
          - (wx * v[a + VX] + wy * v[a + VY])
          + (sB * v[b + W] - sA * v[a + W]);
    }
    return ux * (v[b + VX] - v[a + VX])
        + uy * (v[b + VY] - v[a + VY])
        + (sB * v[b + W] - sA * v[a + W]);
  }

  /**
   * Applies an impulse along the row. Writes nothing to what can't be moved: others may read it.
   */
  final void applyRowImpulse(float p) {
    if (mA != 0) {
      v[a + VX] -= mAx * p * (split ? wx : ux);
      v[a + VY] -= mAy * p * (split ? wy : uy);
      v[a + W] -= iA * p * sA;
    }
    if (mB != 0) {
      v[b + VX] += mBx * p * ux;
      v[b + VY] += mBy * p * uy;
      v[b + W] += iB * p * sB;
    }
  }

  /** Applies an angular impulse. */
  final void applyAngularImpulse(float p) {
    if (mA != 0) {
      v[a + W] -= iA * p;
    }
    if (mB != 0) {
      v[b + W] += iB * p;
    }
  }

  /**
   * Lets both impulses act at one point, B's anchor. At both ends of a gap they would be a torque
   * out of nothing, which made overloaded nets tremble: the net of 10,000 opened by up to 1.07 m
   * while it fell, and by 0.53 m like this (midway 0.62 m).
   */
  final void actAtOnePoint() {
    if (Math.abs(dx) + Math.abs(dy) <= MAX_ERROR) {
      rAx += dx;
      rAy += dy;
    }
  }

  /** Lets both impulses act at B's anchor, however far it is from A's. */
  final void actAtB() {
    rAx += dx;
    rAy += dy;
  }

  /** Finds K of a point at which both impulses act, 1/kg. */
  final void measurePointMass() {
    kxx = (mAx + mBx) + iA * rAy * rAy + iB * rBy * rBy;
    kxy = -iA * rAx * rAy - iB * rBx * rBy;
    kyy = (mAy + mBy) + iA * rAx * rAx + iB * rBx * rBx;
  }

  /**
   * Finds the determinant of K. Locks can leave one direction n in which the coordinates move, K =
   * k n n. Its inverse there is K / trace^2; so both axes change places, and the determinant is
   * that square.
   */
  final void invert() {
    determinant = kxx * kyy - kxy * kxy;
    float trace = kxx + kyy;
    if (locked && !(determinant > SINGULAR * trace * trace)) {
      float other = kxx;
      kxx = kyy;
      kyy = other;
      kxy = -kxy;
      determinant = trace * trace;
    }
  }

  /** Applies an impulse at the anchors. */
  final void applyImpulse(float px, float py) {
    if (mA != 0) {
      v[a + VX] -= mAx * px;
      v[a + VY] -= mAy * py;
      v[a + W] -= iA * (rAx * py - rAy * px);
    }
    if (mB != 0) {
      v[b + VX] += mBx * px;
      v[b + VY] += mBy * py;
      v[b + W] += iB * (rBx * py - rBy * px);
    }
  }

  /** Solves the row as a rigid one, and returns the impulse of this visit. */
  final float solveRigid(float error, float sum, boolean bias) {
    float p;
    if (bias) {
      float near = Math.max(-MAX_ERROR, Math.min(error, MAX_ERROR));
      p = -mass * massScale * (rowSpeed() + biasRate * near) - impulseScale * sum;
    } else {
      p = -mass * rowSpeed();
    }
    applyRowImpulse(p);
    return p;
  }

  /** Keeps a gap open, seen in the direction of the sign. Returns the impulse of this visit. */
  final float solveLimit(float gap, float sign, float sum, boolean bias) {
    boolean yields = gap <= 0 && bias;
    float scale = yields ? massScale : 1;
    float leak = yields ? impulseScale : 0;
    float p = -mass * scale * (sign * rowSpeed() + closingSpeed(gap, bias)) - leak * sum;
    p = Math.max(sum + p, 0) - sum;
    applyRowImpulse(sign * p);
    return p;
  }

  /** Returns the most speed with which a gap may close; what is closed too far has to open. */
  final float closingSpeed(float gap, boolean bias) {
    return closingSpeed(gap, bias, inverseH, biasRate);
  }

  static float closingSpeed(float gap, boolean bias, float inverseH, float biasRate) {
    return gap > 0 ? gap * inverseH : bias ? biasRate * gap : 0;
  }

  /**
   * Notes the spring of the present row.
   *
   * @param at place of the joint's record
   * @param m the mass by which it has its stiffness
   */
  final void noteSpring(int at, float m, float hertz, float zeta) {
    float oh = swing(hertz);
    float soft = oh * ((oh > SYMPLECTIC_LIMIT ? oh : 0) + 2 * zeta);
    float[] d = joints.data;
    d[at + SPRING_MASS] = m;
    d[at + SPRING_PULL] = oh * oh * inverseH;
    d[at + SPRING_SOFT] = soft;
    d[at + SPRING_SHARE] = mass > 0 ? 1 + soft * m / mass : 1;
  }

  /** Visits the spring that was noted, and returns the impulse of this visit. */
  final float solveNotedSpring(int k, float stretch, float sum) {
    float[] d = joints.data;
    int at = k * RECORD;
    float speed = d[at + SPRING_PULL] * stretch + d[at + SPRING_SOFT] * rowSpeed();
    float p = -(d[at + SPRING_MASS] * speed + sum) / d[at + SPRING_SHARE];
    p = sum + p - sum;
    applyRowImpulse(p);
    return p;
  }

  /** Returns the angle by which a spring of a frequency swings in a substep, o h, rad. */
  final float swing(float hertz) {
    return swing(hertz, h);
  }

  private static float swing(float hertz, float h) {
    return TWO_PI * Math.min(hertz * h, MAX_HERTZ_PER_RATE);
  }

  /**
   * Returns the energy that a spring holds, J. Symplectic steps don't keep that, but what they run
   * ahead by half a substep is taken off.
   *
   * @param m the mass by which it has its stiffness
   * @param speed that of its coordinate
   * @param h length of a substep, s
   */
  static double springEnergy(
      double m, double stretch, float hertz, double speed, float h, float inverseH) {
    float oh = swing(hertz, h);
    double pull = m * oh * oh * inverseH * inverseH * stretch;
    return 0.5 * pull * (oh > SYMPLECTIC_LIMIT ? stretch : stretch - h * speed);
  }

  /**
   * Returns an angle as the one within half a turn of another: a cut of half a turn does no work.
   */
  static double unwound(double angle, double from) {
    return angle - from > Math.PI
        ? angle - TWO_PI
        : from - angle > Math.PI ? angle + TWO_PI : angle;
  }

  /**
   * Visits a spring on the row, and returns the impulse of this visit.
   *
   * @param m the mass by which it has its stiffness
   */
  final float solveSpring(
      float m, float stretch, float hertz, float zeta, float sum, float maxForce) {
    float oh = swing(hertz);
    float soft = oh * ((oh > SYMPLECTIC_LIMIT ? oh : 0) + 2 * zeta);
    float share = mass > 0 ? 1 + soft * m / mass : 1;
    float p = -(m * (oh * oh * inverseH * stretch + soft * rowSpeed()) + sum) / share;
    float most = h * maxForce;
    p = Math.max(-most, Math.min(sum + p, most)) - sum;
    applyRowImpulse(p);
    return p;
  }

  /** Loads a joint: masses, lever arms and the gap of the anchors as they are now. */
  final void load(int k) {
    float[] d = joints.data;
    int at = k * RECORD;
    a = joints.bodyA[k];
    b = joints.bodyB[k];
    mA = d[at + MASS_A];
    mB = d[at + MASS_B];
    iA = d[at + INERTIA_A];
    iB = d[at + INERTIA_B];
    int locks = joints.locks[k];
    locked = locks != 0;
    mAx = (locks & JointRecords.LOCK_AX) == 0 ? mA : 0;
    mAy = (locks & JointRecords.LOCK_AY) == 0 ? mA : 0;
    mBx = (locks & JointRecords.LOCK_BX) == 0 ? mB : 0;
    mBy = (locks & JointRecords.LOCK_BY) == 0 ? mB : 0;
    angular = d[at + ANGULAR];
    if (joints.measured[k] != joints.poses()) {
      joints.measured[k] = joints.poses();
      measureArms(at);
      measure(k, at);
    }
    rAx = d[at + NOW_AX];
    rAy = d[at + NOW_AY];
    rBx = d[at + NOW_BX];
    rBy = d[at + NOW_BY];
    dx = d[at + NOW_DX];
    dy = d[at + NOW_DY];
  }

  /** Finds lever arms and the gap of the anchors, and notes them in the record at a place. */
  private void measureArms(int at) {
    float[] d = joints.data;
    float cA = v[a + COS];
    float nA = v[a + SIN];
    float cB = v[b + COS];
    float nB = v[b + SIN];
    rAx = cA * d[at + ARM_AX] - nA * d[at + ARM_AY];
    rAy = nA * d[at + ARM_AX] + cA * d[at + ARM_AY];
    rBx = cB * d[at + ARM_BX] - nB * d[at + ARM_BY];
    rBy = nB * d[at + ARM_BX] + cB * d[at + ARM_BY];
    dx = d[at + GAP_X] + (v[b + DX] - v[a + DX]) + (rBx - rAx);
    dy = d[at + GAP_Y] + (v[b + DY] - v[a + DY]) + (rBy - rAy);
    d[at + NOW_AX] = rAx;
    d[at + NOW_AY] = rAy;
    d[at + NOW_BX] = rBx;
    d[at + NOW_BY] = rBy;
    d[at + NOW_DX] = dx;
    d[at + NOW_DY] = dy;
  }

  /**
   * Notes what else follows from poses. Arms and gap are measured, and it may change them.
   *
   * @param at place of the joint's record
   */
  abstract void measure(int k, int at);

  /** Notes the present row, and its coordinate, from a place on. */
  final void noteRow(int at, float value) {
    float[] d = joints.data;
    d[at + ROW_X] = ux;
    d[at + ROW_Y] = uy;
    d[at + ROW_A] = sA;
    d[at + ROW_B] = sB;
    d[at + ROW_MASS] = mass;
    d[at + ROW_VALUE] = value;
  }

  /** Makes the row that was noted at a place, and returns its coordinate. */
  private float row(int at) {
    float[] d = joints.data;
    split = false;
    ux = d[at + ROW_X];
    uy = d[at + ROW_Y];
    sA = d[at + ROW_A];
    sB = d[at + ROW_B];
    mass = d[at + ROW_MASS];
    return d[at + ROW_VALUE];
  }

  /** Makes the row of a length or along an axis, and returns that length or the translation, m. */
  final float firstRow(int k) {
    return row(k * RECORD + FIRST_ROW);
  }

  /** Makes the row across an axis, turned left from it, and returns the error, m. */
  final float secondRow(int k) {
    return row(k * RECORD + SECOND_ROW);
  }

  /** Returns the joint's angle now, -pi to pi. */
  final float angle(int k) {
    int at = k * RECORD;
    if (joints.turned[k] != joints.poses()) {
      joints.turned[k] = joints.poses();
      joints.data[at + NOW_ANGLE] = measureAngle(at);
    }
    return joints.data[at + NOW_ANGLE];
  }

  private float measureAngle(int at) {
    float[] d = joints.data;
    float c = v[b + COS] * v[a + COS] + v[b + SIN] * v[a + SIN];
    float s = v[b + SIN] * v[a + COS] - v[b + COS] * v[a + SIN];
    return Trig.atan2(
        d[at + ANGLE_SIN] * c + d[at + ANGLE_COS] * s,
        d[at + ANGLE_COS] * c - d[at + ANGLE_SIN] * s);
  }

  /** Makes the row along the axis, and returns the translation, m. */
  final float axisRow(int k) {
    float[] d = joints.data;
    int at = k * RECORD;
    float c = v[a + COS];
    float s = v[a + SIN];
    direction(c * d[at + AXIS_X] - s * d[at + AXIS_Y], s * d[at + AXIS_X] + c * d[at + AXIS_Y]);
    return ux * dx + uy * dy;
  }

  /** Makes the row across the axis, turned left from it, and returns the error, m. */
  final float acrossRow(int k) {
    float[] d = joints.data;
    int at = k * RECORD;
    float c = v[a + COS];
    float s = v[a + SIN];
    direction(-(s * d[at + AXIS_X] + c * d[at + AXIS_Y]), c * d[at + AXIS_X] - s * d[at + AXIS_Y]);
    return ux * dx + uy * dy;
  }
}
