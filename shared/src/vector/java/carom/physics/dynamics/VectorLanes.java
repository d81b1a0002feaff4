package carom.physics.dynamics;

import static carom.physics.dynamics.ContactSolver.AX;
import static carom.physics.dynamics.ContactSolver.AY;
import static carom.physics.dynamics.ContactSolver.BIAS_RATE;
import static carom.physics.dynamics.ContactSolver.BX;
import static carom.physics.dynamics.ContactSolver.BY;
import static carom.physics.dynamics.ContactSolver.CROSS;
import static carom.physics.dynamics.ContactSolver.FIRST;
import static carom.physics.dynamics.ContactSolver.FRICTION;
import static carom.physics.dynamics.ContactSolver.GAP;
import static carom.physics.dynamics.ContactSolver.INERTIA_A;
import static carom.physics.dynamics.ContactSolver.INERTIA_B;
import static carom.physics.dynamics.ContactSolver.LANES;
import static carom.physics.dynamics.ContactSolver.MASS_A;
import static carom.physics.dynamics.ContactSolver.MASS_B;
import static carom.physics.dynamics.ContactSolver.NORMAL;
import static carom.physics.dynamics.ContactSolver.NX;
import static carom.physics.dynamics.ContactSolver.NY;
import static carom.physics.dynamics.ContactSolver.RECORD;
import static carom.physics.dynamics.ContactSolver.ROUND_A;
import static carom.physics.dynamics.ContactSolver.ROUND_B;
import static carom.physics.dynamics.ContactSolver.SECOND;
import static carom.physics.dynamics.ContactSolver.SEPARATION;
import static carom.physics.dynamics.ContactSolver.SLIDE;
import static carom.physics.dynamics.ContactSolver.SOFT;
import static carom.physics.dynamics.ContactSolver.SOFT_CROSS;
import static carom.physics.dynamics.ContactSolver.SURFACE;
import static carom.physics.dynamics.ContactSolver.TANGENT;
import static carom.physics.dynamics.ContactSolver.TANGENT_MASS;
import static carom.physics.dynamics.ContactSolver.TOTAL;
import static carom.physics.dynamics.ContactSolver.YIELD;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The eight contacts of a block at once, with the Vector API: the same operations in the same order
 * as { link ContactSolver}'s, hence the same bits.
 *
 * <p>The bodies' velocities are first copied, one quantity for all lanes side by side, to a scratch
 * array that stays in the nearest cache; after that all work is on vectors. The methods are small
 * and pass each other arrays, never vectors, and call the Vector API without helpers in between: a
 * vector that crosses a call the JIT compiler didn't inline would be boxed (40 MB per step of the
 * 5,050-box pyramid, and no gain).
 */
final class VectorLanes extends ContactLanes {
  private static final VectorSpecies<Float> LANE = FloatVector.SPECIES_256;

  // Quantities of the scratch array.
  private static final int VAX = 0;
  private static final int VAY = VAX + LANES;
  private static final int WA = VAY + LANES;
  private static final int VBX = WA + LANES;
  private static final int VBY = VBX + LANES;
  private static final int WB = VBY + LANES;
  private static final int MOVED_X = WB + LANES;
  private static final int MOVED_Y = MOVED_X + LANES;
  private static final int COS_A = MOVED_Y + LANES;
  private static final int SIN_A = COS_A + LANES;
  private static final int COS_B = SIN_A + LANES;
  private static final int SIN_B = COS_B + LANES;

  /** How fast B leaves A at the point at hand. */
  private static final int DVX = SIN_B + LANES;

  private static final int DVY = DVX + LANES;

  /** Impulse at the point at hand. */
  private static final int PX = DVY + LANES;

  private static final int PY = PX + LANES;

  /** Of each point: speed along the normal, speed to push with, softness, change of impulse. */
  private static final int SPEED = PY + LANES;

