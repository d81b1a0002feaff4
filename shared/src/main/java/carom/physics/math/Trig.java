package carom.physics.math;

/**
 * Sine, cosine and arc tangent with the same bits on every machine. The JVM may replace {@code
 * Math.sin} and its kin by code for a processor. These functions are plain IEEE double arithmetic
 * in a fixed order, rounded to float once at the end.
 *
 * <p>Method: an angle is reduced to a count k of quarter turns and a remainder |r| &lt;= pi/4 by
 * subtracting k * pi/2 in two parts (Cody and Waite). Then follow the Taylor series of sine and
 * cosine, whose first omitted terms are below 1e-11. So the error is that of the final rounding:
 * within one float ulp, at most 6e-8 in absolute terms, for every finite float. The arc tangent is
 * folded to |t| &lt;= tan(pi/8). Its series ends at t^19 (omitted: below 1e-9), and its result is
 * within 2.5e-7 rad (half an ulp of pi, plus the series).
 *
 * <p>Above {@value #REDUCIBLE} rad, neighbouring floats are more than 0.06 rad apart and the
 * two-part reduction loses digits. There {@code StrictMath} takes over, which is bit-exact by
 * definition but slow. NaN and infinities give NaN.
 */
public final class Trig {
  /** Pi, rounded to float. */
  public static final float PI = 3.14159265f;

  /**
   * Largest magnitude in radians that is reduced here rather than by {@code StrictMath}. Up to it,
   * k fits in 20 bits.
   */
  private static final float REDUCIBLE = 1_000_000f;

  /** First 33 bits of pi/2. Its product with any k below 2^20 is exact. */
  private static final double HALF_PI_HIGH = 0x1.921fb544p0;

  /** Remainder of pi/2 after {@link #HALF_PI_HIGH}. */
  private static final double HALF_PI_LOW = 0x1.0b4611a626331p-34;

  private static final double PER_HALF_PI = 0.63661977236758134308;
  private static final double TAN_EIGHTH_PI = 0.41421356237309504880;

  /** A whole turn in the units of {@link #roughTurn}. */
  public static final int TURN = 1 << 26;

  /** Largest error of {@link #roughTurn} in its units, which is 2e-5 rad. */
  public static final int ROUGH = 214;

  private Trig() {}

  /**
   * Returns the sine of an angle.
   *
   * @param rad radians, any float; NaN and infinities give NaN, both zeros give 0
   * @return in [-1, 1]
   */
  public static float sin(float rad) {
    if (!(Math.abs(rad) <= REDUCIBLE)) {
      return (float) StrictMath.sin(rad);
    }
    int k = quarters(rad);
    double r = rest(rad, k);
    double s = (k & 1) == 0 ? sinSeries(r) : cosSeries(r);
    return (float) ((k & 2) == 0 ? s : -s);
  }

  /**
   * Returns the cosine of an angle.
   *
   * @param rad radians, any float; NaN and infinities give NaN
   * @return in [-1, 1]
   */
  public static float cos(float rad) {
    if (!(Math.abs(rad) <= REDUCIBLE)) {
      return (float) StrictMath.cos(rad);
    }
    int k = quarters(rad);
    double r = rest(rad, k);
    double c = (k & 1) == 0 ? cosSeries(r) : sinSeries(r);
    return (float) (((k + 1) & 2) == 0 ? c : -c);
  }

  /**
   * Returns the angle of the vector (x, y) in radians, counter-clockwise from the x axis.
   *
   * @return in [-pi, pi] as floats; 0 for the zero vector with zeros of any sign; for y = -0 and x
   *     &lt; 0 it is pi, not -pi; NaN when an argument is NaN; infinite arguments are treated as
   *     very long finite ones
   */
  public static float atan2(float y, float x) {
    if (Float.isNaN(x) || Float.isNaN(y)) {
      return Float.NaN;
    }
    double ax = Math.min(Math.abs(x), Float.MAX_VALUE);
    double ay = Math.min(Math.abs(y), Float.MAX_VALUE);
    if (ax == 0 && ay == 0) {
      return 0;
    }
    boolean steep = ay > ax;
    double t = steep ? ax / ay : ay / ax;
    double a =
        t > TAN_EIGHTH_PI
            ? HALF_PI_HIGH / 2 + (HALF_PI_LOW / 2 + atanSeries((t - 1) / (t + 1)))
            : atanSeries(t);
    if (steep) {
      a = HALF_PI_HIGH - (a - HALF_PI_LOW);
    }
    if (x < 0) {
      a = 2 * HALF_PI_HIGH - (a - 2 * HALF_PI_LOW);
    }
    return (float) (y < 0 ? -a : a);
  }

  /**
   * Returns the approximate angle of the vector (x, y), for thousands of vectors of which few need
   * all digits. It has no branch and one division. The polynomial for the first eighth of a turn is
   * 4.4.47 of Abramowitz and Stegun (error below 1e-5).
   *
   * @return the angle with {@link #TURN} for a whole turn, in -TURN/2..TURN/2, off by at most
   *     {@link #ROUGH}; an undefined number in that range for NaN and for vectors shorter than
   *     1e-30 or longer than 1e30
   */
  public static int roughTurn(float y, float x) {
    // Magnitudes of floats sort like their bits, which integers compare without a branch.
    int ax = Float.floatToRawIntBits(x) & Integer.MAX_VALUE;
    int ay = Float.floatToRawIntBits(y) & Integer.MAX_VALUE;
    int steep = ax - ay >> 31;
    int shift = ax - ay & steep;
    float t = Float.intBitsToFloat(ay + shift) / Float.intBitsToFloat(ax - shift);
    float q = t * t;
    float p = 0.0208351f;
    p = p * q - 0.0851330f;
    p = p * q + 0.1801410f;
    p = p * q - 0.3302995f;
    p = p * q + 0.9998660f;
    int turn = (int) (t * p * (TURN / (2 * PI)));
    turn = (turn ^ steep) - steep + (steep & TURN / 4);
    int left = Float.floatToRawIntBits(x) >> 31;
    turn = (turn ^ left) - left + (left & TURN / 2);
    int below = Float.floatToRawIntBits(y) >> 31;
    return (turn ^ below) - below;
  }

  private static int quarters(double rad) {
    double k = rad * PER_HALF_PI;
    return (int) (k + (k < 0 ? -0.5 : 0.5));
  }

  private static double rest(double rad, int k) {
    return rad - k * HALF_PI_HIGH - k * HALF_PI_LOW;
  }

  private static double sinSeries(double r) {
    double q = r * r;
    double p = -1.0 / 39916800;
    p = p * q + 1.0 / 362880;
    p = p * q - 1.0 / 5040;
    p = p * q + 1.0 / 120;
    p = p * q - 1.0 / 6;
    return r + r * q * p;
  }

  private static double cosSeries(double r) {
    double q = r * r;
    double p = 1.0 / 479001600;
    p = p * q - 1.0 / 3628800;
    p = p * q + 1.0 / 40320;
    p = p * q - 1.0 / 720;
    p = p * q + 1.0 / 24;
    return 1 - 0.5 * q + q * q * p;
  }

  private static double atanSeries(double t) {
    double q = t * t;
    double p = -1.0 / 19;
    p = p * q + 1.0 / 17;
    p = p * q - 1.0 / 15;
    p = p * q + 1.0 / 13;
    p = p * q - 1.0 / 11;
    p = p * q + 1.0 / 9;
    p = p * q - 1.0 / 7;
    p = p * q + 1.0 / 5;
    p = p * q - 1.0 / 3;
    return t + t * q * p;
  }
}
