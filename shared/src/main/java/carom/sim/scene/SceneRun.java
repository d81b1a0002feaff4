package carom.sim.scene;

import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.archive.ArchiveReader;
import carom.sim.pool.ParticleWorld;
import carom.sim.pool.ShownParticles;
import java.util.List;

/**
 * A scene that is running: its world and the number of steps made. One thread at a time. A steady
 * step allocates nothing unless the scene makes bodies.
 */
public final class SceneRun implements ParticleWorld.Copy {
  private final World<String> world;
  private final SceneWorld<String> stage;
  private final float tickSeconds;
  private int tick;

  SceneRun(Scene scene, WorldDef def) {
    world = new World<>(def);
    stage = new SceneWorld<>(world);
    scene.build(stage);
    world.listener(stage.listener());
    tickSeconds = 1f / scene.tickRate();
  }

  /**
   * Returns the world, to look at or to change. The users of its bodies are null.
   *
   * @return always the same
   */
  public World<String> world() {
    return world;
  }

  /**
   * Returns the scene's particles.
   *
   * @return in the order they were made, unmodifiable; none in most scenes
   */
  @Override
  public List<ShownParticles> particles() {
    return stage.particles();
  }

  /**
   * Returns the number of steps made.
   *
   * @return 0 at the start
   */
  public int tick() {
    return tick;
  }

  /**
   * Returns the length of a step.
   *
   * @return s
   */
  public float tickSeconds() {
    return tickSeconds;
  }

  /** Advances the scene by one tick. */
  @Override
  public void step() {
    stage.beforeStep(tick, tickSeconds);
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
   * Returns 64 bits of everything that decides the future: world, particles and tick.
   *
   * @return equal for equal runs
   */
  public long stateHash() {
    long h = world.stateHash() ^ tick;
    for (ShownParticles system : particles()) {
      h = Long.rotateLeft(h * 0x9e3779b97f4a7c15L, 29) ^ system.particles().stateHash();
    }
    return h;
  }

  /**
   * Saves the state.
   *
   * @param reuseOrNull a state of this run to overwrite, or null for a new one
   * @return the state
   */
  @Override
  public SceneState save(ParticleWorld.State reuseOrNull) {
    return SceneState.save(world, particles(), tick, (SceneState) reuseOrNull);
  }

  @Override
  public SceneState read(ArchiveReader archive) {
    SceneState s = new SceneState(particles().size());
    s.world = world.read(archive, i -> null);
    for (int i = 0; i < s.particles.length; i++) {
      s.particles[i] = particles().get(i).particles().read(archive);
    }
    s.readTick(archive);
    return s;
  }

  /**
   * Returns to a saved state, earlier or later than the present one.
   *
   * @param saved a {@link SceneState} of this run; stays as it is
   */
  @Override
  public void restore(ParticleWorld.State saved) {
    SceneState state = (SceneState) saved;
    world.restore(state.world);
    for (int i = 0; i < state.particles.length; i++) {
      particles().get(i).particles().restore(state.particles[i]);
    }
    tick = state.tick;
  }
}
