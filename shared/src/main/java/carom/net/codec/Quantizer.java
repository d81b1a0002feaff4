package carom.net.codec;

/**
 * Numbers of the world to integers on the wire and back. Rounds to nearest. What is outside a range
 * is clamped to its end, NaN becomes 0: the wire shows a wrong picture of a broken world, and never
 * breaks itself.
 */
public final class Quantizer {

  /** Steps per metre of a position. */
  public static final int POSITION_STEPS = 512;

  /** Steps per turn of an angle. */
  public static final int ANGLE_STEPS = 1_024;

  /** Steps per metre per second of a velocity. */
  public static final int VELOCITY_STEPS = 64;

  /** Steps per radian per second of an angular velocity. */
  public static final int OMEGA_STEPS = 32;

  /** Largest magnitude of a quantised position: 65,536 m. */
  public static final int MAX_POSITION = 1 << 25;

  /** Largest magnitude of a quantised velocity: 2,048 m/s. */
  public static final int MAX_VELOCITY = 1 << 17;

  /** Largest magnitude of a quantised angular velocity: 1,024 rad/s. */
  public static final int MAX_OMEGA = 1 << 15;

  /**
   * Columns of so many numbers, and longer ones, are quantised by vectors where the JVM has them;
   * shorter ones gain too little to be worth the calls until the JIT compiler is done.
   */
  public static final int LONG = 1_000;

  private static final double ANGLE_SCALE = ANGLE_STEPS / (2 * Math.PI);

  /** From 2^26 to a turn to 2^10. */
  private static final int TURN_SHIFT = 16;

  private Quantizer() {}

  /** Metres to steps, within plus or minus {@link #MAX_POSITION}. */
  public static int position(float metres) {
    return clamp(metres * (double) POSITION_STEPS, MAX_POSITION);
  }

  /** Steps to metres; exact in a float up to 32,768 m. */
  public static float positionOf(int steps) {
    return steps * (1f / POSITION_STEPS);
  }

  /** Radians to steps, 0..1,023; whole turns vanish. */
  public static int angle(float radians) {
    double steps = radians * ANGLE_SCALE;
    if (!(Math.abs(steps) < 1e15)) {
      return 0;
    }
    return (int) Math.floorMod(Math.round(steps), (long) ANGLE_STEPS);
  }

  /**
   * An angle that is known about to steps, as {@link #angle} rounds the exact one.
   *
   * @param turn 2^26 for a whole turn
   * @param error how far it may be off, less than 2^15
   * @return 0..1,023; -1 when it is too close to where the next step begins
   */
  public static int angleOfTurn(int turn, int error) {
    int moved = turn + (1 << TURN_SHIFT - 1);
    int rest = moved & (1 << TURN_SHIFT) - 1;
    boolean sure = rest > error && rest < (1 << TURN_SHIFT) - error;
    return sure ? moved >> TURN_SHIFT & ANGLE_STEPS - 1 : -1;
  }

  /** Steps to radians, -pi (exclusive) .. pi. */
  public static float angleOf(int steps) {
    int wrapped = wrapAngle(steps);
    return (float) ((wrapped == -ANGLE_STEPS / 2 ? ANGLE_STEPS / 2 : wrapped) / ANGLE_SCALE);
  }

  /** Metres per second to steps, within plus or minus {@link #MAX_VELOCITY}. */
  public static int velocity(float metresPerSecond) {
    return clamp(metresPerSecond * (double) VELOCITY_STEPS, MAX_VELOCITY);
  }

  /** Steps to metres per second. */
  public static float velocityOf(int steps) {
    return steps * (1f / VELOCITY_STEPS);
  }

  /** Radians per second to steps, within plus or minus {@link #MAX_OMEGA}. */
  public static int omega(float radiansPerSecond) {
    return clamp(radiansPerSecond * (double) OMEGA_STEPS, MAX_OMEGA);
  }

  /** Steps to radians per second. */
  public static float omegaOf(int steps) {
    return steps * (1f / OMEGA_STEPS);
  }

  /** The shortest way of an angle difference in steps: -512..511. */
  public static int wrapAngle(int steps) {
    return (steps << 22) >> 22;
  }

  /** {@link #position} of the first n numbers of an array. */
  public static void positions(float[] metres, int n, int[] to) {
    column(metres, n, POSITION_STEPS, MAX_POSITION, to);
  }

  /** {@link #velocity} of the first n numbers of an array. */
  public static void velocities(float[] metresPerSecond, int n, int[] to) {
    column(metresPerSecond, n, VELOCITY_STEPS, MAX_VELOCITY, to);
  }

  /** {@link #omega} of the first n numbers of an array. */
  public static void omegas(float[] radiansPerSecond, int n, int[] to) {
    column(radiansPerSecond, n, OMEGA_STEPS, MAX_OMEGA, to);
  }

  /**
   * About the angles of n directions, as {@link #angleOfTurn} rounds them, by vectors.
   *
   * @param cos cosines, or the directions' x
   * @param sin sines, or their y
   * @param error how far {@code Trig.roughTurn} may be off, which this does the same way
   * @param to receives 0..1,023, or -1 for one that is too close to where the next step begins
   * @return how many were done, 0..n: the first ones; the caller does the others
   */
  public static int anglesOfTurns(float[] cos, float[] sin, int n, int error, int[] to) {
    ColumnLanes lanes = ColumnLanes.FOUND;
    return lanes == null ? 0 : lanes.turns(cos, sin, n, error, to);
  }

  private static void column(float[] from, int n, int scale, int max, int[] to) {
    ColumnLanes lanes = ColumnLanes.FOUND;
    int done = lanes == null ? 0 : lanes.steps(from, n, scale, max, to);
    clampColumn(from, done, n, scale, max, to);
  }

  /** Quantises the numbers from one index to before another. */
  static void clampColumn(float[] from, int begin, int end, double scale, int max, int[] to) {
    for (int i = begin; i < end; i++) {
      to[i] = clamp(from[i] * scale, max);
    }
  }

  private static int clamp(double steps, int max) {
    // as Math.round, but by an instruction that processors have; NaN becomes 0
    return Math.max(-max, Math.min(max, (int) Math.floor(steps + 0.5)));
  }
}
