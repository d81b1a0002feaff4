package carom.net.snapshot;

/**
 * Says what {@link SnapshotDecoder#decode} did with a datagram. Only {@link #OK} changes anything.
 */
public enum DecodeStatus {
  /** The datagram was decoded: it is in the history, and from now on in the acks. */
  OK,
  /** The datagram was received before. */
  DUPLICATE,
  /** The datagram is too far behind the newest to be acked. */
  STALE,
  /** The datagram is cut, damaged, or not from this session. */
  DAMAGED,
  /** The datagram is coded against a state that this client doesn't hold: it counts as lost. */
  NO_BASELINE
}
