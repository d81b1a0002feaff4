package carom.net.snapshot;

import carom.net.codec.BitCoder;
import carom.net.codec.BitTable;
import carom.net.codec.Bits;
import carom.net.codec.RangeEncoder;

/**
 * The forms of which an entity's record is made, each described once: with a {@link
 * carom.net.codec.RangeEncoder} the same lines write that with a {@link
 * carom.net.codec.RangeDecoder} read. {@code docs/PROTOCOL.md} has the same as tables.
 *
 * <p>Each bit has a node in a table of probabilities. Which node it is depends on what both sides
 * know by then: how old the baseline is, whether the body moved in it, how large the differences
 * before were. As a datagram must be decodable alone, each begins with the same table ({@link
 * RecordPrior}), and adapts it as it goes on. One object codes one datagram at a time.
 */
class RecordCodec {

  /** Kinds of records. */
  static final int DELTA = 0;

  static final int ABSOLUTE = 1;
  static final int GONE = 2;
  static final int OUT_OF_SIGHT = 3;

  /** Answer of {@link #slot} at the end of the records. */
  static final int END = -1;

  static final int AGE_BITS = 6;

  /** Most records of a datagram. */
  static final int MAX_RECORDS = 4_096;

  private static final int SLOT_BITS = 16;
  private static final int SHORT_ARCHETYPE_BITS = 6;
  private static final int WIDTH_BITS = 5;
  private static final int ANGLE_BITS = 10;
  private static final int MAX_WIDTH = 27;

  // Nodes of a number's tree.
  private static final int ZERO = 0;
  private static final int NEGATIVE = 1;
  private static final int LONGER = 2;
  private static final int MAX_DIGITS = 27;
  private static final int SECOND = LONGER + MAX_DIGITS - 1;
  private static final int MODELLED_DIGITS = 9;
  private static final int NUMBER_NODES = SECOND + MODELLED_DIGITS - 1;

  // Where in the table what begins.
  private static final int SIZES = 5;
  private static final int SITUATIONS = 4;
  private static final int WAYS = 3;
  private static final int FIELDS = 6;
  private static final int KIND_AT = 0;
  private static final int END_AT = KIND_AT + 3;
  private static final int NEXT_AT = END_AT + 1;
  private static final int FAR_AT = NEXT_AT + 2;
  private static final int SAME_AGE_AT = FAR_AT + 1;
  private static final int WAY_AT = SAME_AGE_AT + 1;
  private static final int EXACT_AT = WAY_AT + 2 * SITUATIONS * WAYS;
  private static final int GAP_AT = EXACT_AT + SITUATIONS * WAYS;
  private static final int NUMBERS_AT = GAP_AT + NUMBER_NODES;

  /** Length of the table. */
  static final int NODES = NUMBERS_AT + FIELDS * SITUATIONS * SIZES * NUMBER_NODES;

  private final BitTable table;
  private int slot;
  private int age;
  private int way;
  private boolean wasNext;
  private int markedSlot;
  private int markedAge;
  private int markedWay;
  private boolean markedNext;

  RecordCodec() {
    this(RecordPrior.TABLE);
  }

  /**
   * Creates a codec.
   *
   * @param prior probability of a 1 for each node, in 1/65,536; copied
   */
  RecordCodec(char[] prior) {
    table = new BitTable(prior);
  }

  /** Codes a bit at a node. */
  int bit(BitCoder c, int node, int bit) {
    return table.code(c, node, bit);
  }

  /** Codes bits that are equally likely. */
  int plain(BitCoder c, int value, int count) {
    return c.plain(value, count);
  }

  private boolean flag(BitCoder c, int node, boolean value) {
    return bit(c, node, value ? 1 : 0) != 0;
  }

  /** Starts a datagram. */
  void begin() {
    table.begin();
    slot = -1;
    age = 0;
    way = Predictor.GOES_ON;
    wasNext = true;
  }

  /** Remembers this place, before a record that may not fit. */
  void mark() {
    table.mark();
    markedSlot = slot;
    markedAge = age;
    markedWay = way;
    markedNext = wasNext;
  }

  /** Goes back to the last {@link #mark}. */
  void rewind() {
    table.rewind();
    slot = markedSlot;
    age = markedAge;
    way = markedWay;
    wasNext = markedNext;
  }

  /** Slots mostly ascend within a datagram; {@link #END} ends it. */
  int slot(BitCoder c, int value) {
    if (flag(c, END_AT, value == END)) {
      return END;
    }
    int gap = value - slot - 1;
    boolean next = flag(c, NEXT_AT + (wasNext ? 1 : 0), gap == 0);
    wasNext = next;
    if (next) {
      slot++;
    } else if (flag(c, FAR_AT, gap < 0)) {
      slot = c.plain(value, SLOT_BITS);
    } else {
      slot += 1 + magnitude(c, GAP_AT, gap);
    }
    return slot;
  }

  int kind(BitCoder c, int kind) {
    if (flag(c, KIND_AT, kind == DELTA)) {
      return DELTA;
    }
    if (flag(c, KIND_AT + 1, kind == ABSOLUTE)) {
      return ABSOLUTE;
    }
    return flag(c, KIND_AT + 2, kind == GONE) ? GONE : OUT_OF_SIGHT;
  }

  int age(BitCoder c, int value) {
    if (!flag(c, SAME_AGE_AT, value == age)) {
      age = c.plain(value, AGE_BITS);
    }
    return age;
  }

