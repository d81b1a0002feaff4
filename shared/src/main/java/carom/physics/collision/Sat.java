package carom.physics.collision;

import carom.physics.geometry.Shape;
import carom.physics.math.Transform;

/**
 * Overlap tests and minimum translation vectors. Holds scratch memory: one per thread, then no call
 * allocates.
 */
public final class Sat {
  /** Makes an instance with its own scratch memory. */
  public Sat() {}

  /**
   * Finds the shortest move that takes A out of B.
   *
   * @return true when the shapes overlap; false when they are apart or only touch, and {@code out}
   *     is then zero
   */
  public boolean mtv(Shape a, Transform ta, Shape b, Transform tb, Mtv out) {
    throw new UnsupportedOperationException("soon");
  }
}
