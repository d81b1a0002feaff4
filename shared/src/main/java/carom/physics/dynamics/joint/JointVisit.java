package carom.physics.dynamics.joint;

import static carom.physics.dynamics.joint.JointRecords.ANGLE_COS;
import static carom.physics.dynamics.joint.JointRecords.ANGLE_SIN;
import static carom.physics.dynamics.joint.JointRecords.ARM_AX;
import static carom.physics.dynamics.joint.JointRecords.ARM_AY;
import static carom.physics.dynamics.joint.JointRecords.ARM_BX;
import static carom.physics.dynamics.joint.JointRecords.ARM_BY;
import static carom.physics.dynamics.joint.JointRecords.AXIS_X;
import static carom.physics.dynamics.joint.JointRecords.AXIS_Y;
import static carom.physics.dynamics.joint.JointRecords.GAP_X;
import static carom.physics.dynamics.joint.JointRecords.GAP_Y;
import static carom.physics.dynamics.joint.JointRecords.INERTIA_A;
import static carom.physics.dynamics.joint.JointRecords.INERTIA_B;
import static carom.physics.dynamics.joint.JointRecords.MASS_A;
import static carom.physics.dynamics.joint.JointRecords.MASS_B;
import static carom.physics.dynamics.joint.JointRecords.RECORD;
import static carom.physics.dynamics.solver.SolverBodies.COS;
import static carom.physics.dynamics.solver.SolverBodies.DX;
import static carom.physics.dynamics.solver.SolverBodies.DY;
import static carom.physics.dynamics.solver.SolverBodies.SIN;
import static carom.physics.dynamics.solver.SolverBodies.VX;
import static carom.physics.dynamics.solver.SolverBodies.VY;
import static carom.physics.dynamics.solver.SolverBodies.W;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.solver.ContactSolver;
import carom.physics.math.Trig;

/**
 * What one worker needs to visit joints: the joint at hand, and the rows it consists of.
 *
 * <p><b>Rows.</b> Everything a joint does to one coordinate q (a length, a translation along an
 * axis u, an angle) is a row: with the speed {@code q' = u . (vB - vA) + sB wB - sA wA} an impulse
 * p changes velocities by {@code -p u / mA, -p sA / IA, p u / mB, p sB / IB}, hence q' by p / m
 * with {@code 1 / m = 1/mA + 1/mB + sA^2 / IA + sB^2 / IB}. For an angle u = 0 and sA = sB = 1; for
 * a direction u with the anchors' lever arms rA, rB and the gap d between them, {@code sA = (rA +
 * d) x u, sB = rB x u}. Two coordinates that share a lever arm (a point, or the perpendicular and
 * the angle of a slider) are one block with a 2x2 mass.
 *
 * <p><b>Held</b> coordinates (q = 0) are a rigid row. Before positions move, the error is fed back
 * into the velocity as in contacts (see {@link ContactSolver}), {@code p = -m M (q' + b q) - I P},
 * with the joint's own hertz; after that the row is solved again without (relax), so that no energy
 * enters.
 *
 * <p><b>Limits</b> are contacts: {@code P >= 0}; a gap may just be closed in a substep.
 *
 * <p><b>Motors</b> drive q' to a speed, {@code |P| <= h max}.
 *
 * <p><b>Springs</b> are forces, so they act once per substep and are left alone by relaxing. With k
 * = m o^2, c = 2 m z o (o = 2 pi hertz, z the damping ratio) and the velocity v' at the end of the
 * substep, the impulse of the substep is
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
 * With t = 0 the spring is symplectic: an undamped one keeps its amplitude for ever, its frequency
 * is exact up to (o h)^2 / 24. That is stable while o h is well below 2; springs with o h beyond
 * {@value #SYMPLECTIC_LIMIT} (19 hertz at 60 ticks and 4 substeps) use t = 1, implicit Euler, which
 * is stable always and damps by itself.
 *
 * <p><b>Coupled</b> coordinates are rows, too: of a gear {@code q = angleB - r angleA}, so u = 0,
 * sA = r, sB = 1; of a rack {@code q = u . (pB - pA) - r (angleA - angleB)} with an axis u of B,
 * since what rolls off is the turning of A seen from B; of a pulley {@code q = lengthA + r
 * lengthB}, a row with two directions: A moves along its rope and B along its own, r times. Angles
 * are counted over full turns, and the error is measured from poses, so that nothing drifts.
 *
 * <p>Lever arms turn with the bodies in each substep, other than those of contacts: a pendulum
 * turns much between two ticks. The row for the spring follows Erin Catto's GDC 2011 talk; written
 * from the algebra above.
 */
