package carom.physics.collision;

import carom.physics.geometry.Convex;
import carom.physics.math.Transform;

/** Computes contact manifolds. Holds scratch memory: one per thread, then no call allocates. */
public final class Collider {
  /** Makes a collider with its own scratch memory. */
  public Collider() {}

  /**
   * Finds where two convex shapes touch, or nearly do.
   *
   * @param a shape A in its body's frame
   * @param ta pose of A, read only
   * @param b shape B in its body's frame
   * @param tb pose of B, read only
   * @param speculativeDistance points up to this far apart are reported too, metres, not negative
   * @param out receives the manifold; count 0 when the shapes are farther apart
   */
  public void collide(
      Convex a, Transform ta, Convex b, Transform tb, float speculativeDistance, Manifold out) {
    throw new UnsupportedOperationException("soon");
  }
}
