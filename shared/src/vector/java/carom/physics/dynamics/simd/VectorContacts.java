package carom.physics.dynamics.simd;

import static carom.physics.dynamics.simd.ContactGather.COS_A;
import static carom.physics.dynamics.simd.ContactGather.COS_B;
import static carom.physics.dynamics.simd.ContactGather.MOVED_X;
import static carom.physics.dynamics.simd.ContactGather.MOVED_Y;
import static carom.physics.dynamics.simd.ContactGather.SIN_A;
import static carom.physics.dynamics.simd.ContactGather.SIN_B;
import static carom.physics.dynamics.simd.ContactGather.VXA;
import static carom.physics.dynamics.simd.ContactGather.VXB;
import static carom.physics.dynamics.simd.ContactGather.VYA;
import static carom.physics.dynamics.simd.ContactGather.VYB;
import static carom.physics.dynamics.simd.ContactGather.WA;
import static carom.physics.dynamics.simd.ContactGather.WB;
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
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_IMPULSE;
import static carom.physics.dynamics.solver.ContactBlocks.NX;
import static carom.physics.dynamics.solver.ContactBlocks.NY;
import static carom.physics.dynamics.solver.ContactBlocks.RADIUS_A;
import static carom.physics.dynamics.solver.ContactBlocks.RADIUS_B;
import static carom.physics.dynamics.solver.ContactBlocks.RECORD;
import static carom.physics.dynamics.solver.ContactBlocks.SECOND;
import static carom.physics.dynamics.solver.ContactBlocks.SEPARATION;
import static carom.physics.dynamics.solver.ContactBlocks.SURFACE;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_IMPULSE;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.TOTAL_NORMAL;
import static carom.physics.dynamics.solver.ContactBlocks.TOTAL_TANGENT;

import carom.physics.dynamics.solver.ContactBlocks;
import carom.physics.dynamics.solver.ContactLanes;
import carom.physics.dynamics.solver.ContactPacker;
import carom.physics.dynamics.solver.ContactSolver;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Solves the contacts of a block at once, with the Vector API: the operations of {@code
 * ScalarContacts} in the same order, by methods of the same names, hence the same bits.
 *
 * <p>{@link ContactGather} first copies the bodies' velocities, one quantity for all lanes side by
 * side, to a scratch array that stays in the nearest cache. After that all work is on vectors.
 *
 * <pre>
 *   bodies in memory      gather       scratch               kernels         scatter
 *   vx vy w dx dy c s  ------------>  VXA | 01234567 |  -> one register -> ------------> bodies
 *   vx vy w dx dy c s                 VYA | 01234567 |     per quantity
 *   ...                               ...
 * </pre>
 *
 * <p>The methods are small and pass each other arrays, never vectors, and call the Vector API
 * without helpers in between. The JIT compiler boxes a vector that crosses a call which it didn't
 * inline (40 MB per step of the 5,050-box pyramid, and no gain).
 */
public final class VectorContacts extends ContactLanes {
  private static final VectorSpecies<Float> LANE =
      LANES == 16 ? FloatVector.SPECIES_512 : FloatVector.SPECIES_256;

  // Quantities of the scratch array, behind those of ContactGather.

  /** Speed along the normal at which B leaves A, without rotation, m/s. */
  private static final int NORMAL_SPEED = ContactGather.END;

  /** Speed along the tangent, without rotation, m/s. */
  private static final int TANGENT_SPEED = NORMAL_SPEED + LANES;

  /** Distance by which the bodies moved apart along the normal since the step began, m. */
  private static final int NORMAL_MOTION = TANGENT_SPEED + LANES;

  /** Bias of each of the two points: the speed to part with, m/s, negative to push apart. */
  private static final int BIAS = NORMAL_MOTION + LANES;

  /** Softness of each of the two points, 1/kg. */
  private static final int SOFT = BIAS + 2 * LANES;

  /** Change of the normal impulse at each of the two points, N s. */
  private static final int CHANGE = SOFT + 2 * LANES;

