package carom.physics;

/**
 * Receives the bodies a query finds.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
@FunctionalInterface
public interface BodyVisitor<T> {
  /**
   * Called once per body.
   *
   * @param body a body; it must not be destroyed, nor another be created, during the query
   * @return false stops the query
   */
  boolean visit(Body<T> body);
}
