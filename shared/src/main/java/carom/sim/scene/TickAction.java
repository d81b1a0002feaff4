package carom.sim.scene;

/** What a scene does by itself before each step: controllers, emitters. */
@FunctionalInterface
public interface TickAction {
  /**
   * Called before a step. It must depend on the tick and the world's state alone, so that a
   * restored world goes on as the saved one did.
   *
   * @param tick number of the step that follows, 0 for the first
   */
  void run(int tick);
}
