package carom.physics.rows;

/**
 * The version of the simulation's arithmetic. Worlds of one version that hold the same rows step to
 * the same state hash.
 */
public final class PhysicsVersion {
  /**
   * Number of the version. A change that alters a result of {@code carom.physics}, {@code
   * carom.sim} or a shipped game raises it. Recordings and connections of another version are
   * refused.
   */
  public static final int NUMBER = 8;

  private PhysicsVersion() {}
}
