package carom.physics.profile;

/**
 * Listener that learns which stage of a step begins. The engine reads no clock; a program that
 * measures times reads one here.
 *
 * <p>The world calls it on the thread that steps, some dozens of times per step. The cost of a call
 * counts for the stage that it ends. A listener must not touch the world, and it has no influence
 * on the result.
 */
public interface StageListener {
  /**
   * Reports that a stage begins and the one before has ended.
   *
   * @param stage the stage that runs until the next call
   */
  void begins(StepStage stage);

  /** Reports that the step has ended. */
  void done();
}