  /**
   * Codes how a delta's velocities are predicted.
   *
   * @param baseline what both sides know
   */
  int way(BitCoder c, Motion baseline, int value) {
    return way(c, situation(baseline, age), value);
  }

  private int way(BitCoder c, int situation, int value) {
    int node = WAY_AT + 2 * (situation * WAYS + way);
    if (flag(c, node, value == Predictor.GOES_ON)) {
      way = Predictor.GOES_ON;
    } else {
      way = flag(c, node + 1, value == Predictor.FALLS) ? Predictor.FALLS : Predictor.STOPS;
    }
    return way;
  }

  /** Codes a delta's differences in place, after its way. */
  void residual(BitCoder c, Motion baseline, Motion residual) {
    residual(c, situation(baseline, age), way, baseline, residual);
  }

  /** Codes a delta's differences in place, whatever was coded before. */
  final void residual(BitCoder c, int situation, int way, Motion baseline, Motion residual) {
    if (flag(c, EXACT_AT + situation * WAYS + way, residual.isZero())) {
      residual.clear();
      return;
    }
    int at = NUMBERS_AT + situation * SIZES * NUMBER_NODES;
    int speed = size(Math.abs(baseline.vx) + Math.abs(baseline.vy) >> 3);
    residual.vx = number(c, at, speed, residual.vx, baseline.vx);
    at += SITUATIONS * SIZES * NUMBER_NODES;
    residual.vy = number(c, at, size(residual.vx), residual.vy, baseline.vy);
    at += SITUATIONS * SIZES * NUMBER_NODES;
    int hit = size(Math.abs(residual.vx) + Math.abs(residual.vy));
    residual.omega = number(c, at, hit, residual.omega, baseline.omega);
    at += SITUATIONS * SIZES * NUMBER_NODES;
    residual.x = number(c, at, size(residual.vx), residual.x, residual.vx);
    at += SITUATIONS * SIZES * NUMBER_NODES;
    residual.y = number(c, at, size(residual.vy), residual.y, residual.vy);
    at += SITUATIONS * SIZES * NUMBER_NODES;
    residual.angle = number(c, at, size(residual.omega), residual.angle, residual.omega);
  }

  /**
   * Writes a delta's age, way and differences.
   *
   * @param age ticks
   */
  void delta(RangeEncoder range, int age, Deltas deltas, int delta) {
    age(range, age);
    way(range, deltas.situation(delta), deltas.way(delta));
    range.code(table, deltas.steps(), deltas.from(delta), deltas.to(delta));
  }

  /** What tells from each other the trees that a delta's bits are coded with, 0..3. */
  static int situation(Motion baseline, int age) {
    boolean moving = (baseline.vx | baseline.vy | baseline.omega) != 0;
    return (moving ? 2 : 0) + (age > 6 ? 1 : 0);
  }

  private static int size(int value) {
    int magnitude = Math.abs(value);
    if (magnitude <= 2) {
      return magnitude == 0 ? 0 : 1;
    }
    return magnitude <= 8 ? 2 : magnitude <= 32 ? 3 : 4;
  }

  /** A number with the sign seen along another one, as most follow or oppose what was before. */
  private int number(BitCoder c, int at, int size, int value, int along) {
    int tree = at + size * NUMBER_NODES;
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
    while (digits < MAX_DIGITS && flag(c, tree + LONGER + digits - 1, value >>> digits != 0)) {
      digits++;
    }
    if (digits == 1) {
      return 1;
    }
    int low = digits - 2;
    int second = value >>> low & 1;
    second =
        digits <= MODELLED_DIGITS
            ? bit(c, tree + SECOND + digits - 2, second)
            : plain(c, second, 1);
    return (2 | second) << low | plain(c, value, low);
  }

  int generation(BitCoder c, int value) {
    return c.plain(value, 8);
  }

  int archetype(BitCoder c, int value) {
    int wide = c.plain(value >= 1 << SHORT_ARCHETYPE_BITS ? 1 : 0, 1);
    return c.plain(value, wide != 0 ? 16 : SHORT_ARCHETYPE_BITS);
  }

  int owner(BitCoder c, int value) {
    return c.plain(value >= 0 ? 1 : 0, 1) != 0 ? c.plain(value, 8) : -1;
  }

  /**
   * Codes how often the entity was put elsewhere.
   *
   * @param teleports 0..15
   */
  int teleports(BitCoder c, int teleports) {
    boolean any = c.plain(teleports != 0 ? 1 : 0, 1) != 0;
    return any ? c.plain(teleports, FrameState.TELEPORT_BITS) : 0;
  }

  void absolute(BitCoder c, Motion motion) {
    motion.x = sized(c, motion.x);
    motion.y = sized(c, motion.y);
    motion.angle = c.plain(motion.angle, ANGLE_BITS);
    boolean moving = c.plain((motion.vx | motion.vy | motion.omega) != 0 ? 1 : 0, 1) != 0;
    motion.vx = moving ? sized(c, motion.vx) : 0;
    motion.vy = moving ? sized(c, motion.vy) : 0;
    motion.omega = moving ? sized(c, motion.omega) : 0;
  }

  private static int sized(BitCoder c, int value) {
    int z = Bits.zigzag(value);
    int width = Math.min(MAX_WIDTH, c.plain(Bits.width(z), WIDTH_BITS));
    return Bits.unzigzag(c.plain(z, width));
  }
}
