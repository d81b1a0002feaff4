package carom.physics.dynamics.simd;

import static carom.physics.dynamics.jointsolver.RevoluteSolver.ARM_AX;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.ARM_AY;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.ARM_BX;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.ARM_BY;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.BIAS_X;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.BIAS_Y;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.GAP_X;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.GAP_Y;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.INERTIA_A;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.INERTIA_B;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.LANES;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.MASS_A;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.MASS_B;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.MAX_ERROR;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.PX;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.PY;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.RAX;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.RAY;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.RBX;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.RBY;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.RECORD;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.XX;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.XY;
import static carom.physics.dynamics.jointsolver.RevoluteSolver.YY;

import carom.physics.dynamics.domain.SolverBodies;
import carom.physics.dynamics.jointsolver.RevoluteLanes;
import carom.physics.dynamics.jointsolver.RevoluteSolver;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Solves the revolute joints of a block at once, with the Vector API: the operations of {@code
 * RevoluteSolver} in the same order, hence the same bits. In small methods that pass each other
 * arrays; see {@code VectorContacts} for why.
 */
public final class VectorRevolutes extends RevoluteLanes {
  private static final VectorSpecies<Float> LANE =
      LANES == 16 ? FloatVector.SPECIES_512 : FloatVector.SPECIES_256;

  // Quantities of the scratch array.

  /** Velocities of both bodies, m/s and rad/s. */
  private static final int AVX = APART;

  private static final int AVY = AVX + LANES;
  private static final int WA = AVY + LANES;
  private static final int BVX = WA + LANES;
  private static final int BVY = BVX + LANES;
  private static final int WB = BVY + LANES;

  /** Distance by which B moved away from A, and the turns of both. */
  private static final int MOVED_X = WB + LANES;

  private static final int MOVED_Y = MOVED_X + LANES;
  private static final int COS_A = MOVED_Y + LANES;
  private static final int SIN_A = COS_A + LANES;
  private static final int COS_B = SIN_A + LANES;
  private static final int SIN_B = COS_B + LANES;

  /** Impulse of this visit on B, N s. */
  private static final int DPX = SIN_B + LANES;

  private static final int DPY = DPX + LANES;

  private static final int SCRATCH = DPY + LANES + APART;

  /** Creates the kernels; called by name, see {@link RevoluteLanes#FOUND}. */
  public VectorRevolutes() {
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
    return SCRATCH + RECORD;
  }

  @Override
  protected void warmUp(float[] n) {
    rotateArms(n, n, SCRATCH);
    bias(n, n, SCRATCH, 1);
    effectiveMass(n, SCRATCH);
    loadImpulses(n, n, SCRATCH);
    applyImpulse(n, n, SCRATCH);
    solveWithBias(n, n, SCRATCH, 1, 1);
    solveRigid(n, n, SCRATCH);
  }

  @Override
  public void measure(RevoluteSolver solver, float[] v, float[] s, int block) {
    float[] d = solver.data;
    int at = block * RECORD;
    gatherMotion(s, v, solver.bodyA, solver.bodyB, block * LANES);
    rotateArms(s, d, at);
    bias(s, d, at, solver.biasRate);
    effectiveMass(d, at);
  }

  @Override
  public void warmStart(RevoluteSolver solver, float[] v, float[] s, int block) {
    float[] d = solver.data;
    int at = block * RECORD;
    gather(s, v, solver.bodyA, solver.bodyB, block * LANES);
    loadImpulses(s, d, at);
    applyImpulse(s, d, at);
    scatter(s, v, solver, block);
  }

  @Override
  public void applyBiasedImpulses(RevoluteSolver solver, float[] v, float[] s, int block) {
    float[] d = solver.data;
    int at = block * RECORD;
    gather(s, v, solver.bodyA, solver.bodyB, block * LANES);
    solveWithBias(s, d, at, solver.massScale, solver.impulseScale);
    applyImpulse(s, d, at);
    scatter(s, v, solver, block);
  }

  @Override
  public void relax(RevoluteSolver solver, float[] v, float[] s, int block) {
    float[] d = solver.data;
    int at = block * RECORD;
    gather(s, v, solver.bodyA, solver.bodyB, block * LANES);
    measure(solver, v, s, block);
    solveRigid(s, d, at);
    applyImpulse(s, d, at);
    scatter(s, v, solver, block);
  }

