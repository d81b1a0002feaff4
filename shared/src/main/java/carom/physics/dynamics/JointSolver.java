package carom.physics.dynamics;

import static carom.physics.dynamics.SolverBodies.COS;
import static carom.physics.dynamics.SolverBodies.DX;
import static carom.physics.dynamics.SolverBodies.DY;
import static carom.physics.dynamics.SolverBodies.SIN;
import static carom.physics.dynamics.SolverBodies.STRIDE;
import static carom.physics.dynamics.SolverBodies.VX;
import static carom.physics.dynamics.SolverBodies.VY;
import static carom.physics.dynamics.SolverBodies.W;

import carom.physics.math.Trig;
import java.util.Arrays;

/**
 * Joints, solved by sequential impulses in the same substeps as contacts, before them.
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
 * <p><b>Colours.</b> As contacts, joints are given colours, greedily in the order of their slots:
 * those of one colour share no body that can be moved, so their order changes no bit. Colours are
 * solved one after the other, of each first the plain hinges, in lanes and by several threads (see
 * {@link PinSolver}), then the others one by one. A body with more than {@value #LAST_COLOUR}
 * joints spills into a last colour without pins. The colouring depends on the awake joints alone,
 * and is kept while these stay the same.
 *
 * <p>Lever arms turn with the bodies in each substep, other than those of contacts: a pendulum
 * turns much between two ticks. The row for the spring follows Erin Catto's GDC 2011 talk; written
 * from the algebra above.
 */
final class JointSolver {
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

  /** Held coordinates correct themselves at most this fraction as fast as the substeps. */
  private static final float MAX_HERTZ_PER_RATE = 0.25f;

  /** The last colour; it takes what found no other. */
  private static final int LAST_COLOUR = 63;

  /** Every colour has a group of pins, and one of other joints. */
  private static final int GROUPS = 2 * (LAST_COLOUR + 1);

  private final PinSolver pins;
  private JointStore store;
  private BodyStore bodies;
  private int count;
  private int capacity;

  /** The joints to solve and their groups, by ascending slot. */
  private int[] found = new int[0];

  private int[] group = new int[0];

  /** Colours that each slot of {@link SolverBodies} has. */
  private long[] taken = new long[0];

  /** Per group: its joints; and, while they are packed, where the next one goes. */
  private final int[] size = new int[GROUPS];

  private final int[] next = new int[GROUPS];

  /** Per colour: its first block of pins, and its first other joint; colours in use. */
  private final int[] pinStart = new int[LAST_COLOUR + 2];

  private final int[] start = new int[LAST_COLOUR + 2];
  private int colours;

  /** Which {@link JointStore#version} the colours are of; they are kept until it changes. */
  private int painted = -1;

  // Of the joints that are no pins, in the order of their colours:
  /** Slot of the joint; offsets of the two bodies in {@link SolverBodies#state}. */
  private int[] joint = new int[0];

  private int[] offsetA = new int[0];
  private int[] offsetB = new int[0];
  private float[] massA = new float[0];
  private float[] massB = new float[0];
  private float[] inertiaA = new float[0];
  private float[] inertiaB = new float[0];

  /** Lever arms when the step began, and B's centre relative to A's, m. */
  private float[] armAx = new float[0];

  private float[] armAy = new float[0];
  private float[] armBx = new float[0];
  private float[] armBy = new float[0];
  private float[] gapX = new float[0];
  private float[] gapY = new float[0];

  /** Axis, and the joint's angle as a rotation, when the step began. */
  private float[] axisX = new float[0];

  private float[] axisY = new float[0];
  private float[] angleCos = new float[0];
  private float[] angleSin = new float[0];

  /** The substep, and the softness of held coordinates. */
  private float h;

  private float inverseH;
  private float biasRate;
  private float massScale;
  private float impulseScale;

  // The joint at hand: filled by bring, used by the rows.
  private float[] v = new float[0];
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

  /**
   * Makes a solver.
   *
   * @param lanes kernels for pins, null for none
   * @param crew does pins
   */
  JointSolver(PinLanes lanes, Crew crew) {
    pins = new PinSolver(lanes, crew);
  }

  /** The number of joints to solve. */
  int count() {
    return count;
  }

  /** Collects, colours and packs the joints that can move something. */
  void prepare(
      JointStore j,
      BodyStore bodyStore,
      int[] activeIndex,
      Settings s,
      float substep,
      SolverBodies solverBodies) {
    store = j;
    bodies = bodyStore;
    v = solverBodies.state;
    h = substep;
    inverseH = 1 / substep;
    float omega = TWO_PI * Math.min(s.jointHertz(), MAX_HERTZ_PER_RATE / substep);
    float twiceZeta = 2 * s.jointDampingRatio();
    float soft = h * omega * (twiceZeta + h * omega);
    biasRate = omega / (twiceZeta + h * omega);
    massScale = soft / (1 + soft);
    impulseScale = 1 / (1 + soft);
    if (capacity < j.count()) {
      ensure(Math.max(j.count(), capacity * 2));
    }
    if (painted != j.version()) {
      painted = j.version();
      paint(activeIndex, solverBodies.count());
    }
    System.arraycopy(size, 0, next, 0, GROUPS);
    layOut();
    for (int i = 0; i < count; i++) {
      pack(found[i], group[i], activeIndex);
    }
    pins.ready();
  }

