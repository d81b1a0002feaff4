package carom.physics.dynamics.contact;

/**
 * Receives the contact events of {@code Dynamics.step}. The argument is a row of the contact table,
 * valid during the call; order and rules are those of {@code carom.physics.CollisionListener}.
 */
public interface ContactEvents {
  /**
   * Receives two parts that began to touch.
   *
   * @param row of the contact table
   */
  void begin(int row);

  /**
   * Receives two parts that no longer touch.
   *
   * @param row of the contact table
   */
  void end(int row);

  /**
   * Decides about two parts that touch and are about to be solved.
   *
   * @param row of the contact table
   * @return false to leave them alone in this step
   */
  boolean preSolve(int row);

  /**
   * Decides about two parts of which one would be stopped at the other by continuous collision.
   *
   * @param table whose only row is their contact at the place of the impact
   * @return false to let them pass in this step
   */
  boolean preSolveSwept(ContactTable table);

  /**
   * Receives two parts that were solved.
   *
   * @param row of the contact table
   */
  void postSolve(int row);

  /**
   * Receives two parts that hit each other.
   *
   * @param row of the contact table
   * @param speed how fast they approached, m/s
   */
  void hit(int row, float speed);
}
