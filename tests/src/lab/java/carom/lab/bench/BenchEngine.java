package carom.lab.bench;

import carom.physics.World;
import carom.sim.scene.Scene;

/**
 * A physics engine that can be measured. Other engines than Carom are found by {@link
 * java.util.ServiceLoader}, see {@link Peers}. One thread at a time.
 */
public interface BenchEngine extends AutoCloseable {
  /**
   * Returns what it is called in flags and tables.
   *
   * @return small letters, digits and dashes
   */
  String name();

  /**
   * Makes the bodies of a scene, and forgets those made before.
   *
   * @param scene what to build
   * @throws UnsupportedOperationException if this engine lacks something the scene needs
   */
  void start(Scene scene);

  /** Makes one step of the scene's length. This alone is timed. */
  void step();

  /**
   * Returns the bodies as they are now, for the sanity figures.
   *
   * @return Carom's world, or a copy of the other engine's one
   */
  World<?> world();

  /**
   * Returns how many bodies are awake and not static now.
   *
   * @return a count
   */
  int awake();

  /** Gives back what no collector does. */
  @Override
  void close();
}
