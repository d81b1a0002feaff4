package carom.physics.dynamics.joint;

import carom.physics.simd.LaneTrust;
import carom.physics.simd.RehearsedLanes;
import carom.physics.simd.VectorModule;

/**
 * Kernels that solve the {@link RevoluteSolver#LANES} pins of a block side by side, bit for bit as
 * {@link RevoluteSolver} does one after the other.
 */
public abstract class RevoluteLanes extends RehearsedLanes {
  private static final LaneTrust TRUST = new LaneTrust();

  public RevoluteLanes() {
    super(TRUST);
  }

  public abstract void measure(RevoluteSolver solver, float[] v, float[] scratch, int block);

  public abstract void warm(RevoluteSolver solver, float[] v, float[] scratch, int block);

  public abstract void push(RevoluteSolver solver, float[] v, float[] scratch, int block);

  public abstract void relax(RevoluteSolver solver, float[] v, float[] scratch, int block);

  /** The kernels made with the Vector API, null without; see {@link VectorModule}. */
  public static RevoluteLanes find() {
    return VectorModule.find("carom.physics.dynamics.simd.VectorRevolutes", RevoluteLanes.class);
  }
}
