package carom.physics;

/**
 * Chooses whom a query sees.
 *
 * @param <T> the world's user type
 */
@FunctionalInterface
public interface QueryFilter<T> {
  /**
   * Called for shapes that may be hit, in no particular order, maybe several times; so the answer
   * must not depend on order, and nothing may be created, destroyed, changed or asked again.
   *
   * @param body whose shape it is
   * @param shape its number, see {@link Body#shape}
   * @return false to look through it
   */
  boolean accepts(Body<T> body, int shape);
}
