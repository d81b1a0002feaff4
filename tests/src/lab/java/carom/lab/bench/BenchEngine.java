package carom.lab.bench;

import carom.physics.World;
import carom.sim.scene.Scene;

/**
 * A physics engine that the benchmark can measure. {@link java.util.ServiceLoader} finds engines
 * other than Carom; see {@link Peers}. One thread at a time.
 */
public interface BenchEngine extends AutoCloseable {
  /**
   * Returns the engine's name in flags and tables.
   *
   * @return small letters, digits and dashes
   */
  String name();

  /**
   * Builds the bodies of a scene, in place of those built before.
   *
   * @param scene what to build
   * @throws UnsupportedOperationException if this engine lacks something the scene needs
   */
  void start(Scene scene);

  /** Does one step of the scene's time step. Only this is timed. */
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

  /** Frees the resources that the garbage collector doesn't. */
  @Override
  void close();
}
