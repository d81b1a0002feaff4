package carom.physics.dynamics;

/**
 * Kernels that solve the {@link ContactBlocks#LANES} contacts of a block side by side, bit for bit
 * as {@link ContactSolver} does one after the other.
 */
abstract class ContactLanes extends RehearsedLanes {
  private static final LaneTrust TRUST = new LaneTrust();

  ContactLanes() {
    super(TRUST);
  }

  /** Makes lever arms and masses of a full block that {@link ContactPacker} has copied together. */
  abstract void arms(float[] data, int at, boolean two);

  abstract void warm(ContactSolver solver, float[] v, float[] scratch, int block);

  abstract void push(ContactSolver solver, float[] v, float[] scratch, int block);

  abstract void relax(ContactSolver solver, float[] v, float[] scratch, int block);

  /** The kernels made with the Vector API, null without; see {@link VectorModule}. */
  static ContactLanes find() {
    return VectorModule.find("carom.physics.dynamics.VectorLanes", ContactLanes.class);
  }
}
