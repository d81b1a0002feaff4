package carom.net.snapshot;

import carom.net.codec.BitCoder;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.QuantizedPose;

/**
 * Codes the content of a delta: whether the body stands still, and how far its pose is from the
 * predicted one. Described once: with a {@link carom.net.codec.SliceWriter} the same lines write
 * that with a {@link carom.net.codec.RangeDecoder} read. {@code docs/protocol/CODING.md} has the
 * same as tables.
 *
 * <p>Of a body that stands still at the baseline, the ticks for which it went on resting come
 * first. Then it is predicted to stay, and the client learns when it began to move.
 *
 * <p>The <em>head</em> is one symbol: whether the body stands still, and which of x, y and the
 * angle were predicted wrongly. Each of those follows with its sign, length and highest digits as
 * one symbol. How likely each is, one of the {@link Profiles} says, as a product over the nodes of
 * a tree of yes and no. Which tree it is depends on what is known by then: on the {@link Track},
 * and on the numbers before. Of a body that stood still at the baseline and went far since, the
 * ticks follow for which it went on resting: so the client learns when it began to move. Nothing
 * depends on other records: so what a delta's bits are is the same for all sessions.
 */
class DeltaCodec {

  private static final int MAX_DIGITS = 27;

  // Nodes of a number's tree.
  private static final int NEGATIVE = 0;
  private static final int LONGER = 1;
  private static final int LONGER_NODES = 14;
  private static final int SECOND = LONGER + LONGER_NODES;
  private static final int MODELLED_DIGITS = 9;
  private static final int NUMBER_NODES = SECOND + MODELLED_DIGITS - 1;

  // Bits of a head, and the nodes of its tree: still, then for each answer x, y by x, angle by
  // both.
  private static final int X_WRONG = 1;
  private static final int Y_WRONG = 2;
  private static final int ANGLE_WRONG = 4;
  private static final int STILL = 8;
  private static final int WRONG_NODES = 7;
  private static final int HEAD_NODES = 1 + 2 * WRONG_NODES;

  // Forms of a magnitude: one digit; up to nine by the second one; more, up to fourteen; longer.
  private static final int LONG_FORMS = 1 + 2 * (MODELLED_DIGITS - 1);
  private static final int LONGEST = LONG_FORMS + LONGER_NODES - MODELLED_DIGITS;
  private static final int LENGTH_BITS = 4;

  /** Number of symbols of a number: each form with each sign. */
  static final int NUMBER_SYMBOLS = 2 * (LONGEST + 1);

  /** Number of symbols of a head. */
  static final int HEAD_SYMBOLS = 16;

  /** By form: the least magnitude, and how many plain bits follow. */
  private static final int[] LEAST = new int[LONGEST];

  private static final int[] LOW_BITS = new int[LONGEST];

  // Which head and tree is which.
  private static final int HEAD_TWISTS = 3;
  private static final int Y_SIZES = 7;
  private static final int ANGLE_SIZES = 9;
  private static final int X_AT = 0;
  private static final int Y_AT = X_AT + Track.BENDS * Track.SPEEDS;
  private static final int ANGLE_AT = Y_AT + Track.BENDS * Y_SIZES;

  /** Number of trees of a profile. */
  static final int TREES = ANGLE_AT + Track.TWISTS * ANGLE_SIZES;

  /** Number of heads of a profile. */
  static final int HEADS = Track.BENDS * Track.SPEEDS * HEAD_TWISTS;

  private static final int TREE_NODES = HEADS * HEAD_NODES;

  // A rest: so many ticks; from the last symbol on, as plain bits.
  private static final int LONG_REST = 8;

  /** A body that was at rest has gone far if its way or turn has more binary digits. */
  private static final int FAR_DIGITS = 2;

  private static final int REST_NODES = TREE_NODES + TREES * NUMBER_NODES;

  /** Number of symbols of a rest. */
  static final int REST_SYMBOLS = LONG_REST + 1;

  /** Number of nodes of a profile. */
  public static final int NODES = REST_NODES + LONG_REST;

  static {
    for (int form = 0; form < LONGEST; form++) {
      int digits = digitsOf(form);
      boolean second = form > 0 && form < LONG_FORMS;
      LOW_BITS[form] = digits - (second ? 2 : 1);
      LEAST[form] = (second ? 2 + (form + 1 & 1) : 1) << LOW_BITS[form];
    }
  }

  private int firstHead;
  private int firstTree;
  private int profile;

  /** Creates a codec; needs a {@link #profile}. */
  public DeltaCodec() {}

  /**
   * Sets how likely everything is in the deltas that follow.
   *
   * @param number of {@link Profiles}
   */
  public void profile(int number) {
    profile = number;
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
    int first = head * HEAD_NODES;
    int still = symbol / STILL;
    out.take(first, still);
    first += 1 + still * WRONG_NODES;
    out.take(first, symbol & X_WRONG);
    out.take(first + 1 + (symbol & X_WRONG), symbol / Y_WRONG & 1);
    out.take(first + 3 + (symbol & X_WRONG + Y_WRONG), symbol / ANGLE_WRONG & 1);
  }