  /** Finds the joints to solve and gives each its colour. */
  private void paint(int[] activeIndex, int slots) {
    JointStore j = store;
    count = 0;
    colours = 0;
    Arrays.fill(size, 0);
    for (int slot = j.nextAwake(0); slot >= 0; slot = j.nextAwake(slot + 1)) {
      if (count == 0) {
        clearTaken(slots);
      }
      int one = j.bodyA[slot];
      int two = j.bodyB[slot];
      boolean heldA = one < 0 || bodies.invMass[one] == 0;
      boolean heldB = bodies.invMass[two] == 0;
      boolean gone = bodies.disabled(two) || (one >= 0 && bodies.disabled(one));
      if ((heldA && heldB) || gone) {
        j.forget(slot);
        continue;
      }
      // Slot 0 stands for what can't be moved, and takes no colour.
      int a = heldA ? 0 : activeIndex[one] + 1;
      int b = heldB ? 0 : activeIndex[two] + 1;
      int colour = Math.min(Long.numberOfTrailingZeros(~(taken[a] | taken[b])), LAST_COLOUR);
      long bit = 1L << colour;
      taken[a] |= bit;
      taken[b] |= bit;
      taken[0] = 0;
      colours = Math.max(colours, colour + 1);
      group[count] = 2 * colour + (colour < LAST_COLOUR && isPin(slot) ? 0 : 1);
      size[group[count]]++;
      found[count++] = slot;
    }
  }

  private void clearTaken(int slots) {
    if (taken.length < slots) {
      taken = new long[Math.max(slots, taken.length * 2)];
    }
    Arrays.fill(taken, 0, slots, 0);
  }

  private boolean isPin(int slot) {
    int more = JointStore.LIMITED | JointStore.DRIVEN | JointStore.SPRUNG;
    return store.type[slot] == JointStore.REVOLUTE && (store.flags[slot] & more) == 0;
  }

  /** Gives each group its places. */
  private void layOut() {
    pins.begin(v, biasRate, massScale, impulseScale);
    int others = 0;
    for (int c = 0; c < colours; c++) {
      pinStart[c] = pins.blocks();
      next[2 * c] = pins.reserve(next[2 * c]);
      start[c] = others;
      others += next[2 * c + 1];
      next[2 * c + 1] = start[c];
    }
    pinStart[colours] = pins.blocks();
    start[colours] = others;
  }

  /** Puts a joint to its place, with lever arms and gap as the step begins. */
  private void pack(int slot, int group, int[] activeIndex) {
    JointStore j = store;
    int one = j.bodyA[slot];
    int two = j.bodyB[slot];
    float cB = bodies.cos[two];
    float nB = bodies.sin[two];
    float bx = j.anchorBx[slot] - bodies.localX[two];
    float by = j.anchorBy[slot] - bodies.localY[two];
    b = (activeIndex[two] + 1) * STRIDE;
    mB = bodies.invMass[two];
    iB = bodies.invInertia[two];
    rBx = cB * bx - nB * by;
    rBy = nB * bx + cB * by;
    float cA = 1;
    float nA = 0;
    a = 0;
    mA = 0;
    iA = 0;
    rAx = 0;
    rAy = 0;
    if (one < 0) {
      dx = bodies.x[two] - j.anchorAx[slot];
      dy = bodies.y[two] - j.anchorAy[slot];
    } else {
      a = (activeIndex[one] + 1) * STRIDE;
      mA = bodies.invMass[one];
      iA = bodies.invInertia[one];
      cA = bodies.cos[one];
      nA = bodies.sin[one];
      float ax = j.anchorAx[slot] - bodies.localX[one];
      float ay = j.anchorAy[slot] - bodies.localY[one];
      rAx = cA * ax - nA * ay;
      rAy = nA * ax + cA * ay;
      dx = bodies.x[two] - bodies.x[one];
      dy = bodies.y[two] - bodies.y[one];
    }
    int k = next[group]++;
    if ((group & 1) == 0) {
      pins.pack(k, slot, a, b, mA, mB, iA, iB, j.impulseX[slot], j.impulseY[slot]);
      pins.place(k, rAx, rAy, rBx, rBy, dx, dy);
      return;
    }
    joint[k] = slot;
    offsetA[k] = a;
    offsetB[k] = b;
    massA[k] = mA;
    massB[k] = mB;
    inertiaA[k] = iA;
    inertiaB[k] = iB;
    armAx[k] = rAx;
    armAy[k] = rAy;
    armBx[k] = rBx;
    armBy[k] = rBy;
    gapX[k] = dx;
    gapY[k] = dy;
    axisX[k] = cA * j.axisX[slot] - nA * j.axisY[slot];
    axisY[k] = nA * j.axisX[slot] + cA * j.axisY[slot];
    float relativeCos = cB * cA + nB * nA;
    float relativeSin = nB * cA - cB * nA;
    angleCos[k] = relativeCos * j.refCos[slot] + relativeSin * j.refSin[slot];
    angleSin[k] = relativeSin * j.refCos[slot] - relativeCos * j.refSin[slot];
  }

