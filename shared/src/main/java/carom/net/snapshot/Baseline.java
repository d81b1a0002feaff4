package carom.net.snapshot;

/** What an entity's record is coded against, and why. */
public enum Baseline {
  /** Nothing is sent: the client has the present state, and the server knows it. */
  QUIESCENT,
  /** Delta against a state that the client has acked. */
  ACKED,
  /** Absolute: the client has acked nothing of this slot. */
  NEW,
  /** Absolute: the acked state has left the ring. */
  TOO_OLD,
  /** Absolute: the acked state is of another entity, owner or archetype. */
  IDENTITY,
  /** Absolute: asked for by {@link SnapshotEncoder#force}. */
  FORCED,
  /** The slot is free and the client may still see an entity there. */
  GONE
}
