package carom.sim.scene;

import carom.physics.WorldState;
import carom.physics.particles.ParticleState;

/**
 * The saved state of a {@link SceneRun}: world, particles and tick. {@link SceneRun#save} makes it
 * and {@link SceneRun#restore} takes it over.
 */
public final class SceneState {
  WorldState world;
  final ParticleState[] particles;
  int tick;

  SceneState(int systems) {
    particles = new ParticleState[systems];
  }
}
