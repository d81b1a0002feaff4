package carom.physics;

/**
 * Receives the hits of a query, in the query's order.
 *
 * @param <T> the world's user type
 */
@FunctionalInterface
public interface QueryVisitor<T> {
  /**
   * Receives a hit; called once per body found. It must not create or destroy anything, or make
   * another query.
   *
   * @param hit reused for the next hit: copy what you keep
   * @return true to continue with the next hit, false to stop
   */
  boolean visit(QueryHit<T> hit);
}
