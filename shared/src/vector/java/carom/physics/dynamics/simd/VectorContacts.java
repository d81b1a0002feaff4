package carom.physics.dynamics.simd;

import static carom.physics.dynamics.solver.ContactBlocks.CROSS;
import static carom.physics.dynamics.solver.ContactBlocks.EXTRA;
import static carom.physics.dynamics.solver.ContactBlocks.FIRST;
import static carom.physics.dynamics.solver.ContactBlocks.FRICTION;
import static carom.physics.dynamics.solver.ContactBlocks.GAP;
import static carom.physics.dynamics.solver.ContactBlocks.INERTIA_A;
import static carom.physics.dynamics.solver.ContactBlocks.INERTIA_B;
import static carom.physics.dynamics.solver.ContactBlocks.LANES;
import static carom.physics.dynamics.solver.ContactBlocks.MASS_A;
import static carom.physics.dynamics.solver.ContactBlocks.MASS_B;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.NORMAL_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.NX;
import static carom.physics.dynamics.solver.ContactBlocks.NY;
import static carom.physics.dynamics.solver.ContactBlocks.RECORD;
import static carom.physics.dynamics.solver.ContactBlocks.ROUND_A;
import static carom.physics.dynamics.solver.ContactBlocks.ROUND_B;
import static carom.physics.dynamics.solver.ContactBlocks.SECOND;
import static carom.physics.dynamics.solver.ContactBlocks.SEPARATION;
import static carom.physics.dynamics.solver.ContactBlocks.SLIDE;
import static carom.physics.dynamics.solver.ContactBlocks.SURFACE;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_A;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_ARM_B;
import static carom.physics.dynamics.solver.ContactBlocks.TANGENT_MASS;
import static carom.physics.dynamics.solver.ContactBlocks.TOTAL;
import static carom.physics.dynamics.solver.ContactBlocks.YIELD;

import carom.physics.dynamics.solver.ContactBlocks;
import carom.physics.dynamics.solver.ContactLanes;
import carom.physics.dynamics.solver.ContactPacker;
import carom.physics.dynamics.solver.ContactSolver;
import carom.physics.dynamics.solver.SolverBodies;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The contacts of a block at once, with the Vector API: the same operations in the same order as
 * {@link ContactSolver}'s, hence the same bits.
 *
 * <p>The bodies' velocities are first copied, one quantity for all lanes side by side, to a scratch
 * array that stays in the nearest cache; after that all work is on vectors. The methods are small
 * and pass each other arrays, never vectors, and call the Vector API without helpers in between: a
 * vector that crosses a call the JIT compiler didn't inline would be boxed (40 MB per step of the
 * 5,050-box pyramid, and no gain).
 */
public final class VectorContacts extends ContactLanes {
  private static final VectorSpecies<Float> LANE =
      LANES == 16 ? FloatVector.SPECIES_512 : FloatVector.SPECIES_256;

  // Quantities of the scratch array: velocities of the bodies;
  private static final int VXA = APART;
  private static final int VYA = VXA + LANES;
  private static final int WA = VYA + LANES;
  private static final int VXB = WA + LANES;
  private static final int VYB = VXB + LANES;
  private static final int WB = VYB + LANES;

  /** how fast B leaves A along the normal and the tangent, without rotation. */
  private static final int SPEED = WB + LANES;

  private static final int SLIP = SPEED + LANES;

  /** How far the bodies have moved apart and turned. */
  private static final int MOVED_X = SLIP + LANES;

  private static final int MOVED_Y = MOVED_X + LANES;
  private static final int MOVED = MOVED_Y + LANES;
  private static final int COS_A = MOVED + LANES;
  private static final int SIN_A = COS_A + LANES;
  private static final int COS_B = SIN_A + LANES;
  private static final int SIN_B = COS_B + LANES;

  /** Of each point: speed to push with, softness, change of impulse. */
  private static final int URGE = SIN_B + LANES;

