package carom.physics.dynamics.solver;

import static carom.physics.dynamics.domain.SolverBodies.COS;
import static carom.physics.dynamics.domain.SolverBodies.DX;
import static carom.physics.dynamics.domain.SolverBodies.DY;
import static carom.physics.dynamics.domain.SolverBodies.SIN;
import static carom.physics.dynamics.domain.SolverBodies.STRIDE;
import static carom.physics.dynamics.domain.SolverBodies.VX;
import static carom.physics.dynamics.domain.SolverBodies.VY;
import static carom.physics.dynamics.domain.SolverBodies.W;
import static carom.physics.dynamics.solver.ContactBlocks.CROSS;
import static carom.physics.dynamics.solver.ContactBlocks.EXTRA;
import static carom.physics.dynamics.solver.ContactBlocks.FIRST;
import static carom.physics.dynamics.solver.ContactBlocks.FRICTION;
import static carom.physics.dynamics.solver.ContactBlocks.GAP;
import static carom.physics.dynamics.solver.ContactBlocks.INERTIA_A;
import static carom.physics.dynamics.solver.ContactBlocks.INERTIA_B;
import static carom.physics.dynamics.solver.ContactBlocks.INVERSE_NORMAL_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.LANES;
import static carom.physics.dynamics.solver.ContactBlocks.MASS_A;
import static carom.physics.dynamics.solver.ContactBlocks.MASS_B;
import static carom.physics.dynamics.solver.ContactBlocks.MOVING_SURFACE;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_IMPULSE;
import static carom.physics.dynamics.solver.ContactBlocks.NX;
import static carom.physics.dynamics.solver.ContactBlocks.NY;
import static carom.physics.dynamics.solver.ContactBlocks.RADIUS_A;
import static carom.physics.dynamics.solver.ContactBlocks.RADIUS_B;
import static carom.physics.dynamics.solver.ContactBlocks.RECORD;
import static carom.physics.dynamics.solver.ContactBlocks.ROLL;
import static carom.physics.dynamics.solver.ContactBlocks.ROLLING;
import static carom.physics.dynamics.solver.ContactBlocks.ROLLS;
import static carom.physics.dynamics.solver.ContactBlocks.ROLL_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.ROUNDED;
import static carom.physics.dynamics.solver.ContactBlocks.SECOND;
import static carom.physics.dynamics.solver.ContactBlocks.SEPARATION;
import static carom.physics.dynamics.solver.ContactBlocks.SOFTNESS;
import static carom.physics.dynamics.solver.ContactBlocks.SURFACE;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_IMPULSE;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.TOTAL_NORMAL;
import static carom.physics.dynamics.solver.ContactBlocks.TOTAL_TANGENT;
import static carom.physics.dynamics.solver.ContactBlocks.TWO;

import carom.physics.dynamics.domain.AxisLocks;
import carom.physics.dynamics.domain.SolverBodies;

/**
 * Solves contacts one by one: one visit of one contact per call. The reference for the vector
 * kernels ({@link ContactLanes}), which do the same operations in the same order and have the same
 * names. {@link ContactSolver} says what is solved, and why.
 *
 * <p>Threads may visit contacts of different domains, or of the same colour, at once.
 */
final class ScalarContacts {
  /** A speed beyond all others, m/s. */
  private static final float ANY_SPEED = 1e6f;

  private final ContactSolver solver;
  private final ContactBlocks blocks;

  /** State of the bodies: {@link SolverBodies#state}. */
  private float[] v = new float[0];

  private AxisLocks locks = new AxisLocks();

  /** Solves the contacts of these blocks with the constants of that solver. */
  ScalarContacts(ContactSolver solver, ContactBlocks blocks) {
    this.solver = solver;
    this.blocks = blocks;
  }

  /** Begins a step with these bodies. */
  void begin(SolverBodies bodies) {
    v = bodies.state;
    locks = bodies.locks;
  }

