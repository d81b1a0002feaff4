package carom.physics.simd;

import jdk.incubator.vector.FloatVector;

/** Tells how many floats this processor's vectors have. */
public final class VectorWidth implements VectorModule.Width {
  private final int floats = FloatVector.SPECIES_PREFERRED.length();

  /**
   * Creates the kernels; called by name, see {@link VectorModule#LANES}; fails without the module.
   */
  public VectorWidth() {}

  @Override
  public int floats() {
    return floats;
  }
}