final class JointVisit {
  private static final float TWO_PI = 6.2831855f;

  /**
   * What is further apart than this, m, was torn: by a teleport or by absurd forces. It is drawn
   * together as if it were that far apart, at some 100 m/s, and each impulse acts at its own
   * anchor; at full speed and with arms that long, a chain of which one link is teleported by 80 m
   * blew up instead of closing.
   */
  private static final float TORN = 4;

  /** Beyond this angle per substep a spring is integrated implicitly. */
  private static final float SYMPLECTIC_LIMIT = 0.5f;

  private final JointRecords joints;

  // What the step is about.
  private JointStore store;
  private BodyStore bodies;
  private float[] v = new float[0];
  private float h;
  private float inverseH;
  private float biasRate;
  private float massScale;
  private float impulseScale;

  // The joint at hand: filled by bring, used by the rows.
  private int a;
  private int b;
  private float mA;
  private float mB;
  private float iA;
  private float iB;
  private float rAx;
  private float rAy;
  private float rBx;
  private float rBy;

  /** From A's anchor to B's. */
  private float dx;

  private float dy;

  /** The row at hand: direction, lever arms, mass. */
  private float ux;

  private float uy;
  private float sA;
  private float sB;
  private float mass;

  /** Of a pulley's row: direction for A, in which it is pushed back; u is that for B. */
  private float wx;

  private float wy;
  private boolean split;

  /** Visits these joints. */
  JointVisit(JointRecords joints) {
    this.joints = joints;
  }

  /** Begins a step; the softness is that of held coordinates. */
  void begin(
      JointStore jointStore,
      BodyStore bodyStore,
      float[] state,
      float substep,
      float rate,
      float scale,
      float leak) {
    store = jointStore;
    bodies = bodyStore;
    v = state;
    h = substep;
    inverseH = 1 / substep;
    biasRate = rate;
    massScale = scale;
    impulseScale = leak;
  }

  /** Applies the impulses remembered from the last substep, or the last step. */
  void warmStart(int from, int to) {
    JointStore j = store;
    for (int k = from; k < to; k++) {
      int slot = joints.joint[k];
      bring(k);
      float axial = axialImpulse(j, slot);
      switch (j.type[slot]) {
        case JointStore.DISTANCE -> {
          lengthRow();
          apply(axial + j.impulseX[slot]);
        }
        case JointStore.GEAR, JointStore.RACK, JointStore.PULLEY -> {
          coupledRow(k, slot);
          apply(axial + j.impulseX[slot]);
        }
        case JointStore.PRISMATIC -> {
          axisRow(k);
          apply(axial);
          acrossRow(k);
          apply(j.impulseX[slot]);
          turn(j.impulseY[slot]);
        }
        case JointStore.WHEEL -> {
          axisRow(k);
          apply(axial - j.motorImpulse[slot]);
          acrossRow(k);
          apply(j.impulseX[slot]);
          turn(j.motorImpulse[slot]);
        }
        default -> {
          boolean hinge = j.type[slot] == JointStore.REVOLUTE;
          if (hinge || (j.type[slot] == JointStore.WELD && j.hertz[slot] == 0)) {
            meet();
          }
          push(j.impulseX[slot], j.impulseY[slot]);
          turn(j.impulseW[slot] + axial);
        }
      }
    }
  }