  private static void gather(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
    for (int i = 0; i < LANES; i++) {
      int a = bodyA[lane + i];
      int b = bodyB[lane + i];
      s[AVX + i] = v[a + SolverBodies.VX];
      s[AVY + i] = v[a + SolverBodies.VY];
      s[WA + i] = v[a + SolverBodies.W];
      s[BVX + i] = v[b + SolverBodies.VX];
      s[BVY + i] = v[b + SolverBodies.VY];
      s[WB + i] = v[b + SolverBodies.W];
    }
  }

  private static void gatherMotion(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
    for (int i = 0; i < LANES; i++) {
      int a = bodyA[lane + i];
      int b = bodyB[lane + i];
      s[MOVED_X + i] = v[b + SolverBodies.DX] - v[a + SolverBodies.DX];
      s[MOVED_Y + i] = v[b + SolverBodies.DY] - v[a + SolverBodies.DY];
      s[COS_A + i] = v[a + SolverBodies.COS];
      s[SIN_A + i] = v[a + SolverBodies.SIN];
      s[COS_B + i] = v[b + SolverBodies.COS];
      s[SIN_B + i] = v[b + SolverBodies.SIN];
    }
  }

  private static void scatter(float[] s, float[] v, RevoluteSolver solver, int block) {
    if (solver.loose[block]) {
      scatterBoth(s, v, solver.bodyA, solver.bodyB, block * LANES);
    } else {
      scatterMoved(s, v, solver, block);
    }
  }

  private static void scatterBoth(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
    for (int i = 0; i < LANES; i++) {
      int a = bodyA[lane + i];
      int b = bodyB[lane + i];
      v[a + SolverBodies.VX] = s[AVX + i];
      v[a + SolverBodies.VY] = s[AVY + i];
      v[a + SolverBodies.W] = s[WA + i];
      v[b + SolverBodies.VX] = s[BVX + i];
      v[b + SolverBodies.VY] = s[BVY + i];
      v[b + SolverBodies.W] = s[WB + i];
    }
  }

  /** Writes nothing to bodies that can't be moved: other workers may be reading them. */
  private static void scatterMoved(float[] s, float[] v, RevoluteSolver solver, int block) {
    float[] d = solver.data;
    for (int i = 0; i < LANES; i++) {
      if (d[block * RECORD + MASS_A + i] != 0) {
        int a = solver.bodyA[block * LANES + i];
        v[a + SolverBodies.VX] = s[AVX + i];
        v[a + SolverBodies.VY] = s[AVY + i];
        v[a + SolverBodies.W] = s[WA + i];
      }
      if (d[block * RECORD + MASS_B + i] != 0) {
        int b = solver.bodyB[block * LANES + i];
        v[b + SolverBodies.VX] = s[BVX + i];
        v[b + SolverBodies.VY] = s[BVY + i];
        v[b + SolverBodies.W] = s[WB + i];
      }
    }
  }

  /** Loads the impulse of the substep before. */
  private static void loadImpulses(float[] s, float[] d, int at) {
    FloatVector.fromArray(LANE, d, at + PX).intoArray(s, DPX);
    FloatVector.fromArray(LANE, d, at + PY).intoArray(s, DPY);
  }

  /** Turns lever arms to where the bodies are now. */
  private static void rotateArms(float[] s, float[] d, int at) {
    FloatVector x = FloatVector.fromArray(LANE, d, at + ARM_AX);
    FloatVector y = FloatVector.fromArray(LANE, d, at + ARM_AY);
    FloatVector cos = FloatVector.fromArray(LANE, s, COS_A);
    FloatVector sin = FloatVector.fromArray(LANE, s, SIN_A);
    cos.mul(x).sub(sin.mul(y)).intoArray(d, at + RAX);
    sin.mul(x).add(cos.mul(y)).intoArray(d, at + RAY);
    x = FloatVector.fromArray(LANE, d, at + ARM_BX);
    y = FloatVector.fromArray(LANE, d, at + ARM_BY);
    cos = FloatVector.fromArray(LANE, s, COS_B);
    sin = FloatVector.fromArray(LANE, s, SIN_B);
    cos.mul(x).sub(sin.mul(y)).intoArray(d, at + RBX);
    sin.mul(x).add(cos.mul(y)).intoArray(d, at + RBY);
  }

