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

  /** Speed below which a body stands still, m/s. */
  public static final float STILL_SPEED = 1f / 32;

  /** Angular speed below which a body stands still, rad/s. */
  public static final float STILL_SPIN = 1f / 16;

  /** Largest magnitude of a quantised position: a step less than 32,768 m, where worlds end. */
  public static final int MAX_POSITION = (1 << 24) - 1;

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

  /**
   * Returns whether a body with these velocities, in m/s and rad/s, stands still: so slow that a
   * picture without newer poses need not go on. Less would make settling heaps tell it again and
   * again.
   */
  public static boolean isStill(float vx, float vy, float omega) {
    return Math.abs(vx) < STILL_SPEED && Math.abs(vy) < STILL_SPEED && Math.abs(omega) < STILL_SPIN;
  }

  /** Wraps an angle difference in steps to the shorter way round, -512..511. */
  public static int wrapAngle(int steps) {
    return (steps << 22) >> 22;
  }

  /** Converts the first n numbers of an array as {@link #position} does. */
  public static void positions(float[] metres, int n, int[] to) {
    column(metres, n, POSITION_STEPS, MAX_POSITION, to);
  }

  /** Sets the first n numbers to 1 where {@link #isStill} says so, else to 0. */
  public static void stills(float[] vx, float[] vy, float[] omega, int n, int[] to) {
    for (int i = 0; i < n; i++) {
      to[i] = isStill(vx[i], vy[i], omega[i]) ? 1 : 0;
    }
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