  /**
   * Visits joints once.
   *
   * @param from the first
   * @param to behind the last
   * @param bias whether errors are corrected and springs act; else it is rigid
   */
  void solve(int from, int to, boolean bias) {
    JointStore j = store;
    for (int k = from; k < to; k++) {
      int slot = joints.joint[k];
      bring(k);
      switch (j.type[slot]) {
        case JointStore.REVOLUTE -> {
          int flags = j.flags[slot];
          if ((flags & (JointStore.LIMITED | JointStore.DRIVEN | JointStore.SPRUNG)) != 0) {
            angleRow();
            float angle = angle(k);
            coordinate(slot, j.winds(slot) ? (float) j.windB(slot, angle) : angle, bias);
          }
          point(slot, bias);
        }
        case JointStore.DISTANCE -> {
          float length = lengthRow();
          coordinate(slot, length, bias);
          if ((j.flags[slot] & (JointStore.LIMITED | JointStore.SPRUNG)) == 0) {
            j.impulseX[slot] += held(length - j.rest[slot], j.impulseX[slot], bias);
          }
        }
        case JointStore.GEAR, JointStore.RACK -> {
          float error = coupledRow(k, slot);
          j.impulseX[slot] += held(error, j.impulseX[slot], bias);
        }
        case JointStore.PULLEY -> {
          float length = coupledRow(k, slot);
          coordinate(slot, length, bias);
          if ((j.flags[slot] & (JointStore.LIMITED | JointStore.SPRUNG)) == 0) {
            j.impulseX[slot] += held(length - j.rest[slot], j.impulseX[slot], bias);
          }
        }
        case JointStore.PRISMATIC -> {
          float along = axisRow(k);
          coordinate(slot, along, bias);
          slider(k, slot, bias);
        }
        case JointStore.WELD -> {
          angleRow();
          float angular = j.angularHertz[slot];
          if (angular == 0) {
            j.impulseW[slot] += held(bias ? angle(k) : 0, j.impulseW[slot], bias);
          } else if (bias) {
            float old = j.impulseW[slot];
            j.impulseW[slot] +=
                spring(angle(k), angular, j.angularDamping[slot], old, Float.POSITIVE_INFINITY);
          }
          if (j.hertz[slot] == 0) {
            point(slot, bias);
          } else if (bias) {
            softPoint(slot, Float.POSITIVE_INFINITY);
          }
        }
        case JointStore.WHEEL -> {
          if ((j.flags[slot] & JointStore.DRIVEN) != 0) {
            angleRow();
            motor(slot);
          }
          float along = axisRow(k);
          springAndLimits(slot, along, bias);
          float across = acrossRow(k);
          j.impulseX[slot] += held(across, j.impulseX[slot], bias);
        }
        case JointStore.MOTOR -> {
          if (bias) {
            angleRow();
            float old = j.impulseW[slot];
            float most = j.maxTorque[slot];
            j.impulseW[slot] +=
                spring(angle(k), j.angularHertz[slot], j.angularDamping[slot], old, most);
            softPoint(slot, j.maxForce[slot]);
          }
        }
        default -> {
          if (bias) {
            softPoint(slot, j.maxForce[slot]);
          }
        }
      }
    }
  }

  /** What spring, motor and limits exert together, along the axis or about it. */
  private static float axialImpulse(JointStore j, int slot) {
    return j.springImpulse[slot]
        + j.motorImpulse[slot]
        + j.lowerImpulse[slot]
        - j.upperImpulse[slot];
  }

