package carom.sim;

/** Refuses calls of a simulation's methods in the wrong {@link Role} or during the physics. */
final class CallRules {
  private final Role role;
  private boolean physicsRun;

  CallRules(Role role) {
    this.role = role;
  }

  /** Notes whether the physics runs now. */
  void physicsRun(boolean now) {
    physicsRun = now;
  }

  void requireAuthority(String what) {
    require(Role.AUTHORITY, what);
  }

  void requirePrediction(String what) {
    require(Role.PREDICTION, what);
  }

  private void require(Role wanted, String what) {
    if (role != wanted) {
      throw new IllegalStateException(
          what + " is for the " + wanted + " role only, this is " + role);
    }
    requireQuiet(what);
  }

  /** Refuses a call during the physics. */
  void requireQuiet(String what) {
    if (physicsRun) {
      throw new IllegalStateException(
          what + " can't happen while the physics step; do it in Game.afterStep");
    }
  }
}
