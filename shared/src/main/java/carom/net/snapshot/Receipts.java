package carom.net.snapshot;

import carom.net.codec.Sequence;

/** The snapshot datagrams that a client has taken, which its next input datagram acknowledges. */
final class Receipts {
  private static final int BITS = Long.SIZE;

  private boolean any;
  private int newest;
  private long older;

  /** Returns whether a datagram may be taken: OK, or why it comes too late. */
  DecodeStatus status(int sequence) {
    int ahead = any ? Sequence.difference(sequence, newest) : 1;
    if (ahead > 0) {
      return DecodeStatus.OK;
    }
    if (ahead < -BITS) {
      return DecodeStatus.STALE;
    }
    boolean taken = ahead == 0 || (older >>> (-1 - ahead) & 1) != 0;
    return taken ? DecodeStatus.DUPLICATE : DecodeStatus.OK;
  }

  /** Adds a datagram whose status is OK. */
  void add(int sequence) {
    int ahead = any ? Sequence.difference(sequence, newest) : 0;
    if (ahead < 0) {
      older |= 1L << (-1 - ahead);
      return;
    }
    if (any) {
      // The old newest moves to bit (ahead - 1); Java shifts by the lowest six bits only.
      long moved = ahead >= BITS ? 0 : older << ahead;
      older = ahead > BITS ? 0 : moved | 1L << (ahead - 1);
    }
    any = true;
    newest = sequence;
  }

  /** Returns whether any datagram was taken. */
  boolean any() {
    return any;
  }

  /** Returns the sequence number of the newest datagram. */
  int newest() {
    return newest;
  }

  /** Returns the older ones: bit i = datagram {@code newest() - 1 - i} was taken. */
  long older() {
    return older;
  }
}
