package carom.net.seal;

/**
 * A side's choice whether a link is encrypted. Both sides must agree; neither gives way to the
 * other.
 */
public enum Encryption {
  /**
   * Frames are in the clear. Each carries the key of its session as a tag, which keeps out senders
   * that see nothing of the session, but no one who can read its packets.
   */
  OFF(
      "nothing is encrypted: a program that sees packets can read them, change them and be any"
          + " player"),
  /** Frames are encrypted and authenticated by AES-256-GCM. */
  ON("links are encrypted");

  private final String meaning;

  Encryption(String meaning) {
    this.meaning = meaning;
  }

  /** Returns what it means, for the operator. */
  public String meaning() {
    return meaning;
  }

  /** Returns the byte in the handshake. */
  public byte code() {
    return (byte) ordinal();
  }
}
