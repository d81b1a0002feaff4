package carom.physics.rows;

/**
 * The fields of a joint's row: offsets of ints from the row's beginning. The package's page has a
 * drawing.
 *
 * <p>A row holds what a step changes and what a game may change while the joint exists. All else
 * about a joint is constant and in its {@link JointDefRow}. Floats are stored by their raw bits.
 * The key belongs to the program that uses the world; the physics leaves it as it is.
 *
 * <p>An end names a body: by its place among the rows of bodies, or a static body that has no row
 * by its inverted slot ({@code ~slot}), or {@link #GROUND}.
 */
public final class JointRow {
  /** Key by which the using program knows the joint in every world; an int of its choice. */
  public static final int KEY = 0;

  /** Body A: a place, the inverted slot of a static body, or {@link #GROUND}. */
  public static final int END_A = KEY + 1;

  /** Body B: a place, or the inverted slot of a static body. */
  public static final int END_B = END_A + 1;

  /** Value of an end that is the world itself. */
  public static final int GROUND = Integer.MIN_VALUE;

  /** First of {@link #SETTING_INTS} ints that a game may change. */
  public static final int SETTINGS = END_B + 1;

  /** Number of the ints of {@link #SETTINGS}. */
  public static final int SETTING_INTS = 12;

  /** Flags of the joint: whether it has limits, a motor, a spring, and counts full turns. */
  public static final int FLAGS = SETTINGS;

  /** The first field that is a float. */
  public static final int FLOATS = FLAGS + 1;

  /** Speed of the motor, m/s or rad/s. */
  public static final int MOTOR_SPEED = FLOATS;

  /** Most force or torque of the motor, N or N m. */
  public static final int MOTOR_MAX = MOTOR_SPEED + 1;

  /** Lower limit, m or rad. */
  public static final int LOWER = MOTOR_MAX + 1;

  /** Upper limit, m or rad. */
  public static final int UPPER = LOWER + 1;

  /** Frequency of the spring, 1/s. */
  public static final int HERTZ = UPPER + 1;

  /** Damping ratio of the spring. */
  public static final int DAMPING = HERTZ + 1;

  /** Rest value of the coordinate, m or rad. */
  public static final int REST = DAMPING + 1;

  /** Anchor in A's frame, m: the target of motor and mouse joints. */
  public static final int ANCHOR_AX = REST + 1;

  /** Anchor in A's frame, m. */
  public static final int ANCHOR_AY = ANCHOR_AX + 1;

  /** Cosine of the angle of B relative to A that counts as 0. */
  public static final int REF_COS = ANCHOR_AY + 1;

  /** Sine of that angle. */
  public static final int REF_SIN = REF_COS + 1;

  /** First of {@link #TURN_INTS} ints that count full turns, all zero if they aren't counted. */
  public static final int TURNS = SETTINGS + SETTING_INTS;

  /** Number of the ints of {@link #TURNS}. */
  public static final int TURN_INTS = 4;

  /** Full turns of A, or teeth that a ratchet has passed, an integer. */
  public static final int TURNS_A = TURNS;

  /** Full turns of B, or of B relative to A, an integer. */
  public static final int TURNS_B = TURNS_A + 1;

  /** Angle of A when its turns were counted last, rad. */
  public static final int LAST_A = TURNS_B + 1;

  /** Angle of B when its turns were counted last, rad. */
  public static final int LAST_B = LAST_A + 1;

  /** First of {@link #IMPULSE_INTS} floats: impulses that the joint starts with. */
  public static final int IMPULSES = TURNS + TURN_INTS;

  /** Number of the floats of {@link #IMPULSES}. */
  public static final int IMPULSE_INTS = 7;

  /** Impulse along x, along the perpendicular, or of the rod, N s. */
  public static final int IMPULSE_X = IMPULSES;

  /** Impulse along y, N s; of a prismatic joint the angular one, N m s. */
  public static final int IMPULSE_Y = IMPULSE_X + 1;

  /** Angular impulse, N m s. */
  public static final int IMPULSE_W = IMPULSE_Y + 1;

  /** Impulse of the spring. */
  public static final int SPRING_IMPULSE = IMPULSE_W + 1;

  /** Impulse of the motor. */
  public static final int MOTOR_IMPULSE = SPRING_IMPULSE + 1;

  /** Impulse of the lower limit. */
  public static final int LOWER_IMPULSE = MOTOR_IMPULSE + 1;

  /** Impulse of the upper limit. */
  public static final int UPPER_IMPULSE = LOWER_IMPULSE + 1;

  /** First of {@link #LOAD_INTS} floats: what the joint exerted on B in the last substep. */
  public static final int LOADS = IMPULSES + IMPULSE_INTS;

  /** Number of the floats of {@link #LOADS}. */
  public static final int LOAD_INTS = 3;

  /** Force on B, N. */
  public static final int FORCE_X = LOADS;

  /** Force on B, N. */
  public static final int FORCE_Y = FORCE_X + 1;

  /** Torque on B, N m. */
  public static final int TORQUE = FORCE_Y + 1;

  /** Number of ints of a row. */
  public static final int INTS = LOADS + LOAD_INTS;

  /** By int of {@link #SETTINGS}: where the definition has it. */
  private static final int[] DEFINED = {
    JointDefRow.FLAGS,
    JointDefRow.MOTOR_SPEED,
    JointDefRow.MOTOR_MAX,
    JointDefRow.LOWER,
    JointDefRow.UPPER,
    JointDefRow.HERTZ,
    JointDefRow.DAMPING,
    JointDefRow.REST,
    JointDefRow.ANCHOR_AX,
    JointDefRow.ANCHOR_AY,
    JointDefRow.REF_COS,
    JointDefRow.REF_SIN
  };

  private JointRow() {}

  /**
   * Returns the field of {@link JointDefRow} that has a setting.
   *
   * @param setting 0..{@link #SETTING_INTS} - 1, a number of {@link #SETTINGS}
   */
  public static int definedBy(int setting) {
    return DEFINED[setting];
  }
}
