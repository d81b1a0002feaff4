package carom.physics.dynamics.solver;

import carom.physics.simd.LaneTrust;
import carom.physics.simd.RehearsedLanes;
import carom.physics.simd.VectorModule;

/**
 * Kernels that solve the {@link ContactBlocks#LANES} contacts of a block side by side, bit for bit
 * as {@link ContactSolver} does one after the other.
 */
public abstract class ContactLanes extends RehearsedLanes {
  private static final LaneTrust TRUST = new LaneTrust();

  public ContactLanes() {
    super(TRUST);
  }

  /** Makes lever arms and masses of a full block that {@link ContactPacker} has copied together. */
  public abstract void arms(float[] data, int at, boolean two);

  public abstract void warm(ContactSolver solver, float[] v, float[] scratch, int block);

  public abstract void push(ContactSolver solver, float[] v, float[] scratch, int block);

  public abstract void relax(ContactSolver solver, float[] v, float[] scratch, int block);

  /** The kernels made with the Vector API, null without; see {@link VectorModule}. */
  public static ContactLanes find() {
    return VectorModule.find("carom.physics.dynamics.simd.VectorContacts", ContactLanes.class);
  }
}
