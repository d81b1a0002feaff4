package carom.physics.dynamics.solver;

import carom.physics.simd.VectorKernels;
import carom.physics.simd.VectorModule;

/**
 * Kernels that solve the {@link ContactBlocks#LANES} contacts of a block side by side, bit for bit
 * as {@link ContactSolver} does one after the other.
 */
public abstract class ContactLanes extends VectorKernels {
  /** The kernels made with the Vector API, null without; see {@link VectorModule}. */
  public static final ContactLanes FOUND =
      VectorModule.find("carom.physics.dynamics.simd.VectorContacts", ContactLanes.class);

  /** Makes the kernels; they are found by name. */
  protected ContactLanes() {}

  /** Returns how long a worker's scratch array must be, {@link #APART} at both ends included. */
  public abstract int scratchSize();

  /** Makes lever arms and masses of a full block that {@link ContactPacker} has copied together. */
  public abstract void leverArms(float[] data, int at, boolean two);

  /** Applies the impulses that a block's contacts start with. */
  public abstract void warmStart(ContactSolver solver, float[] v, float[] scratch, int block);

  /** Visits a block's contacts once, with their springs. */
  public abstract void applyBiasedImpulses(
      ContactSolver solver, float[] v, float[] scratch, int block);

  /** Visits a block's contacts once, rigid. */
  public abstract void relax(ContactSolver solver, float[] v, float[] scratch, int block);
}
