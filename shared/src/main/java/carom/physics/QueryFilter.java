package carom.physics;

/**
 * Chooses the shapes that a query sees.
 *
 * @param <T> the world's user type
 */
@FunctionalInterface
public interface QueryFilter<T> {
  /**
   * Returns whether a query sees a shape. It is called for shapes that may be hit, in no particular
   * order, maybe several times, so the answer must not depend on order. It must not create, destroy
   * or change anything, or make another query.
   *
   * @param body the body of the shape
   * @param shape number of the shape, see {@link Body#shape}
   * @return false to ignore the shape
   */
  boolean accepts(Body<T> body, int shape);
}
