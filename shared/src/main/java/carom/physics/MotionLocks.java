package carom.physics;

/**
 * The axes along which nothing but {@link Body#setVelocity} and {@link Body#setAngularVelocity}
 * moves a dynamic body: no force, gravity, contact or joint. Along a locked axis the body behaves
 * as if it were kinematic. Axes are those of the world. Static and kinematic bodies ignore locks.
 *
 * @param linearX true if x is locked
 * @param linearY true if y is locked
 * @param angularZ true if the rotation is locked, as by {@link BodyDef#fixedRotation}
 */
public record MotionLocks(boolean linearX, boolean linearY, boolean angularZ) {
  /** No locks, which is the default. */
  public static final MotionLocks NONE = new MotionLocks(false, false, false);

  /**
   * Returns a copy with the rotation locked or free.
   *
   * @param locked true to lock it
   * @return a changed copy
   */
  public MotionLocks withAngularZ(boolean locked) {
    return new MotionLocks(linearX, linearY, locked);
  }
}