  /** Applies the impulses remembered from the last substep, or the last step. */
  void warmStart() {
    for (int c = 0; c < colours; c++) {
      pins.warmStart(pinStart[c], pinStart[c + 1]);
      warmStart(start[c], start[c + 1]);
    }
  }

  /** One visit of each joint before bodies move: errors are corrected and springs act. */
  void push() {
    for (int c = 0; c < colours; c++) {
      pins.push(pinStart[c], pinStart[c + 1]);
      solve(start[c], start[c + 1], true);
    }
  }

  /** One visit of each joint after bodies moved, rigid. */
  void relax() {
    for (int c = 0; c < colours; c++) {
      pins.relax(pinStart[c], pinStart[c + 1]);
      solve(start[c], start[c + 1], false);
    }
  }

  private void warmStart(int from, int to) {
    JointStore j = store;
    for (int k = from; k < to; k++) {
      int slot = joint[k];
      bring(k);
      float axial =
          j.springImpulse[slot]
              + j.motorImpulse[slot]
              + j.lowerImpulse[slot]
              - j.upperImpulse[slot];
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

  private void solve(int from, int to, boolean bias) {
    JointStore j = store;
    for (int k = from; k < to; k++) {
      int slot = joint[k];
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

  /** Writes down what the joints exerted. */
  void store() {
    JointStore j = store;
    pins.store(j, inverseH);
    for (int k = 0; k < start[colours]; k++) {
      int slot = joint[k];
      bring(k);
      float axial =
          j.springImpulse[slot]
              + j.motorImpulse[slot]
              + j.lowerImpulse[slot]
              - j.upperImpulse[slot];
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
    a = offsetA[k];
    b = offsetB[k];
    mA = massA[k];
    mB = massB[k];
    iA = inertiaA[k];
    iB = inertiaB[k];
    float cA = v[a + COS];
    float nA = v[a + SIN];
    float cB = v[b + COS];
    float nB = v[b + SIN];
    rAx = cA * armAx[k] - nA * armAy[k];
    rAy = nA * armAx[k] + cA * armAy[k];
    rBx = cB * armBx[k] - nB * armBy[k];
    rBy = nB * armBx[k] + cB * armBy[k];
    dx = gapX[k] + (v[b + DX] - v[a + DX]) + (rBx - rAx);
    dy = gapY[k] + (v[b + DY] - v[a + DY]) + (rBy - rAy);
  }

  /** The joint's angle now, -pi to pi. */
  private float angle(int k) {
    float c = v[b + COS] * v[a + COS] + v[b + SIN] * v[a + SIN];
    float s = v[b + SIN] * v[a + COS] - v[b + COS] * v[a + SIN];
    return Trig.atan2(angleSin[k] * c + angleCos[k] * s, angleCos[k] * c - angleSin[k] * s);
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
    float c = v[a + COS];
    float s = v[a + SIN];
    direction(c * axisX[k] - s * axisY[k], s * axisX[k] + c * axisY[k]);
    return ux * dx + uy * dy;
  }

  /** The row across the axis, turned left from it; answers the error. */
  private float acrossRow(int k) {
    float c = v[a + COS];
    float s = v[a + SIN];
    direction(-(s * axisX[k] + c * axisY[k]), c * axisX[k] - s * axisY[k]);
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

  /** An impulse along the row. */
  private void apply(float p) {
    v[a + VX] -= mA * p * (split ? wx : ux);
    v[a + VY] -= mA * p * (split ? wy : uy);
    v[a + W] -= iA * p * sA;
    v[b + VX] += mB * p * ux;
    v[b + VY] += mB * p * uy;
    v[b + W] += iB * p * sB;
  }

  /** An angular impulse. */
  private void turn(float p) {
    v[a + W] -= iA * p;
    v[b + W] += iB * p;
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
    v[a + VX] -= mA * px;
    v[a + VY] -= mA * py;
    v[a + W] -= iA * (rAx * py - rAy * px);
    v[b + VX] += mB * px;
    v[b + VY] += mB * py;
    v[b + W] += iB * (rBx * py - rBy * px);
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

  private void ensure(int n) {
    capacity = n;
    found = new int[n];
    group = new int[n];
    joint = new int[n];
    offsetA = new int[n];
    offsetB = new int[n];
    massA = new float[n];
    massB = new float[n];
    inertiaA = new float[n];
    inertiaB = new float[n];
    armAx = new float[n];
    armAy = new float[n];
    armBx = new float[n];
    armBy = new float[n];
    gapX = new float[n];
    gapY = new float[n];
    axisX = new float[n];
    axisY = new float[n];
    angleCos = new float[n];
    angleSin = new float[n];
  }
}
