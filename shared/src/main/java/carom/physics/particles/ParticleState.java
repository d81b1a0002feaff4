package carom.physics.particles;

/**
 * Particles at one moment: a few arrays, made by {@link Particles#save} and taken over by {@link
 * Particles#restore}. Saving into the same object again allocates only if there are more particles.
 */
public final class ParticleState {
  final ParticleStore store;
  final Particles owner;

  ParticleState(Particles owner) {
    this.owner = owner;
    store = new ParticleStore(1);
  }
}
