package carom.physics.dynamics;

/**
 * Kernels that solve the {@link PinSolver#LANES} pins of a block side by side, bit for bit as
 * {@link PinSolver} does one after the other.
 */
abstract class PinLanes {
  private static final LaneTrust TRUST = new LaneTrust(2_600, 32);

  /** How many of a step's blocks may be given to the kernels. */
  int trusted(int blocks) {
    return TRUST.blocks(blocks);
  }

  /** How long the scratch array of each worker must be. */
  abstract int scratchSize();

  abstract void measure(PinSolver solver, float[] v, float[] scratch, int block);

  abstract void warm(PinSolver solver, float[] v, float[] scratch, int block);

  abstract void push(PinSolver solver, float[] v, float[] scratch, int block);

  abstract void relax(PinSolver solver, float[] v, float[] scratch, int block);

  /** The kernels made with the Vector API, null without; see {@link VectorModule}. */
  static PinLanes find() {
    return VectorModule.find("VectorPins", PinLanes.class);
  }
}
