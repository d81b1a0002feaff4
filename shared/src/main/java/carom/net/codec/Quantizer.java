package carom.net.codec;

/**
 * Conversion of world quantities to integers on the wire and back. It rounds to nearest, clamps a
 * value outside the range to its end, and turns NaN into 0. So a broken world gives a wrong
 * picture, but never a broken datagram.
 */
public final class Quantizer {

  /** Steps per metre of a position. */
  public static final int POSITION_STEPS = 512;

  /** Steps per turn of an angle. */
  public static final int ANGLE_STEPS = 1_024;

  /**
   * Steps per metre per second of a velocity. They are coarse because most of a delta's bits would
   * go to digits of velocities that no picture shows: positions say where a body is.
   */
  public static final int VELOCITY_STEPS = 8;

  /** Steps per radian per second of an angular velocity, coarse for the same reason. */
  public static final int OMEGA_STEPS = 4;

  /** Largest magnitude of a quantised position: 65,536 m. */
  public static final int MAX_POSITION = 1 << 25;

  /** Largest magnitude of a quantised velocity: 2,048 m/s. */
  public static final int MAX_VELOCITY = 1 << 14;

  /** Largest magnitude of a quantised angular velocity: 1,024 rad/s. */
  public static final int MAX_OMEGA = 1 << 12;

  /**
   * Shortest column that is quantised by vector kernels, where the JVM has them. A shorter one
   * gains too little to be worth the calls made while the JIT compiler hasn't finished.
   */
  public static final int LONG = 1_000;

  private static final double ANGLE_SCALE = ANGLE_STEPS / (2 * Math.PI);

  /** Shift from an angle with 2^26 to a turn to one with 2^10. */
  private static final int TURN_SHIFT = 16;

  private Quantizer() {}

  /** Converts metres to steps, clamped to plus or minus {@link #MAX_POSITION}. */
  public static int position(float metres) {
    return clamp(metres * (double) POSITION_STEPS, MAX_POSITION);
  }

  /** Converts steps to metres. The result is exact in a float up to 32,768 m. */
  public static float positionOf(int steps) {
    return steps * (1f / POSITION_STEPS);
  }

  /** Converts radians to steps, 0..1,023. Whole turns drop out. */
  public static int angle(float radians) {
    double steps = radians * ANGLE_SCALE;
    if (!(Math.abs(steps) < 1e15)) {
      return 0;
    }
    return (int) Math.floorMod(Math.round(steps), (long) ANGLE_STEPS);
  }

  /**
   * Rounds an angle that is known only approximately, if the result is sure to equal what {@link
   * #angle} gives for the exact angle.
   *
   * @param turn the angle, with 2^26 for a whole turn
   * @param error largest error of {@code turn}, less than 2^15
   * @return 0..1,023, or -1 when the angle is too close to a rounding boundary
   */
  public static int angleOfTurn(int turn, int error) {
    int moved = turn + (1 << TURN_SHIFT - 1);
    int rest = moved & (1 << TURN_SHIFT) - 1;
    boolean sure = rest > error && rest < (1 << TURN_SHIFT) - error;
    return sure ? moved >> TURN_SHIFT & ANGLE_STEPS - 1 : -1;
  }

  /** Converts steps to radians, -pi (exclusive) .. pi. */
  public static float angleOf(int steps) {
    int wrapped = wrapAngle(steps);
    return (float) ((wrapped == -ANGLE_STEPS / 2 ? ANGLE_STEPS / 2 : wrapped) / ANGLE_SCALE);
  }

  /** Converts metres per second to steps, clamped to plus or minus {@link #MAX_VELOCITY}. */
  public static int velocity(float metresPerSecond) {
    return clamp(metresPerSecond * (double) VELOCITY_STEPS, MAX_VELOCITY);
  }

  /** Converts steps to metres per second. */
  public static float velocityOf(int steps) {
    return steps * (1f / VELOCITY_STEPS);
  }

  /** Converts radians per second to steps, clamped to plus or minus {@link #MAX_OMEGA}. */
  public static int omega(float radiansPerSecond) {
    return clamp(radiansPerSecond * (double) OMEGA_STEPS, MAX_OMEGA);
  }

  /** Converts steps to radians per second. */
  public static float omegaOf(int steps) {
    return steps * (1f / OMEGA_STEPS);
  }

  /** Wraps an angle difference in steps to the shorter way round, -512..511. */
  public static int wrapAngle(int steps) {
    return (steps << 22) >> 22;
  }

  /** Converts the first n numbers of an array as {@link #position} does. */
  public static void positions(float[] metres, int n, int[] to) {
    column(metres, n, POSITION_STEPS, MAX_POSITION, to);
  }

  /** Converts the first n numbers of an array as {@link #velocity} does. */
  public static void velocities(float[] metresPerSecond, int n, int[] to) {
    column(metresPerSecond, n, VELOCITY_STEPS, MAX_VELOCITY, to);
  }

  /** Converts the first n numbers of an array as {@link #omega} does. */
  public static void omegas(float[] radiansPerSecond, int n, int[] to) {
    column(radiansPerSecond, n, OMEGA_STEPS, MAX_OMEGA, to);
  }

  /**
   * Converts leading directions of two columns to angles with vector kernels, rounded as {@link
   * #angleOfTurn} does.
   *
   * @param cos cosines, or the x of the directions
   * @param sin sines, or the y of the directions
   * @param error largest error of {@code Trig.roughTurn}, whose polynomial the kernels use
   * @param to receives 0..1,023, or -1 for an angle too close to a rounding boundary
   * @return how many directions were converted, 0..n; the caller converts the rest
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

  /** Quantises the numbers at {@code begin} to {@code end - 1} one by one. */
  static void clampColumn(float[] from, int begin, int end, double scale, int max, int[] to) {
    for (int i = begin; i < end; i++) {
      to[i] = clamp(from[i] * scale, max);
    }
  }

  private static int clamp(double steps, int max) {
    // Rounds as Math.round does, but with one instruction of the processor. NaN becomes 0.
    return Math.max(-max, Math.min(max, (int) Math.floor(steps + 0.5)));
  }
}
