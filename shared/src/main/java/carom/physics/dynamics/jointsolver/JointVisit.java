package carom.physics.dynamics.jointsolver;

import static carom.physics.dynamics.solverbody.SolverBodies.COS;
import static carom.physics.dynamics.solverbody.SolverBodies.DX;
import static carom.physics.dynamics.solverbody.SolverBodies.DY;
import static carom.physics.dynamics.solverbody.SolverBodies.SIN;
import static carom.physics.dynamics.solverbody.SolverBodies.VX;
import static carom.physics.dynamics.solverbody.SolverBodies.VY;
import static carom.physics.dynamics.solverbody.SolverBodies.W;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.math.Trig;

/**
 * Visits joints one by one, for one worker: loads a joint, makes the {@linkplain ConstraintRow
 * rows} it consists of, and solves them.
 *
 * <p>Each type of joint is a list of rows:
 *
 * <pre>
 *   revolute    angle: motor, spring, limits        then the point (2 x 2)
 *   distance    length: motor, spring, limits       or rigid
 *   ratchet     as revolute; angle: a limit at the last tooth
 *   prismatic   axis: motor, spring, limits         then across the axis and angle (2 x 2)
 *   weld        angle: rigid or spring              then the point: rigid or spring
 *   wheel       angle: motor; axis: spring, limits  then across the axis
 *   motor       angle: spring                       then the point: spring, both of limited force
 *   friction    angle: at rest                      then the point: at rest, both of limited force
 *   mouse                                           the point: spring of limited force
 *   gear, rack  the coupled coordinate, rigid
 *   pulley      the coupled length: limits, spring  or rigid
 * </pre>
 *
 * <p><b>Coupled</b> coordinates are rows, too: of a gear {@code q = angleB - r angleA}, so u = 0,
 * sA = r, sB = 1; of a rack {@code q = u . (pB - pA) - r (angleA - angleB)} with an axis u of B,
 * since what rolls off is the turning of A seen from B; of a pulley {@code q = lengthA + r
 * lengthB}, a row with two directions: A moves along its rope and B along its own, r times. Angles
 * are counted over full turns, and the error is measured from poses, so that nothing drifts.
 *
 * <p>Lever arms turn with the bodies in each substep, other than those of contacts: a pendulum
 * turns much between two ticks.
 *
 * <p><b>Length.</b> One idea: one joint is solved. It stays whole, because a type of joint is a
 * choice among the same rows, and all rows work on the joint that is loaded in the fields.
 */
final class JointVisit extends ConstraintRow {
  // What the step is about.
  private JointStore store;
  private BodyStore bodies;

  /** Visits these joints. */
  JointVisit(JointRecords joints) {
    super(joints);
  }

  /** Begins a step. The softness is that of rigid coordinates. */
  void begin(
      JointStore jointStore,
      BodyStore bodyStore,
      float[] state,
      float substep,
      float biasRate,
      float massScale,
      float impulseScale) {
    store = jointStore;
    bodies = bodyStore;
    beginRows(state, substep, biasRate, massScale, impulseScale);
  }

