package carom.physics.dynamics.pairs;

/** Decides whether two parts may touch, after filters, types and joints have let them. */
@FunctionalInterface
public interface PartRule {
  /**
   * Returns whether two parts may touch. Called on the thread that steps.
   *
   * @param partA a part of the body with the smaller slot
   * @param partB a part of the other body
   */
  boolean mayTouch(int partA, int partB);
}
