package carom.physics;

/**
 * Receives the bodies a query finds.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
@FunctionalInterface
public interface BodyVisitor<T> {
  /**
   * Receives a body; called once per body. It must not destroy the body or create another during
   * the query.
   *
   * @param body a body that was found
   * @return true to continue, false to stop the query
   */
  boolean visit(Body<T> body);
}
