package carom.physics;

/**
 * Receives what a query found, in the query's order.
 *
 * @param <T> the world's user type
 */
@FunctionalInterface
public interface QueryVisitor<T> {
  /**
   * Called once per body found.
   *
   * @param hit reused: copy what you keep; nothing may be created, destroyed or asked again
   * @return true to go on to what lies behind, false to stop here
   */
  boolean visit(QueryHit<T> hit);
}
