package carom.physics;

/** Receives contact points, for debug drawing. */
@FunctionalInterface
public interface ContactVisitor {
  /**
   * Receives a contact point; called once per point of the last step.
   *
   * @param x x of the point, m, world
   * @param y y of the point, m, world
   * @param normalX x of the unit normal, from the body with the smaller index to the other
   * @param normalY y of the unit normal
   * @param separation gap when the step began, m; negative when overlapping
   * @param impulse impulse along the normal in the last step, N s
   */
  void contact(float x, float y, float normalX, float normalY, float separation, float impulse);
}
