package carom.net.frame;

import carom.net.seal.Encryption;
import carom.net.seal.KnownServers;

/**
 * The demands that a client makes of a server before it plays there.
 *
 * @param encryption whether links are encrypted; a server that differs is refused
 * @param servers the servers known so far, and what to do about others
 */
public record Trust(Encryption encryption, KnownServers servers) {

  /** Returns the trust of a program without files: encrypted, and every server is new. */
  public static Trust firstUse() {
    return new Trust(Encryption.ON, KnownServers.inMemory());
  }
}
