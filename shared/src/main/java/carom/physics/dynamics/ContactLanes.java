package carom.physics.dynamics;

/**
 * Kernels that solve the {@link ContactBlocks#LANES} contacts of a block side by side, bit for bit
 * as {@link ContactSolver} does one after the other.
 */
abstract class ContactLanes {
  private static final LaneTrust TRUST = new LaneTrust(2_600, 32);

  /** How many of a step's blocks may be given to the kernels. */
  int trusted(int blocks) {
    return TRUST.blocks(blocks);
  }

  /** How long the scratch array of each worker must be. */
  abstract int scratchSize();

  /** Makes lever arms and masses of a full block that {@link ContactPacker} has copied together. */
  abstract void arms(float[] data, int at, boolean two);

  abstract void warm(ContactSolver solver, float[] v, float[] scratch, int block);

  abstract void push(ContactSolver solver, float[] v, float[] scratch, int block);

  abstract void relax(ContactSolver solver, float[] v, float[] scratch, int block);

  /** The kernels made with the Vector API, null without; see {@link VectorModule}. */
  static ContactLanes find() {
    return VectorModule.find("VectorLanes", ContactLanes.class);
  }
}