  private static final int PUSH = SPEED + 2 * LANES;
  private static final int YIELDS = PUSH + 2 * LANES;
  private static final int CHANGE = YIELDS + 2 * LANES;

  /** Softness that both points share. */
  private static final int YIELDS_CROSS = CHANGE + 2 * LANES;

  /** And room behind, so that no two workers' arrays share a line of the cache. */
  private static final int SCRATCH = YIELDS_CROSS + 3 * LANES;

  /** Loaded by name, see { link ContactLanes#find}. */
  VectorLanes() {
    if (FloatVector.SPECIES_PREFERRED.length() < LANES) {
      throw new UnsupportedOperationException("vectors have fewer than " + LANES + " lanes");
    }
  }

  @Override
  int scratchSize() {
    return SCRATCH;
  }

  @Override
  void push(ContactSolver solver, float[] v, float[] s, int block) {
    float[] d = solver.data;
    int at = block * RECORD;
    gather(s, v, solver.bodyA, solver.bodyB, block * LANES);
    friction(s, d, at, FIRST);
    springs(s, d, at, FIRST, 0, solver.inverseH, solver.slop, solver.maxPush);
    if (solver.two[block]) {
      friction(s, d, at, SECOND);
      springs(s, d, at, SECOND, LANES, solver.inverseH, solver.slop, solver.maxPush);
      springCross(s, d, at);
      normals(s, d, at);
    } else {
      normal(s, d, at);
    }
    scatter(s, v, solver, block);
  }

  @Override
  void relax(ContactSolver solver, float[] v, float[] s, int block) {
    float[] d = solver.data;
    int at = block * RECORD;
    gather(s, v, solver.bodyA, solver.bodyB, block * LANES);
    gatherMotion(s, v, solver.bodyA, solver.bodyB, block * LANES);
    rigid(s);
    room(s, d, at, at + FIRST, 0, solver.inverseH);
    if (solver.two[block]) {
      room(s, d, at, at + SECOND, LANES, solver.inverseH);
      normals(s, d, at);
      friction(s, d, at, FIRST);
      friction(s, d, at, SECOND);
      addUp(d, at + SECOND);
    } else {
      normal(s, d, at);
      friction(s, d, at, FIRST);
    }
    addUp(d, at + FIRST);
    scatter(s, v, solver, block);
  }

  @Override
  void warmStart(ContactSolver solver, float[] v, float[] s, int block) {
    int at = block * RECORD;
    gather(s, v, solver.bodyA, solver.bodyB, block * LANES);
    warm(s, solver.data, at, at + FIRST);
    apply(s, solver.data, at, at + FIRST);
    if (solver.two[block]) {
      warm(s, solver.data, at, at + SECOND);
      apply(s, solver.data, at, at + SECOND);
    }
    scatter(s, v, solver, block);
  }

  private static void gather(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
    for (int i = 0; i < LANES; i++) {
      int a = bodyA[lane + i];
      int b = bodyB[lane + i];
      s[VAX + i] = v[a + SolverBodies.VX];
      s[VAY + i] = v[a + SolverBodies.VY];
      s[WA + i] = v[a + SolverBodies.W];
      s[VBX + i] = v[b + SolverBodies.VX];
      s[VBY + i] = v[b + SolverBodies.VY];
      s[WB + i] = v[b + SolverBodies.W];
    }
  }

  private static void gatherMotion(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
    for (int i = 0; i < LANES; i++) {
      int a = bodyA[lane + i];
      int b = bodyB[lane + i];
      s[MOVED_X + i] = v[b + SolverBodies.DX] - v[a + SolverBodies.DX];
      s[MOVED_Y + i] = v[b + SolverBodies.DY] - v[a + SolverBodies.DY];
      s[COS_A + i] = v[a + SolverBodies.COS] - 1;
      s[SIN_A + i] = v[a + SolverBodies.SIN];
      s[COS_B + i] = v[b + SolverBodies.COS] - 1;
      s[SIN_B + i] = v[b + SolverBodies.SIN];
    }
  }

