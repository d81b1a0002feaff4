package carom.physics.dynamics.jointsolver;

import carom.physics.simd.VectorKernels;
import carom.physics.simd.VectorModule;

/**
 * Kernels that solve the {@link RevoluteSolver#LANES} revolute joints of a block side by side, bit
 * for bit as {@link RevoluteSolver} does one after the other.
 */
public abstract class RevoluteLanes extends VectorKernels {
  /** The kernels made with the Vector API, null without; see {@link VectorModule}. */
  public static final RevoluteLanes FOUND =
      VectorModule.find("carom.physics.dynamics.simd.VectorRevolutes", RevoluteLanes.class);

  /** Makes the kernels; they are found by name. */
  protected RevoluteLanes() {}

  /** Returns how long a worker's scratch array must be, {@link #APART} at both ends included. */
  public abstract int scratchSize();

  /** Finds lever arms, bias and mass of a block's joints with the bodies where they are now. */
  public abstract void measure(RevoluteSolver solver, float[] v, float[] scratch, int block);

  /** Applies the impulses of the last substep, or the last step. */
  public abstract void warmStart(RevoluteSolver solver, float[] v, float[] scratch, int block);

  /** Visits a block's joints once, with bias. */
  public abstract void applyBiasedImpulses(
      RevoluteSolver solver, float[] v, float[] scratch, int block);

  /** Visits a block's joints once, rigid, after bodies moved. */
  public abstract void relax(RevoluteSolver solver, float[] v, float[] scratch, int block);
}