  /** Returns the sum of the inverse masses of a contact's bodies along a unit vector, 1/kg. */
  float inverseMasses(int lane, int at, float x, float y) {
    float massA = blocks.data[at + MASS_A];
    float massB = blocks.data[at + MASS_B];
    int a = blocks.bodyA[lane] / STRIDE;
    int b = blocks.bodyB[lane] / STRIDE;
    return locks.inverseMasses(a, massA, b, massB, x, y);
  }

  /**
   * Returns the speed along the normal that friction gives the bodies of a contact, for each unit
   * of its impulse, and the normal's impulse along the tangent; 0 where no axis is locked, 1/kg.
   */
  private float coupling(int lane, int at) {
    float[] d = blocks.data;
    int a = blocks.bodyA[lane] / STRIDE;
    int b = blocks.bodyB[lane] / STRIDE;
    return locks.coupling(a, d[at + MASS_A], b, d[at + MASS_B], d[at + NX], d[at + NY]);
  }

  /** Applies the impulses that a contact starts with. */
  void warmStart(int block, int i) {
    float[] d = blocks.data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int p = at + FIRST;
    float normal = d[p + NORMAL_IMPULSE];
    float tangent = d[p + TANGENT_IMPULSE];
    float turnA = d[p + NORMAL_ARM_A] * normal + d[p + TANGENT_ARM_A] * tangent;
    float turnB = d[p + NORMAL_ARM_B] * normal + d[p + TANGENT_ARM_B] * tangent;
    if ((blocks.traits[block] & TWO) != 0) {
      int q = at + SECOND;
      float normal2 = d[q + NORMAL_IMPULSE];
      float tangent2 = d[q + TANGENT_IMPULSE];
      turnA += d[q + NORMAL_ARM_A] * normal2 + d[q + TANGENT_ARM_A] * tangent2;
      turnB += d[q + NORMAL_ARM_B] * normal2 + d[q + TANGENT_ARM_B] * tangent2;
      normal += normal2;
      tangent += tangent2;
    }
    if ((blocks.traits[block] & ROLLS) != 0) {
      float roll = blocks.extra[block * EXTRA + i + ROLL];
      turnA += roll;
      turnB += roll;
    }
    float wa = v[blocks.bodyA[lane] + W] - d[at + INERTIA_A] * turnA;
    float wb = v[blocks.bodyB[lane] + W] + d[at + INERTIA_B] * turnB;
    applyImpulse(lane, at, normal, tangent, wa, wb);
  }