  /** Finds the bias from the gap of the anchors. Both impulses act at B's anchor. */
  private static void bias(float[] s, float[] d, int at, float biasRate) {
    FloatVector ax = FloatVector.fromArray(LANE, d, at + RAX);
    FloatVector ay = FloatVector.fromArray(LANE, d, at + RAY);
    FloatVector dx =
        FloatVector.fromArray(LANE, d, at + GAP_X)
            .add(FloatVector.fromArray(LANE, s, MOVED_X))
            .add(FloatVector.fromArray(LANE, d, at + RBX).sub(ax));
    FloatVector dy =
        FloatVector.fromArray(LANE, d, at + GAP_Y)
            .add(FloatVector.fromArray(LANE, s, MOVED_Y))
            .add(FloatVector.fromArray(LANE, d, at + RBY).sub(ay));
    FloatVector far = dx.abs().add(dy.abs());
    VectorMask<Float> near = far.compare(VectorOperators.LE, MAX_ERROR);
    ax.blend(ax.add(dx), near).intoArray(d, at + RAX);
    ay.blend(ay.add(dy), near).intoArray(d, at + RAY);
    FloatVector plain = FloatVector.broadcast(LANE, biasRate);
    FloatVector less = FloatVector.broadcast(LANE, biasRate * MAX_ERROR).div(far);
    FloatVector rate = plain.blend(less, far.compare(VectorOperators.GT, MAX_ERROR));
    rate.mul(dx).intoArray(d, at + BIAS_X);
    rate.mul(dy).intoArray(d, at + BIAS_Y);
  }

  /** Finds the effective mass of the point. */
  private static void effectiveMass(float[] d, int at) {
    FloatVector masses =
        FloatVector.fromArray(LANE, d, at + MASS_A)
            .add(FloatVector.fromArray(LANE, d, at + MASS_B));
    FloatVector inertiaA = FloatVector.fromArray(LANE, d, at + INERTIA_A);
    FloatVector inertiaB = FloatVector.fromArray(LANE, d, at + INERTIA_B);
    FloatVector ax = FloatVector.fromArray(LANE, d, at + RAX);
    FloatVector ay = FloatVector.fromArray(LANE, d, at + RAY);
    FloatVector bx = FloatVector.fromArray(LANE, d, at + RBX);
    FloatVector by = FloatVector.fromArray(LANE, d, at + RBY);
    FloatVector xx = masses.add(inertiaA.mul(ay.mul(ay)).add(inertiaB.mul(by.mul(by))));
    FloatVector xy = inertiaA.mul(ax.mul(ay)).add(inertiaB.mul(bx.mul(by)));
    FloatVector yy = masses.add(inertiaA.mul(ax.mul(ax)).add(inertiaB.mul(bx.mul(bx))));
    FloatVector determinant = xx.mul(yy).sub(xy.mul(xy));
    FloatVector zero = FloatVector.zero(LANE);
    FloatVector one = FloatVector.broadcast(LANE, 1);
    FloatVector inverse =
        zero.blend(one.div(determinant), determinant.compare(VectorOperators.GT, 0));
    xx.mul(inverse).intoArray(d, at + XX);
    xy.mul(inverse).intoArray(d, at + XY);
    yy.mul(inverse).intoArray(d, at + YY);
  }

  /** Finds the impulse of a visit with bias, which draws the anchors together. */
  private static void solveWithBias(
      float[] s, float[] d, int at, float massScale, float impulseScale) {
    relativeVelocity(s, d, at);
    FloatVector x =
        FloatVector.fromArray(LANE, s, DPX).add(FloatVector.fromArray(LANE, d, at + BIAS_X));
    FloatVector y =
        FloatVector.fromArray(LANE, s, DPY).add(FloatVector.fromArray(LANE, d, at + BIAS_Y));
    FloatVector xy = FloatVector.fromArray(LANE, d, at + XY);
    FloatVector oldX = FloatVector.fromArray(LANE, d, at + PX);
    FloatVector oldY = FloatVector.fromArray(LANE, d, at + PY);
    FloatVector px =
        FloatVector.fromArray(LANE, d, at + YY)
            .mul(x)
            .add(xy.mul(y))
            .neg()
            .mul(massScale)
            .sub(oldX.mul(impulseScale));
    FloatVector py =
        FloatVector.fromArray(LANE, d, at + XX)
            .mul(y)
            .add(xy.mul(x))
            .neg()
            .mul(massScale)
            .sub(oldY.mul(impulseScale));
    oldX.add(px).intoArray(d, at + PX);
    oldY.add(py).intoArray(d, at + PY);
    px.intoArray(s, DPX);
    py.intoArray(s, DPY);
  }

