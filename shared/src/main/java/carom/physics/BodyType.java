package carom.physics;

/** The type of a body, which says what moves it. */
public enum BodyType {
  /** A static body doesn't move and has infinite mass, like floors and walls. Forces do nothing. */
  STATIC,
  /**
   * A kinematic body moves with the velocity it was given. It pushes dynamic bodies, and nothing
   * pushes it, like lifts and doors. Forces do nothing.
   */
  KINEMATIC,
  /** A dynamic body moves by forces, impulses, gravity and contacts. */
  DYNAMIC
}
