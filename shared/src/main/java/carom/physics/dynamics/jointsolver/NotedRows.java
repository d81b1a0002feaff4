package carom.physics.dynamics.jointsolver;

import static carom.physics.dynamics.domain.SolverBodies.VX;
import static carom.physics.dynamics.domain.SolverBodies.VY;
import static carom.physics.dynamics.domain.SolverBodies.W;
import static carom.physics.dynamics.jointsolver.JointRecords.ANGULAR;
import static carom.physics.dynamics.jointsolver.JointRecords.FIRST_ROW;
import static carom.physics.dynamics.jointsolver.JointRecords.INERTIA_A;
import static carom.physics.dynamics.jointsolver.JointRecords.INERTIA_B;
import static carom.physics.dynamics.jointsolver.JointRecords.MASS_A;
import static carom.physics.dynamics.jointsolver.JointRecords.MASS_B;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_ANGLE;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_BX;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_BY;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_DX;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_DY;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_TURNED;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_AX;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_AY;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_RIGID;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_SOFT;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_XX;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_XY;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_YY;
import static carom.physics.dynamics.jointsolver.JointRecords.RECORD;
import static carom.physics.dynamics.jointsolver.JointRecords.ROW_A;
import static carom.physics.dynamics.jointsolver.JointRecords.ROW_B;
import static carom.physics.dynamics.jointsolver.JointRecords.ROW_VALUE;
import static carom.physics.dynamics.jointsolver.JointRecords.ROW_X;
import static carom.physics.dynamics.jointsolver.JointRecords.ROW_Y;
import static carom.physics.dynamics.jointsolver.JointRecords.SPRING_MASS;
import static carom.physics.dynamics.jointsolver.JointRecords.SPRING_PULL;
import static carom.physics.dynamics.jointsolver.JointRecords.SPRING_SHARE;
import static carom.physics.dynamics.jointsolver.JointRecords.SPRING_SOFT;

import carom.physics.dynamics.joint.JointStore;

/**
 * Solves the rows that are visited most often, straight from the numbers of their records: points,
 * springs of angles and lengths, and limits of angles. {@link JointVisit} must have measured the
 * joint at its present poses. The operations are those of {@link ConstraintRow}, one for one.
 */
final class NotedRows {
  private final JointRecords joints;
  private JointStore store;
  private float[] v;
  private float h;
  private float inverseH;
  private float biasRate;
  private float massScale;
  private float impulseScale;

  /** Solves rows of these joints. */
  NotedRows(JointRecords joints) {
    this.joints = joints;
  }

  /** Begins a step. */
  void begin(
      JointStore jointStore, float[] state, float substep, float rate, float scale, float leak) {
    store = jointStore;
    v = state;
    h = substep;
    inverseH = 1 / substep;
    biasRate = rate;
    massScale = scale;
    impulseScale = leak;
  }

  /** Holds the anchors of a joint together. */
  void solvePoint(int k, int slot, boolean bias) {
    JointStore j = store;
    float[] s = v;
    float[] d = joints.data;
    int at = k * RECORD;
    int a = joints.bodyA[k];
    int b = joints.bodyB[k];
    float rAx = d[at + POINT_AX];
    float rAy = d[at + POINT_AY];
    float rBx = d[at + NOW_BX];
    float rBy = d[at + NOW_BY];
    float vx = s[b + VX] - s[b + W] * rBy - s[a + VX] + s[a + W] * rAy;
    float vy = s[b + VY] + s[b + W] * rBx - s[a + VY] - s[a + W] * rAx;
    float inverse = d[at + POINT_RIGID];
    float leak = 0;
    if (bias) {
      float dx = d[at + NOW_DX];
      float dy = d[at + NOW_DY];
      float far = Math.abs(dx) + Math.abs(dy);
      float rate =
          far > ConstraintRow.MAX_ERROR ? biasRate * ConstraintRow.MAX_ERROR / far : biasRate;
      vx += rate * dx;
      vy += rate * dy;
      inverse = d[at + POINT_SOFT];
      leak = impulseScale;
    }
    float xx = d[at + POINT_XX];
    float xy = d[at + POINT_XY];
    float yy = d[at + POINT_YY];
    float oldX = j.impulseX[slot];
    float oldY = j.impulseY[slot];
    float px = -inverse * (yy * vx - xy * vy) - leak * oldX;
    float py = -inverse * (xx * vy - xy * vx) - leak * oldY;
    j.impulseX[slot] = oldX + px;
    j.impulseY[slot] = oldY + py;
    float mA = d[at + MASS_A];
    float mB = d[at + MASS_B];
    int locks = joints.locks[k];
    if (mA != 0) {
      s[a + VX] -= (locks & JointRecords.LOCK_AX) == 0 ? mA * px : 0;
      s[a + VY] -= (locks & JointRecords.LOCK_AY) == 0 ? mA * py : 0;
      s[a + W] -= d[at + INERTIA_A] * (rAx * py - rAy * px);
    }
    if (mB != 0) {
      s[b + VX] += (locks & JointRecords.LOCK_BX) == 0 ? mB * px : 0;
      s[b + VY] += (locks & JointRecords.LOCK_BY) == 0 ? mB * py : 0;
      s[b + W] += d[at + INERTIA_B] * (rBx * py - rBy * px);
    }
  }