  /** Finds the impulse of a rigid visit. */
  private static void solveRigid(float[] s, float[] d, int at) {
    relativeVelocity(s, d, at);
    FloatVector x = FloatVector.fromArray(LANE, s, DPX);
    FloatVector y = FloatVector.fromArray(LANE, s, DPY);
    FloatVector xy = FloatVector.fromArray(LANE, d, at + XY);
    FloatVector px = FloatVector.fromArray(LANE, d, at + YY).mul(x).add(xy.mul(y)).neg();
    FloatVector py = FloatVector.fromArray(LANE, d, at + XX).mul(y).add(xy.mul(x)).neg();
    FloatVector.fromArray(LANE, d, at + PX).add(px).intoArray(d, at + PX);
    FloatVector.fromArray(LANE, d, at + PY).add(py).intoArray(d, at + PY);
    px.intoArray(s, DPX);
    py.intoArray(s, DPY);
  }

  /** Finds how fast the anchors part, in the place of the impulse. */
  private static void relativeVelocity(float[] s, float[] d, int at) {
    FloatVector wa = FloatVector.fromArray(LANE, s, WA);
    FloatVector wb = FloatVector.fromArray(LANE, s, WB);
    FloatVector.fromArray(LANE, s, BVX)
        .sub(FloatVector.fromArray(LANE, s, AVX))
        .add(
            wa.mul(FloatVector.fromArray(LANE, d, at + RAY))
                .sub(wb.mul(FloatVector.fromArray(LANE, d, at + RBY))))
        .intoArray(s, DPX);
    FloatVector.fromArray(LANE, s, BVY)
        .sub(FloatVector.fromArray(LANE, s, AVY))
        .add(
            wb.mul(FloatVector.fromArray(LANE, d, at + RBX))
                .sub(wa.mul(FloatVector.fromArray(LANE, d, at + RAX))))
        .intoArray(s, DPY);
  }

  /** Applies the impulse to the velocities. */
  private static void applyImpulse(float[] s, float[] d, int at) {
    FloatVector px = FloatVector.fromArray(LANE, s, DPX);
    FloatVector py = FloatVector.fromArray(LANE, s, DPY);
    FloatVector massA = FloatVector.fromArray(LANE, d, at + MASS_A);
    FloatVector massB = FloatVector.fromArray(LANE, d, at + MASS_B);
    FloatVector.fromArray(LANE, s, AVX).sub(massA.mul(px)).intoArray(s, AVX);
    FloatVector.fromArray(LANE, s, AVY).sub(massA.mul(py)).intoArray(s, AVY);
    FloatVector.fromArray(LANE, s, BVX).add(massB.mul(px)).intoArray(s, BVX);
    FloatVector.fromArray(LANE, s, BVY).add(massB.mul(py)).intoArray(s, BVY);
    FloatVector turnA =
        FloatVector.fromArray(LANE, d, at + RAX)
            .mul(py)
            .sub(FloatVector.fromArray(LANE, d, at + RAY).mul(px));
    FloatVector turnB =
        FloatVector.fromArray(LANE, d, at + RBX)
            .mul(py)
            .sub(FloatVector.fromArray(LANE, d, at + RBY).mul(px));
    FloatVector.fromArray(LANE, s, WA)
        .sub(FloatVector.fromArray(LANE, d, at + INERTIA_A).mul(turnA))
        .intoArray(s, WA);
    FloatVector.fromArray(LANE, s, WB)
        .add(FloatVector.fromArray(LANE, d, at + INERTIA_B).mul(turnB))
        .intoArray(s, WB);
  }
}
