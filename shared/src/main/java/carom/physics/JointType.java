package carom.physics;

/** The type of a {@link Joint}, which says how it connects its bodies; see {@link JointDef}. */
public enum JointType {
  /** Two points coincide. The coordinate is the angle, rad. */
  REVOLUTE,
  /** The distance of two points is held, limited or sprung. The coordinate is the distance, m. */
  DISTANCE,
  /** B slides along an axis of A and doesn't turn. The coordinate is the translation, m. */
  PRISMATIC,
  /** B is glued to A, rigidly or by springs. The coordinate is the angle, rad. */
  WELD,
  /** B slides along an axis of A, and turns. The coordinate is the translation, m. */
  WHEEL,
  /** B is drawn to a pose relative to A with limited force. The coordinate is the angle, rad. */
  MOTOR,
  /** A point of B is drawn to a point of the world. The coordinate is the angle, rad. */
  MOUSE,
  /** B turns by a ratio of what A turns. The coordinate is the angle of B, rad. */
  GEAR,
  /** B moves along an axis by a ratio of what A turns. The coordinate is the translation, m. */
  RACK,
  /**
   * Two ropes from points of the world to A and B that share one length. The coordinate is {@code
   * lengthA + ratio lengthB}, m.
   */
  PULLEY
}