  /**
   * Visits a contact once: friction, then the normals with their springs. The gaps are those of the
   * last {@link #relax}.
   */
  void applyBiasedImpulses(int block, int i) {
    float[] d = blocks.data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int a = blocks.bodyA[lane];
    int b = blocks.bodyB[lane];
    float nx = d[at + NX];
    float ny = d[at + NY];
    float dvx = v[b + VX] - v[a + VX];
    float dvy = v[b + VY] - v[a + VY];
    float normalSpeed = dvx * nx + dvy * ny;
    float tangentSpeed = dvy * nx - dvx * ny;
    float wa = v[a + W];
    float wb = v[b + W];
    float across = inverseMasses(lane, at, -ny, nx);
    float coupling = coupling(lane, at);
    float inertiaA = d[at + INERTIA_A];
    float inertiaB = d[at + INERTIA_B];
    int trait = blocks.traits[block];
    if ((trait & MOVING_SURFACE) != 0) {
      tangentSpeed += blocks.extra[block * EXTRA + i + SURFACE];
    }
    if ((trait & ROLLS) != 0) {
      float turn = solveRolling(block, i, wb - wa);
      wa -= inertiaA * turn;
      wb += inertiaB * turn;
    }
    int p = at + FIRST;
    float change = solveFriction(at, p, tangentSpeed, wa, wb);
    tangentSpeed += across * change;
    wa -= inertiaA * (d[p + TANGENT_ARM_A] * change);
    wb += inertiaB * (d[p + TANGENT_ARM_B] * change);
    float tangent = 0 + change; // -0 becomes 0, as in lanes
    float gap = d[p + GAP];
    float softness = solver.soft[trait & SOFTNESS] * inverseMasses(lane, at, nx, ny);
    float rate = solver.biasRate[trait & SOFTNESS];
    float old = d[p + NORMAL_IMPULSE];
    float normal;
    if ((trait & TWO) == 0) {
      if (coupling != 0) { // else -0 would become 0
        normalSpeed += coupling * tangent;
      }
      normal =
          solveNormal(
                  p, normalSpeed, wa, wb, bias(block, i, FIRST, gap, rate), gap > 0 ? 0 : softness)
              - old;
      wa -= inertiaA * (d[p + NORMAL_ARM_A] * normal);
      wb += inertiaB * (d[p + NORMAL_ARM_B] * normal);
    } else {
      int q = at + SECOND;
      change = solveFriction(at, q, tangentSpeed, wa, wb);
      wa -= inertiaA * (d[q + TANGENT_ARM_A] * change);
      wb += inertiaB * (d[q + TANGENT_ARM_B] * change);
      tangent += change;
      if (coupling != 0) { // else -0 would become 0
        normalSpeed += coupling * tangent;
      }
      float gap2 = d[q + GAP];
      float soft1 = gap > 0 ? 0 : softness;
      float soft2 = gap2 > 0 ? 0 : softness;
      float softCross = gap > 0 || gap2 > 0 ? 0 : softness * ContactSolver.COUPLING;
      float old2 = d[q + NORMAL_IMPULSE];
      solveNormalPair(
          at,
          normalSpeed,
          wa,
          wb,
          bias(block, i, FIRST, gap, rate),
          bias(block, i, SECOND, gap2, rate),
          soft1,
          soft2,
          softCross);
      normal = d[p + NORMAL_IMPULSE] - old;
      float normal2 = d[q + NORMAL_IMPULSE] - old2;
      wa -= inertiaA * (d[p + NORMAL_ARM_A] * normal + d[q + NORMAL_ARM_A] * normal2);
      wb += inertiaB * (d[p + NORMAL_ARM_B] * normal + d[q + NORMAL_ARM_B] * normal2);
      normal += normal2;
    }
    applyImpulse(lane, at, normal, tangent, wa, wb);
  }

