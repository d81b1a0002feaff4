package carom.physics.dynamics.joint;

import carom.physics.simd.LaneTrust;
import carom.physics.simd.RehearsedLanes;
import carom.physics.simd.VectorModule;

/**
 * Kernels that solve the {@link PinSolver#LANES} pins of a block side by side, bit for bit as
 * {@link PinSolver} does one after the other.
 */
public abstract class PinLanes extends RehearsedLanes {
  private static final LaneTrust TRUST = new LaneTrust();

  public PinLanes() {
    super(TRUST);
  }

  public abstract void measure(PinSolver solver, float[] v, float[] scratch, int block);

  public abstract void warm(PinSolver solver, float[] v, float[] scratch, int block);

  public abstract void push(PinSolver solver, float[] v, float[] scratch, int block);

  public abstract void relax(PinSolver solver, float[] v, float[] scratch, int block);

  /** The kernels made with the Vector API, null without; see {@link VectorModule}. */
  public static PinLanes find() {
    return VectorModule.find("carom.physics.dynamics.simd.VectorPins", PinLanes.class);
  }
}