  private static void scatter(float[] s, float[] v, ContactSolver solver, int block) {
    if (solver.fixed[block]) {
      scatterMoved(s, v, solver, block);
    } else {
      scatterBoth(s, v, solver.bodyA, solver.bodyB, block * LANES);
    }
  }

  private static void scatterBoth(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
    for (int i = 0; i < LANES; i++) {
      int a = bodyA[lane + i];
      int b = bodyB[lane + i];
      v[a + SolverBodies.VX] = s[VAX + i];
      v[a + SolverBodies.VY] = s[VAY + i];
      v[a + SolverBodies.W] = s[WA + i];
      v[b + SolverBodies.VX] = s[VBX + i];
      v[b + SolverBodies.VY] = s[VBY + i];
      v[b + SolverBodies.W] = s[WB + i];
    }
  }

  /** Writes nothing to bodies that can't be moved: other workers may be reading them. */
  private static void scatterMoved(float[] s, float[] v, ContactSolver solver, int block) {
    float[] d = solver.data;
    for (int i = 0; i < LANES; i++) {
      int a = solver.bodyA[block * LANES + i];
      int b = solver.bodyB[block * LANES + i];
      if (d[block * RECORD + MASS_A + i] != 0) {
        v[a + SolverBodies.VX] = s[VAX + i];
        v[a + SolverBodies.VY] = s[VAY + i];
        v[a + SolverBodies.W] = s[WA + i];
      }
      if (d[block * RECORD + MASS_B + i] != 0) {
        v[b + SolverBodies.VX] = s[VBX + i];
        v[b + SolverBodies.VY] = s[VBY + i];
        v[b + SolverBodies.W] = s[WB + i];
      }
    }
  }

  private static void friction(float[] s, float[] d, int at, int point) {
    approach(s, d, at + point);
    slide(s, d, at, at + point);
    apply(s, d, at, at + point);
  }

  /** Solves the one point. */
  private static void normal(float[] s, float[] d, int at) {
    approach(s, d, at + FIRST);
    along(s, d, at, 0);
    solveOne(s, d, at + FIRST);
    impulse(s, d, at, 0);
    apply(s, d, at, at + FIRST);
  }

  /** Solves both points together. */
  private static void normals(float[] s, float[] d, int at) {
    approach(s, d, at + FIRST);
    along(s, d, at, 0);
    approach(s, d, at + SECOND);
    along(s, d, at, LANES);
    solveBoth(s, d, at);
    impulse(s, d, at, 0);
    apply(s, d, at, at + FIRST);
    impulse(s, d, at, LANES);
    apply(s, d, at, at + SECOND);
  }

  /** How fast B leaves A at a point, x and y. */
  private static void approach(float[] s, float[] d, int p) {
    FloatVector wa = FloatVector.fromArray(LANE, s, WA);
    FloatVector wb = FloatVector.fromArray(LANE, s, WB);
    FloatVector.fromArray(LANE, s, VBX)
        .sub(wb.mul(FloatVector.fromArray(LANE, d, p + BY)))
        .sub(FloatVector.fromArray(LANE, s, VAX))
        .add(wa.mul(FloatVector.fromArray(LANE, d, p + AY)))
        .intoArray(s, DVX);
    FloatVector.fromArray(LANE, s, VBY)
        .add(wb.mul(FloatVector.fromArray(LANE, d, p + BX)))
        .sub(FloatVector.fromArray(LANE, s, VAY))
        .sub(wa.mul(FloatVector.fromArray(LANE, d, p + AX)))
        .intoArray(s, DVY);
  }

  /** The same along the normal. */
  private static void along(float[] s, float[] d, int at, int point) {
    FloatVector.fromArray(LANE, s, DVX)
        .mul(FloatVector.fromArray(LANE, d, at + NX))
        .add(FloatVector.fromArray(LANE, s, DVY).mul(FloatVector.fromArray(LANE, d, at + NY)))
        .intoArray(s, SPEED + point);
  }

