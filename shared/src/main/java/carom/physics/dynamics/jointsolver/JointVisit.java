package carom.physics.dynamics.jointsolver;

import static carom.physics.dynamics.domain.SolverBodies.COS;
import static carom.physics.dynamics.domain.SolverBodies.DX;
import static carom.physics.dynamics.domain.SolverBodies.DY;
import static carom.physics.dynamics.domain.SolverBodies.SIN;
import static carom.physics.dynamics.domain.SolverBodies.VX;
import static carom.physics.dynamics.domain.SolverBodies.VY;
import static carom.physics.dynamics.domain.SolverBodies.W;
import static carom.physics.dynamics.jointsolver.JointRecords.FIRST_ROW;
import static carom.physics.dynamics.jointsolver.JointRecords.NOW_TURNED;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_AX;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_AY;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_RIGID;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_SOFT;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_XX;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_XY;
import static carom.physics.dynamics.jointsolver.JointRecords.POINT_YY;
import static carom.physics.dynamics.jointsolver.JointRecords.SECOND_ROW;

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
 * <p><b>Order.</b> Before bodies move, joints are visited in the order of their colours and rows in
 * the order above; after they moved, all the other way round. There and back is a symmetric method,
 * whose errors die away one by one; twice there isn't, and in stars of joints errors chase each
 * other and grow. Chains and nets of hinges and rods are visited in one direction, which carries
 * loads along them twice as far.
 *
 * <p>Lever arms turn with the bodies in each substep, other than those of contacts: a pendulum
 * turns much between two ticks.
 */
final class JointVisit extends ConstraintRow {
  // What the step is about.
  private JointStore store;
  private BodyStore bodies;

  /** Solves the rows that are visited most often. */
  private final NotedRows noted;

  /** Visits these joints. */
  JointVisit(JointRecords joints) {
    super(joints);
    noted = new NotedRows(joints);
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
    noted.begin(jointStore, state, substep, biasRate, massScale, impulseScale);
    beginRows(state, substep, biasRate, massScale, impulseScale);
  }

  @Override
  void measure(int k, int at) {
    JointStore j = store;
    int slot = joints.joint[k];
    switch (j.type[slot]) {
      case JointStore.REVOLUTE -> {
        if ((j.flags[slot] & JointStore.SPRUNG) != 0) {
          angle(k);
          if (joints.poses() == 1) { // the first ones: it's the same in all others
            angleRow();
            noteSpring(at, mass, j.hertz[slot], j.damping[slot]);
          }
        } else if (joints.kind[k] == JointRecords.LIMITED) {
          float angle = angle(k);
          joints.data[at + NOW_TURNED] = (float) (j.winds(slot) ? j.windB(slot, angle) : angle);
        }
        if (!joints.inTree[k]) {
          measurePoint(at);
        }
      }
      case JointStore.DISTANCE -> {
        noteRow(at + FIRST_ROW, lengthRow());
        measureSpring(slot, at);
      }
      case JointStore.PRISMATIC, JointStore.WHEEL -> {
        noteRow(at + FIRST_ROW, axisRow(k));
        measureSpring(slot, at);
        noteRow(at + SECOND_ROW, acrossRow(k));
      }
      case JointStore.WELD -> {
        if (j.hertz[slot] == 0) {
          measurePoint(at);
        }
      }
      case JointStore.PULLEY -> {
        pulleyRow(slot);
        measureSpring(slot, at);
      }
      default -> {}
    }
  }

  private void measureSpring(int slot, int at) {
    if ((store.flags[slot] & JointStore.SPRUNG) != 0) {
      noteSpring(at, springMass(slot), store.hertz[slot], store.damping[slot]);
    }
  }