  /** Writes down what joints exerted. */
  void store(int from, int to) {
    JointStore j = store;
    for (int k = from; k < to; k++) {
      int slot = joints.joint[k];
      bring(k);
      float axial = axialImpulse(j, slot);
      float x = j.impulseX[slot];
      float y = j.impulseY[slot];
      float torque = j.impulseW[slot] + axial;
      switch (j.type[slot]) {
        case JointStore.DISTANCE -> {
          lengthRow();
          float p = axial + x;
          x = p * ux;
          y = p * uy;
          torque = 0;
        }
        case JointStore.GEAR -> {
          torque = x;
          x = 0;
        }
        case JointStore.RACK, JointStore.PULLEY -> {
          coupledRow(k, slot);
          float p = axial + x;
          x = p * ux;
          y = p * uy;
          torque = 0;
        }
        case JointStore.PRISMATIC, JointStore.WHEEL -> {
          boolean wheel = j.type[slot] == JointStore.WHEEL;
          torque = wheel ? j.motorImpulse[slot] : y;
          axial -= wheel ? torque : 0;
          axisRow(k);
          y = axial * uy + x * ux;
          x = axial * ux - x * uy;
        }
        default -> {}
      }
      if (!(Math.abs(x) + Math.abs(y) + Math.abs(torque) <= Float.MAX_VALUE)) {
        // Absurd masses and arms can overflow; what isn't a number must not be warm-started.
        j.forget(slot);
        continue;
      }
      j.forceX[slot] = x * inverseH;
      j.forceY[slot] = y * inverseH;
      j.torque[slot] = torque * inverseH;
    }
  }

  /** Loads a joint: masses, lever arms and the gap of the anchors as they are now. */
  private void bring(int k) {
    float[] d = joints.data;
    int at = k * RECORD;
    a = joints.bodyA[k];
    b = joints.bodyB[k];
    mA = d[at + MASS_A];
    mB = d[at + MASS_B];
    iA = d[at + INERTIA_A];
    iB = d[at + INERTIA_B];
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
  }

  /** The joint's angle now, -pi to pi. */
  private float angle(int k) {
    float[] d = joints.data;
    int at = k * RECORD;
    float c = v[b + COS] * v[a + COS] + v[b + SIN] * v[a + SIN];
    float s = v[b + SIN] * v[a + COS] - v[b + COS] * v[a + SIN];
    return Trig.atan2(
        d[at + ANGLE_SIN] * c + d[at + ANGLE_COS] * s,
        d[at + ANGLE_COS] * c - d[at + ANGLE_SIN] * s);
  }

  /** The row of a gear, a rack or a pulley; answers error, error, or length. */
  private float coupledRow(int k, int slot) {
    return switch (store.type[slot]) {
      case JointStore.GEAR -> gearRow(slot);
      case JointStore.RACK -> rackRow(k, slot);
      default -> pulleyRow(slot);
    };
  }

  private float gearRow(int slot) {
    JointStore j = store;
    float r = j.ratio[slot];
    row(0, 0, r, 1, iA * r * r + iB);
    double angleA = j.windA(slot, turned(j.bodyA[slot], a, j.baseAx[slot], j.baseAy[slot]));
    double angleB = j.windB(slot, turned(j.bodyB[slot], b, j.baseBx[slot], j.baseBy[slot]));
    return (float) (angleB - r * angleA);
  }

  /** How far a body has turned from a rotation, -pi to pi. */
  private float turned(int body, int offset, float fromCos, float fromSin) {
    float c = bodies.cos[body] * v[offset + COS] - bodies.sin[body] * v[offset + SIN];
    float s = bodies.sin[body] * v[offset + COS] + bodies.cos[body] * v[offset + SIN];
    return Trig.atan2(s * fromCos - c * fromSin, c * fromCos + s * fromSin);
  }

  private float rackRow(int k, int slot) {
    JointStore j = store;
    int body = j.bodyB[slot];
    float c = bodies.cos[body] * v[b + COS] - bodies.sin[body] * v[b + SIN];
    float s = bodies.sin[body] * v[b + COS] + bodies.cos[body] * v[b + SIN];
    float x = c * j.axisX[slot] - s * j.axisY[slot];
    float y = s * j.axisX[slot] + c * j.axisY[slot];
    float r = j.ratio[slot];
    float armA = rAx * y - rAy * x + r;
    float armB = (rBx - dx) * y - (rBy - dy) * x + r;
    row(x, y, armA, armB, mA + mB + iA * armA * armA + iB * armB * armB);
    double angle = -j.windB(slot, angle(k));
    return (float) (x * dx + y * dy - j.rest[slot] - r * angle);
  }

