package carom.physics.dynamics;

/**
 * Kernels that solve the {@link PinSolver#LANES} pins of a block side by side, bit for bit as
 * {@link PinSolver} does one after the other.
 */
abstract class PinLanes extends RehearsedLanes {
  private static final LaneTrust TRUST = new LaneTrust();

  PinLanes() {
    super(TRUST);
  }

  abstract void measure(PinSolver solver, float[] v, float[] scratch, int block);

  abstract void warm(PinSolver solver, float[] v, float[] scratch, int block);

  abstract void push(PinSolver solver, float[] v, float[] scratch, int block);

  abstract void relax(PinSolver solver, float[] v, float[] scratch, int block);

  /** The kernels made with the Vector API, null without; see {@link VectorModule}. */
  static PinLanes find() {
    return VectorModule.find("carom.physics.dynamics.VectorPins", PinLanes.class);
  }
}
