package carom.physics.rows;

/**
 * The fields of a body's row: offsets of ints from the row's beginning. The package's page has a
 * drawing.
 *
 * <p>Floats are stored by their raw bits. Positions are metres, velocities m/s and rad/s, all of
 * the centre of mass. The physics reads and writes {@link #MOTION} to {@link #LOADS}. The key and
 * the archetype belong to the program that uses the world; the physics leaves them as they are.
 */
public final class BodyRow {
  /** Key by which the using program knows the body in every world; an int of its choice. */
  public static final int KEY = 0;

  /** First of {@link #MOTION_INTS} floats: pose and velocity. */
  public static final int MOTION = KEY + 1;

  /** Number of the floats of {@link #MOTION}. */
  public static final int MOTION_INTS = 7;

  /** Position of the centre of mass, metres. */
  public static final int X = MOTION;

  /** Position of the centre of mass, metres. */
  public static final int Y = X + 1;

  /** Cosine of the angle; the sine follows it. */
  public static final int COS = Y + 1;

  /** Sine of the angle. */
  public static final int SIN = COS + 1;

  /** Velocity of the centre of mass, m/s. */
  public static final int VX = SIN + 1;

  /** Velocity of the centre of mass, m/s. */
  public static final int VY = VX + 1;

  /** Angular velocity, rad/s. */
  public static final int OMEGA = VY + 1;

  /** Number of ints up to the sleep time: which body it is, and how it moves. */
  public static final int HEAD_INTS = MOTION + MOTION_INTS;

  /** Seconds that the body has been slow, a float; or {@link #ASLEEP}. */
  public static final int SLEEP_TIME = HEAD_INTS;

  /** Value of {@link #SLEEP_TIME} of a body that sleeps. It is an int, and no number as a float. */
  public static final int ASLEEP = -1;

  /** First of {@link #LOAD_INTS} floats: what acts on the body in the next step. */
  public static final int LOADS = SLEEP_TIME + 1;

  /** Number of the floats of {@link #LOADS}. */
  public static final int LOAD_INTS = 6;

  /** Impulse, N s. */
  public static final int IMPULSE_X = LOADS;

  /** Impulse, N s. */
  public static final int IMPULSE_Y = IMPULSE_X + 1;

  /** Angular impulse, N m s. */
  public static final int ANGULAR_IMPULSE = IMPULSE_Y + 1;

  /** Force, N. */
  public static final int FORCE_X = ANGULAR_IMPULSE + 1;

  /** Force, N. */
  public static final int FORCE_Y = FORCE_X + 1;

  /** Torque, N m. */
  public static final int TORQUE = FORCE_Y + 1;

  /** Number of the ints from {@link #MOTION} to the last load: all that the physics keeps. */
  public static final int STATE_INTS = LOADS + LOAD_INTS - MOTION;

  /**
   * Model after which the using program made the body, such as the index of a blueprint; an int of
   * its choice, as {@link #KEY} is.
   */
  public static final int ARCHETYPE = LOADS + LOAD_INTS;

  /** Number of the ints from {@link #MOTION} to {@link #ARCHETYPE}: all that can change. */
  public static final int CHANGING_INTS = ARCHETYPE + 1 - MOTION;

  /** Number of ints of a row. */
  public static final int INTS = ARCHETYPE + 1;

  private BodyRow() {}

  /**
   * Refuses a state that no world can have: numbers that are not finite, and a cosine and sine that
   * are no rotation.
   *
   * @param row holds the row
   * @param at where it begins
   * @throws IllegalArgumentException if the state is refused
   */
  public static void check(int[] row, int at) {
    for (int i = 0; i < STATE_INTS; i++) {
      float value = Float.intBitsToFloat(row[at + MOTION + i]);
      boolean sleeps = MOTION + i == SLEEP_TIME && row[at + SLEEP_TIME] == ASLEEP;
      if (!(Math.abs(value) <= Float.MAX_VALUE) && !sleeps) {
        throw new IllegalArgumentException("row[" + (MOTION + i) + "]=" + value + " isn't finite");
      }
    }
    float cos = Float.intBitsToFloat(row[at + COS]);
    float sin = Float.intBitsToFloat(row[at + SIN]);
    float square = cos * cos + sin * sin;
    if (!(Math.abs(square - 1) <= 0.01f)) {
      throw new IllegalArgumentException(
          "cos=" + cos + " sin=" + sin + " of a row is no rotation; their squares must add to 1");
    }
  }
}
