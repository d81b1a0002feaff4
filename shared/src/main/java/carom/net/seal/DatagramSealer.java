package carom.net.seal;

/**
 * Seals the datagrams that one side of a link sends. Each carries the link's number and a counter
 * in the clear. Guard it by a lock.
 *
 * <pre>
 * tag u8 | link i32 | counter u48 | sealed fields | proof 16
 * </pre>
 */
public final class DatagramSealer {
  /** Bytes in front of the sealed fields: tag, link and counter. */
  public static final int HEAD_BYTES = 1 + 4 + 6;

  /** Bytes that sealing adds to a datagram's tag and fields. */
  public static final int EXTRA_BYTES = HEAD_BYTES - 1 + LinkCipher.TAG_BYTES;

  private final LinkCipher seal;
  private final int link;
  private final byte[] sealed;
  private long counter;

  DatagramSealer(LinkCipher seal, int link, int maxFields, long counter) {
    this.seal = seal;
    this.link = link;
    this.sealed = new byte[HEAD_BYTES + maxFields + LinkCipher.TAG_BYTES];
    this.counter = counter;
  }

  /** Returns whether the key has sealed as many datagrams as it may. The link must close then. */
  public boolean isUsedUp() {
    return counter >= LinkCipher.MAX_FRAMES;
  }

  /** Returns the sealed datagram, valid until the next one. */
  public byte[] bytes() {
    return sealed;
  }

  /**
   * Seals a datagram into {@link #bytes}. Returns its length.
   *
   * @throws IllegalStateException when the key is used up
   */
  public int seal(byte tag, byte[] fields, int offset, int length) {
    if (isUsedUp()) {
      throw new IllegalStateException("counter=" + counter + " is all that one key may seal");
    }
    sealed[0] = tag;
    for (int i = 0; i < 4; i++) {
      sealed[1 + i] = (byte) (link >>> 24 - 8 * i);
    }
    for (int i = 0; i < 6; i++) {
      sealed[5 + i] = (byte) (counter >>> 40 - 8 * i);
    }
    System.arraycopy(fields, offset, sealed, HEAD_BYTES, length);
    seal.seal(counter++, sealed, 0, HEAD_BYTES, length);
    return HEAD_BYTES + length + LinkCipher.TAG_BYTES;
  }
}