  /** Solves the spring about the axis of a hinge, which changes nothing but spins. */
  void solveAngleSpring(int k, int slot, boolean bias) {
    float[] s = v;
    float[] d = joints.data;
    int at = k * RECORD;
    int a = joints.bodyA[k] + W;
    int b = joints.bodyB[k] + W;
    if (bias) {
      joints.stretchX[k] = d[at + NOW_ANGLE] - store.rest[slot];
    }
    float p = solveSpring(k, slot, s[b] - s[a]);
    if (d[at + MASS_A] != 0) {
      s[a] -= d[at + INERTIA_A] * p;
    }
    if (d[at + MASS_B] != 0) {
      s[b] += d[at + INERTIA_B] * p;
    }
  }

  /** Keeps the angle of a hinge within its limits, which changes nothing but spins. */
  void solveAngleLimits(int k, int slot, boolean bias) {
    JointStore j = store;
    float q = joints.data[k * RECORD + NOW_TURNED];
    if (bias) {
      j.lowerImpulse[slot] += solveLimit(k, q - j.lower[slot], 1, j.lowerImpulse[slot], true);
    }
    j.upperImpulse[slot] += solveLimit(k, j.upper[slot] - q, -1, j.upperImpulse[slot], bias);
    if (!bias) {
      j.lowerImpulse[slot] += solveLimit(k, q - j.lower[slot], 1, j.lowerImpulse[slot], false);
    }
  }

  private float solveLimit(int k, float gap, float sign, float sum, boolean bias) {
    float[] s = v;
    float[] d = joints.data;
    int at = k * RECORD;
    int a = joints.bodyA[k] + W;
    int b = joints.bodyB[k] + W;
    boolean yields = gap <= 0 && bias;
    float scale = yields ? massScale : 1;
    float leak = yields ? impulseScale : 0;
    float target = ConstraintRow.closingSpeed(gap, bias, inverseH, biasRate);
    float p = -d[at + ANGULAR] * scale * (sign * (s[b] - s[a]) + target) - leak * sum;
    p = Math.max(sum + p, 0) - sum;
    if (p == 0) {
      return 0; // far from the limit
    }
    if (d[at + MASS_A] != 0) {
      s[a] -= d[at + INERTIA_A] * (sign * p);
    }
    if (d[at + MASS_B] != 0) {
      s[b] += d[at + INERTIA_B] * (sign * p);
    }
    return p;
  }

  /** Solves the spring of a distance joint. */
  void solveLengthSpring(int k, int slot, boolean bias) {
    float[] s = v;
    float[] d = joints.data;
    int at = k * RECORD;
    int row = at + FIRST_ROW;
    int a = joints.bodyA[k];
    int b = joints.bodyB[k];
    if (bias) {
      joints.stretchX[k] = d[row + ROW_VALUE] - store.rest[slot];
    }
    float ux = d[row + ROW_X];
    float uy = d[row + ROW_Y];
    float sA = d[row + ROW_A];
    float sB = d[row + ROW_B];
    float p = solveSpring(k, slot, speed(a, b, ux, uy, sA, sB));
    float mA = d[at + MASS_A];
    float mB = d[at + MASS_B];
    if (mA != 0) {
      s[a + VX] -= mA * p * ux;
      s[a + VY] -= mA * p * uy;
      s[a + W] -= d[at + INERTIA_A] * p * sA;
    }
    if (mB != 0) {
      s[b + VX] += mB * p * ux;
      s[b + VY] += mB * p * uy;
      s[b + W] += d[at + INERTIA_B] * p * sB;
    }
  }

  /** Adds up the impulse of a spring, and returns that of this visit. */
  private float solveSpring(int k, int slot, float speed) {
    float[] d = joints.data;
    int at = k * RECORD;
    float sum = store.springImpulse[slot];
    float wanted = d[at + SPRING_PULL] * joints.stretchX[k] + d[at + SPRING_SOFT] * speed;
    float p = -(d[at + SPRING_MASS] * wanted + sum) / d[at + SPRING_SHARE];
    p = sum + p - sum;
    store.springImpulse[slot] = sum + p;
    return p;
  }

  /** Returns the energy that the spring about the axis of a hinge holds, J. */
  double angleSpringEnergy(int k, int slot, boolean moved) {
    double q = joints.data[k * RECORD + NOW_ANGLE] - store.rest[slot];
    q = moved ? ConstraintRow.unwound(q, joints.stretchX[k]) : q;
    float speed = v[joints.bodyB[k] + W] - v[joints.bodyA[k] + W];
    return ConstraintRow.springEnergy(
        joints.data[k * RECORD + ANGULAR], q, store.hertz[slot], speed, h, inverseH);
  }

  /** Returns the energy that the spring of a distance joint holds, J. */
  double lengthSpringEnergy(int k, int slot) {
    float[] d = joints.data;
    int row = k * RECORD + FIRST_ROW;
    double q = d[row + ROW_VALUE] - store.rest[slot];
    float speed =
        speed(
            joints.bodyA[k],
            joints.bodyB[k],
            d[row + ROW_X],
            d[row + ROW_Y],
            d[row + ROW_A],
            d[row + ROW_B]);
    return ConstraintRow.springEnergy(
        d[k * RECORD + SPRING_MASS], q, store.hertz[slot], speed, h, inverseH);
  }

  private float speed(int a, int b, float ux, float uy, float sA, float sB) {
    float[] s = v;
    return ux * (s[b + VX] - s[a + VX])
        + uy * (s[b + VY] - s[a + VY])
        + (sB * s[b + W] - sA * s[a + W]);
  }
}
