package carom.sim.scene;

import carom.physics.World;
import carom.physics.WorldState;
import carom.physics.archive.Archive;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.particles.ParticleState;
import carom.sim.pool.ParticleWorld;
import carom.sim.pool.ShownParticles;
import java.util.List;

/**
 * The saved state of a running scene: world, particles and tick. {@link SceneRun#save} makes it and
 * {@link SceneRun#restore} takes it over.
 */
final class SceneState implements ParticleWorld.State {
  WorldState world;
  final ParticleState[] particles;
  int tick;

  SceneState(int systems) {
    particles = new ParticleState[systems];
  }

  /** Saves a scene that runs in a world, into a state of it or, with null, a new one. */
  static SceneState save(
      World<?> world, List<ShownParticles> systems, int tick, SceneState reuseOrNull) {
    SceneState s = reuseOrNull == null ? new SceneState(systems.size()) : reuseOrNull;
    s.world = world.save(s.world);
    for (int i = 0; i < s.particles.length; i++) {
      s.particles[i] = systems.get(i).particles().save(s.particles[i]);
    }
    s.tick = tick;
    return s;
  }

  @Override
  public void write(ArchiveWriter archive) {
    world.write(archive);
    for (ParticleState some : particles) {
      some.write(archive);
    }
    passTick(archive);
  }

  void readTick(ArchiveReader archive) {
    passTick(archive);
  }

  private void passTick(Archive archive) {
    tick = archive.integer("tick of the scene", tick, 0, Integer.MAX_VALUE);
  }
}
