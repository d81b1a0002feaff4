package carom.net.snapshot.record;

import carom.net.codec.BitCoder;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.Motion;
import carom.net.snapshot.frame.Predictor;

/**
 * Codes the content of a delta: in which way the body's velocities are predicted, and how far the
 * six numbers are from the prediction. Described once: with a {@link carom.net.codec.SliceWriter}
 * the same lines write that with a {@link carom.net.codec.RangeDecoder} read. {@code
 * docs/PROTOCOL.md} has the same as tables.
 *
 * <p>Each number's sign, length and highest digits are one symbol, and so are the way and whether
 * it was right; how likely each is, one of the {@link Profiles} says, as a product over the nodes
 * of a tree of yes and no. Which tree it is depends on what is known of the body by then: how old
 * the baseline is, how fast the body was, how large the differences before are. Nothing depends on
 * other records: so what a delta's bits are is the same for all sessions.
 */
public class DeltaCodec {

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

  // Forms of a magnitude: one digit; up to nine by the second one; more, up to fourteen; longer.
  private static final int LONG_FORMS = 1 + 2 * (MODELLED_DIGITS - 1);
  private static final int LONGEST = LONG_FORMS + LONGER_NODES - MODELLED_DIGITS;
  private static final int LENGTH_BITS = 4;

  /** Number of symbols of a number: zero, and each form with each sign. */
  static final int NUMBER_SYMBOLS = 1 + 2 * (LONGEST + 1);

  /** Number of symbols of a head: each way, exact or not. */
  static final int HEAD_SYMBOLS = 6;

  /** By form: the least magnitude, and how many plain bits follow. */
  private static final int[] LEAST = new int[LONGEST];

  private static final int[] LOW_BITS = new int[LONGEST];

  // Which tree is which.
  private static final int AGES = 3;
  private static final int SPEEDS = 12;
  private static final int WAYS = 3;
  private static final int VY_CLASSES = 8;
  private static final int OMEGA_CLASSES = 10;
  private static final int PLACE_CLASSES = 12;
  private static final int ANGLE_CLASSES = 10;
  private static final int VX_AT = 0;
  private static final int VY_AT = VX_AT + AGES * SPEEDS;
  private static final int OMEGA_AT = VY_AT + AGES * VY_CLASSES;
  private static final int PLACE_AT = OMEGA_AT + AGES * OMEGA_CLASSES;
  private static final int ANGLE_AT = PLACE_AT + AGES * PLACE_CLASSES;

  /** Number of trees of a profile. */
  static final int TREES = ANGLE_AT + AGES * ANGLE_CLASSES;

  /** Number of heads of a profile. */
  static final int HEADS = AGES * SPEEDS;

  private static final int EXACT_NODES = 2 * HEADS;
  private static final int TREE_NODES = EXACT_NODES + WAYS * HEADS;

  /** Number of nodes of a profile. */
  public static final int NODES = TREE_NODES + TREES * NUMBER_NODES;

  /** Position steps that a step of velocity makes in a second, and angle steps, roughly. */
  private static final int PLACE_RATE = 64;

  private static final int ANGLE_RATE = 41;

  static {
    for (int form = 0; form < LONGEST; form++) {
      int digits = digitsOf(form);
      boolean second = form > 0 && form < LONG_FORMS;
      LOW_BITS[form] = digits - (second ? 2 : 1);
      LEAST[form] = (second ? 2 + (form + 1 & 1) : 1) << LOW_BITS[form];
    }
  }

  private final int tickRate;
  private int firstHead;
  private int firstTree;

  /**
   * Creates a codec; needs a {@link #profile}.
   *
   * @param tickRate ticks per second; the other side's must be the same
   */
  public DeltaCodec(int tickRate) {
    this.tickRate = tickRate;
  }

  /**
   * Sets how likely everything is in the deltas that follow.
   *
   * @param number of {@link Profiles}
   */
  public void profile(int number) {
    firstHead = number * HEADS;
    firstTree = number * TREES;
  }

  /** Receives what a symbol says about the nodes that it was made of. */
  interface Steps {
    /** Takes the bit at a node. */
    void take(int node, int bit);
  }

  /** Tells the nodes behind a symbol of a head. */
  static void headSteps(int head, int symbol, Steps out) {
    int way = symbol >> 1;
    out.take(2 * head, way == Predictor.GOES_ON ? 1 : 0);
    if (way != Predictor.GOES_ON) {
      out.take(2 * head + 1, way == Predictor.FALLS ? 1 : 0);
    }
    out.take(EXACT_NODES + WAYS * head + way, symbol & 1 ^ 1);
  }

  /** Tells the nodes behind a symbol of a number. */
  static void numberSteps(int tree, int symbol, Steps out) {
    int first = TREE_NODES + tree * NUMBER_NODES;
    out.take(first + ZERO, symbol == 0 ? 1 : 0);
    if (symbol == 0) {
      return;
    }
    int form = symbol - 1 >> 1;
    out.take(first + NEGATIVE, symbol - 1 & 1);
    int digits = digitsOf(form);
    for (int d = 1; d <= Math.min(digits, LONGER_NODES); d++) {
      out.take(first + LONGER + d - 1, digits > d ? 1 : 0);
    }
    if (form > 0 && form < LONG_FORMS) {
      out.take(first + SECOND + digits - 2, form + 1 & 1);
    }
  }