  /** Visits a contact once after the bodies have moved: the normals, rigid, then friction. */
  void relax(int block, int i) {
    float[] d = blocks.data;
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    int a = blocks.bodyA[lane];
    int b = blocks.bodyB[lane];
    float nx = d[at + NX];
    float ny = d[at + NY];
    float dvx = v[b + VX] - v[a + VX];
    float dvy = v[b + VY] - v[a + VY];
    float normalSpeed = dvx * nx + dvy * ny;
    float tangentSpeed = dvy * nx - dvx * ny;
    float wa = v[a + W];
    float wb = v[b + W];
    float across = inverseMasses(lane, at, -ny, nx);
    float coupling = coupling(lane, at);
    float inertiaA = d[at + INERTIA_A];
    float inertiaB = d[at + INERTIA_B];
    int trait = blocks.traits[block];
    if ((trait & MOVING_SURFACE) != 0) {
      tangentSpeed += blocks.extra[block * EXTRA + i + SURFACE];
    }
    float motion = normalMotion(block, i);
    int p = at + FIRST;
    int q = at + SECOND;
    float gap = gap(p, motion, a, b);
    d[p + GAP] = gap;
    float old = d[p + NORMAL_IMPULSE];
    float normal;
    if ((trait & TWO) == 0) {
      normal = solveNormal(p, normalSpeed, wa, wb, closing(block, i, FIRST, gap), 0) - old;
      wa -= inertiaA * (d[p + NORMAL_ARM_A] * normal);
      wb += inertiaB * (d[p + NORMAL_ARM_B] * normal);
    } else {
      float gap2 = gap(q, motion, a, b);
      d[q + GAP] = gap2;
      float old2 = d[q + NORMAL_IMPULSE];
      float bias = closing(block, i, FIRST, gap);
      float bias2 = closing(block, i, SECOND, gap2);
      solveNormalPair(at, normalSpeed, wa, wb, bias, bias2, 0, 0, 0);
      normal = d[p + NORMAL_IMPULSE] - old;
      float normal2 = d[q + NORMAL_IMPULSE] - old2;
      wa -= inertiaA * (d[p + NORMAL_ARM_A] * normal + d[q + NORMAL_ARM_A] * normal2);
      wb += inertiaB * (d[p + NORMAL_ARM_B] * normal + d[q + NORMAL_ARM_B] * normal2);
      normal += normal2;
    }
    if (coupling != 0) { // else -0 would become 0
      tangentSpeed += coupling * normal;
    }
    float change = solveFriction(at, p, tangentSpeed, wa, wb);
    tangentSpeed += across * change;
    wa -= inertiaA * (d[p + TANGENT_ARM_A] * change);
    wb += inertiaB * (d[p + TANGENT_ARM_B] * change);
    float tangent = 0 + change; // -0 becomes 0, as in lanes
    if ((trait & TWO) != 0) {
      change = solveFriction(at, q, tangentSpeed, wa, wb);
      wa -= inertiaA * (d[q + TANGENT_ARM_A] * change);
      wb += inertiaB * (d[q + TANGENT_ARM_B] * change);
      tangent += change;
      addToTotals(q);
    }
    if ((trait & ROLLS) != 0) {
      float turn = solveRolling(block, i, wb - wa);
      wa -= inertiaA * turn;
      wb += inertiaB * turn;
    }
    addToTotals(p);
    applyImpulse(lane, at, normal, tangent, wa, wb);
  }

  /** Returns the speed at which a gap may close in the next substep, m/s. */
  float closing(int block, int i, int point, float gap) {
    float bias = gap > 0 ? gap * solver.inverseH : 0;
    return solver.isFree(block, i) ? freeBias(block * LANES + i, point, bias, true) : bias;
  }

  /**
   * Returns the bias of a point that impacts alone answer. What parts after one isn't pushed: it
   * would be lifted without losing speed. A gap that is about to bounce may close at any speed in
   * the next substep: the impact comes first.
   *
   * @param bias what it is otherwise, m/s
   * @param rigid whether the bias is that of relaxing
   */
  float freeBias(int lane, int point, float bias, boolean rigid) {
    float speed = normalSpeed(lane, point);
    if (rigid) {
      return bias > 0 && -speed > solver.threshold ? ANY_SPEED : bias;
    }
    return bias < 0 && speed > solver.threshold ? 0 : bias;
  }

  void addToTotals(int p) {
    blocks.data[p + TOTAL_NORMAL] += blocks.data[p + NORMAL_IMPULSE];
    blocks.data[p + TOTAL_TANGENT] += blocks.data[p + TANGENT_IMPULSE];
  }

  /** Solves friction at a point, and returns the change of its impulse. */
  private float solveFriction(int at, int p, float tangentSpeed, float wa, float wb) {
    float[] d = blocks.data;
    float limit = d[at + FRICTION] * d[p + NORMAL_IMPULSE];
    float old = d[p + TANGENT_IMPULSE];
    float sum =
        old
            - d[p + TANGENT_MASS]
                * (tangentSpeed + (wb * d[p + TANGENT_ARM_B] - wa * d[p + TANGENT_ARM_A]));
    sum = sum < limit ? sum : limit;
    sum = sum > -limit ? sum : -limit;
    d[p + TANGENT_IMPULSE] = sum;
    return sum - old;
  }

