package carom.physics.dynamics.pairs;

/**
 * Decides whether two bodies may touch, apart from their filters and types: joints keep the bodies
 * apart that they hold together.
 */
@FunctionalInterface
public interface PairRule {
  /**
   * Returns whether two bodies may touch.
   *
   * @param bodyA a slot
   * @param bodyB another slot
   */
  boolean mayTouch(int bodyA, int bodyB);
}
