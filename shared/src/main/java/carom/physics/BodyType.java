package carom.physics;

/** What may move a body. */
public enum BodyType {
  /** Never moves by itself and has infinite mass: floors, walls. Forces are no-ops. */
  STATIC,
  /**
   * Moves with the velocity it was given, pushes dynamic bodies, and nothing pushes it: lifts,
   * doors. Forces are no-ops.
   */
  KINEMATIC,
  /** Moves by forces, impulses, gravity and contacts. */
  DYNAMIC
}
