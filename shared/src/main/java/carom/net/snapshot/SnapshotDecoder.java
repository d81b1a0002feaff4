package carom.net.snapshot;

/**
 * The client's side: datagrams in, a history per entity out, and the acks to send back.
 *
 * <p>Total: any bytes give a {@link DecodeStatus}, never an exception, and a datagram counts as a
 * whole or not at all. Memory is bounded by the number of slots. One thread; allocates only when a
 * slot is seen for the first time.
 */
public final class SnapshotDecoder {

  /**
   * Creates a decoder that knows nothing.
   *
   * @param capacity entity slots, at least the server's; 1..65,535
   * @param key the session's datagram key
   * @param tick the server's tick in {@code Welcome}: datagrams carry 16 bits of theirs
   */
  public SnapshotDecoder(int capacity, int key, int tick) {}

  /** Decodes a datagram. When it answers {@code OK}, the other methods tell what it held. */
  public DecodeStatus decode(byte[] bytes, int offset, int length) {
    throw new UnsupportedOperationException("soon");
  }

  /** Tick of the last decoded datagram: its content is the state after this tick. */
  public int tick() {
    throw new UnsupportedOperationException("soon");
  }

  /** Newest tick of all datagrams so far; the tick of {@code Welcome} before the first. */
  public int newestTick() {
    throw new UnsupportedOperationException("soon");
  }

  /** Feedback of the last decoded datagram; {@code present} is false when it had none. */
  public InputFeedback feedback() {
    throw new UnsupportedOperationException("soon");
  }

  /** Whether the last decoded datagram had the own section. */
  public boolean hasOwn() {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Own section of the last decoded datagram, the exact state after {@link #tick}; valid when
   * {@link #hasOwn}.
   */
  public OwnState own() {
    throw new UnsupportedOperationException("soon");
  }

  /** Records in the last decoded datagram. */
  public int touchedCount() {
    throw new UnsupportedOperationException("soon");
  }

  /** Slot of a record of the last decoded datagram, ascending; index 0..touchedCount - 1. */
  public int touchedSlot(int index) {
    throw new UnsupportedOperationException("soon");
  }

  /** One more than the highest slot ever seen: iterate {@link #history} below it. */
  public int slotLimit() {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * What is known of a slot, or null when nothing ever was. The same object for ever, changed by
   * {@link #decode}.
   */
  public EntityHistory history(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /** Whether any datagram was decoded: before that, there is nothing to ack. */
  public boolean hasAck() {
    throw new UnsupportedOperationException("soon");
  }

  /** Sequence number of the newest datagram decoded. */
  public int ackSequence() {
    throw new UnsupportedOperationException("soon");
  }

  /** Bit i = datagram {@code ackSequence() - 1 - i} was decoded. */
  public long ackBits() {
    throw new UnsupportedOperationException("soon");
  }
}
