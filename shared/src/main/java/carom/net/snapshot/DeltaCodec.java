package carom.net.snapshot;

import carom.net.codec.BitCoder;

/**
 * The content of a delta: in which way the body's velocities are predicted, and how far the six
 * numbers are from the prediction. Described once: with a {@link carom.net.codec.SliceWriter} the
 * same lines write that with a {@link carom.net.codec.RangeDecoder} read. {@code docs/PROTOCOL.md}
 * has the same as tables.
 *
 * <p>Each bit has a node in a table of probabilities, one of the {@link Profiles}. Which node it is
 * depends on what is known of the body by then: how old the baseline is, how fast the body was, how
 * large the differences before are. Nothing depends on other records: so what a delta's bits are is
 * the same for all sessions.
 */
class DeltaCodec {

  private static final int STOPPED_CLASSES = 3;
  private static final int MAX_DIGITS = 27;

  // Nodes of a number's tree.
  private static final int ZERO = 0;
  private static final int NEGATIVE = 1;
  private static final int LONGER = 2;
  private static final int LONGER_NODES = 14;
  private static final int SECOND = LONGER + LONGER_NODES;
  private static final int MODELLED_DIGITS = 9;
  private static final int NUMBER_NODES = SECOND + MODELLED_DIGITS - 1;

  // Where in the table what begins.
  private static final int AGES = 3;
  private static final int SPEEDS = 12;
  private static final int WAYS = 3;
  private static final int EXACT_AT = 2 * AGES * SPEEDS;
  private static final int VX_AT = EXACT_AT + WAYS * AGES * SPEEDS;
  private static final int VY_CLASSES = 8;
  private static final int VY_AT = VX_AT + AGES * SPEEDS * NUMBER_NODES;
  private static final int OMEGA_CLASSES = 10;
  private static final int OMEGA_AT = VY_AT + AGES * VY_CLASSES * NUMBER_NODES;
  private static final int PLACE_CLASSES = 12;
  private static final int PLACE_AT = OMEGA_AT + AGES * OMEGA_CLASSES * NUMBER_NODES;
  private static final int ANGLE_CLASSES = 10;
  private static final int ANGLE_AT = PLACE_AT + AGES * PLACE_CLASSES * NUMBER_NODES;

  /** Length of a table. */
  static final int NODES = ANGLE_AT + AGES * ANGLE_CLASSES * NUMBER_NODES;

  /** Position steps that a step of velocity makes in a second, and angle steps, roughly. */
  private static final int PLACE_RATE = 8;

  private static final int ANGLE_RATE = 5;

  private final int tickRate;
  private char[] profile;

  /**
   * Creates a codec; needs a {@link #profile}.
   *
   * @param tickRate ticks per second; the other side's must be the same
   */
  DeltaCodec(int tickRate) {
    this.tickRate = tickRate;
  }

  /** Sets the table for the deltas that follow: probabilities of a 1 by node; not copied. */
  void profile(char[] table) {
    profile = table;
  }

  /** Codes a bit at a node. */
  int bit(BitCoder c, int node, int bit) {
    return c.code(bit, profile[node]);
  }

  /** Codes bits that are equally likely. */
  int plain(BitCoder c, int value, int count) {
    return c.plain(value, count);
  }

  private boolean flag(BitCoder c, int node, boolean value) {
    return bit(c, node, value ? 1 : 0) != 0;
  }

  /**
   * Codes a delta.
   *
   * @param age ticks, 1..{@link FrameRing#SIZE} - 1
   * @param baseline what both sides know
   * @param way how the velocities are predicted, as {@link Predictor#way}
   * @param residual what differs from the prediction, or where it goes to
   * @return the way
   */
  final int code(BitCoder c, int age, Motion baseline, int way, Motion residual) {
    int old = age <= 3 ? 0 : age <= 6 ? 1 : 2;
    int speed = Math.abs(baseline.vx) + Math.abs(baseline.vy);
    boolean moving = (speed | baseline.omega) != 0;
    int fast = moving ? 1 + digits(speed, SPEEDS - 2) : 0;
    int situation = old * SPEEDS + fast;
    int result = way(c, 2 * situation, way);
    if (flag(c, EXACT_AT + WAYS * situation + result, residual.isZero())) {
      residual.clear();
      return result;
    }
    if (result == Predictor.STOPS) {
      residual.vx = 0;
      residual.vy = 0;
      residual.omega = 0;
      stopped(c, old, age, baseline, residual);
    } else {
      moving(c, old, age, fast, baseline, residual);
    }
    return result;
  }

