package carom.physics;

/** Receives contact points, for debug drawing. */
@FunctionalInterface
public interface ContactVisitor {
  /**
   * Called once per contact point of the last step.
   *
   * @param x the point, m
   * @param y the point, m
   * @param normalX unit normal, from the body with the smaller index to the other
   * @param normalY its y
   * @param separation gap when the step began, m; negative when overlapping
   * @param impulse impulse along the normal in the last step, N s
   */
  void contact(float x, float y, float normalX, float normalY, float separation, float impulse);
}
