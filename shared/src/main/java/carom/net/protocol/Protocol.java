package carom.net.protocol;

import carom.physics.rows.PhysicsVersion;

/** Versions on which client and server must agree. */
public final class Protocol {

  /**
   * Version of all that {@code docs/protocol} defines. A change of one byte on the wire raises it,
   * also between two releases, because builds that don't understand each other must refuse each
   * other.
   */
  public static final int VERSION = 14;

  /** The version of the simulation's arithmetic, as clients and servers tell it. */
  public static final String PHYSICS_VERSION = "carom-physics-" + PhysicsVersion.NUMBER;

  private Protocol() {}

  /**
   * Returns the digest on which prediction and recordings depend: {@link #PHYSICS_VERSION} as
   * 64-bit FNV-1a. It names the build's arithmetic and is not a checksum of class files. Two builds
   * that differ elsewhere may play together and replay each other's recordings.
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