  private int way(BitCoder c, int node, int way) {
    if (flag(c, node, way == Predictor.GOES_ON)) {
      return Predictor.GOES_ON;
    }
    return flag(c, node + 1, way == Predictor.FALLS) ? Predictor.FALLS : Predictor.STOPS;
  }

  /** Where it came to rest: the faster it was, the less that can be foreseen. */
  private void stopped(BitCoder c, int old, int age, Motion baseline, Motion residual) {
    int at = PLACE_AT + old * PLACE_CLASSES * NUMBER_NODES;
    int x = stoppedClass(baseline.vx, age) * NUMBER_NODES;
    residual.x = number(c, at + x, residual.x, baseline.vx);
    int y = stoppedClass(baseline.vy, age) * NUMBER_NODES;
    residual.y = number(c, at + y, residual.y, baseline.vy);
    at = ANGLE_AT + old * ANGLE_CLASSES * NUMBER_NODES;
    residual.angle = number(c, at, residual.angle, baseline.omega);
  }

  private int stoppedClass(int velocity, int age) {
    return Math.min(STOPPED_CLASSES - 1, digits(way(velocity, age, PLACE_RATE), MAX_DIGITS) / 3);
  }

  private void moving(BitCoder c, int old, int age, int fast, Motion baseline, Motion residual) {
    int at = VX_AT + (old * SPEEDS + fast) * NUMBER_NODES;
    residual.vx = number(c, at, residual.vx, baseline.vx);
    at = VY_AT + (old * VY_CLASSES + digits(residual.vx, VY_CLASSES - 1)) * NUMBER_NODES;
    residual.vy = number(c, at, residual.vy, baseline.vy);
    int pushed = digits(Math.abs(residual.vx) + Math.abs(residual.vy), OMEGA_CLASSES - 1);
    at = OMEGA_AT + (old * OMEGA_CLASSES + pushed) * NUMBER_NODES;
    residual.omega = number(c, at, residual.omega, baseline.omega);
    int place = PLACE_AT + old * PLACE_CLASSES * NUMBER_NODES;
    at = place + placeClass(residual.vx, residual.vy, age) * NUMBER_NODES;
    residual.x = number(c, at, residual.x, residual.vx);
    at = place + placeClass(residual.vy, residual.vx, age) * NUMBER_NODES;
    residual.y = number(c, at, residual.y, residual.vy);
    at = ANGLE_AT + (old * ANGLE_CLASSES + angleClass(residual.omega, age)) * NUMBER_NODES;
    residual.angle = number(c, at, residual.angle, residual.omega);
  }

  /** How far a place may be off: by when it was that the velocity changed. */
  private int placeClass(int pushed, int across, int age) {
    if (pushed == 0) {
      int size = Math.abs(across);
      return STOPPED_CLASSES + (size == 0 ? 0 : size < 4 ? 1 : 2);
    }
    int least = STOPPED_CLASSES + 3;
    return least + digits(way(pushed, age, PLACE_RATE), PLACE_CLASSES - 1 - least);
  }

  private int angleClass(int turned, int age) {
    return turned == 0 ? 1 : 2 + digits(way(turned, age, ANGLE_RATE), ANGLE_CLASSES - 3);
  }

  /** Steps that a velocity makes in a delta's time; of hostile numbers, anything. */
  private int way(int velocity, int age, int rate) {
    return (int) ((long) Math.abs(velocity) * age * rate / tickRate);
  }

  /** Binary digits of a magnitude, no more than so many. */
  private static int digits(int value, int most) {
    return Math.min(most, Integer.SIZE - Integer.numberOfLeadingZeros(Math.abs(value)));
  }

  /** A number with the sign seen along another one, as most follow or oppose what was before. */
  private int number(BitCoder c, int tree, int value, int along) {
    int turned = along < 0 ? -value : value;
    int magnitude = Math.abs(turned);
    if (flag(c, tree + ZERO, magnitude == 0)) {
      return 0;
    }
    boolean negative = flag(c, tree + NEGATIVE, turned < 0);
    magnitude = magnitude(c, tree, magnitude);
    return negative == along < 0 ? magnitude : -magnitude;
  }

  /** A number of at least 1: how many binary digits, then those behind the first. */
  private int magnitude(BitCoder c, int tree, int value) {
    int digits = 1;
    while (digits < MAX_DIGITS
        && flag(c, tree + LONGER + Math.min(digits, LONGER_NODES) - 1, value >>> digits != 0)) {
      digits++;
    }
    if (digits == 1) {
      return 1;
    }
    int low = digits - 2;
    int second = value >>> low & 1;
    second = digits <= MODELLED_DIGITS ? bit(c, tree + SECOND + low, second) : plain(c, second, 1);
    return (2 | second) << low | plain(c, value, low);
  }
}