  private static final int SOFT = URGE + 2 * LANES;
  private static final int CHANGE = SOFT + 2 * LANES;

  /** Softness that both points share. */
  private static final int SOFT_CROSS = CHANGE + 2 * LANES;

  /** Impulses along normal and tangent. */
  private static final int NORMAL_SUM = SOFT_CROSS + LANES;

  private static final int TANGENT_SUM = NORMAL_SUM + LANES;

  private static final int SCRATCH = TANGENT_SUM + LANES + APART;

  /** Loaded by name, see {@link ContactLanes#FOUND}. */
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
    arms(n, at, true);
    warmOne(n, n, at);
    warmBoth(n, n, at);
    turnToFrame(n, n, at);
    surface(n, n, more);
    soften(n, n, at, 1);
    urge(n, n, first, 0, 1, 1, 1, 1);
    friction(n, n, at, first);
    press(n, n, first);
    turn(n, n, at);
    pressBoth(n, n, at);
    turnBoth(n, n, at);
    give(n, n, at);
    move(n, n, at);
    round(n, n, more);
    room(n, n, first, 0, 1);
    addUp(n, first);
  }

  @Override
  public void arms(float[] d, int at, boolean two) {
    if (two) {
      arms(d, at, at + SECOND);
    }
    arms(d, at, at + FIRST);
    if (two) {
      share(d, at);
    }
  }

  /** The first point's comes last: it holds where B is. */
  private static void arms(float[] d, int at, int p) {
    FloatVector nx = FloatVector.fromArray(LANE, d, at + NX);
    FloatVector ny = FloatVector.fromArray(LANE, d, at + NY);
    FloatVector x = FloatVector.fromArray(LANE, d, p + ContactPacker.ARM_X);
    FloatVector y = FloatVector.fromArray(LANE, d, p + ContactPacker.ARM_Y);
    FloatVector bx = x.sub(FloatVector.fromArray(LANE, d, at + FIRST + ContactPacker.APART_X));
    FloatVector by = y.sub(FloatVector.fromArray(LANE, d, at + FIRST + ContactPacker.APART_Y));
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
        .intoArray(d, p + YIELD);
    FloatVector kt =
        masses.add(inertiaA.mul(tangentA).mul(tangentA)).add(inertiaB.mul(tangentB).mul(tangentB));
    FloatVector zero = FloatVector.zero(LANE);
    zero.blend(FloatVector.broadcast(LANE, 1).div(kt), kt.compare(VectorOperators.GT, 0))
        .intoArray(d, p + TANGENT_MASS);
    FloatVector.fromArray(LANE, d, p + SEPARATION).intoArray(d, p + GAP);
    zero.intoArray(d, p + TOTAL);
    zero.intoArray(d, p + SLIDE);
  }

  /** What the points do to each other. */
  private static void share(float[] d, int at) {
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
    FloatVector.fromArray(LANE, d, at + FIRST + YIELD)
        .mul(ContactPacker.SHARE)
        .intoArray(d, at + FIRST + YIELD);
    FloatVector.fromArray(LANE, d, at + SECOND + YIELD)
        .mul(ContactPacker.SHARE)
        .intoArray(d, at + SECOND + YIELD);
  }

  @Override
  public void warm(ContactSolver solver, float[] v, float[] s, int block) {
    float[] d = solver.blocks.data;
    int at = block * RECORD;
    gather(s, v, solver.blocks.bodyA, solver.blocks.bodyB, block * LANES);
    if ((solver.blocks.traits[block] & ContactBlocks.TWO) != 0) {
      warmBoth(s, d, at);
    } else {
      warmOne(s, d, at);
    }
    give(s, d, at);
    scatter(s, v, solver, block);
  }

  @Override
  public void push(ContactSolver solver, float[] v, float[] s, int block) {
    float[] d = solver.blocks.data;
    int at = block * RECORD;
    int traits = solver.blocks.traits[block];
    int softness = traits & (ContactBlocks.TWO | ContactBlocks.FIXED);
    float rate = solver.biasRate[softness];
    gather(s, v, solver.blocks.bodyA, solver.blocks.bodyB, block * LANES);
    turnToFrame(s, d, at);
    if ((traits & ContactBlocks.MOVING_SURFACE) != 0) {
      surface(s, solver.blocks.extra, block * EXTRA);
    }
    soften(s, d, at, solver.soft[softness]);
    urge(s, d, at + FIRST, 0, rate, solver.inverseH, solver.slop, solver.maxPush);
    friction(s, d, at, at + FIRST);
    if ((traits & ContactBlocks.TWO) != 0) {
      urge(s, d, at + SECOND, LANES, rate, solver.inverseH, solver.slop, solver.maxPush);
      friction(s, d, at, at + SECOND);
      pressBoth(s, d, at);
      turnBoth(s, d, at);
    } else {
      press(s, d, at + FIRST);
      turn(s, d, at);
    }
    give(s, d, at);
    scatter(s, v, solver, block);
  }

  @Override
  public void relax(ContactSolver solver, float[] v, float[] s, int block) {
    float[] d = solver.blocks.data;
    int at = block * RECORD;
    int traits = solver.blocks.traits[block];
    gather(s, v, solver.blocks.bodyA, solver.blocks.bodyB, block * LANES);
    gatherMotion(s, v, solver.blocks.bodyA, solver.blocks.bodyB, block * LANES);
    turnToFrame(s, d, at);
    move(s, d, at);
    if ((traits & ContactBlocks.MOVING_SURFACE) != 0) {
      surface(s, solver.blocks.extra, block * EXTRA);
    }
    if ((traits & ContactBlocks.ROUND) != 0) {
      round(s, solver.blocks.extra, block * EXTRA);
    }
    room(s, d, at + FIRST, 0, solver.inverseH);
    if ((traits & ContactBlocks.TWO) != 0) {
      room(s, d, at + SECOND, LANES, solver.inverseH);
      pressBoth(s, d, at);
      turnBoth(s, d, at);
      friction(s, d, at, at + FIRST);
      friction(s, d, at, at + SECOND);
      addUp(d, at + SECOND);
    } else {
      press(s, d, at + FIRST);
      turn(s, d, at);
      friction(s, d, at, at + FIRST);
    }
    addUp(d, at + FIRST);
    give(s, d, at);
    scatter(s, v, solver, block);
  }

  /*
   * One lane after the other, spelt out: as loops the JIT compiler gives them pre- and post-loops
   * around an unrolled one, for so few turns.
   */

  private static void gather(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
    gatherLane(s, v, bodyA, bodyB, lane, 0);
    gatherLane(s, v, bodyA, bodyB, lane, 1);
    gatherLane(s, v, bodyA, bodyB, lane, 2);
    gatherLane(s, v, bodyA, bodyB, lane, 3);
    gatherLane(s, v, bodyA, bodyB, lane, 4);
    gatherLane(s, v, bodyA, bodyB, lane, 5);
    gatherLane(s, v, bodyA, bodyB, lane, 6);
    gatherLane(s, v, bodyA, bodyB, lane, 7);
    if (LANES == 16) {
      gatherUpper(s, v, bodyA, bodyB, lane);
    }
  }

  private static void gatherUpper(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
    gatherLane(s, v, bodyA, bodyB, lane, 8);
    gatherLane(s, v, bodyA, bodyB, lane, 9);
    gatherLane(s, v, bodyA, bodyB, lane, 10);
    gatherLane(s, v, bodyA, bodyB, lane, 11);
    gatherLane(s, v, bodyA, bodyB, lane, 12);
    gatherLane(s, v, bodyA, bodyB, lane, 13);
    gatherLane(s, v, bodyA, bodyB, lane, 14);
    gatherLane(s, v, bodyA, bodyB, lane, 15);
  }

  private static void gatherLane(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane, int i) {
    int a = bodyA[lane + i];
    int b = bodyB[lane + i];
    s[VXA + i] = v[a + SolverBodies.VX];
    s[VYA + i] = v[a + SolverBodies.VY];
    s[WA + i] = v[a + SolverBodies.W];
    s[VXB + i] = v[b + SolverBodies.VX];
    s[VYB + i] = v[b + SolverBodies.VY];
    s[WB + i] = v[b + SolverBodies.W];
  }

  private static void gatherMotion(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
    gatherMotionLane(s, v, bodyA, bodyB, lane, 0);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 1);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 2);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 3);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 4);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 5);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 6);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 7);
    if (LANES == 16) {
      gatherMotionUpper(s, v, bodyA, bodyB, lane);
    }
  }

  private static void gatherMotionUpper(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
    gatherMotionLane(s, v, bodyA, bodyB, lane, 8);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 9);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 10);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 11);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 12);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 13);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 14);
    gatherMotionLane(s, v, bodyA, bodyB, lane, 15);
  }

  private static void gatherMotionLane(
      float[] s, float[] v, int[] bodyA, int[] bodyB, int lane, int i) {
    int a = bodyA[lane + i];
    int b = bodyB[lane + i];
    s[MOVED_X + i] = v[b + SolverBodies.DX] - v[a + SolverBodies.DX];
    s[MOVED_Y + i] = v[b + SolverBodies.DY] - v[a + SolverBodies.DY];
    s[COS_A + i] = v[a + SolverBodies.COS] - 1;
    s[SIN_A + i] = v[a + SolverBodies.SIN];
    s[COS_B + i] = v[b + SolverBodies.COS] - 1;
    s[SIN_B + i] = v[b + SolverBodies.SIN];
  }

  private static void scatter(float[] s, float[] v, ContactSolver solver, int block) {
    if ((solver.blocks.traits[block] & ContactBlocks.FIXED) != 0) {
      scatterMoved(s, v, solver, block);
    } else {
      scatterBoth(s, v, solver.blocks.bodyA, solver.blocks.bodyB, block * LANES);
    }
  }

  private static void scatterBoth(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
    scatterLane(s, v, bodyA, bodyB, lane, 0);
    scatterLane(s, v, bodyA, bodyB, lane, 1);
    scatterLane(s, v, bodyA, bodyB, lane, 2);
    scatterLane(s, v, bodyA, bodyB, lane, 3);
    scatterLane(s, v, bodyA, bodyB, lane, 4);
    scatterLane(s, v, bodyA, bodyB, lane, 5);
    scatterLane(s, v, bodyA, bodyB, lane, 6);
    scatterLane(s, v, bodyA, bodyB, lane, 7);
    if (LANES == 16) {
      scatterUpper(s, v, bodyA, bodyB, lane);
    }
  }

  private static void scatterUpper(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
    scatterLane(s, v, bodyA, bodyB, lane, 8);
    scatterLane(s, v, bodyA, bodyB, lane, 9);
    scatterLane(s, v, bodyA, bodyB, lane, 10);
    scatterLane(s, v, bodyA, bodyB, lane, 11);
    scatterLane(s, v, bodyA, bodyB, lane, 12);
    scatterLane(s, v, bodyA, bodyB, lane, 13);
    scatterLane(s, v, bodyA, bodyB, lane, 14);
    scatterLane(s, v, bodyA, bodyB, lane, 15);
  }

  private static void scatterLane(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane, int i) {
    int a = bodyA[lane + i];
    int b = bodyB[lane + i];
    v[a + SolverBodies.VX] = s[VXA + i];
    v[a + SolverBodies.VY] = s[VYA + i];
    v[a + SolverBodies.W] = s[WA + i];
    v[b + SolverBodies.VX] = s[VXB + i];
    v[b + SolverBodies.VY] = s[VYB + i];
    v[b + SolverBodies.W] = s[WB + i];
  }

  /** Writes nothing to bodies that can't be moved: other workers may be reading them. */
  private static void scatterMoved(float[] s, float[] v, ContactSolver solver, int block) {
    float[] d = solver.blocks.data;
    for (int i = 0; i < LANES; i++) {
      int a = solver.blocks.bodyA[block * LANES + i];
      int b = solver.blocks.bodyB[block * LANES + i];
      if (d[block * RECORD + MASS_A + i] != 0) {
        v[a + SolverBodies.VX] = s[VXA + i];
        v[a + SolverBodies.VY] = s[VYA + i];
        v[a + SolverBodies.W] = s[WA + i];
      }
      if (d[block * RECORD + MASS_B + i] != 0) {
        v[b + SolverBodies.VX] = s[VXB + i];
        v[b + SolverBodies.VY] = s[VYB + i];
        v[b + SolverBodies.W] = s[WB + i];
      }
    }
  }

  /** Speeds along normal and tangent; no impulse yet. */
  private static void turnToFrame(float[] s, float[] d, int at) {
    FloatVector nx = FloatVector.fromArray(LANE, d, at + NX);
    FloatVector ny = FloatVector.fromArray(LANE, d, at + NY);
    FloatVector dvx = FloatVector.fromArray(LANE, s, VXB).sub(FloatVector.fromArray(LANE, s, VXA));
    FloatVector dvy = FloatVector.fromArray(LANE, s, VYB).sub(FloatVector.fromArray(LANE, s, VYA));
    dvx.mul(nx).add(dvy.mul(ny)).intoArray(s, SPEED);
    dvy.mul(nx).sub(dvx.mul(ny)).intoArray(s, SLIP);
    FloatVector.zero(LANE).intoArray(s, TANGENT_SUM);
  }

  private static void surface(float[] s, float[] extra, int more) {
    FloatVector.fromArray(LANE, s, SLIP)
        .add(FloatVector.fromArray(LANE, extra, more + SURFACE))
        .intoArray(s, SLIP);
  }

  /** How far the bodies moved apart along the normal; rigid from here on. */
  private static void move(float[] s, float[] d, int at) {
    FloatVector.fromArray(LANE, s, MOVED_X)
        .mul(FloatVector.fromArray(LANE, d, at + NX))
        .add(FloatVector.fromArray(LANE, s, MOVED_Y).mul(FloatVector.fromArray(LANE, d, at + NY)))
        .intoArray(s, MOVED);
    FloatVector zero = FloatVector.zero(LANE);
    zero.intoArray(s, SOFT);
    zero.intoArray(s, SOFT + LANES);
    zero.intoArray(s, SOFT_CROSS);
  }

  private static void round(float[] s, float[] extra, int more) {
    FloatVector a =
        FloatVector.fromArray(LANE, extra, more + ROUND_A)
            .mul(FloatVector.fromArray(LANE, s, COS_A));
    FloatVector b =
        FloatVector.fromArray(LANE, extra, more + ROUND_B)
            .mul(FloatVector.fromArray(LANE, s, COS_B));
    FloatVector.fromArray(LANE, s, MOVED).add(a.add(b)).intoArray(s, MOVED);
  }

  /** Friction at a point. */
  private static void friction(float[] s, float[] d, int at, int p) {
    FloatVector wa = FloatVector.fromArray(LANE, s, WA);
    FloatVector wb = FloatVector.fromArray(LANE, s, WB);
    FloatVector slip = FloatVector.fromArray(LANE, s, SLIP);
    FloatVector armA = FloatVector.fromArray(LANE, d, p + TANGENT_ARM_A);
    FloatVector armB = FloatVector.fromArray(LANE, d, p + TANGENT_ARM_B);
    FloatVector limit =
        FloatVector.fromArray(LANE, d, at + FRICTION)
            .mul(FloatVector.fromArray(LANE, d, p + NORMAL));
    FloatVector old = FloatVector.fromArray(LANE, d, p + TANGENT);
    FloatVector sum =
        old.sub(
            FloatVector.fromArray(LANE, d, p + TANGENT_MASS)
                .mul(slip.add(wb.mul(armB).sub(wa.mul(armA)))));
    sum = limit.blend(sum, sum.compare(VectorOperators.LT, limit));
    FloatVector least = limit.neg();
    sum = least.blend(sum, sum.compare(VectorOperators.GT, least));
    sum.intoArray(d, p + TANGENT);
    FloatVector change = sum.sub(old);
    FloatVector masses =
        FloatVector.fromArray(LANE, d, at + MASS_A)
            .add(FloatVector.fromArray(LANE, d, at + MASS_B));
    slip.add(masses.mul(change)).intoArray(s, SLIP);
    wa.sub(FloatVector.fromArray(LANE, d, at + INERTIA_A).mul(armA.mul(change))).intoArray(s, WA);
    wb.add(FloatVector.fromArray(LANE, d, at + INERTIA_B).mul(armB.mul(change))).intoArray(s, WB);
    FloatVector.fromArray(LANE, s, TANGENT_SUM).add(change).intoArray(s, TANGENT_SUM);
  }

  /** Softness of both points, and what they share; those of open gaps are taken away by urge. */
  private static void soften(float[] s, float[] d, int at, float perMass) {
    FloatVector soft =
        FloatVector.fromArray(LANE, d, at + MASS_A)
            .add(FloatVector.fromArray(LANE, d, at + MASS_B))
            .mul(perMass);
    soft.intoArray(s, SOFT);
    soft.intoArray(s, SOFT + LANES);
    soft.mul(ContactSolver.COUPLING).intoArray(s, SOFT_CROSS);
  }

  /** Speed to push a point with, from the gap of the last relaxing visit. */
  private static void urge(
      float[] s,
      float[] d,
      int p,
      int point,
      float rate,
      float inverseH,
      float slop,
      float maxPush) {
    FloatVector gap = FloatVector.fromArray(LANE, d, p + GAP);
    VectorMask<Float> open = gap.compare(VectorOperators.GT, 0);
    FloatVector zero = FloatVector.zero(LANE);
    FloatVector overlap = gap.add(slop);
    overlap = zero.blend(overlap, overlap.compare(VectorOperators.LT, 0));
    FloatVector apart = overlap.mul(rate);
    FloatVector urge = FloatVector.broadcast(LANE, -maxPush);
    urge = urge.blend(apart, apart.compare(VectorOperators.GT, -maxPush));
    urge.blend(gap.mul(inverseH), open).intoArray(s, URGE + point);
    FloatVector.fromArray(LANE, s, SOFT + point).blend(0, open).intoArray(s, SOFT + point);
    FloatVector.fromArray(LANE, s, SOFT_CROSS).blend(0, open).intoArray(s, SOFT_CROSS);
  }

  /** The gap at a point now, and the speed by which it may close. */
  private static void room(float[] s, float[] d, int p, int point, float inverseH) {
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
            .add(FloatVector.fromArray(LANE, s, MOVED).add(turnedB.sub(turnedA)));
    gap.intoArray(d, p + GAP);
    FloatVector zero = FloatVector.zero(LANE);
    zero.blend(gap.mul(inverseH), gap.compare(VectorOperators.GT, 0)).intoArray(s, URGE + point);
  }

  /** Solves the one point. */
  private static void press(float[] s, float[] d, int p) {
    FloatVector old = FloatVector.fromArray(LANE, d, p + NORMAL);
    FloatVector yield = FloatVector.fromArray(LANE, d, p + YIELD);
    FloatVector turning =
        FloatVector.fromArray(LANE, s, WB)
            .mul(FloatVector.fromArray(LANE, d, p + NORMAL_ARM_B))
            .sub(
                FloatVector.fromArray(LANE, s, WA)
                    .mul(FloatVector.fromArray(LANE, d, p + NORMAL_ARM_A)));
    FloatVector q =
        FloatVector.fromArray(LANE, s, SPEED)
            .add(turning)
            .add(FloatVector.fromArray(LANE, s, URGE))
            .sub(yield.mul(old));
    FloatVector zero = FloatVector.zero(LANE);
    FloatVector sum = q.neg().div(yield.add(FloatVector.fromArray(LANE, s, SOFT)));
    sum = zero.blend(sum, q.compare(VectorOperators.LT, 0));
    sum.intoArray(d, p + NORMAL);
    sum.sub(old).intoArray(s, CHANGE);
  }

  /** Solves both points together. */
  private static void pressBoth(float[] s, float[] d, int at) {
    FloatVector old1 = FloatVector.fromArray(LANE, d, at + FIRST + NORMAL);
    FloatVector old2 = FloatVector.fromArray(LANE, d, at + SECOND + NORMAL);
    FloatVector k1 = FloatVector.fromArray(LANE, d, at + FIRST + YIELD);
    FloatVector k2 = FloatVector.fromArray(LANE, d, at + SECOND + YIELD);
    FloatVector k = FloatVector.fromArray(LANE, d, at + CROSS);
    FloatVector speed = FloatVector.fromArray(LANE, s, SPEED);
    FloatVector wa = FloatVector.fromArray(LANE, s, WA);
    FloatVector wb = FloatVector.fromArray(LANE, s, WB);
    FloatVector turning1 =
        wb.mul(FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_B))
            .sub(wa.mul(FloatVector.fromArray(LANE, d, at + FIRST + NORMAL_ARM_A)));
    FloatVector turning2 =
        wb.mul(FloatVector.fromArray(LANE, d, at + SECOND + NORMAL_ARM_B))
            .sub(wa.mul(FloatVector.fromArray(LANE, d, at + SECOND + NORMAL_ARM_A)));
    FloatVector q1 =
        speed
            .add(turning1)
            .add(FloatVector.fromArray(LANE, s, URGE))
            .sub(k1.mul(old1))
            .sub(k.mul(old2));
    FloatVector q2 =
        speed
            .add(turning2)
            .add(FloatVector.fromArray(LANE, s, URGE + LANES))
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
    sum1.intoArray(d, at + FIRST + NORMAL);
    sum2.intoArray(d, at + SECOND + NORMAL);
    sum1.sub(old1).intoArray(s, CHANGE);
    sum2.sub(old2).intoArray(s, CHANGE + LANES);
  }

  /** Lets the change of the one point's impulse turn the bodies. */
  private static void turn(float[] s, float[] d, int at) {
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

  /** Lets the changes of both points' impulses turn the bodies. */
  private static void turnBoth(float[] s, float[] d, int at) {
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

  /** Lets the impulse of the one point turn the bodies. */
  private static void warmOne(float[] s, float[] d, int at) {
    FloatVector normal = FloatVector.fromArray(LANE, d, at + FIRST + NORMAL);
    FloatVector tangent = FloatVector.fromArray(LANE, d, at + FIRST + TANGENT);
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

  /** Lets the impulses of both points turn the bodies. */
  private static void warmBoth(float[] s, float[] d, int at) {
    FloatVector normal1 = FloatVector.fromArray(LANE, d, at + FIRST + NORMAL);
    FloatVector tangent1 = FloatVector.fromArray(LANE, d, at + FIRST + TANGENT);
    FloatVector normal2 = FloatVector.fromArray(LANE, d, at + SECOND + NORMAL);
    FloatVector tangent2 = FloatVector.fromArray(LANE, d, at + SECOND + TANGENT);
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

  /** Lets the impulses change the velocities. */
  private static void give(float[] s, float[] d, int at) {
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

  private static void addUp(float[] d, int p) {
    FloatVector.fromArray(LANE, d, p + TOTAL)
        .add(FloatVector.fromArray(LANE, d, p + NORMAL))
        .intoArray(d, p + TOTAL);
    FloatVector.fromArray(LANE, d, p + SLIDE)
        .add(FloatVector.fromArray(LANE, d, p + TANGENT))
        .intoArray(d, p + SLIDE);
  }
}
