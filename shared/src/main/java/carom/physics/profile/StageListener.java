package carom.physics.profile;

/**
 * Is told which part of a step begins. The engine knows no clock: who wants times reads one here.
 *
 * <p>Called on the thread that steps, some dozens of times per step; what a call costs is part of
 * the stage it ends. It must not touch the world, and changes nothing about the result.
 */
public interface StageListener {
  /**
   * Whatever was under way is done, and this begins.
   *
   * @param stage what follows, until the next call
   */
  void begins(StepStage stage);

  /** The step is done. */
  void done();
}