  /** Tells the nodes behind a symbol of a number. */
  static void numberSteps(int tree, int symbol, Steps out) {
    int first = TREE_NODES + tree * NUMBER_NODES;
    int form = symbol >> 1;
    out.take(first + NEGATIVE, symbol & 1);
    int digits = digitsOf(form);
    for (int d = 1; d <= Math.min(digits, LONGER_NODES); d++) {
      out.take(first + LONGER + d - 1, digits > d ? 1 : 0);
    }
    if (form > 0 && form < LONG_FORMS) {
      out.take(first + SECOND + digits - 2, form + 1 & 1);
    }
  }

  /** Tells the nodes behind a symbol of a rest. */
  static void restSteps(int symbol, Steps out) {
    for (int ticks = 0; ticks < LONG_REST && ticks <= symbol; ticks++) {
      out.take(REST_NODES + ticks, symbol > ticks ? 1 : 0);
    }
  }

  /** Returns the binary digits of the magnitudes of a form: of the longest one, the least. */
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

  /** Codes the symbol of a rest. */
  int restSymbol(BitCoder c, int symbol, int most) {
    return c.symbol(Profiles.RESTS, profile, symbol, most);
  }

  /** Codes bits that are equally likely. */
  int plain(BitCoder c, int value, int count) {
    return c.plain(value, count);
  }

  /**
   * Codes a delta.
   *
   * @param track what both sides know, studied by a {@link Predictor}
   * @param residual what differs from the prediction, or where it goes to
   * @param rested for how many ticks the body stayed as it was at the baseline
   * @return the same, or 0 if that isn't told; what is read may be anything up to 63
   */
  public final int code(BitCoder c, Track track, QuantizedPose residual, int rested) {
    int twist = Math.min(3, track.twist) + 1 >> 1;
    int head = (track.bend * Track.SPEEDS + track.speed) * HEAD_TWISTS + twist;
    int wrong = head(c, head, symbolOf(residual));
    residual.still = (wrong & STILL) != 0;
    int tree = X_AT + track.bend * Track.SPEEDS + track.speed;
    residual.x =
        (wrong & X_WRONG) == 0 ? 0 : number(c, tree, residual.x, along(track.bendX, track.dx));
    tree = Y_AT + track.bend * Y_SIZES + digits(residual.x, Y_SIZES - 1);
    residual.y =
        (wrong & Y_WRONG) == 0 ? 0 : number(c, tree, residual.y, along(track.bendY, track.dy));
    int size = digits(Math.abs(residual.x) + Math.abs(residual.y), ANGLE_SIZES - 1);
    tree = ANGLE_AT + track.twist * ANGLE_SIZES + size;
    residual.angle =
        (wrong & ANGLE_WRONG) == 0
            ? 0
            : number(c, tree, residual.angle, along(track.bendTurn, track.turn));
    boolean far = size > FAR_DIGITS || Math.abs(residual.angle) >= 1 << FAR_DIGITS;
    int most = Math.min(LONG_REST, Baseline.age(track.baseline) - 1);
    return far && track.newest.still && most > 0 ? rest(c, rested, most) : 0;
  }

  private int rest(BitCoder c, int ticks, int most) {
    int symbol = restSymbol(c, Math.min(most, ticks), most);
    return symbol < LONG_REST ? symbol : plain(c, ticks, FrameRing.AGE_BITS);
  }

  private static int symbolOf(QuantizedPose residual) {
    return (residual.x != 0 ? X_WRONG : 0)
        | (residual.y != 0 ? Y_WRONG : 0)
        | (residual.angle != 0 ? ANGLE_WRONG : 0)
        | (residual.still ? STILL : 0);
  }

  private static int along(int bend, int way) {
    return bend != 0 ? bend : way;
  }

  /** Returns the binary digits of a magnitude, at most a number. */
  private static int digits(int value, int most) {
    return Math.min(most, Integer.SIZE - Integer.numberOfLeadingZeros(Math.abs(value)));
  }

  /** Codes a number but 0, its sign along another one: most follow or oppose a bend. */
  private int number(BitCoder c, int tree, int value, int along) {
    int turned = along < 0 ? -value : value;
    int magnitude = Math.abs(turned);
    int symbol = symbol(c, tree, 2 * form(magnitude) + (turned >>> 31));
    int form = symbol >> 1;
    int low = form < LONGEST ? LOW_BITS[form] : lengthen(c, magnitude);
    int least = form < LONGEST ? LEAST[form] : 1 << low;
    if (low > 0) {
      least |= plain(c, magnitude, low);
    }
    return (symbol & 1) != 0 == along < 0 ? least : -least;
  }

  private static int form(int magnitude) {
    int digits = digits(magnitude, MAX_DIGITS);
    if (digits <= 1) { // 0 only where a reader has no value
      return 0;
    }
    if (digits <= MODELLED_DIGITS) {
      return 2 * digits - 3 + (magnitude >>> digits - 2 & 1);
    }
    return LONG_FORMS + Math.min(digits - 1, LONGER_NODES) - MODELLED_DIGITS;
  }

  /** Codes the digits behind the first of a magnitude of the longest form. */
  private int lengthen(BitCoder c, int magnitude) {
    int more = Math.max(0, digits(magnitude, MAX_DIGITS) - 1 - LONGER_NODES);
    return Math.min(MAX_DIGITS - 1, LONGER_NODES + plain(c, more, LENGTH_BITS));
  }
}