  /** Softness that both points share, 1/kg. */
  private static final int SOFT_CROSS = CHANGE + 2 * LANES;

  /** Impulse along the normal to apply, N s. */
  private static final int NORMAL_SUM = SOFT_CROSS + LANES;

  /** Impulse along the tangent to apply, N s. */
  private static final int TANGENT_SUM = NORMAL_SUM + LANES;

  private static final int SCRATCH = TANGENT_SUM + LANES + APART;

  /** Creates the kernels; called by name, see {@link ContactLanes#FOUND}. */
  public VectorContacts() {
    if (FloatVector.SPECIES_PREFERRED.length() < LANES) {
      throw new UnsupportedOperationException("vectors have fewer than " + LANES + " lanes");
    }
  }

  @Override
  public int scratchSize() {
    return SCRATCH;
  }

  @Override
  protected int warmUpSize() {
    return SCRATCH + RECORD + EXTRA;
  }

  @Override
  protected void warmUp(float[] n) {
    int at = SCRATCH;
    int first = at + FIRST;
    int more = at + RECORD;
    leverArms(n, at, true);
    warmStartPoint(n, n, at);
    warmStartPair(n, n, at);
    relativeVelocity(n, n, at);
    surface(n, n, more);
    softness(n, n, at, 1);
    bias(n, n, first, 0, 1, 1, 1, 1);
    solveFriction(n, n, at, first);
    solveNormal(n, n, first);
    applyAngularImpulse(n, n, at);
    solveNormalPair(n, n, at);
    applyAngularImpulsePair(n, n, at);
    applyImpulse(n, n, at);
    normalMotion(n, n, at);
    addRounding(n, n, more);
    rigidBias(n, n, first, 0, 1);
    addToTotals(n, first);
  }

  @Override
  public void leverArms(float[] d, int at, boolean two) {
    if (two) {
      leverArms(d, at, at + SECOND);
    }
    leverArms(d, at, at + FIRST);
    if (two) {
      cross(d, at);
    }
  }

  /** Makes lever arms and masses of a point. The first point comes last: it holds B's position. */
  private static void leverArms(float[] d, int at, int p) {
    FloatVector nx = FloatVector.fromArray(LANE, d, at + NX);
    FloatVector ny = FloatVector.fromArray(LANE, d, at + NY);
    FloatVector x = FloatVector.fromArray(LANE, d, p + ContactPacker.ARM_X);
    FloatVector y = FloatVector.fromArray(LANE, d, p + ContactPacker.ARM_Y);
    FloatVector bx = x.sub(FloatVector.fromArray(LANE, d, at + FIRST + ContactPacker.OFFSET_X));
    FloatVector by = y.sub(FloatVector.fromArray(LANE, d, at + FIRST + ContactPacker.OFFSET_Y));
    FloatVector normalA = x.mul(ny).sub(y.mul(nx));
    FloatVector normalB = bx.mul(ny).sub(by.mul(nx));
    FloatVector tangentA = x.mul(nx).add(y.mul(ny));
    FloatVector tangentB = bx.mul(nx).add(by.mul(ny));
    normalA.intoArray(d, p + NORMAL_ARM_A);
    normalB.intoArray(d, p + NORMAL_ARM_B);
    tangentA.intoArray(d, p + TANGENT_ARM_A);
    tangentB.intoArray(d, p + TANGENT_ARM_B);
    FloatVector inertiaA = FloatVector.fromArray(LANE, d, at + INERTIA_A);
    FloatVector inertiaB = FloatVector.fromArray(LANE, d, at + INERTIA_B);
    FloatVector masses =
        FloatVector.fromArray(LANE, d, at + MASS_A)
            .add(FloatVector.fromArray(LANE, d, at + MASS_B));
    masses
        .add(inertiaA.mul(normalA).mul(normalA))
        .add(inertiaB.mul(normalB).mul(normalB))
        .intoArray(d, p + INVERSE_NORMAL_MASS);
    FloatVector kt =
        masses.add(inertiaA.mul(tangentA).mul(tangentA)).add(inertiaB.mul(tangentB).mul(tangentB));
    FloatVector zero = FloatVector.zero(LANE);
    zero.blend(FloatVector.broadcast(LANE, 1).div(kt), kt.compare(VectorOperators.GT, 0))
        .intoArray(d, p + TANGENT_MASS);
    FloatVector.fromArray(LANE, d, p + SEPARATION).intoArray(d, p + GAP);
    zero.intoArray(d, p + TOTAL_NORMAL);
    zero.intoArray(d, p + TOTAL_TANGENT);
  }

