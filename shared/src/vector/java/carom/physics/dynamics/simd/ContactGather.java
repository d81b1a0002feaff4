package carom.physics.dynamics.simd;

import static carom.physics.dynamics.solver.ContactBlocks.LANES;
import static carom.physics.dynamics.solver.ContactBlocks.MASS_A;
import static carom.physics.dynamics.solver.ContactBlocks.MASS_B;
import static carom.physics.dynamics.solver.ContactBlocks.RECORD;

import carom.physics.dynamics.domain.SolverBodies;
import carom.physics.dynamics.solver.ContactBlocks;
import carom.physics.dynamics.solver.ContactSolver;
import carom.physics.simd.VectorKernels;

/**
 * Copies what the kernels for contacts need of a block's bodies to a scratch array, one quantity
 * for all lanes side by side, and back.
 *
 * <p>The lanes are spelt out one after the other: the JIT compiler would give a loop of so few
 * turns pre- and post-loops around an unrolled one.
 */
final class ContactGather {
  // Quantities of the scratch array.

  /** Velocity of A, m/s. */
  static final int VXA = VectorKernels.APART;

  /** The y part of the velocity of A. */
  static final int VYA = VXA + LANES;

  /** Angular velocity of A, rad/s. */
  static final int WA = VYA + LANES;

  /** Velocity of B, m/s. */
  static final int VXB = WA + LANES;

  /** The y part of the velocity of B. */
  static final int VYB = VXB + LANES;

  /** Angular velocity of B, rad/s. */
  static final int WB = VYB + LANES;

  /** Distance by which B moved away from A since the step began, m. */
  static final int MOVED_X = WB + LANES;

  /** The y part of that distance. */
  static final int MOVED_Y = MOVED_X + LANES;

  /** Cosine of A's turn since the step began, minus 1. */
  static final int COS_A = MOVED_Y + LANES;

  /** Sine of A's turn. */
  static final int SIN_A = COS_A + LANES;

  /** Cosine of B's turn, minus 1. */
  static final int COS_B = SIN_A + LANES;

  /** Sine of B's turn. */
  static final int SIN_B = COS_B + LANES;

  /** Offset behind these quantities. */
  static final int END = SIN_B + LANES;

  private ContactGather() {}

  /** Copies the velocities of a block's bodies to the scratch array. */
  static void gather(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
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

  /** Copies how far a block's bodies have moved and turned since the step began. */
  static void gatherMotion(float[] s, float[] v, int[] bodyA, int[] bodyB, int lane) {
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

  /** Copies velocities back to a block's bodies, but for those that can't be moved. */
  static void scatter(float[] s, float[] v, ContactSolver solver, int block) {
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
}
