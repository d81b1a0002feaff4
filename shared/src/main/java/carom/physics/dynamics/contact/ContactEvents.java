package carom.physics.dynamics.contact;

/**
 * What {@code Dynamics.step} tells its owner. The argument is a row of the contact table, valid
 * during the call; order and rules are those of {@code carom.physics.CollisionListener}.
 */
public interface ContactEvents {
  /**
   * Two parts began to touch.
   *
   * @param row of the contact table
   */
  void begin(int row);

  /**
   * Two parts no longer touch.
   *
   * @param row of the contact table
   */
  void end(int row);

  /**
   * Two parts touch and are about to be solved.
   *
   * @param row of the contact table
   * @return false to leave them alone in this step
   */
  boolean preSolve(int row);

  /**
   * Two parts were solved.
   *
   * @param row of the contact table
   */
  void postSolve(int row);

  /**
   * Two parts hit each other.
   *
   * @param row of the contact table
   * @param speed how fast they approached, m/s
   */
  void hit(int row, float speed);
}