  /** Turns a change of the normal impulse into a vector. */
  private static void impulse(float[] s, float[] d, int at, int point) {
    FloatVector change = FloatVector.fromArray(LANE, s, CHANGE + point);
    change.mul(FloatVector.fromArray(LANE, d, at + NX)).intoArray(s, PX);
    change.mul(FloatVector.fromArray(LANE, d, at + NY)).intoArray(s, PY);
  }

  /** Gives B the impulse at a point, and A its opposite. */
  private static void apply(float[] s, float[] d, int at, int p) {
    FloatVector px = FloatVector.fromArray(LANE, s, PX);
    FloatVector py = FloatVector.fromArray(LANE, s, PY);
    FloatVector massA = FloatVector.fromArray(LANE, d, at + MASS_A);
    FloatVector.fromArray(LANE, s, VAX).sub(massA.mul(px)).intoArray(s, VAX);
    FloatVector.fromArray(LANE, s, VAY).sub(massA.mul(py)).intoArray(s, VAY);
    FloatVector turnA =
        FloatVector.fromArray(LANE, d, p + AX)
            .mul(py)
            .sub(FloatVector.fromArray(LANE, d, p + AY).mul(px));
    FloatVector.fromArray(LANE, s, WA)
        .sub(FloatVector.fromArray(LANE, d, at + INERTIA_A).mul(turnA))
        .intoArray(s, WA);
    FloatVector massB = FloatVector.fromArray(LANE, d, at + MASS_B);
    FloatVector.fromArray(LANE, s, VBX).add(massB.mul(px)).intoArray(s, VBX);
    FloatVector.fromArray(LANE, s, VBY).add(massB.mul(py)).intoArray(s, VBY);
    FloatVector turnB =
        FloatVector.fromArray(LANE, d, p + BX)
            .mul(py)
            .sub(FloatVector.fromArray(LANE, d, p + BY).mul(px));
    FloatVector.fromArray(LANE, s, WB)
        .add(FloatVector.fromArray(LANE, d, at + INERTIA_B).mul(turnB))
        .intoArray(s, WB);
  }

  private static void slide(float[] s, float[] d, int at, int p) {
    FloatVector nx = FloatVector.fromArray(LANE, d, at + NX);
    FloatVector ny = FloatVector.fromArray(LANE, d, at + NY);
    FloatVector vt =
        FloatVector.fromArray(LANE, s, DVY)
            .mul(nx)
            .sub(FloatVector.fromArray(LANE, s, DVX).mul(ny))
            .add(FloatVector.fromArray(LANE, d, at + SURFACE));
    FloatVector limit =
        FloatVector.fromArray(LANE, d, at + FRICTION)
            .mul(FloatVector.fromArray(LANE, d, p + NORMAL));
    FloatVector old = FloatVector.fromArray(LANE, d, p + TANGENT);
    FloatVector sum = old.sub(FloatVector.fromArray(LANE, d, p + TANGENT_MASS).mul(vt));
    sum = limit.blend(sum, sum.compare(VectorOperators.LT, limit));
    FloatVector least = limit.neg();
    sum = least.blend(sum, sum.compare(VectorOperators.GT, least));
    sum.intoArray(d, p + TANGENT);
    old.sub(sum).mul(ny).intoArray(s, PX);
    sum.sub(old).mul(nx).intoArray(s, PY);
  }

