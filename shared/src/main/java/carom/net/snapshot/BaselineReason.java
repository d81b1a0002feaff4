package carom.net.snapshot;

/** Says what an entity's record is coded against, and why. */
public enum BaselineReason {
  /** Nothing is sent: the client has the present state, and the server knows it. */
  QUIESCENT,
  /** A delta is sent against a state that the client has acked. */
  ACKED,
  /**
   * The state is sent whole: the client has acked nothing of this slot since it came into sight.
   */
  NEW,
  /** The state is sent whole: the acked state was left 64 ticks ago or more. */
  TOO_OLD,
  /** The state is sent whole: the acked state is young enough, but no frame of the ring has it. */
  ROLLED_OUT,
  /**
   * The state is sent whole: the acked one is of another entity, owner or archetype, or before a
   * teleport.
   */
  IDENTITY,
  /** The state is sent whole because {@code SnapshotEncoder.force} asked for it. */
  FORCED,
  /** The slot is free and the client may still see an entity there. */
  GONE,
  /** The entity has left the client's sight and the client may not know it yet. */
  OUT_OF_SIGHT
}
