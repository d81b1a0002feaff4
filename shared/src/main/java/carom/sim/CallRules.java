package carom.sim;

/** Refuses calls of a simulation's methods in the wrong {@link Role} or during the physics step. */
final class CallRules {
  private final Role role;
  private boolean inPhysics;

  CallRules(Role role) {
    this.role = role;
  }

  /** Sets whether the physics step runs now. */
  void inPhysics(boolean now) {
    inPhysics = now;
  }

  /**
   * Throws unless the role is {@link Role#AUTHORITY} and the physics step does not run.
   *
   * @param what the method that was called
   */
  void requireAuthority(String what) {
    require(Role.AUTHORITY, what);
  }

  /**
   * Throws unless the role is {@link Role#PREDICTION} and the physics step does not run.
   *
   * @param what the method that was called
   */
  void requirePrediction(String what) {
    require(Role.PREDICTION, what);
  }

  private void require(Role wanted, String what) {
    if (role != wanted) {
      throw new IllegalStateException(
          what + " is for the " + wanted + " role only, this is " + role);
    }
    requireOutsidePhysics(what);
  }

  /**
   * Throws while the physics step runs.
   *
   * @param what the method that was called
   */
  void requireOutsidePhysics(String what) {
    if (inPhysics) {
      throw new IllegalStateException(
          what + " can't be called during the physics step; call it in Game.afterStep");
    }
  }
}
