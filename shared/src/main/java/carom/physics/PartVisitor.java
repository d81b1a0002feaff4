package carom.physics;

import carom.physics.geometry.Convex;
import carom.physics.math.Transform;

/**
 * Receives the convex parts that a query finds.
 *
 * @param <T> the world's user type
 */
@FunctionalInterface
public interface PartVisitor<T> {
  /**
   * Receives a part. It must not create or destroy anything, or make another query.
   *
   * @param body the part's body
   * @param shape number of the shape that the part belongs to, see {@link Body#shape}
   * @param part the geometry, relative to {@code pose}; immutable
   * @param pose the body's centre of mass and rotation; reused for the next part: copy it
   * @return true to continue with the next part, false to stop
   */
  boolean visit(Body<T> body, int shape, Convex part, Transform pose);
}
