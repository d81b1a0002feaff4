package carom.net.protocol;

/**
 * What a client sends each tick: key, acks of snapshots, and its last inputs. A mutable object that
 * is used again and again: the client fills and encodes it, the server decodes into one. No
 * allocation. One thread.
 */
public final class InputDatagram {

  /**
   * The key of {@link ServerMessage.Welcome}. The server drops datagrams with another one silently.
   */
  public int key;

  /** Sequence number of this datagram, 16 bits, wraps. */
  public int sequence;

  /** Whether any snapshot datagram was received; when false the acks are meaningless. */
  public boolean hasAck;

  /** Sequence number of the newest snapshot datagram received, 16 bits. */
  public int ackSequence;

  /** Bit i = snapshot datagram {@code ackSequence - 1 - i} was received. */
  public long ackBits;

  /** Tick of the newest input, {@code inputs[0]}. */
  public int newestTick;

  /** How many inputs follow, 0..{@link Limits#MAX_INPUTS}; 0 = keep-alive. */
  public int count;

  /**
   * Packed inputs (48 bits each, {@code Input.pack()}); {@code inputs[i]} is for tick {@code
   * newestTick - i}.
   */
  public final long[] inputs = new long[Limits.MAX_INPUTS];

  /**
   * Writes this datagram.
   *
   * @param out at least {@link #MAX_BYTES} from {@code offset} on
   * @return number of bytes written
   */
  public int encode(byte[] out, int offset) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Reads a datagram into this object. Never throws on the content.
   *
   * @return false when the bytes are not exactly one input datagram; this object is then undefined
   */
  public boolean decode(byte[] bytes, int offset, int length) {
    throw new UnsupportedOperationException("soon");
  }

  /** The key of an encoded datagram without decoding the rest; 0 when shorter than 4 bytes. */
  public static int peekKey(byte[] bytes, int offset, int length) {
    throw new UnsupportedOperationException("soon");
  }

  /** Largest encoded size in bytes. */
  public static final int MAX_BYTES = 160;
}
