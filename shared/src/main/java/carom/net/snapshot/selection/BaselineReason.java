package carom.net.snapshot.selection;

import carom.net.snapshot.SnapshotEncoder;

/** Says what an entity's record is coded against, and why. */
public enum BaselineReason {
  /** Nothing is sent: the client has the present state, and the server knows it. */
  QUIESCENT,
  /** Delta against a state that the client has acked. */
  ACKED,
  /** Absolute: first seen, the client has acked nothing of this slot since it came into sight. */
  NEW,
  /** Absolute: too old, the acked state was left 64 ticks ago or more. */
  TOO_OLD,
  /** Absolute: rolled out, the acked state is young enough but no frame of the ring has it. */
  ROLLED_OUT,
  /** Absolute: the acked state is of another entity, owner or archetype, or before a teleport. */
  IDENTITY,
  /** Absolute: asked for by {@link SnapshotEncoder#force}. */
  FORCED,
  /** The slot is free and the client may still see an entity there. */
  GONE,
  /** The entity has left the client's sight and the client may not know it yet. */
  OUT_OF_SIGHT
}
