package carom.net.protocol;

/** Versions that both sides must share. */
public final class Protocol {

  /**
   * Version of everything in {@code docs/PROTOCOL.md}; a change of one byte on the wire raises it,
   * also between two releases: builds that don't understand each other must refuse each other.
   */
  public static final int VERSION = 8;

  /**
   * Version of the simulation's arithmetic. Two builds with the same value step any world to the
   * same state hash; whoever changes a result of {@code carom.physics}, {@code carom.sim} or a game
   * that ships raises it.
   */
  public static final String PHYSICS_VERSION = "carom-physics-4";

  private Protocol() {}

  /**
   * Digest of what must be equal for prediction and recordings to be exact: {@link
   * #PHYSICS_VERSION} as 64-bit FNV-1a. It is a name for the build's arithmetic, not a checksum of
   * class files: two builds that differ elsewhere may play together, and play what the other
   * recorded.
   */
  public static long physicsDigest() {
    String text = PHYSICS_VERSION;
    long hash = 0xcbf29ce484222325L;
    for (int i = 0; i < text.length(); i++) {
      hash = (hash ^ text.charAt(i)) * 0x100000001b3L;
    }
    return hash;
  }
}
