package carom.sim.scene;

import carom.physics.WorldState;
import carom.physics.particles.ParticleState;

/**
 * A run at one moment: world, particles and tick; made by {@link SceneRun#save} and taken over by
 * {@link SceneRun#restore}.
 */
public final class SceneState {
  WorldState world;
  final ParticleState[] particles;
  int tick;

  SceneState(int systems) {
    particles = new ParticleState[systems];
  }
}
