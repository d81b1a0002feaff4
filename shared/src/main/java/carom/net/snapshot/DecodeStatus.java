package carom.net.snapshot;

/** What {@link SnapshotDecoder#decode} did with a datagram. Only {@link #OK} changes anything. */
public enum DecodeStatus {
  /** Decoded, in the history, and from now on in the acks. */
  OK,
  /** Received before. */
  DUPLICATE,
  /** Too far behind the newest to be acked. */
  STALE,
  /** Cut, damaged, or not from this session. */
  DAMAGED,
  /** Coded against a state that this client doesn't have (any more): as if lost. */
  NO_BASELINE
}
