package carom.sim.entity;

/**
 * Refuses calls of a simulation's methods in the wrong {@code Role}, during the physics step, or in
 * {@code Game.forces}.
 */
public final class CallRules {
  private final boolean decides;
  private boolean inPhysics;
  private boolean inForces;
  private boolean inInput;

  /**
   * Creates the rules of a simulation that doesn't compute yet.
   *
   * @param decides whether its role is {@code AUTHORITY}, else {@code PREDICTION}
   */
  public CallRules(boolean decides) {
    this.decides = decides;
  }

  /** Sets whether the physics step runs now. */
  public void inPhysics(boolean now) {
    inPhysics = now;
  }

  /** Sets whether {@code Game.forces} is called now. */
  public void inForces(boolean now) {
    inForces = now;
  }

  /** Sets whether {@code Game.input} is called now. */
  public void inInput(boolean now) {
    inInput = now;
  }

  /**
   * Throws in {@code Game.input}, which clients run, too.
   *
   * @param what the method that was called
   */
  public void requireOutsideInput(String what) {
    if (inInput) {
      throw new IllegalStateException(
          what
              + " can't be called in Game.input, which clients run, too; call Player.spawn there"
              + " and set its velocity and fields, or do this in Game.beforeStep or"
              + " Game.afterStep");
    }
  }

  /**
   * Throws in {@code Game.forces}, which may change nothing but its body.
   *
   * @param what the method that was called
   */
  public void requireOutsideForces(String what) {
    if (inForces) {
      throw new IllegalStateException(
          what
              + " can't be called in Game.forces, which clients run, too: they know only some"
              + " entities, and it may only push the body it is called for; do it in"
              + " Game.beforeStep or Game.afterStep");
    }
  }

  /**
   * Throws unless the role is {@code Role.AUTHORITY} and the physics step does not run.
   *
   * @param what the method that was called
   */
  public void requireAuthority(String what) {
    require(true, what);
  }

  /**
   * Throws unless the role is {@code Role.PREDICTION} and the physics step does not run.
   *
   * @param what the method that was called
   */
  public void requirePrediction(String what) {
    require(false, what);
  }

  private void require(boolean deciding, String what) {
    requireOutsideForces(what);
    if (decides != deciding) {
      throw new IllegalStateException(
          what + " is for the " + role(deciding) + " role only, this is " + role(decides));
    }
    requireOutsidePhysics(what);
  }

  private static String role(boolean decides) {
    return decides ? "AUTHORITY" : "PREDICTION";
  }

  /**
   * Throws while the physics step runs.
   *
   * @param what the method that was called
   */
  public void requireOutsidePhysics(String what) {
    requireOutsideForces(what);
    if (inPhysics) {
      throw new IllegalStateException(
          what + " can't be called during the physics step; call it in Game.afterStep");
    }
  }
}
