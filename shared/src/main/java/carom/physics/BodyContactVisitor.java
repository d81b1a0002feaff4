package carom.physics;

/**
 * Receives what touched one body in the last step.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
@FunctionalInterface
public interface BodyContactVisitor<T> {
  /**
   * Called once per pair of touching shapes.
   *
   * @param other the other body
   * @param normalX unit normal from the asking body towards the other
   * @param normalY its y; below -0.7 means "I stand on it" with y up
   * @param impulse total impulse along the normal in the last step, N s, not negative; 0 if the
   *     shapes were merely close, or vetoed
   */
  void contact(Body<T> other, float normalX, float normalY, float impulse);
}