  /** Applies the impulses remembered from the last substep, or the last step. */
  void warmStart(int from, int to) {
    JointStore j = store;
    for (int k = from; k < to; k++) {
      int slot = joints.joint[k];
      load(k);
      float axial = axialImpulse(j, slot);
      switch (j.type[slot]) {
        case JointStore.DISTANCE -> {
          lengthRow();
          applyRowImpulse(axial + j.impulseX[slot]);
        }
        case JointStore.GEAR, JointStore.RACK, JointStore.PULLEY -> {
          coupledRow(k, slot);
          applyRowImpulse(axial + j.impulseX[slot]);
        }
        case JointStore.PRISMATIC -> {
          axisRow(k);
          applyRowImpulse(axial);
          acrossRow(k);
          applyRowImpulse(j.impulseX[slot]);
          applyAngularImpulse(j.impulseY[slot]);
        }
        case JointStore.WHEEL -> {
          axisRow(k);
          applyRowImpulse(axial - j.motorImpulse[slot]);
          acrossRow(k);
          applyRowImpulse(j.impulseX[slot]);
          applyAngularImpulse(j.motorImpulse[slot]);
        }
        default -> {
          boolean hinge = j.type[slot] == JointStore.REVOLUTE;
          if (hinge || (j.type[slot] == JointStore.WELD && j.hertz[slot] == 0)) {
            actAtOnePoint();
          }
          if (isFriction(slot)) {
            actAtB();
          }
          if (!joints.inTree[k]) {
            applyImpulse(j.impulseX[slot], j.impulseY[slot]);
          }
          applyAngularImpulse(j.impulseW[slot] + axial);
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
      load(k);
      switch (j.type[slot]) {
        case JointStore.REVOLUTE -> solveRevolute(k, slot, bias);
        case JointStore.DISTANCE -> {
          float length = lengthRow();
          solveCoordinate(slot, length, bias);
          int free = JointStore.LIMITED | JointStore.DRIVEN | JointStore.SPRUNG;
          if ((j.flags[slot] & free) == 0) {
            j.impulseX[slot] += solveRigid(length - j.rest[slot], j.impulseX[slot], bias);
          }
        }
        case JointStore.GEAR, JointStore.RACK -> {
          float error = coupledRow(k, slot);
          j.impulseX[slot] += solveRigid(error, j.impulseX[slot], bias);
        }
        case JointStore.PULLEY -> {
          float length = coupledRow(k, slot);
          solveCoordinate(slot, length, bias);
          if ((j.flags[slot] & (JointStore.LIMITED | JointStore.SPRUNG)) == 0) {
            j.impulseX[slot] += solveRigid(length - j.rest[slot], j.impulseX[slot], bias);
          }
        }
        case JointStore.PRISMATIC -> {
          float along = axisRow(k);
          solveCoordinate(slot, along, bias);
          solveSlider(k, slot, bias);
        }
        case JointStore.WELD -> solveWeld(k, slot, bias);
        case JointStore.WHEEL -> solveWheel(k, slot, bias);
        case JointStore.MOTOR -> solveMotorJoint(k, slot, bias);
        default -> {
          if (bias) {
            solveSoftPoint(slot, j.maxForce[slot]);
          }
        }
      }
    }
  }

  /** Visits a revolute joint: what acts about its axis, then its point. */
  private void solveRevolute(int k, int slot, boolean bias) {
    JointStore j = store;
    int flags = j.flags[slot];
    boolean ratchet = j.isRatchet(slot);
    if (ratchet || (flags & (JointStore.LIMITED | JointStore.DRIVEN | JointStore.SPRUNG)) != 0) {
      angleRow();
      float angle = angle(k);
      double turned = j.winds(slot) ? j.windB(slot, angle) : angle;
      solveCoordinate(slot, (float) turned, bias);
      if (ratchet) {
        solveRatchet(slot, turned, bias);
      }
    }
    if (!joints.inTree[k]) {
      solvePoint(slot, bias);
    }
  }

  /** Visits a weld: the angle, then the point, each rigid or by a spring. */
  private void solveWeld(int k, int slot, boolean bias) {
    JointStore j = store;
    angleRow();
    float angular = j.angularHertz[slot];
    if (angular == 0) {
      j.impulseW[slot] += solveRigid(bias ? angle(k) : 0, j.impulseW[slot], bias);
    } else if (bias) {
      float old = j.impulseW[slot];
      j.impulseW[slot] +=
          solveSpring(angle(k), angular, j.angularDamping[slot], old, Float.POSITIVE_INFINITY);
    }
    if (j.hertz[slot] == 0) {
      solvePoint(slot, bias);
    } else if (bias) {
      solveSoftPoint(slot, Float.POSITIVE_INFINITY);
    }
  }

  /** Visits a wheel: its motor, its spring along the axis, and what holds it on the axis. */
  private void solveWheel(int k, int slot, boolean bias) {
    JointStore j = store;
    if ((j.flags[slot] & JointStore.DRIVEN) != 0) {
      angleRow();
      solveMotor(slot);
    }
    float along = axisRow(k);
    solveSpringAndLimits(slot, along, bias);
    float across = acrossRow(k);
    j.impulseX[slot] += solveRigid(across, j.impulseX[slot], bias);
  }

  /** Visits a motor joint, or a friction joint, which has no springs. */
  private void solveMotorJoint(int k, int slot, boolean bias) {
    JointStore j = store;
    if (isFriction(slot)) {
      solveFriction(slot);
    } else if (bias) {
      angleRow();
      float old = j.impulseW[slot];
      float most = j.maxTorque[slot];
      j.impulseW[slot] +=
          solveSpring(angle(k), j.angularHertz[slot], j.angularDamping[slot], old, most);
      solveSoftPoint(slot, j.maxForce[slot]);
    }
  }

  /** Returns what spring, motor and limits exert together, along the axis or about it. */
  private static float axialImpulse(JointStore j, int slot) {
    return j.springImpulse[slot]
        + j.motorImpulse[slot]
        + j.lowerImpulse[slot]
        - j.upperImpulse[slot];
  }

  /** Stores what joints exerted. */
  void store(int from, int to) {
    JointStore j = store;
    for (int k = from; k < to; k++) {
      int slot = joints.joint[k];
      load(k);
      float axial = axialImpulse(j, slot);
      if (j.isRatchet(slot)) {
        j.passTeeth(slot, j.windB(slot, angle(k)));
      }
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

  /** Makes the row of a gear, a rack or a pulley. Returns its error, or the pulley's length. */
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

  /** Returns how far a body has turned from a rotation, -pi to pi. */
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

  /** Makes the row of a pulley, whose ropes run from points of the world to the anchors. */
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
    splitRow(backX, backY);
    return lengthA + r * lengthB;
  }

  /** Solves spring, motor and limits of the row's coordinate. */
  private void solveCoordinate(int slot, float q, boolean bias) {
    if ((store.flags[slot] & JointStore.DRIVEN) != 0) {
      solveMotor(slot);
    }
    solveSpringAndLimits(slot, q, bias);
  }

  private void solveSpringAndLimits(int slot, float q, boolean bias) {
    JointStore j = store;
    int flags = j.flags[slot];
    if (bias && (flags & JointStore.SPRUNG) != 0) {
      float old = j.springImpulse[slot];
      j.springImpulse[slot] +=
          solveSpring(
              q - j.rest[slot], j.hertz[slot], j.damping[slot], old, Float.POSITIVE_INFINITY);
    }
    if ((flags & JointStore.LIMITED) != 0) {
      j.lowerImpulse[slot] += solveLimit(q - j.lower[slot], 1, j.lowerImpulse[slot], bias);
      j.upperImpulse[slot] += solveLimit(j.upper[slot] - q, -1, j.upperImpulse[slot], bias);
    }
  }

  /** Keeps a ratchet from turning back behind the last tooth that it has passed. */
  private void solveRatchet(int slot, double angle, boolean bias) {
    JointStore j = store;
    double past = angle - j.tooth(slot);
    if (j.ratio[slot] > 0) {
      j.lowerImpulse[slot] += solveLimit((float) past, 1, j.lowerImpulse[slot], bias);
    } else {
      j.upperImpulse[slot] += solveLimit((float) -past, -1, j.upperImpulse[slot], bias);
    }
  }

  /** Returns whether a motor joint draws its body to rest instead of to a pose. */
  private boolean isFriction(int slot) {
    return store.type[slot] == JointStore.MOTOR && (store.flags[slot] & JointStore.DRIVEN) != 0;
  }

  /** Brings angle and point to rest relative to A, by limited torque and force. */
  private void solveFriction(int slot) {
    JointStore j = store;
    angleRow();
    float oldW = j.impulseW[slot];
    float mostW = h * j.maxTorque[slot];
    j.impulseW[slot] = Math.max(-mostW, Math.min(oldW - mass * rowSpeed(), mostW));
    applyAngularImpulse(j.impulseW[slot] - oldW);
    actAtB();
    float vx = v[b + VX] - v[b + W] * rBy - v[a + VX] + v[a + W] * rAy;
    float vy = v[b + VY] + v[b + W] * rBx - v[a + VY] - v[a + W] * rAx;
    float masses = mA + mB;
    float xx = masses + iA * rAy * rAy + iB * rBy * rBy;
    float xy = -iA * rAx * rAy - iB * rBx * rBy;
    float yy = masses + iA * rAx * rAx + iB * rBx * rBx;
    float determinant = xx * yy - xy * xy;
    float inverse = determinant > 0 ? 1 / determinant : 0;
    float oldX = j.impulseX[slot];
    float oldY = j.impulseY[slot];
    limitPoint(
        slot,
        oldX - inverse * (yy * vx - xy * vy),
        oldY - inverse * (xx * vy - xy * vx),
        j.maxForce[slot]);
    applyImpulse(j.impulseX[slot] - oldX, j.impulseY[slot] - oldY);
  }

  /** Stores the impulse of a point, cut to what a force may give in a substep. */
  private void limitPoint(int slot, float x, float y, float maxForce) {
    float most = h * maxForce;
    float square = x * x + y * y;
    float cut = square > most * most ? most / (float) Math.sqrt(square) : 1;
    store.impulseX[slot] = x * cut;
    store.impulseY[slot] = y * cut;
  }

  private void solveMotor(int slot) {
    JointStore j = store;
    float old = j.motorImpulse[slot];
    float most = h * j.motorMax[slot];
    float sum = old + mass * (j.motorSpeed[slot] - rowSpeed());
    sum = Math.max(-most, Math.min(sum, most));
    j.motorImpulse[slot] = sum;
    applyRowImpulse(sum - old);
  }

  /** Holds the anchors together. */
  private void solvePoint(int slot, boolean bias) {
    JointStore j = store;
    actAtOnePoint();
    float vx = v[b + VX] - v[b + W] * rBy - v[a + VX] + v[a + W] * rAy;
    float vy = v[b + VY] + v[b + W] * rBx - v[a + VY] - v[a + W] * rAx;
    float scale = 1;
    float leak = 0;
    if (bias) {
      float far = Math.abs(dx) + Math.abs(dy);
      float rate = far > MAX_ERROR ? biasRate * MAX_ERROR / far : biasRate;
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
    applyImpulse(px, py);
  }

  /** Draws the anchors together by a spring of limited force. */
  private void solveSoftPoint(int slot, float maxForce) {
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
    limitPoint(slot, x, y, maxForce);
    applyImpulse(j.impulseX[slot] - oldX, j.impulseY[slot] - oldY);
  }

  /** Holds a slider on its axis and from turning, both at once. */
  private void solveSlider(int k, int slot, boolean bias) {
    JointStore j = store;
    float across = acrossRow(k);
    float first = rowSpeed();
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
    applyRowImpulse(p);
    applyAngularImpulse(torque);
  }
}
