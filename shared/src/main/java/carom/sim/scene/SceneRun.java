package carom.sim.scene;

import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.WorldState;

/**
 * A scene that is running: its world and the number of steps made. One thread at a time; a steady
 * step allocates nothing unless the scene makes bodies.
 */
public final class SceneRun {
  private final Scene scene;
  private final World<String> world;
  private final Stage<String> stage;
  private final float tickSeconds;
  private int tick;

  SceneRun(Scene scene, WorldDef def) {
    this.scene = scene;
    world = new World<>(def);
    stage = new Stage<>(world);
    scene.build(stage);
    world.listener(stage.listener());
    tickSeconds = 1f / scene.tickRate();
  }

  /**
   * What is running.
   *
   * @return its recipe
   */
  public Scene scene() {
    return scene;
  }

  /**
   * The world, to look at or to change. The users of its bodies are null.
   *
   * @return always the same
   */
  public World<String> world() {
    return world;
  }

  /**
   * The number of steps made.
   *
   * @return 0 at the start
   */
  public int tick() {
    return tick;
  }

  /**
   * The length of a step.
   *
   * @return s
   */
  public float tickSeconds() {
    return tickSeconds;
  }

  /** Advances the scene by one tick. */
  public void step() {
    stage.beforeStep(tick);
    world.step(tickSeconds);
    tick++;
  }

  /**
   * Advances the scene.
   *
   * @param ticks how many steps
   */
  public void steps(int ticks) {
    for (int i = 0; i < ticks; i++) {
      step();
    }
  }

  /**
   * Goes back (or forth) to a saved state.
   *
   * @param state of this run's world
   * @param atTick what {@link #tick} was when it was saved
   */
  public void restore(WorldState state, int atTick) {
    world.restore(state);
    tick = atTick;
  }
}
