package carom.physics.dynamics;

import jdk.incubator.vector.FloatVector;

/** How many floats this processor's vectors have. */
final class VectorWidth implements VectorModule.Width {
  private final int floats = FloatVector.SPECIES_PREFERRED.length();

  /** Loaded by name, see {@link VectorModule#LANES}; fails without the module. */
  VectorWidth() {}

  /**
   * Refuses kernels for longer vectors than this processor has.
   *
   * @param lanes floats that a vector must have
   * @throws UnsupportedOperationException if it has fewer
   */
  static void require(int lanes) {
    if (FloatVector.SPECIES_PREFERRED.length() < lanes) {
      throw new UnsupportedOperationException("vectors have fewer than " + lanes + " lanes");
    }
  }

  @Override
  public int floats() {
    return floats;
  }
}