  /** Solves rolling resistance, and returns the change of its impulse. */
  private float solveRolling(int block, int i, float w) {
    int at = block * RECORD + i;
    int more = block * EXTRA + i;
    float load = blocks.data[at + FIRST + NORMAL_IMPULSE];
    if ((blocks.traits[block] & TWO) != 0) {
      load += blocks.data[at + SECOND + NORMAL_IMPULSE];
    }
    float limit = blocks.extra[more + ROLLING] * load;
    float old = blocks.extra[more + ROLL];
    float sum = Math.max(-limit, Math.min(old - blocks.extra[more + ROLL_MASS] * w, limit));
    blocks.extra[more + ROLL] = sum;
    return sum - old;
  }

  /**
   * Returns the share of a push that contacts of locked bodies take. A body that can only slide
   * past a slight slope would have to go far and fast to get out of the overlap; so it goes as fast
   * as it would be pushed without locks.
   *
   * @return 1 where no axis is locked
   */
  private float share(int block, int i) {
    int lane = block * LANES + i;
    int at = block * RECORD + i;
    float[] d = blocks.data;
    if (!locks.isEither(blocks.bodyA[lane] / STRIDE, blocks.bodyB[lane] / STRIDE)) {
      return 1;
    }
    float share = locks.freedom(blocks.bodyA[lane] / STRIDE, d[at + NX], d[at + NY]);
    share = d[at + MASS_A] > 0 ? share : 0;
    if (d[at + MASS_B] > 0) {
      int b = blocks.bodyB[lane] / STRIDE;
      share = Math.max(share, locks.freedom(b, d[at + NX], d[at + NY]));
    }
    return (float) Math.sqrt(share);
  }

  /** Returns the speed at which a gap may close, or overlap is pushed apart (negative), m/s. */
  float bias(int block, int i, int point, float gap, float rate) {
    if (gap > 0) {
      return gap * solver.inverseH;
    }
    float overlap = gap + solver.slop;
    float apart = rate * (overlap < 0 ? overlap : 0);
    float bias = (apart > -solver.maxPushSpeed ? apart : -solver.maxPushSpeed) * share(block, i);
    return solver.isFree(block, i) ? freeBias(block * LANES + i, point, bias, false) : bias;
  }

  /** Solves the normal of a single point, and returns its impulse. */
  private float solveNormal(int p, float normalSpeed, float wa, float wb, float bias, float soft) {
    float[] d = blocks.data;
    float old = d[p + NORMAL_IMPULSE];
    float inverseMass = d[p + INVERSE_NORMAL_MASS];
    float q =
        normalSpeed
            + (wb * d[p + NORMAL_ARM_B] - wa * d[p + NORMAL_ARM_A])
            + bias
            - inverseMass * old;
    float sum = q < 0 ? -q / (inverseMass + soft) : 0;
    d[p + NORMAL_IMPULSE] = sum;
    return sum;
  }

  /** Solves the normals of both points together. */
  private void solveNormalPair(
      int at,
      float normalSpeed,
      float wa,
      float wb,
      float bias1,
      float bias2,
      float soft1,
      float soft2,
      float softCross) {
    float[] d = blocks.data;
    int p = at + FIRST;
    int q = at + SECOND;
    float old1 = d[p + NORMAL_IMPULSE];
    float old2 = d[q + NORMAL_IMPULSE];
    float k1 = d[p + INVERSE_NORMAL_MASS];
    float k2 = d[q + INVERSE_NORMAL_MASS];
    float k = d[at + CROSS];
    float speed1 = normalSpeed + (wb * d[p + NORMAL_ARM_B] - wa * d[p + NORMAL_ARM_A]);
    float speed2 = normalSpeed + (wb * d[q + NORMAL_ARM_B] - wa * d[q + NORMAL_ARM_A]);
    float q1 = speed1 + bias1 - k1 * old1 - k * old2;
    float q2 = speed2 + bias2 - k2 * old2 - k * old1;
    k1 += soft1;
    k2 += soft2;
    k += softCross;
    float scale = 1 / (k1 * k2 - k * k);
    float sum1 = (k * q2 - k2 * q1) * scale;
    float sum2 = (k * q1 - k1 * q2) * scale;
    if (!(sum1 >= 0) || !(sum2 >= 0)) {
      sum1 = q1 < 0 ? -q1 / k1 : 0;
      sum2 = 0;
      if (q2 + k * sum1 < 0) {
        sum1 = 0;
        sum2 = q2 < 0 ? -q2 / k2 : 0;
      }
    }
    d[p + NORMAL_IMPULSE] = sum1;
    d[q + NORMAL_IMPULSE] = sum2;
  }

