package carom.sim;

/**
 * Refuses calls of a simulation's methods in the wrong {@link Role}, during the physics step, or in
 * {@link Game#forces}.
 */
final class CallRules {
  private final Role role;
  private boolean inPhysics;
  private boolean inForces;
  private boolean inInput;

  CallRules(Role role) {
    this.role = role;
  }

  /** Sets whether the physics step runs now. */
  void inPhysics(boolean now) {
    inPhysics = now;
  }

  /** Sets whether {@link Game#forces} is called now. */
  void inForces(boolean now) {
    inForces = now;
  }

  /** Sets whether {@link Game#input} is called now. */
  void inInput(boolean now) {
    inInput = now;
  }

  /**
   * Throws in {@link Game#input}, which clients run, too.
   *
   * @param what the method that was called
   */
  void requireOutsideInput(String what) {
    if (inInput) {
      throw new IllegalStateException(
          what
              + " can't be called in Game.input, which clients run, too; call spawn(archetype, x,"
              + " y, angle, player) there and set its velocity and fields, or do this in"
              + " Game.beforeStep or Game.afterStep");
    }
  }

  /**
   * Throws in {@link Game#forces}, which may change nothing but its body.
   *
   * @param what the method that was called
   */
  void requireOutsideForces(String what) {
    if (inForces) {
      throw new IllegalStateException(
          what
              + " can't be called in Game.forces, which clients run, too: they know only some"
              + " entities, and it may only push the body it is called for; do it in"
              + " Game.beforeStep or Game.afterStep");
    }
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
    requireOutsideForces(what);
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
    requireOutsideForces(what);
    if (inPhysics) {
      throw new IllegalStateException(
          what + " can't be called during the physics step; call it in Game.afterStep");
    }
  }
}
