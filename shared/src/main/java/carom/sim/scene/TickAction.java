package carom.sim.scene;

/** An action of a scene that runs before each step, such as a controller or an emitter. */
@FunctionalInterface
interface TickAction {
  /**
   * Runs before a step. It must depend on the tick and the world's state alone, so that a restored
   * world goes on as the saved one did.
   *
   * @param tick number of the step that follows, 0 for the first
   */
  void run(int tick);
}
