package carom.sim.pool;

import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import java.util.List;

/**
 * A world whose particles push its bodies and are pushed by them, and on which nothing acts from
 * outside, such as a scene that players watch. Its next state follows from the last one and the
 * tick. So a client that has one state of it computes all later ones itself, bit for bit.
 */
public interface ParticleWorld {
  /** A saved state of such a world. */
  interface State {
    /** Appends the state to an archive. */
    void write(ArchiveWriter archive);
  }

  /** The world of a client, which follows the server's. */
  interface Copy extends ParticleWorld {
    /** Computes the next tick. */
    void step();

    /**
     * Reads a state of this world for {@link #restore}. It trusts nothing and changes nothing here.
     *
     * @throws ArchiveException if the bytes are damaged or of another world
     */
    State read(ArchiveReader archive);

    /** Takes over a state that {@link #read} returned. */
    void restore(State state);
  }

  /** Returns the systems of particles, always the same; unmodifiable. */
  List<ShownParticles> particles();

  /**
   * Saves the state between two ticks.
   *
   * @param reuse a state of this world to overwrite, or null for a new one
   */
  State save(State reuse);
}