  /** The ropes run from points of the world to the anchors. */
  private float pulleyRow(int slot) {
    JointStore j = store;
    float r = j.ratio[slot];
    int one = j.bodyA[slot];
    int two = j.bodyB[slot];
    float ropeAx = bodies.x[one] - j.baseAx[slot] + (v[a + DX] + rAx);
    float ropeAy = bodies.y[one] - j.baseAy[slot] + (v[a + DY] + rAy);
    float ropeBx = bodies.x[two] - j.baseBx[slot] + (v[b + DX] + rBx);
    float ropeBy = bodies.y[two] - j.baseBy[slot] + (v[b + DY] + rBy);
    float lengthA = (float) Math.sqrt(ropeAx * ropeAx + ropeAy * ropeAy);
    float lengthB = (float) Math.sqrt(ropeBx * ropeBx + ropeBy * ropeBy);
    float inverseA = lengthA > 1e-9f ? 1 / lengthA : 0;
    float inverseB = lengthB > 1e-9f ? r / lengthB : 0;
    float x = ropeBx * inverseB;
    float y = ropeBy * inverseB;
    float backX = -ropeAx * inverseA;
    float backY = -ropeAy * inverseA;
    float armA = rAx * backY - rAy * backX;
    float armB = rBx * y - rBy * x;
    float inverse = mA * (backX * backX + backY * backY) + mB * (x * x + y * y);
    row(x, y, armA, armB, inverse + iA * armA * armA + iB * armB * armB);
    wx = backX;
    wy = backY;
    split = true;
    return lengthA + r * lengthB;
  }

  private void row(float x, float y, float armA, float armB, float inverseMass) {
    ux = x;
    uy = y;
    sA = armA;
    sB = armB;
    mass = inverseMass > 0 ? 1 / inverseMass : 0;
    split = false;
  }

  private void angleRow() {
    split = false;
    ux = 0;
    uy = 0;
    sA = 1;
    sB = 1;
    float turning = iA + iB;
    mass = turning > 0 ? 1 / turning : 0;
  }

  /** The row along the line of the anchors; answers their distance. */
  private float lengthRow() {
    float length = (float) Math.sqrt(dx * dx + dy * dy);
    if (length > 1e-9f) {
      direction(dx / length, dy / length);
    } else {
      direction(1, 0);
    }
    return length;
  }

  /** The row along the axis; answers the translation. */
  private float axisRow(int k) {
    float[] d = joints.data;
    int at = k * RECORD;
    float c = v[a + COS];
    float s = v[a + SIN];
    direction(c * d[at + AXIS_X] - s * d[at + AXIS_Y], s * d[at + AXIS_X] + c * d[at + AXIS_Y]);
    return ux * dx + uy * dy;
  }

  /** The row across the axis, turned left from it; answers the error. */
  private float acrossRow(int k) {
    float[] d = joints.data;
    int at = k * RECORD;
    float c = v[a + COS];
    float s = v[a + SIN];
    direction(-(s * d[at + AXIS_X] + c * d[at + AXIS_Y]), c * d[at + AXIS_X] - s * d[at + AXIS_Y]);
    return ux * dx + uy * dy;
  }

  private void direction(float x, float y) {
    split = false;
    ux = x;
    uy = y;
    sA = (rAx + dx) * y - (rAy + dy) * x;
    sB = rBx * y - rBy * x;
    float inverse = mA + mB + iA * sA * sA + iB * sB * sB;
    mass = inverse > 0 ? 1 / inverse : 0;
  }

  private float speed() {
    if (split) {
      return (ux * v[b + VX] + uy * v[b + VY])
          - (wx * v[a + VX] + wy * v[a + VY])
          + (sB * v[b + W] - sA * v[a + W]);
    }
    return ux * (v[b + VX] - v[a + VX])
        + uy * (v[b + VY] - v[a + VY])
        + (sB * v[b + W] - sA * v[a + W]);
  }

