package carom.net.seal;

/**
 * Opens the datagrams that one side of a link receives. It lets each datagram through once. A
 * datagram that isn't genuine changes nothing. Use it from one thread.
 */
public final class DatagramOpener {
  /** The result of a datagram that isn't genuine. */
  public static final int FORGED = -1;

  /** The result of a datagram that has come before, or is too old to know. */
  public static final int REPLAYED = -2;

  private final LinkCipher seal;
  private final int link;
  private final ReplayWindow window = new ReplayWindow();

  DatagramOpener(LinkCipher seal, int link) {
    this.seal = seal;
    this.link = link;
  }

  /** Returns the link that a datagram names, or 0 if it is too short for any. */
  public static int link(byte[] bytes, int length) {
    return length < DatagramSealer.HEAD_BYTES + LinkCipher.TAG_BYTES
        ? 0
        : bytes[1] << 24 | (bytes[2] & 0xff) << 16 | (bytes[3] & 0xff) << 8 | bytes[4] & 0xff;
  }

  /**
   * Opens a datagram in place. Its fields then begin at {@link DatagramSealer#HEAD_BYTES}. Returns
   * the number of bytes in the fields, or {@link #FORGED}, or {@link #REPLAYED}.
   */
  public int open(byte[] bytes, int length) {
    int fields = length - DatagramSealer.HEAD_BYTES - LinkCipher.TAG_BYTES;
    if (fields < 0 || link(bytes, length) != link) {
      return FORGED;
    }
    long counter = 0;
    for (int i = 5; i < DatagramSealer.HEAD_BYTES; i++) {
      counter = counter << 8 | bytes[i] & 0xff;
    }
    if (counter >= LinkCipher.MAX_FRAMES) {
      return FORGED;
    }
    if (!window.isNew(counter)) {
      return REPLAYED; // or forged: not worth the time to find out
    }
    if (!seal.open(counter, bytes, 0, DatagramSealer.HEAD_BYTES, fields)) {
      return FORGED;
    }
    window.mark(counter);
    return fields;
  }
}