  /** Binary digits of the magnitudes of a form, of the longest one's least. */
  private static int digitsOf(int form) {
    return form < LONG_FORMS ? 1 + (form + 1 >> 1) : MODELLED_DIGITS + 1 + form - LONG_FORMS;
  }

  /** Codes the symbol of a head. */
  int head(BitCoder c, int head, int symbol) {
    return c.symbol(Profiles.HEADS, firstHead + head, symbol, HEAD_SYMBOLS - 1);
  }

  /** Codes the symbol of a number. */
  int symbol(BitCoder c, int tree, int symbol) {
    return c.symbol(Profiles.NUMBERS, firstTree + tree, symbol, NUMBER_SYMBOLS - 1);
  }

  /** Codes bits that are equally likely. */
  int plain(BitCoder c, int value, int count) {
    return c.plain(value, count);
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
  public final int code(BitCoder c, int age, Motion baseline, int way, Motion residual) {
    int old = age <= 3 ? 0 : age <= 6 ? 1 : 2;
    int speed = Math.abs(baseline.vx) + Math.abs(baseline.vy);
    boolean moving = (speed | baseline.omega) != 0;
    int fast = moving ? 1 + digits(speed, SPEEDS - 2) : 0;
    int head = head(c, old * SPEEDS + fast, 2 * way + (residual.isZero() ? 0 : 1));
    int result = head >> 1;
    if ((head & 1) == 0) {
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

  /** Where it came to rest: the faster it was, the less that can be foreseen. */
  private void stopped(BitCoder c, int old, int age, Motion baseline, Motion residual) {
    int at = PLACE_AT + old * PLACE_CLASSES;
    int x = stoppedClass(baseline.vx, age);
    residual.x = number(c, at + x, residual.x, baseline.vx);
    int y = stoppedClass(baseline.vy, age);
    residual.y = number(c, at + y, residual.y, baseline.vy);
    at = ANGLE_AT + old * ANGLE_CLASSES;
    residual.angle = number(c, at, residual.angle, baseline.omega);
  }

  private int stoppedClass(int velocity, int age) {
    return Math.min(STOPPED_CLASSES - 1, digits(way(velocity, age, PLACE_RATE), MAX_DIGITS) / 3);
  }

  private void moving(BitCoder c, int old, int age, int fast, Motion baseline, Motion residual) {
    int at = VX_AT + old * SPEEDS + fast;
    residual.vx = number(c, at, residual.vx, baseline.vx);
    at = VY_AT + old * VY_CLASSES + digits(residual.vx, VY_CLASSES - 1);
    residual.vy = number(c, at, residual.vy, baseline.vy);
    int pushed = digits(Math.abs(residual.vx) + Math.abs(residual.vy), OMEGA_CLASSES - 1);
    at = OMEGA_AT + old * OMEGA_CLASSES + pushed;
    residual.omega = number(c, at, residual.omega, baseline.omega);
    int place = PLACE_AT + old * PLACE_CLASSES;
    at = place + placeClass(residual.vx, residual.vy, age);
    residual.x = number(c, at, residual.x, residual.vx);
    at = place + placeClass(residual.vy, residual.vx, age);
    residual.y = number(c, at, residual.y, residual.vy);
    at = ANGLE_AT + old * ANGLE_CLASSES + angleClass(residual.omega, age);
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
    int symbol = symbol(c, tree, magnitude == 0 ? 0 : 1 + 2 * form(magnitude) + (turned >>> 31));
    if (symbol == 0) {
      return 0;
    }
    int form = symbol - 1 >> 1;
    int low = form < LONGEST ? LOW_BITS[form] : lengthen(c, magnitude);
    int least = form < LONGEST ? LEAST[form] : 1 << low;
    if (low > 0) {
      least |= plain(c, magnitude, low);
    }
    return (symbol & 1) == 0 == along < 0 ? least : -least;
  }

  private static int form(int magnitude) {
    int digits = digits(magnitude, MAX_DIGITS);
    if (digits == 1) {
      return 0;
    }
    if (digits <= MODELLED_DIGITS) {
      return 2 * digits - 3 + (magnitude >>> digits - 2 & 1);
    }
    return LONG_FORMS + Math.min(digits - 1, LONGER_NODES) - MODELLED_DIGITS;
  }

  /** The digits behind the first of a magnitude of the longest form. */
  private int lengthen(BitCoder c, int magnitude) {
    int more = digits(magnitude, MAX_DIGITS) - 1 - LONGER_NODES;
    return Math.min(MAX_DIGITS - 1, LONGER_NODES + plain(c, more, LENGTH_BITS));
  }
}
