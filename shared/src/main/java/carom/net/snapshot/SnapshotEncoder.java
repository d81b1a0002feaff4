package carom.net.snapshot;

/**
 * One session's snapshots. Each send tick, after {@link FrameRing#end}:
 *
 * <pre>{@code
 * encoder.receiveAck(ackSequence, ackBits);            // from each input datagram
 * encoder.begin(feedback, own, budgetBytes);
 * for (int n; (n = encoder.next(buffer)) > 0; ) link.sendDatagram(buffer, 0, n);
 * }</pre>
 *
 * One thread, no allocation in the steady state.
 */
public final class SnapshotEncoder {

  /** Largest datagram; the size of the array for {@link #next}. */
  public static final int MAX_DATAGRAM_BYTES = 1_200;

  /**
   * Creates the encoder of a client that knows nothing.
   *
   * @param ring the room's frames, shared by all sessions
   * @param key the session's datagram key; seeds the check that each datagram carries
   */
  public SnapshotEncoder(FrameRing ring, int key) {}

  /**
   * Forgets all acks: the client knows nothing (it loads anew, or came back). Sequence numbers go
   * on.
   */
  public void reset() {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Takes a client's acks. Anything is accepted: what was never sent, or is too old, changes
   * nothing.
   *
   * @param ackSequence newest snapshot datagram the client received, 16 bits
   * @param ackBits bit i = datagram {@code ackSequence - 1 - i} was received
   */
  public void receiveAck(int ackSequence, long ackBits) {
    throw new UnsupportedOperationException("soon");
  }

  /** The slot's next record is absolute, whatever was acked. */
  public void force(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Whether the client has, as far as the server knows, everything of the newest frame and this own
   * state: then the replication may send less often.
   */
  public boolean nothingNew(OwnState own) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Starts the datagrams of the ring's newest frame. Entities that did not fit the budget wait; who
   * waited longest goes first.
   *
   * @param feedback about the client's inputs; copied
   * @param own the player's exact state at the newest frame's tick, or null to send none; copied
   * @param budgetBytes for all datagrams of this tick; the first one's header and own section are
   *     sent anyway
   */
  public void begin(InputFeedback feedback, OwnState own, int budgetBytes) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Writes the next datagram of this tick. The first call after {@link #begin} always writes one.
   *
   * @param out at least {@link #MAX_DATAGRAM_BYTES}
   * @return its length, or 0 when there is nothing more to send this tick
   */
  public int next(byte[] out) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * What the slot's record would be coded against now, and why: the one place where that is
   * decided.
   */
  public Baseline baseline(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /** Newest tick of the slot that the client has acked, or -1. */
  public int ackedTick(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /** Last tick at which a record of the slot was sent, or -1. */
  public int sentTick(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /** Entities that waited for the budget in the last tick. */
  public int waiting() {
    throw new UnsupportedOperationException("soon");
  }

  /** Sequence number of the last datagram written. */
  public int sequence() {
    throw new UnsupportedOperationException("soon");
  }
}