  /** Push and softness of a point from the gap of the last relaxing visit. */
  private static void springs(
      float[] s,
      float[] d,
      int at,
      int first,
      int point,
      float inverseH,
      float slop,
      float maxPush) {
    FloatVector gap = FloatVector.fromArray(LANE, d, at + first + GAP);
    VectorMask<Float> open = gap.compare(VectorOperators.GT, 0);
    FloatVector zero = FloatVector.zero(LANE);
    FloatVector overlap = gap.add(slop);
    overlap = zero.blend(overlap, overlap.compare(VectorOperators.LT, 0));
    FloatVector speed = FloatVector.fromArray(LANE, d, at + BIAS_RATE).mul(overlap);
    FloatVector push = FloatVector.broadcast(LANE, -maxPush);
    push = push.blend(speed, speed.compare(VectorOperators.GT, -maxPush));
    push.blend(gap.mul(inverseH), open).intoArray(s, PUSH + point);
    FloatVector.fromArray(LANE, d, at + SOFT).blend(0, open).intoArray(s, YIELDS + point);
  }

  private static void springCross(float[] s, float[] d, int at) {
    VectorMask<Float> open =
        FloatVector.fromArray(LANE, d, at + FIRST + GAP).compare(VectorOperators.GT, 0);
    open =
        open.or(FloatVector.fromArray(LANE, d, at + SECOND + GAP).compare(VectorOperators.GT, 0));
    FloatVector.fromArray(LANE, d, at + SOFT_CROSS).blend(0, open).intoArray(s, YIELDS_CROSS);
  }

  private static void rigid(float[] s) {
    FloatVector zero = FloatVector.zero(LANE);
    zero.intoArray(s, YIELDS);
    zero.intoArray(s, YIELDS + LANES);
    zero.intoArray(s, YIELDS_CROSS);
  }

  /** The gap at a point now, and the speed by which it may close. */
  private static void room(float[] s, float[] d, int at, int p, int point, float inverseH) {
    FloatVector ax = FloatVector.fromArray(LANE, d, p + AX);
    FloatVector ay = FloatVector.fromArray(LANE, d, p + AY);
    FloatVector bx = FloatVector.fromArray(LANE, d, p + BX);
    FloatVector by = FloatVector.fromArray(LANE, d, p + BY);
    FloatVector ca = FloatVector.fromArray(LANE, s, COS_A);
    FloatVector sa = FloatVector.fromArray(LANE, s, SIN_A);
    FloatVector cb = FloatVector.fromArray(LANE, s, COS_B);
    FloatVector sb = FloatVector.fromArray(LANE, s, SIN_B);
    FloatVector movedX =
        FloatVector.fromArray(LANE, s, MOVED_X)
            .add(cb.mul(bx).sub(sb.mul(by)).sub(ca.mul(ax).sub(sa.mul(ay))));
    FloatVector movedY =
        FloatVector.fromArray(LANE, s, MOVED_Y)
            .add(sb.mul(bx).add(cb.mul(by)).sub(sa.mul(ax).add(ca.mul(ay))));
    FloatVector gap =
        FloatVector.fromArray(LANE, d, p + SEPARATION)
            .add(movedX.mul(FloatVector.fromArray(LANE, d, at + NX)))
            .add(movedY.mul(FloatVector.fromArray(LANE, d, at + NY)));
    FloatVector roundA = FloatVector.fromArray(LANE, d, at + ROUND_A);
    FloatVector roundB = FloatVector.fromArray(LANE, d, at + ROUND_B);
    gap = gap.add(roundA.mul(ca).add(roundB.mul(cb)));
    gap.intoArray(d, p + GAP);
    FloatVector zero = FloatVector.zero(LANE);
    zero.blend(gap.mul(inverseH), gap.compare(VectorOperators.GT, 0)).intoArray(s, PUSH + point);
  }

  private static void solveOne(float[] s, float[] d, int p) {
    FloatVector old = FloatVector.fromArray(LANE, d, p + NORMAL);
    FloatVector yield = FloatVector.fromArray(LANE, d, p + YIELD);
    FloatVector q =
        FloatVector.fromArray(LANE, s, SPEED)
            .add(FloatVector.fromArray(LANE, s, PUSH))
            .sub(yield.mul(old));
    FloatVector zero = FloatVector.zero(LANE);
    FloatVector sum = q.neg().div(yield.add(FloatVector.fromArray(LANE, s, YIELDS)));
    sum = zero.blend(sum, q.compare(VectorOperators.LT, 0));
    sum.intoArray(d, p + NORMAL);
    sum.sub(old).intoArray(s, CHANGE);
  }

