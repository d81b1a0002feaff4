package carom.physics.particles;

import carom.physics.archive.ArchiveWriter;
import carom.physics.math.Limits;

/**
 * Saved state of particles. {@link Particles#save} makes it and {@link Particles#restore} takes it
 * over; {@link #write} and {@link Particles#read} convert it to and from bytes. Saving into the
 * same object again allocates only if there are more particles.
 */
public final class ParticleState {
  final ParticleStore store;
  final Particles owner;

  ParticleState(Particles owner) {
    this.owner = owner;
    store = new ParticleStore(1);
  }

  /**
   * Appends the state to an archive, with some 32 bytes a particle.
   *
   * @param archive receives the state
   */
  public void write(ArchiveWriter archive) {
    Limits.notNull("archive", archive);
    store.pass(archive, owner.most());
  }
}