  /** An impulse along the row. Writes nothing to what can't be moved: others may be reading it. */
  private void apply(float p) {
    if (mA != 0) {
      v[a + VX] -= mA * p * (split ? wx : ux);
      v[a + VY] -= mA * p * (split ? wy : uy);
      v[a + W] -= iA * p * sA;
    }
    if (mB != 0) {
      v[b + VX] += mB * p * ux;
      v[b + VY] += mB * p * uy;
      v[b + W] += iB * p * sB;
    }
  }

  /** An angular impulse. */
  private void turn(float p) {
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
  private void meet() {
    if (Math.abs(dx) + Math.abs(dy) <= TORN) {
      rAx += dx;
      rAy += dy;
    }
  }

  /** An impulse at the anchors. */
  private void push(float px, float py) {
    if (mA != 0) {
      v[a + VX] -= mA * px;
      v[a + VY] -= mA * py;
      v[a + W] -= iA * (rAx * py - rAy * px);
    }
    if (mB != 0) {
      v[b + VX] += mB * px;
      v[b + VY] += mB * py;
      v[b + W] += iB * (rBx * py - rBy * px);
    }
  }

  /** Spring, motor and limits of the row's coordinate. */
  private void coordinate(int slot, float q, boolean bias) {
    if ((store.flags[slot] & JointStore.DRIVEN) != 0) {
      motor(slot);
    }
    springAndLimits(slot, q, bias);
  }

  private void springAndLimits(int slot, float q, boolean bias) {
    JointStore j = store;
    int flags = j.flags[slot];
    if (bias && (flags & JointStore.SPRUNG) != 0) {
      float old = j.springImpulse[slot];
      j.springImpulse[slot] +=
          spring(q - j.rest[slot], j.hertz[slot], j.damping[slot], old, Float.POSITIVE_INFINITY);
    }
    if ((flags & JointStore.LIMITED) != 0) {
      j.lowerImpulse[slot] += limit(q - j.lower[slot], 1, j.lowerImpulse[slot], bias);
      j.upperImpulse[slot] += limit(j.upper[slot] - q, -1, j.upperImpulse[slot], bias);
    }
  }

  private void motor(int slot) {
    JointStore j = store;
    float old = j.motorImpulse[slot];
    float most = h * j.motorMax[slot];
    float sum = old + mass * (j.motorSpeed[slot] - speed());
    sum = Math.max(-most, Math.min(sum, most));
    j.motorImpulse[slot] = sum;
    apply(sum - old);
  }

  /** Holds the row's coordinate; answers the impulse of this visit. */
  private float held(float error, float sum, boolean bias) {
    float p;
    if (bias) {
      float near = Math.max(-TORN, Math.min(error, TORN));
      p = -mass * massScale * (speed() + biasRate * near) - impulseScale * sum;
    } else {
      p = -mass * speed();
    }
    apply(p);
    return p;
  }

  /** Keeps a gap open, seen in the direction of the sign; answers the impulse of this visit. */
  private float limit(float gap, float sign, float sum, boolean bias) {
    float push = 0;
    float scale = 1;
    float leak = 0;
    if (gap > 0) {
      push = gap * inverseH;
    } else if (bias) {
      push = biasRate * gap;
      scale = massScale;
      leak = impulseScale;
    }
    float p = -mass * scale * (sign * speed() + push) - leak * sum;
    p = Math.max(sum + p, 0) - sum;
    apply(sign * p);
    return p;
  }

  /** One visit of a spring on the row; answers the impulse of this visit. */
  private float spring(float stretch, float hertz, float zeta, float sum, float maxForce) {
    float oh = TWO_PI * hertz * h;
    float soft = oh * ((oh > SYMPLECTIC_LIMIT ? oh : 0) + 2 * zeta);
    float p = -(mass * (oh * oh * inverseH * stretch + soft * speed()) + sum) / (1 + soft);
    float most = h * maxForce;
    p = Math.max(-most, Math.min(sum + p, most)) - sum;
    apply(p);
    return p;
  }

  /** Holds the anchors together. */
  private void point(int slot, boolean bias) {
    JointStore j = store;
    meet();
    float vx = v[b + VX] - v[b + W] * rBy - v[a + VX] + v[a + W] * rAy;
    float vy = v[b + VY] + v[b + W] * rBx - v[a + VY] - v[a + W] * rAx;
    float scale = 1;
    float leak = 0;
    if (bias) {
      float far = Math.abs(dx) + Math.abs(dy);
      float rate = far > TORN ? biasRate * TORN / far : biasRate;
      vx += rate * dx;
      vy += rate * dy;
      scale = massScale;
      leak = impulseScale;
    }
    float masses = mA + mB;
    float xx = masses + iA * rAy * rAy + iB * rBy * rBy;
    float xy = -iA * rAx * rAy - iB * rBx * rBy;
    float yy = masses + iA * rAx * rAx + iB * rBx * rBx;
    float determinant = xx * yy - xy * xy;
    float inverse = determinant > 0 ? scale / determinant : 0;
    float px = -inverse * (yy * vx - xy * vy) - leak * j.impulseX[slot];
    float py = -inverse * (xx * vy - xy * vx) - leak * j.impulseY[slot];
    j.impulseX[slot] += px;
    j.impulseY[slot] += py;
    push(px, py);
  }

  /** Draws the anchors together by a spring of limited force. */
  private void softPoint(int slot, float maxForce) {
    JointStore j = store;
    float vx = v[b + VX] - v[b + W] * rBy - v[a + VX] + v[a + W] * rAy;
    float vy = v[b + VY] + v[b + W] * rBx - v[a + VY] - v[a + W] * rAx;
    float oh = TWO_PI * j.hertz[slot] * h;
    float soft = oh * ((oh > SYMPLECTIC_LIMIT ? oh : 0) + 2 * j.damping[slot]);
    float wantX = oh * oh * inverseH * dx + soft * vx;
    float wantY = oh * oh * inverseH * dy + soft * vy;
    float masses = mA + mB;
    float xx = masses + iA * rAy * rAy + iB * rBy * rBy;
    float xy = -iA * rAx * rAy - iB * rBx * rBy;
    float yy = masses + iA * rAx * rAx + iB * rBx * rBx;
    float determinant = xx * yy - xy * xy;
    float inverse = determinant > 0 ? 1 / determinant : 0;
    float oldX = j.impulseX[slot];
    float oldY = j.impulseY[slot];
    float share = 1 / (1 + soft);
    float x = oldX - (inverse * (yy * wantX - xy * wantY) + oldX) * share;
    float y = oldY - (inverse * (xx * wantY - xy * wantX) + oldY) * share;
    float most = h * maxForce;
    float square = x * x + y * y;
    if (square > most * most) {
      float cut = most / (float) Math.sqrt(square);
      x *= cut;
      y *= cut;
    }
    j.impulseX[slot] = x;
    j.impulseY[slot] = y;
    push(x - oldX, y - oldY);
  }

  /** Holds a slider on its axis and from turning, both at once. */
  private void slider(int k, int slot, boolean bias) {
    JointStore j = store;
    float across = acrossRow(k);
    float first = speed();
    float second = v[b + W] - v[a + W];
    float scale = 1;
    float leak = 0;
    if (bias) {
      first += biasRate * across;
      second += biasRate * angle(k);
      scale = massScale;
      leak = impulseScale;
    }
    float xx = mA + mB + iA * sA * sA + iB * sB * sB;
    float xy = iA * sA + iB * sB;
    float yy = iA + iB;
    if (yy == 0) {
      yy = 1;
    }
    float determinant = xx * yy - xy * xy;
    float inverse = determinant > 0 ? scale / determinant : 0;
    float p = -inverse * (yy * first - xy * second) - leak * j.impulseX[slot];
    float torque = -inverse * (xx * second - xy * first) - leak * j.impulseY[slot];
    j.impulseX[slot] += p;
    j.impulseY[slot] += torque;
    apply(p);
    turn(torque);
  }
}
