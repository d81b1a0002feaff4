package carom.physics.particles;

import carom.physics.archive.ArchiveWriter;

/**
 * Particles at one moment: a few arrays, made by {@link Particles#save} and taken over by {@link
 * Particles#restore}; as bytes by {@link #write} and {@link Particles#read}. Saving into the same
 * object again allocates only if there are more particles.
 */
public final class ParticleState {
  final ParticleStore store;
  final Particles owner;

  ParticleState(Particles owner) {
    this.owner = owner;
    store = new ParticleStore(1);
  }

  /**
   * Appends the state to an archive.
   *
   * @param archive receives some 32 bytes a particle
   */
  public void write(ArchiveWriter archive) {
    store.pass(archive, owner.most());
  }
}