  /** Finds the inverse effective mass between the points. */
  private static void cross(float[] d, int at) {
    FloatVector turnA =
        FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_A)
            .mul(FloatVector.fromArray(LANE, d, at + SECOND + NORMAL_ARM_A));
    FloatVector turnB =
        FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_B)
            .mul(FloatVector.fromArray(LANE, d, at + SECOND + NORMAL_ARM_B));
    FloatVector.fromArray(LANE, d, at + MASS_A)
        .add(FloatVector.fromArray(LANE, d, at + MASS_B))
        .add(FloatVector.fromArray(LANE, d, at + INERTIA_A).mul(turnA))
        .add(FloatVector.fromArray(LANE, d, at + INERTIA_B).mul(turnB))
        .intoArray(d, at + CROSS);
    FloatVector.fromArray(LANE, d, at + FIRST + INVERSE_NORMAL_MASS)
        .mul(ContactPacker.DIAGONAL_SCALE)
        .intoArray(d, at + FIRST + INVERSE_NORMAL_MASS);
    FloatVector.fromArray(LANE, d, at + SECOND + INVERSE_NORMAL_MASS)
        .mul(ContactPacker.DIAGONAL_SCALE)
        .intoArray(d, at + SECOND + INVERSE_NORMAL_MASS);
  }

  @Override
  public void warmStart(ContactSolver solver, float[] v, float[] s, int block) {
    float[] d = solver.blocks.data;
    int at = block * RECORD;
    ContactGather.gather(s, v, solver.blocks.bodyA, solver.blocks.bodyB, block * LANES);
    if ((solver.blocks.traits[block] & ContactBlocks.TWO) != 0) {
      warmStartPair(s, d, at);
    } else {
      warmStartPoint(s, d, at);
    }
    applyImpulse(s, d, at);
    ContactGather.scatter(s, v, solver, block);
  }

  @Override
  public void applyBiasedImpulses(ContactSolver solver, float[] v, float[] s, int block) {
    float[] d = solver.blocks.data;
    int at = block * RECORD;
    int traits = solver.blocks.traits[block];
    int softness = traits & (ContactBlocks.TWO | ContactBlocks.FIXED);
    float rate = solver.biasRate[softness];
    ContactGather.gather(s, v, solver.blocks.bodyA, solver.blocks.bodyB, block * LANES);
    relativeVelocity(s, d, at);
    if ((traits & ContactBlocks.MOVING_SURFACE) != 0) {
      surface(s, solver.blocks.extra, block * EXTRA);
    }
    softness(s, d, at, solver.soft[softness]);
    bias(s, d, at + FIRST, 0, rate, solver.inverseH, solver.slop, solver.maxPushSpeed);
    if ((traits & ContactBlocks.TWO) != 0) {
      bias(s, d, at + SECOND, LANES, rate, solver.inverseH, solver.slop, solver.maxPushSpeed);
    }
    if ((traits & ContactBlocks.FREE) != 0) {
      solver.freeBiases(block, s, BIAS, false);
    }
    solveFriction(s, d, at, at + FIRST);
    if ((traits & ContactBlocks.TWO) != 0) {
      solveFriction(s, d, at, at + SECOND);
      solveNormalPair(s, d, at);
      applyAngularImpulsePair(s, d, at);
    } else {
      solveNormal(s, d, at + FIRST);
      applyAngularImpulse(s, d, at);
    }
    applyImpulse(s, d, at);
    ContactGather.scatter(s, v, solver, block);
  }

  @Override
  public void relax(ContactSolver solver, float[] v, float[] s, int block) {
    float[] d = solver.blocks.data;
    int at = block * RECORD;
    int traits = solver.blocks.traits[block];
    ContactGather.gather(s, v, solver.blocks.bodyA, solver.blocks.bodyB, block * LANES);
    ContactGather.gatherMotion(s, v, solver.blocks.bodyA, solver.blocks.bodyB, block * LANES);
    relativeVelocity(s, d, at);
    normalMotion(s, d, at);
    if ((traits & ContactBlocks.MOVING_SURFACE) != 0) {
      surface(s, solver.blocks.extra, block * EXTRA);
    }
    if ((traits & ContactBlocks.ROUNDED) != 0) {
      addRounding(s, solver.blocks.extra, block * EXTRA);
    }
    rigidBias(s, d, at + FIRST, 0, solver.inverseH);
    if ((traits & ContactBlocks.TWO) != 0) {
      rigidBias(s, d, at + SECOND, LANES, solver.inverseH);
    }
    if ((traits & ContactBlocks.FREE) != 0) {
      solver.freeBiases(block, s, BIAS, true);
    }
    if ((traits & ContactBlocks.TWO) != 0) {
      solveNormalPair(s, d, at);
      applyAngularImpulsePair(s, d, at);
      solveFriction(s, d, at, at + FIRST);
      solveFriction(s, d, at, at + SECOND);
      addToTotals(d, at + SECOND);
    } else {
      solveNormal(s, d, at + FIRST);
      applyAngularImpulse(s, d, at);
      solveFriction(s, d, at, at + FIRST);
    }
    addToTotals(d, at + FIRST);
    applyImpulse(s, d, at);
    ContactGather.scatter(s, v, solver, block);
  }

  /** Finds the speeds along normal and tangent. There is no impulse yet. */
  private static void relativeVelocity(float[] s, float[] d, int at) {
    FloatVector nx = FloatVector.fromArray(LANE, d, at + NX);
    FloatVector ny = FloatVector.fromArray(LANE, d, at + NY);
    FloatVector dvx = FloatVector.fromArray(LANE, s, VXB).sub(FloatVector.fromArray(LANE, s, VXA));
    FloatVector dvy = FloatVector.fromArray(LANE, s, VYB).sub(FloatVector.fromArray(LANE, s, VYA));
    dvx.mul(nx).add(dvy.mul(ny)).intoArray(s, NORMAL_SPEED);
    dvy.mul(nx).sub(dvx.mul(ny)).intoArray(s, TANGENT_SPEED);
    FloatVector.zero(LANE).intoArray(s, TANGENT_SUM);
  }

  private static void surface(float[] s, float[] extra, int more) {
    FloatVector.fromArray(LANE, s, TANGENT_SPEED)
        .add(FloatVector.fromArray(LANE, extra, more + SURFACE))
        .intoArray(s, TANGENT_SPEED);
  }

  /** Finds how far the bodies moved apart along the normal. Sets softness to zero: rigid. */
  private static void normalMotion(float[] s, float[] d, int at) {
    FloatVector.fromArray(LANE, s, MOVED_X)
        .mul(FloatVector.fromArray(LANE, d, at + NX))
        .add(FloatVector.fromArray(LANE, s, MOVED_Y).mul(FloatVector.fromArray(LANE, d, at + NY)))
        .intoArray(s, NORMAL_MOTION);
    FloatVector zero = FloatVector.zero(LANE);
    zero.intoArray(s, SOFT);
    zero.intoArray(s, SOFT + LANES);
    zero.intoArray(s, SOFT_CROSS);
  }

  private static void addRounding(float[] s, float[] extra, int more) {
    FloatVector a =
        FloatVector.fromArray(LANE, extra, more + RADIUS_A)
            .mul(FloatVector.fromArray(LANE, s, COS_A));
    FloatVector b =
        FloatVector.fromArray(LANE, extra, more + RADIUS_B)
            .mul(FloatVector.fromArray(LANE, s, COS_B));
    FloatVector.fromArray(LANE, s, NORMAL_MOTION).add(a.add(b)).intoArray(s, NORMAL_MOTION);
  }

  /** Solves friction at a point. */
  private static void solveFriction(float[] s, float[] d, int at, int p) {
    FloatVector wa = FloatVector.fromArray(LANE, s, WA);
    FloatVector wb = FloatVector.fromArray(LANE, s, WB);
    FloatVector tangentSpeed = FloatVector.fromArray(LANE, s, TANGENT_SPEED);
    FloatVector armA = FloatVector.fromArray(LANE, d, p + TANGENT_ARM_A);
    FloatVector armB = FloatVector.fromArray(LANE, d, p + TANGENT_ARM_B);
    FloatVector limit =
        FloatVector.fromArray(LANE, d, at + FRICTION)
            .mul(FloatVector.fromArray(LANE, d, p + NORMAL_IMPULSE));
    FloatVector old = FloatVector.fromArray(LANE, d, p + TANGENT_IMPULSE);
    FloatVector sum =
        old.sub(
            FloatVector.fromArray(LANE, d, p + TANGENT_MASS)
                .mul(tangentSpeed.add(wb.mul(armB).sub(wa.mul(armA)))));
    sum = limit.blend(sum, sum.compare(VectorOperators.LT, limit));
    FloatVector least = limit.neg();
    sum = least.blend(sum, sum.compare(VectorOperators.GT, least));
    sum.intoArray(d, p + TANGENT_IMPULSE);
    FloatVector change = sum.sub(old);
    FloatVector masses =
        FloatVector.fromArray(LANE, d, at + MASS_A)
            .add(FloatVector.fromArray(LANE, d, at + MASS_B));
    tangentSpeed.add(masses.mul(change)).intoArray(s, TANGENT_SPEED);
    wa.sub(FloatVector.fromArray(LANE, d, at + INERTIA_A).mul(armA.mul(change))).intoArray(s, WA);
    wb.add(FloatVector.fromArray(LANE, d, at + INERTIA_B).mul(armB.mul(change))).intoArray(s, WB);
    FloatVector.fromArray(LANE, s, TANGENT_SUM).add(change).intoArray(s, TANGENT_SUM);
  }

  /** Finds the softness of both points, and what they share. {@code bias} clears it for gaps. */
  private static void softness(float[] s, float[] d, int at, float perMass) {
    FloatVector soft =
        FloatVector.fromArray(LANE, d, at + MASS_A)
            .add(FloatVector.fromArray(LANE, d, at + MASS_B))
            .mul(perMass);
    soft.intoArray(s, SOFT);
    soft.intoArray(s, SOFT + LANES);
    soft.mul(ContactSolver.COUPLING).intoArray(s, SOFT_CROSS);
  }

  /** Finds the bias of a point from the gap of the last relaxing visit. */
  private static void bias(
      float[] s,
      float[] d,
      int p,
      int point,
      float rate,
      float inverseH,
      float slop,
      float maxPushSpeed) {
    FloatVector gap = FloatVector.fromArray(LANE, d, p + GAP);
    VectorMask<Float> open = gap.compare(VectorOperators.GT, 0);
    FloatVector zero = FloatVector.zero(LANE);
    FloatVector overlap = gap.add(slop);
    overlap = zero.blend(overlap, overlap.compare(VectorOperators.LT, 0));
    FloatVector apart = overlap.mul(rate);
    FloatVector bias = FloatVector.broadcast(LANE, -maxPushSpeed);
    bias = bias.blend(apart, apart.compare(VectorOperators.GT, -maxPushSpeed));
    bias.blend(gap.mul(inverseH), open).intoArray(s, BIAS + point);
    FloatVector.fromArray(LANE, s, SOFT + point).blend(0, open).intoArray(s, SOFT + point);
    FloatVector.fromArray(LANE, s, SOFT_CROSS).blend(0, open).intoArray(s, SOFT_CROSS);
  }

  /** Finds the gap at a point now, and the speed by which it may close. */
  private static void rigidBias(float[] s, float[] d, int p, int point, float inverseH) {
    FloatVector turnedA =
        FloatVector.fromArray(LANE, s, COS_A)
            .mul(FloatVector.fromArray(LANE, d, p + TANGENT_ARM_A))
            .add(
                FloatVector.fromArray(LANE, s, SIN_A)
                    .mul(FloatVector.fromArray(LANE, d, p + NORMAL_ARM_A)));
    FloatVector turnedB =
        FloatVector.fromArray(LANE, s, COS_B)
            .mul(FloatVector.fromArray(LANE, d, p + TANGENT_ARM_B))
            .add(
                FloatVector.fromArray(LANE, s, SIN_B)
                    .mul(FloatVector.fromArray(LANE, d, p + NORMAL_ARM_B)));
    FloatVector gap =
        FloatVector.fromArray(LANE, d, p + SEPARATION)
            .add(FloatVector.fromArray(LANE, s, NORMAL_MOTION).add(turnedB.sub(turnedA)));
    gap.intoArray(d, p + GAP);
    FloatVector zero = FloatVector.zero(LANE);
    zero.blend(gap.mul(inverseH), gap.compare(VectorOperators.GT, 0)).intoArray(s, BIAS + point);
  }

  /** Solves the normal of a single point. */
  private static void solveNormal(float[] s, float[] d, int p) {
    FloatVector old = FloatVector.fromArray(LANE, d, p + NORMAL_IMPULSE);
    FloatVector inverseMass = FloatVector.fromArray(LANE, d, p + INVERSE_NORMAL_MASS);
    FloatVector turning =
        FloatVector.fromArray(LANE, s, WB)
            .mul(FloatVector.fromArray(LANE, d, p + NORMAL_ARM_B))
            .sub(
                FloatVector.fromArray(LANE, s, WA)
                    .mul(FloatVector.fromArray(LANE, d, p + NORMAL_ARM_A)));
    FloatVector q =
        FloatVector.fromArray(LANE, s, NORMAL_SPEED)
            .add(turning)
            .add(FloatVector.fromArray(LANE, s, BIAS))
            .sub(inverseMass.mul(old));
    FloatVector zero = FloatVector.zero(LANE);
    FloatVector sum = q.neg().div(inverseMass.add(FloatVector.fromArray(LANE, s, SOFT)));
    sum = zero.blend(sum, q.compare(VectorOperators.LT, 0));
    sum.intoArray(d, p + NORMAL_IMPULSE);
    sum.sub(old).intoArray(s, CHANGE);
  }

  /** Solves the normals of both points together. */
  private static void solveNormalPair(float[] s, float[] d, int at) {
    FloatVector old1 = FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_IMPULSE);
    FloatVector old2 = FloatVector.fromArray(LANE, d, at + SECOND + NORMAL_IMPULSE);
    FloatVector k1 = FloatVector.fromArray(LANE, d, at + FIRST + INVERSE_NORMAL_MASS);
    FloatVector k2 = FloatVector.fromArray(LANE, d, at + SECOND + INVERSE_NORMAL_MASS);
    FloatVector k = FloatVector.fromArray(LANE, d, at + CROSS);
    FloatVector normalSpeed = FloatVector.fromArray(LANE, s, NORMAL_SPEED);
    FloatVector wa = FloatVector.fromArray(LANE, s, WA);
    FloatVector wb = FloatVector.fromArray(LANE, s, WB);
    FloatVector turning1 =
        wb.mul(FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_B))
            .sub(wa.mul(FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_A)));
    FloatVector turning2 =
        wb.mul(FloatVector.fromArray(LANE, d, at + SECOND + NORMAL_ARM_B))
            .sub(wa.mul(FloatVector.fromArray(LANE, d, at + SECOND + NORMAL_ARM_A)));
    FloatVector q1 =
        normalSpeed
            .add(turning1)
            .add(FloatVector.fromArray(LANE, s, BIAS))
            .sub(k1.mul(old1))
            .sub(k.mul(old2));
    FloatVector q2 =
        normalSpeed
            .add(turning2)
            .add(FloatVector.fromArray(LANE, s, BIAS + LANES))
            .sub(k2.mul(old2))
            .sub(k.mul(old1));
    k1 = k1.add(FloatVector.fromArray(LANE, s, SOFT));
    k2 = k2.add(FloatVector.fromArray(LANE, s, SOFT + LANES));
    k = k.add(FloatVector.fromArray(LANE, s, SOFT_CROSS));
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
    sum1.intoArray(d, at + FIRST + NORMAL_IMPULSE);
    sum2.intoArray(d, at + SECOND + NORMAL_IMPULSE);
    sum1.sub(old1).intoArray(s, CHANGE);
    sum2.sub(old2).intoArray(s, CHANGE + LANES);
  }

  /** Applies the change of the single point's impulse to the angular velocities. */
  private static void applyAngularImpulse(float[] s, float[] d, int at) {
    FloatVector change = FloatVector.fromArray(LANE, s, CHANGE);
    FloatVector turnA = FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_A).mul(change);
    FloatVector turnB = FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_B).mul(change);
    FloatVector.fromArray(LANE, s, WA)
        .sub(FloatVector.fromArray(LANE, d, at + INERTIA_A).mul(turnA))
        .intoArray(s, WA);
    FloatVector.fromArray(LANE, s, WB)
        .add(FloatVector.fromArray(LANE, d, at + INERTIA_B).mul(turnB))
        .intoArray(s, WB);
    change.intoArray(s, NORMAL_SUM);
  }

  /** Applies the changes of both points' impulses to the angular velocities. */
  private static void applyAngularImpulsePair(float[] s, float[] d, int at) {
    FloatVector change1 = FloatVector.fromArray(LANE, s, CHANGE);
    FloatVector change2 = FloatVector.fromArray(LANE, s, CHANGE + LANES);
    FloatVector turnA =
        FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_A)
            .mul(change1)
            .add(FloatVector.fromArray(LANE, d, at + SECOND + NORMAL_ARM_A).mul(change2));
    FloatVector turnB =
        FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_B)
            .mul(change1)
            .add(FloatVector.fromArray(LANE, d, at + SECOND + NORMAL_ARM_B).mul(change2));
    FloatVector.fromArray(LANE, s, WA)
        .sub(FloatVector.fromArray(LANE, d, at + INERTIA_A).mul(turnA))
        .intoArray(s, WA);
    FloatVector.fromArray(LANE, s, WB)
        .add(FloatVector.fromArray(LANE, d, at + INERTIA_B).mul(turnB))
        .intoArray(s, WB);
    change1.add(change2).intoArray(s, NORMAL_SUM);
  }

  /** Applies the impulse of the single point to the angular velocities. */
  private static void warmStartPoint(float[] s, float[] d, int at) {
    FloatVector normal = FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_IMPULSE);
    FloatVector tangent = FloatVector.fromArray(LANE, d, at + FIRST + TANGENT_IMPULSE);
    FloatVector turnA =
        FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_A)
            .mul(normal)
            .add(FloatVector.fromArray(LANE, d, at + FIRST + TANGENT_ARM_A).mul(tangent));
    FloatVector turnB =
        FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_B)
            .mul(normal)
            .add(FloatVector.fromArray(LANE, d, at + FIRST + TANGENT_ARM_B).mul(tangent));
    FloatVector.fromArray(LANE, s, WA)
        .sub(FloatVector.fromArray(LANE, d, at + INERTIA_A).mul(turnA))
        .intoArray(s, WA);
    FloatVector.fromArray(LANE, s, WB)
        .add(FloatVector.fromArray(LANE, d, at + INERTIA_B).mul(turnB))
        .intoArray(s, WB);
    normal.intoArray(s, NORMAL_SUM);
    tangent.intoArray(s, TANGENT_SUM);
  }

  /** Applies the impulses of both points to the angular velocities. */
  private static void warmStartPair(float[] s, float[] d, int at) {
    FloatVector normal1 = FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_IMPULSE);
    FloatVector tangent1 = FloatVector.fromArray(LANE, d, at + FIRST + TANGENT_IMPULSE);
    FloatVector normal2 = FloatVector.fromArray(LANE, d, at + SECOND + NORMAL_IMPULSE);
    FloatVector tangent2 = FloatVector.fromArray(LANE, d, at + SECOND + TANGENT_IMPULSE);
    FloatVector turnA =
        FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_A)
            .mul(normal1)
            .add(FloatVector.fromArray(LANE, d, at + FIRST + TANGENT_ARM_A).mul(tangent1))
            .add(
                FloatVector.fromArray(LANE, d, at + SECOND + NORMAL_ARM_A)
                    .mul(normal2)
                    .add(
                        FloatVector.fromArray(LANE, d, at + SECOND + TANGENT_ARM_A).mul(tangent2)));
    FloatVector turnB =
        FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_B)
            .mul(normal1)
            .add(FloatVector.fromArray(LANE, d, at + FIRST + TANGENT_ARM_B).mul(tangent1))
            .add(
                FloatVector.fromArray(LANE, d, at + SECOND + NORMAL_ARM_B)
                    .mul(normal2)
                    .add(
                        FloatVector.fromArray(LANE, d, at + SECOND + TANGENT_ARM_B).mul(tangent2)));
    FloatVector.fromArray(LANE, s, WA)
        .sub(FloatVector.fromArray(LANE, d, at + INERTIA_A).mul(turnA))
        .intoArray(s, WA);
    FloatVector.fromArray(LANE, s, WB)
        .add(FloatVector.fromArray(LANE, d, at + INERTIA_B).mul(turnB))
        .intoArray(s, WB);
    normal1.add(normal2).intoArray(s, NORMAL_SUM);
    tangent1.add(tangent2).intoArray(s, TANGENT_SUM);
  }

  /** Applies the impulses to the velocities. */
  private static void applyImpulse(float[] s, float[] d, int at) {
    FloatVector normal = FloatVector.fromArray(LANE, s, NORMAL_SUM);
    FloatVector tangent = FloatVector.fromArray(LANE, s, TANGENT_SUM);
    FloatVector nx = FloatVector.fromArray(LANE, d, at + NX);
    FloatVector ny = FloatVector.fromArray(LANE, d, at + NY);
    FloatVector px = normal.mul(nx).sub(tangent.mul(ny));
    FloatVector py = normal.mul(ny).add(tangent.mul(nx));
    FloatVector massA = FloatVector.fromArray(LANE, d, at + MASS_A);
    FloatVector massB = FloatVector.fromArray(LANE, d, at + MASS_B);
    FloatVector.fromArray(LANE, s, VXA).sub(massA.mul(px)).intoArray(s, VXA);
    FloatVector.fromArray(LANE, s, VYA).sub(massA.mul(py)).intoArray(s, VYA);
    FloatVector.fromArray(LANE, s, VXB).add(massB.mul(px)).intoArray(s, VXB);
    FloatVector.fromArray(LANE, s, VYB).add(massB.mul(py)).intoArray(s, VYB);
  }

  private static void addToTotals(float[] d, int p) {
    FloatVector.fromArray(LANE, d, p + TOTAL_NORMAL)
        .add(FloatVector.fromArray(LANE, d, p + NORMAL_IMPULSE))
        .intoArray(d, p + TOTAL_NORMAL);
    FloatVector.fromArray(LANE, d, p + TOTAL_TANGENT)
        .add(FloatVector.fromArray(LANE, d, p + TANGENT_IMPULSE))
        .intoArray(d, p + TOTAL_TANGENT);
  }
}