  /** Returns the speed at which a point parts along the normal, m/s. */
  float normalSpeed(int lane, int point) {
    float[] d = blocks.data;
    int at = lane / LANES * RECORD + lane % LANES;
    int a = blocks.bodyA[lane];
    int b = blocks.bodyB[lane];
    float dvx = v[b + VX] - v[a + VX];
    float dvy = v[b + VY] - v[a + VY];
    float linear = dvx * d[at + NX] + dvy * d[at + NY];
    float armA = d[at + point + NORMAL_ARM_A];
    float armB = d[at + point + NORMAL_ARM_B];
    return linear + (v[b + W] * armB - v[a + W] * armA);
  }

  /**
   * Applies impulses along normal and tangent to B, and their opposites to A, and sets the new
   * angular velocities. Writes nothing to a body that can't be moved: other workers may read it.
   */
  void applyImpulse(int lane, int at, float normal, float tangent, float wa, float wb) {
    float[] d = blocks.data;
    float nx = d[at + NX];
    float ny = d[at + NY];
    float px = normal * nx - tangent * ny;
    float py = normal * ny + tangent * nx;
    float massA = d[at + MASS_A];
    float massB = d[at + MASS_B];
    int a = blocks.bodyA[lane];
    int b = blocks.bodyB[lane];
    if (massA != 0) {
      locks.apply(a / STRIDE, massA, -px, -py, v, a + VX);
      v[a + W] = wa;
    }
    if (massB != 0) {
      locks.apply(b / STRIDE, massB, px, py, v, b + VX);
      v[b + W] = wb;
    }
  }

  /**
   * Returns how far B moved away from A along the normal since the step began, rotation of lever
   * arms not counted. Rounding doesn't turn: the lowest point of a rolling disc is always another
   * one. So the anchor of a round part is a radius inside, {@code r - R n}, which makes a
   * difference of {@code R (cos - 1)}. Without it a fast disc would seem to lift off while it
   * turns, and sink in.
   */
  float normalMotion(int block, int i) {
    float[] d = blocks.data;
    int at = block * RECORD + i;
    int a = blocks.bodyA[block * LANES + i];
    int b = blocks.bodyB[block * LANES + i];
    float movedX = v[b + DX] - v[a + DX];
    float movedY = v[b + DY] - v[a + DY];
    float motion = movedX * d[at + NX] + movedY * d[at + NY];
    if ((blocks.traits[block] & ROUNDED) != 0) {
      int more = block * EXTRA + i;
      motion +=
          blocks.extra[more + RADIUS_A] * (v[a + COS] - 1)
              + blocks.extra[more + RADIUS_B] * (v[b + COS] - 1);
    }
    return motion;
  }

  /**
   * Returns the gap at a point now: that of the start, plus how far the two anchors moved and
   * turned apart. A lever arm r that turned by R moves along the normal by {@code (R r - r) . n =
   * (cos - 1) (r . n) + sin (r x n)}.
   */
  float gap(int p, float motion, int a, int b) {
    float[] d = blocks.data;
    float ca = v[a + COS] - 1;
    float sa = v[a + SIN];
    float cb = v[b + COS] - 1;
    float sb = v[b + SIN];
    float turnedA = ca * d[p + TANGENT_ARM_A] + sa * d[p + NORMAL_ARM_A];
    float turnedB = cb * d[p + TANGENT_ARM_B] + sb * d[p + NORMAL_ARM_B];
    return d[p + SEPARATION] + (motion + (turnedB - turnedA));
  }
}
