package carom.physics.rows;

/**
 * The fields of a joint's definition: offsets of ints from its beginning.
 *
 * <p>A definition is what a joint was made with, in the frames of its bodies. It holds raw bits,
 * because a program that made the joint anew from points of the world would round them in another
 * way. {@code World.readJoint} reads it, and {@code World.createJoint} makes an equal joint of it.
 * Floats are stored by their raw bits. What may change later is in {@link JointRow}, too.
 */
public final class JointDefRow {
  /** Type of the joint, the ordinal of {@code JointType}. */
  public static final int TYPE = 0;

  /**
   * Flags: whether its bodies collide, and whether it has limits, a motor, a spring, and counts
   * turns.
   */
  public static final int FLAGS = TYPE + 1;

  /** The first field that is a float. All behind it are floats, too. */
  public static final int FLOATS = FLAGS + 1;

  /** Anchor in A's frame, or in the world's if A is the ground, m. */
  public static final int ANCHOR_AX = FLOATS;

  /** Anchor in A's frame, m. */
  public static final int ANCHOR_AY = ANCHOR_AX + 1;

  /** Anchor in B's frame, m. */
  public static final int ANCHOR_BX = ANCHOR_AY + 1;

  /** Anchor in B's frame, m. */
  public static final int ANCHOR_BY = ANCHOR_BX + 1;

  /** Unit axis in A's frame; of a rack in B's. */
  public static final int AXIS_X = ANCHOR_BY + 1;

  /** Unit axis. */
  public static final int AXIS_Y = AXIS_X + 1;

  /** Cosine of the angle of B relative to A that counts as 0. */
  public static final int REF_COS = AXIS_Y + 1;

  /** Sine of that angle. */
  public static final int REF_SIN = REF_COS + 1;

  /** Rest value of the coordinate, m or rad. */
  public static final int REST = REF_SIN + 1;

  /** Lower limit, m or rad. */
  public static final int LOWER = REST + 1;

  /** Upper limit, m or rad. */
  public static final int UPPER = LOWER + 1;

  /** Speed of the motor, m/s or rad/s. */
  public static final int MOTOR_SPEED = UPPER + 1;

  /** Most force or torque of the motor, N or N m. */
  public static final int MOTOR_MAX = MOTOR_SPEED + 1;

  /** Frequency of the spring, 1/s. */
  public static final int HERTZ = MOTOR_MAX + 1;

  /** Damping ratio of the spring. */
  public static final int DAMPING = HERTZ + 1;

  /** Frequency of the angular spring, 1/s. */
  public static final int ANGULAR_HERTZ = DAMPING + 1;

  /** Damping ratio of the angular spring. */
  public static final int ANGULAR_DAMPING = ANGULAR_HERTZ + 1;

  /** Most force of a motor or mouse joint, N. */
  public static final int MAX_FORCE = ANGULAR_DAMPING + 1;

  /** Most torque of a motor joint, N m. */
  public static final int MAX_TORQUE = MAX_FORCE + 1;

  /** Force beyond which the joint breaks, N; may be infinite. */
  public static final int BREAK_FORCE = MAX_TORQUE + 1;

  /** Torque beyond which the joint breaks, N m; may be infinite. */
  public static final int BREAK_TORQUE = BREAK_FORCE + 1;

  /** Ratio of gear, rack and pulley; angle between a ratchet's teeth, rad. */
  public static final int RATIO = BREAK_TORQUE + 1;

  /** Origin from which A's length or angle counts: a point of the world, m, or a rotation. */
  public static final int BASE_AX = RATIO + 1;

  /** See {@link #BASE_AX}. */
  public static final int BASE_AY = BASE_AX + 1;

  /** Origin from which B's length or angle counts; see {@link #BASE_AX}. */
  public static final int BASE_BX = BASE_AY + 1;

  /** See {@link #BASE_BX}. */
  public static final int BASE_BY = BASE_BX + 1;

  /** Number of ints of a definition. */
  public static final int INTS = BASE_BY + 1;

  private JointDefRow() {}
}