  private static void solveBoth(float[] s, float[] d, int at) {
    FloatVector old1 = FloatVector.fromArray(LANE, d, at + FIRST + NORMAL);
    FloatVector old2 = FloatVector.fromArray(LANE, d, at + SECOND + NORMAL);
    FloatVector k1 = FloatVector.fromArray(LANE, d, at + FIRST + YIELD);
    FloatVector k2 = FloatVector.fromArray(LANE, d, at + SECOND + YIELD);
    FloatVector k = FloatVector.fromArray(LANE, d, at + CROSS);
    FloatVector q1 =
        FloatVector.fromArray(LANE, s, SPEED)
            .add(FloatVector.fromArray(LANE, s, PUSH))
            .sub(k1.mul(old1))
            .sub(k.mul(old2));
    FloatVector q2 =
        FloatVector.fromArray(LANE, s, SPEED + LANES)
            .add(FloatVector.fromArray(LANE, s, PUSH + LANES))
            .sub(k2.mul(old2))
            .sub(k.mul(old1));
    k1 = k1.add(FloatVector.fromArray(LANE, s, YIELDS));
    k2 = k2.add(FloatVector.fromArray(LANE, s, YIELDS + LANES));
    k = k.add(FloatVector.fromArray(LANE, s, YIELDS_CROSS));
    FloatVector zero = FloatVector.zero(LANE);
    FloatVector scale = FloatVector.broadcast(LANE, 1).div(k1.mul(k2).sub(k.mul(k)));
    FloatVector sum1 = k.mul(q2).sub(k2.mul(q1)).mul(scale);
    FloatVector sum2 = k.mul(q1).sub(k1.mul(q2)).mul(scale);
    FloatVector only1 = zero.blend(q1.neg().div(k1), q1.compare(VectorOperators.LT, 0));
    FloatVector only2 = zero.blend(q2.neg().div(k2), q2.compare(VectorOperators.LT, 0));
    VectorMask<Float> second = q2.add(k.mul(only1)).compare(VectorOperators.LT, 0);
    VectorMask<Float> both =
        sum1.compare(VectorOperators.GE, 0).and(sum2.compare(VectorOperators.GE, 0));
    sum1 = only1.blend(0, second).blend(sum1, both);
    sum2 = zero.blend(only2, second).blend(sum2, both);
    sum1.intoArray(d, at + FIRST + NORMAL);
    sum2.intoArray(d, at + SECOND + NORMAL);
    sum1.sub(old1).intoArray(s, CHANGE);
    sum2.sub(old2).intoArray(s, CHANGE + LANES);
  }

  private static void addUp(float[] d, int p) {
    FloatVector.fromArray(LANE, d, p + TOTAL)
        .add(FloatVector.fromArray(LANE, d, p + NORMAL))
        .intoArray(d, p + TOTAL);
    FloatVector.fromArray(LANE, d, p + SLIDE)
        .add(FloatVector.fromArray(LANE, d, p + TANGENT))
        .intoArray(d, p + SLIDE);
  }

  private static void warm(float[] s, float[] d, int at, int p) {
    FloatVector nx = FloatVector.fromArray(LANE, d, at + NX);
    FloatVector ny = FloatVector.fromArray(LANE, d, at + NY);
    FloatVector pn = FloatVector.fromArray(LANE, d, p + NORMAL);
    FloatVector pt = FloatVector.fromArray(LANE, d, p + TANGENT);
    pn.mul(nx).sub(pt.mul(ny)).intoArray(s, PX);
    pn.mul(ny).add(pt.mul(nx)).intoArray(s, PY);
  }
}
