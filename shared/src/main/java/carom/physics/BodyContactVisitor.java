package carom.physics;

/**
 * Receives the contacts of one body in the last step.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
@FunctionalInterface
public interface BodyContactVisitor<T> {
  /**
   * Receives a contact; called once per pair of touching shapes.
   *
   * @param other the other body
   * @param normalX x of the unit normal from the visited body towards the other
   * @param normalY y of the unit normal; below -0.7 the visited body stands on the other one, as y
   *     points up
   * @param impulse total impulse along the normal in the last step, N s, not negative; 0 if the
   *     shapes were merely close, or vetoed
   */
  void contact(Body<T> other, float normalX, float normalY, float impulse);
}