  /** Notes the inverse mass of the point at which both impulses of a rigid joint act. */
  private void measurePoint(int at) {
    actAtOnePoint();
    measurePointMass();
    invert();
    float[] d = joints.data;
    d[at + POINT_AX] = rAx;
    d[at + POINT_AY] = rAy;
    d[at + POINT_XX] = kxx;
    d[at + POINT_XY] = kxy;
    d[at + POINT_YY] = kyy;
    d[at + POINT_SOFT] = determinant > 0 ? massScale / determinant : 0;
    d[at + POINT_RIGID] = determinant > 0 ? 1 / determinant : 0;
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
          firstRow(k);
          applyRowImpulse(axial + j.impulseX[slot]);
        }
        case JointStore.GEAR, JointStore.RACK, JointStore.PULLEY -> {
          coupledRow(k, slot);
          applyRowImpulse(axial + j.impulseX[slot]);
        }
        case JointStore.PRISMATIC -> {
          firstRow(k);
          applyRowImpulse(axial);
          secondRow(k);
          applyRowImpulse(j.impulseX[slot]);
          applyAngularImpulse(j.impulseY[slot]);
        }
        case JointStore.WHEEL -> {
          firstRow(k);
          applyRowImpulse(axial - j.motorImpulse[slot]);
          secondRow(k);
          applyRowImpulse(j.impulseX[slot]);
          applyAngularImpulse(j.motorImpulse[slot]);
        }
        default -> {
          boolean hinge = j.type[slot] == JointStore.REVOLUTE;
          if (hinge || (j.type[slot] == JointStore.WELD && j.hertz[slot] == 0)) {
            actAtOnePoint();
          } else {
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

  /** Visits each joint once with bias: errors are corrected and springs act. */
  void push(int from, int to) {
    for (int k = from; k < to; k++) {
      visit(k, true, true);
    }
  }

  /** Visits each joint of plain groups once, rigid. */
  void relaxPlain(int from, int to) {
    for (int k = from; k < to; k++) {
      if (joints.plain[k]) {
        visit(k, true, false);
      }
    }
  }

  /** Visits each joint of all other groups once, rigid and the other way round. */
  void relax(int from, int to) {
    for (int k = to - 1; k >= from; k--) {
      if (!joints.plain[k]) {
        visit(k, false, false);
      }
    }
  }

  /** Visits the rows of a joint, the first one or the last one first. */
  void visit(int k, boolean forwards, boolean bias) {
    byte kind = joints.kind[k];
    if (kind == JointRecords.ANY || joints.measured[k] != joints.poses()) {
      load(k);
    }
    joints.torn[k] |= bias && joints.isTorn(k);
    if (kind == JointRecords.HINGE) {
      visitHinge(k, joints.joint[k], forwards, bias);
    } else if (kind == JointRecords.SPRING) {
      noted.solveLengthSpring(k, joints.joint[k], bias);
    } else if (kind == JointRecords.LIMITED) {
      visitLimited(k, joints.joint[k], forwards, bias);
    } else if (forwards) {
      visitForwards(k, joints.joint[k], bias);
    } else {
      visitBackwards(k, joints.joint[k], bias);
    }
  }

  private void visitHinge(int k, int slot, boolean forwards, boolean bias) {
    if (joints.sprung[k] && forwards) {
      noted.solveAngleSpring(k, slot, bias);
    }
    noted.solvePoint(k, slot, bias);
    if (joints.sprung[k] && !forwards) {
      noted.solveAngleSpring(k, slot, bias);
    }
  }

  private void visitLimited(int k, int slot, boolean forwards, boolean bias) {
    if (forwards) {
      noted.solveAngleLimits(k, slot, bias);
    }
    noted.solvePoint(k, slot, bias);
    if (!forwards) {
      noted.solveAngleLimits(k, slot, bias);
    }
  }

  private void visitForwards(int k, int slot, boolean bias) {
    JointStore j = store;
    switch (j.type[slot]) {
      case JointStore.REVOLUTE -> {
        solveAxis(k, slot, bias);
        if (!joints.inTree[k]) {
          noted.solvePoint(k, slot, bias);
        }
      }
      case JointStore.DISTANCE, JointStore.PULLEY -> solveLength(k, slot, bias);
      case JointStore.GEAR, JointStore.RACK -> solveCoupled(k, slot, bias);
      case JointStore.PRISMATIC -> {
        solveCoordinate(k, slot, firstRow(k), bias);
        solveSlider(k, slot, bias);
      }
      case JointStore.WELD -> {
        solveWeldAngle(k, slot, bias);
        solveWeldPoint(k, slot, bias);
      }
      case JointStore.WHEEL -> {
        solveWheelMotor(slot);
        solveSpringAndLimits(k, slot, firstRow(k), bias);
        solveAcross(k, slot, bias);
      }
      case JointStore.MOTOR -> {
        if (isFriction(slot)) {
          solveFrictionAngle(slot);
          solveFrictionPoint(slot);
        } else {
          solveMotorAngle(k, slot, bias);
          solveSoftPoint(k, slot, j.maxForce[slot], bias);
        }
      }
      default -> solveSoftPoint(k, slot, j.maxForce[slot], bias);
    }
  }

  private void visitBackwards(int k, int slot, boolean bias) {
    JointStore j = store;
    switch (j.type[slot]) {
      case JointStore.REVOLUTE -> {
        if (!joints.inTree[k]) {
          noted.solvePoint(k, slot, bias);
        }
        solveAxis(k, slot, bias);
      }
      case JointStore.DISTANCE, JointStore.PULLEY -> solveLength(k, slot, bias);
      case JointStore.GEAR, JointStore.RACK -> solveCoupled(k, slot, bias);
      case JointStore.PRISMATIC -> {
        solveSlider(k, slot, bias);
        solveCoordinate(k, slot, firstRow(k), bias);
      }
      case JointStore.WELD -> {
        solveWeldPoint(k, slot, bias);
        solveWeldAngle(k, slot, bias);
      }
      case JointStore.WHEEL -> {
        solveAcross(k, slot, bias);
        solveSpringAndLimits(k, slot, firstRow(k), bias);
        solveWheelMotor(slot);
      }
      case JointStore.MOTOR -> {
        if (isFriction(slot)) {
          solveFrictionPoint(slot);
          solveFrictionAngle(slot);
        } else {
          solveSoftPoint(k, slot, j.maxForce[slot], bias);
          solveMotorAngle(k, slot, bias);
        }
      }
      default -> solveSoftPoint(k, slot, j.maxForce[slot], bias);
    }
  }

  /** Visits what acts about the axis of a revolute joint. */
  private void solveAxis(int k, int slot, boolean bias) {
    JointStore j = store;
    boolean ratchet = j.isRatchet(slot);
    int acting = JointStore.LIMITED | JointStore.DRIVEN | JointStore.SPRUNG;
    if (!ratchet && (j.flags[slot] & acting) == 0) {
      return;
    }
    angleRow();
    float angle = angle(k);
    double turned = j.winds(slot) ? j.windB(slot, angle) : angle;
    if (bias) {
      solveCoordinate(k, slot, (float) turned, true);
    }
    if (ratchet) {
      solveRatchet(slot, turned, bias);
    }
    if (!bias) {
      solveCoordinate(k, slot, (float) turned, false);
    }
  }

  /** Visits a distance joint or a pulley. */
  private void solveLength(int k, int slot, boolean bias) {
    JointStore j = store;
    boolean pulley = j.type[slot] == JointStore.PULLEY;
    float length = pulley ? coupledRow(k, slot) : firstRow(k);
    solveCoordinate(k, slot, length, bias);
    int driven = pulley ? 0 : JointStore.DRIVEN;
    if ((j.flags[slot] & (JointStore.LIMITED | JointStore.SPRUNG | driven)) == 0) {
      j.impulseX[slot] += solveRigid(length - j.rest[slot], j.impulseX[slot], bias);
    }
  }

  private void solveCoupled(int k, int slot, boolean bias) {
    float error = coupledRow(k, slot);
    store.impulseX[slot] += solveRigid(error, store.impulseX[slot], bias);
  }

  private void solveWeldAngle(int k, int slot, boolean bias) {
    JointStore j = store;
    angleRow();
    float hertz = j.angularHertz[slot];
    float old = j.impulseW[slot];
    j.impulseW[slot] +=
        hertz == 0
            ? solveRigid(bias ? angle(k) : 0, old, bias)
            : solveSpring(
                mass,
                stretchedBy(k, bias),
                hertz,
                j.angularDamping[slot],
                old,
                Float.POSITIVE_INFINITY);
  }

  private void solveWeldPoint(int k, int slot, boolean bias) {
    if (store.hertz[slot] == 0) {
      noted.solvePoint(k, slot, bias);
    } else {
      solveSoftPoint(k, slot, Float.POSITIVE_INFINITY, bias);
    }
  }

  private void solveWheelMotor(int slot) {
    if ((store.flags[slot] & JointStore.DRIVEN) != 0) {
      angleRow();
      solveMotor(slot, store.motorSpeed[slot]);
    }
  }

  /** Holds a wheel on its axis. */
  private void solveAcross(int k, int slot, boolean bias) {
    float across = secondRow(k);
    store.impulseX[slot] += solveRigid(across, store.impulseX[slot], bias);
  }

  private void solveMotorAngle(int k, int slot, boolean bias) {
    JointStore j = store;
    angleRow();
    float old = j.impulseW[slot];
    j.impulseW[slot] +=
        solveSpring(
            mass,
            stretchedBy(k, bias),
            j.angularHertz[slot],
            j.angularDamping[slot],
            old,
            j.maxTorque[slot]);
  }

  /** Returns the angle by which a spring is stretched in this substep, rad. */
  private float stretchedBy(int k, boolean bias) {
    if (bias) {
      joints.stretchW[k] = angle(k);
    }
    return joints.stretchW[k];
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
          firstRow(k);
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
          firstRow(k);
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
    row(x, y, armA, armB, massesAlong(x, y) + iA * armA * armA + iB * armB * armB);
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
    float inverse = massesAlong(backX, backY, x, y);
    row(x, y, armA, armB, inverse + iA * armA * armA + iB * armB * armB);
    splitRow(backX, backY);
    return lengthA + r * lengthB;
  }

  /** Solves spring, motor and limits of the row's coordinate. */
  private void solveCoordinate(int k, int slot, float q, boolean bias) {
    boolean driven = (store.flags[slot] & JointStore.DRIVEN) != 0;
    if (driven && bias) {
      solveMotor(slot, possibleSpeed(slot, q, true));
    }
    solveSpringAndLimits(k, slot, q, bias);
    if (driven && !bias) {
      solveMotor(slot, possibleSpeed(slot, q, false));
    }
  }

  /**
   * Returns the speed of a motor, as far as limits let it. What it would exert against a limit that
   * holds would be taken up by that, but limits are soft: a strong motor would bend them by any
   * angle.
   */
  private float possibleSpeed(int slot, float q, boolean bias) {
    JointStore j = store;
    float speed = j.motorSpeed[slot];
    if ((j.flags[slot] & JointStore.LIMITED) != 0) {
      speed = Math.min(speed, closingSpeed(j.upper[slot] - q, bias));
      speed = Math.max(speed, -closingSpeed(q - j.lower[slot], bias));
    } else if (j.isRatchet(slot)) {
      float past = (float) (q - j.tooth(slot));
      speed =
          j.ratio[slot] > 0
              ? Math.max(speed, -closingSpeed(past, bias))
              : Math.min(speed, closingSpeed(-past, bias));
    }
    return speed;
  }

  private void solveSpringAndLimits(int k, int slot, float q, boolean bias) {
    boolean sprung = (store.flags[slot] & JointStore.SPRUNG) != 0;
    boolean limited = (store.flags[slot] & JointStore.LIMITED) != 0;
    if (sprung && bias) {
      joints.stretchX[k] = q - store.rest[slot];
      solveCoordinateSpring(k, slot);
    }
    if (limited) {
      solveLimits(slot, q, bias);
    }
    if (sprung && !bias) {
      solveCoordinateSpring(k, slot);
    }
  }

  private void solveCoordinateSpring(int k, int slot) {
    JointStore j = store;
    j.springImpulse[slot] += solveNotedSpring(k, joints.stretchX[k], j.springImpulse[slot]);
  }

  /**
   * Returns the mass by which a spring on the row has its stiffness. It mustn't change while bodies
   * turn: a stiffness that does makes energy. So an arm that turns against the row counts with half
   * its square, the mean over a turn: both of a rod's, and that of a wheel. And the arms are those
   * of the anchors, even where B is off its line: then the arm of the row changes with the length.
   */
  private float springMass(int slot) {
    boolean wheel = store.type[slot] == JointStore.WHEEL;
    boolean slider = store.type[slot] == JointStore.PRISMATIC;
    if (!wheel && !slider && store.type[slot] != JointStore.DISTANCE) {
      return mass;
    }
    float along = rAx * uy - rAy * ux;
    float armA = wheel || slider ? along * along : 0.5f * (rAx * rAx + rAy * rAy);
    float armB = slider ? sB * sB : 0.5f * (rBx * rBx + rBy * rBy);
    float inverse = meanOfMasses() + iA * armA + iB * armB;
    return inverse > 0 ? 1 / inverse : 0;
  }

  private void solveLimits(int slot, float q, boolean bias) {
    JointStore j = store;
    if (j.lower[slot] == j.upper[slot]) {
      float sum = j.lowerImpulse[slot] - j.upperImpulse[slot];
      sum += solveRigid(q - j.lower[slot], sum, bias);
      j.lowerImpulse[slot] = Math.max(sum, 0);
      j.upperImpulse[slot] = Math.max(-sum, 0);
      return;
    }
    if (bias) {
      j.lowerImpulse[slot] += solveLimit(q - j.lower[slot], 1, j.lowerImpulse[slot], true);
    }
    j.upperImpulse[slot] += solveLimit(j.upper[slot] - q, -1, j.upperImpulse[slot], bias);
    if (!bias) {
      j.lowerImpulse[slot] += solveLimit(q - j.lower[slot], 1, j.lowerImpulse[slot], false);
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

  /**
   * Returns the energy that a joint's springs hold, J.
   *
   * @param moved whether bodies have moved since springs were visited with bias
   */
  double springEnergy(int k, boolean moved) {
    JointStore j = store;
    int slot = joints.joint[k];
    byte kind = joints.kind[k];
    boolean isNoted = kind == JointRecords.HINGE || kind == JointRecords.SPRING;
    if (!isNoted || joints.measured[k] != joints.poses()) {
      load(k);
    }
    if (kind == JointRecords.HINGE) {
      return noted.angleSpringEnergy(k, slot, moved);
    } else if (kind == JointRecords.SPRING) {
      return noted.lengthSpringEnergy(k, slot);
    }
    double sum = 0;
    if ((j.flags[slot] & JointStore.SPRUNG) != 0) {
      double q = springCoordinate(k, slot) - j.rest[slot];
      q = moved && j.type[slot] == JointStore.REVOLUTE ? unwound(q, joints.stretchX[k]) : q;
      sum += heldBy(springMass(slot), q, j.hertz[slot], rowSpeed());
    } else if (j.hertz[slot] > 0) {
      actAtB();
      float vx = v[b + VX] - v[b + W] * rBy - v[a + VX] + v[a + W] * rAy;
      float vy = v[b + VY] + v[b + W] * rBx - v[a + VY] - v[a + W] * rAx;
      float inverse = meanOfMasses() + 0.5f * iA * (rAx * rAx + rAy * rAy);
      inverse += 0.5f * iB * (rBx * rBx + rBy * rBy);
      float mean = inverse > 0 ? 1 / inverse : 0;
      sum += heldBy(mean, dx, j.hertz[slot], vx) + heldBy(mean, dy, j.hertz[slot], vy);
    }
    if (j.angularHertz[slot] > 0) {
      angleRow();
      double q = moved ? unwound(angle(k), joints.stretchW[k]) : angle(k);
      sum += heldBy(mass, q, j.angularHertz[slot], rowSpeed());
    }
    return sum;
  }

  /** Makes the row of a spring's coordinate, and returns that. */
  private double springCoordinate(int k, int slot) {
    switch (store.type[slot]) {
      case JointStore.REVOLUTE -> {
        angleRow();
        return store.winds(slot) ? store.windB(slot, angle(k)) : angle(k);
      }
      case JointStore.PULLEY -> {
        return pulleyRow(slot);
      }
      default -> {
        return firstRow(k);
      }
    }
  }

  private double heldBy(double m, double stretch, float hertz, double speed) {
    double oh = swing(hertz);
    double pull = m * oh * oh * inverseH * inverseH * stretch;
    return 0.5 * pull * (oh > SYMPLECTIC_LIMIT ? stretch : stretch - h * speed);
  }

  /** Brings the angle to rest relative to A, by limited torque. */
  private void solveFrictionAngle(int slot) {
    JointStore j = store;
    angleRow();
    float oldW = j.impulseW[slot];
    float mostW = h * j.maxTorque[slot];
    j.impulseW[slot] = Math.max(-mostW, Math.min(oldW - mass * rowSpeed(), mostW));
    applyAngularImpulse(j.impulseW[slot] - oldW);
  }

  /** Brings the point to rest relative to A, by limited force. */
  private void solveFrictionPoint(int slot) {
    JointStore j = store;
    actAtB();
    float vx = v[b + VX] - v[b + W] * rBy - v[a + VX] + v[a + W] * rAy;
    float vy = v[b + VY] + v[b + W] * rBx - v[a + VY] - v[a + W] * rAx;
    measurePointMass();
    invert();
    float inverse = determinant > 0 ? 1 / determinant : 0;
    float oldX = j.impulseX[slot];
    float oldY = j.impulseY[slot];
    limitPoint(
        slot,
        oldX - inverse * (kyy * vx - kxy * vy),
        oldY - inverse * (kxx * vy - kxy * vx),
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

  private void solveMotor(int slot, float speed) {
    JointStore j = store;
    float old = j.motorImpulse[slot];
    float most = h * j.motorMax[slot];
    float sum = old + mass * (speed - rowSpeed());
    sum = Math.max(-most, Math.min(sum, most));
    j.motorImpulse[slot] = sum;
    applyRowImpulse(sum - old);
  }

  /**
   * Draws the anchors together by a spring of limited force. Its stiffness is the same in all
   * directions, that of the mean effective mass, and both impulses act at B's anchor: so it pulls
   * straight, and neither turning nor energy comes out of nothing. With the effective mass of each
   * direction a soft weld between two small boxes made 750 times its energy.
   */
  private void solveSoftPoint(int k, int slot, float maxForce, boolean bias) {
    JointStore j = store;
    if (bias) {
      joints.stretchX[k] = dx;
      joints.stretchY[k] = dy;
    }
    actAtB();
    float vx = v[b + VX] - v[b + W] * rBy - v[a + VX] + v[a + W] * rAy;
    float vy = v[b + VY] + v[b + W] * rBx - v[a + VY] - v[a + W] * rAx;
    float oh = swing(j.hertz[slot]);
    float soft = oh * ((oh > SYMPLECTIC_LIMIT ? oh : 0) + 2 * j.damping[slot]);
    measurePointMass();
    float mean = kxx + kyy > 0 ? 2 / (kxx + kyy) : 0;
    float pull = mean * oh * oh * inverseH;
    float damp = mean * soft;
    float oldX = j.impulseX[slot];
    float oldY = j.impulseY[slot];
    float wantX = pull * joints.stretchX[k] + damp * vx + oldX;
    float wantY = pull * joints.stretchY[k] + damp * vy + oldY;
    float xx = 1 + damp * kxx;
    float xy = damp * kxy;
    float yy = 1 + damp * kyy;
    float inverse = 1 / (xx * yy - xy * xy);
    float x = oldX - inverse * (yy * wantX - xy * wantY);
    float y = oldY - inverse * (xx * wantY - xy * wantX);
    limitPoint(slot, x, y, maxForce);
    applyImpulse(j.impulseX[slot] - oldX, j.impulseY[slot] - oldY);
  }

  /** Holds a slider on its axis and from turning, both at once. */
  private void solveSlider(int k, int slot, boolean bias) {
    JointStore j = store;
    float across = secondRow(k);
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
    kxx = massesAlong(ux, uy) + iA * sA * sA + iB * sB * sB;
    kxy = iA * sA + iB * sB;
    kyy = iA + iB;
    if (kyy == 0) {
      kyy = 1;
    }
    invert();
    float inverse = determinant > 0 ? scale / determinant : 0;
    float p = -inverse * (kyy * first - kxy * second) - leak * j.impulseX[slot];
    float torque = -inverse * (kxx * second - kxy * first) - leak * j.impulseY[slot];
    j.impulseX[slot] += p;
    j.impulseY[slot] += torque;
    applyRowImpulse(p);
    applyAngularImpulse(torque);
  }
}
