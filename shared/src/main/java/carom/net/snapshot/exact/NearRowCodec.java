package carom.net.snapshot.exact;

import static carom.physics.rows.BodyRow.ARCHETYPE;
import static carom.physics.rows.BodyRow.ASLEEP;
import static carom.physics.rows.BodyRow.COS;
import static carom.physics.rows.BodyRow.LOADS;
import static carom.physics.rows.BodyRow.LOAD_INTS;
import static carom.physics.rows.BodyRow.OMEGA;
import static carom.physics.rows.BodyRow.SLEEP_TIME;
import static carom.physics.rows.BodyRow.VX;
import static carom.physics.rows.BodyRow.VY;
import static carom.physics.rows.BodyRow.X;
import static carom.physics.rows.BodyRow.Y;
import static carom.physics.rows.ContactRow.END_A;
import static carom.physics.rows.ContactRow.END_B;
import static carom.physics.rows.ContactRow.ID_0;
import static carom.physics.rows.ContactRow.ID_1;
import static carom.physics.rows.ContactRow.NORMAL_IMPULSE_0;
import static carom.physics.rows.ContactRow.NORMAL_IMPULSE_1;
import static carom.physics.rows.ContactRow.NORMAL_X;
import static carom.physics.rows.ContactRow.PARTS;
import static carom.physics.rows.ContactRow.POINTS_AND_FLAGS;
import static carom.physics.rows.ContactRow.POINTS_MASK;
import static carom.physics.rows.ContactRow.ROLLING_IMPULSE;
import static carom.physics.rows.ContactRow.TANGENT_IMPULSE_0;
import static carom.physics.rows.ContactRow.TANGENT_IMPULSE_1;
import static carom.physics.rows.ContactRow.TOTAL_IMPULSE_0;
import static carom.physics.rows.ContactRow.TOTAL_IMPULSE_1;
import static carom.physics.rows.FieldRow.CHUNK;
import static carom.physics.rows.FieldRow.PLACE;
import static carom.physics.rows.FieldRow.WORDS;
import static carom.physics.rows.FieldRow.WORD_INTS;
import static carom.physics.rows.JointRow.IMPULSE_INTS;
import static carom.physics.rows.JointRow.TURN_INTS;

import carom.net.codec.BitCoder;
import carom.net.codec.Bits;
import carom.net.snapshot.exact.NearTables.Quantity;
import carom.physics.rows.JointRow;
import carom.physics.rows.RowKind;
import carom.physics.rows.Rows;

/**
 * Codes the rows of a near update; one description serves writing and reading. Most of a row's
 * exact bits can't be predicted, but many can: bodies are near the own one, an angle's cosine gives
 * its sine except for the last digits, contacts are sorted, and one impulse of a contact predicts
 * another. Each number is a symbol of {@link NearTables} followed by plain bits.
 *
 * <p>Any input bits decode to rows whose places, parts and points are in the ranges below; whether
 * the rows make sense is not checked. One object codes one part at a time.
 */
public class NearRowCodec {
  private static final int PARTS_BITS = 20;
  private static final int POINTS_BITS = 16;
  private static final int PLACE_BITS = 8;
  private static final int WIDTH_BITS = 5;
  private static final int CHUNK_BITS = 6;

  /**
   * Number by which an impulse is multiplied to predict the total impulse of a tick, which sums the
   * substeps.
   */
  private static final float SUBSTEPS = 4;

  // Symbols of a float: zeros, anything, each sign and exponent of the usual range.
  private static final int ZERO = 0;
  private static final int MINUS_ZERO = 1;
  private static final int ANYTHING = 2;
  private static final int USUAL = 3;
  private static final int LEAST_EXPONENT = 104;
  private static final int EXPONENTS = 32;
  private static final int MANTISSA_BITS = 23;

  // Symbols of a float coded against a guess: zeros, anything, equal, each sign and bit length of
  // the difference.
  private static final int EQUAL = 3;
  private static final int OFF = 4;
  private static final int MAX_OFF = 31;

  // Symbols of an end of a contact.
  private static final int FAR_PLACE = 30;
  private static final int STATIC_AGAIN = 31;
  private static final int STATIC = 32;

  /** Symbol of a feature id that isn't two vertices below 8; the id follows in plain bits. */
  private static final int ANY_ID = 64;

  /** Bits of a joint's key. */
  private static final int KEY_BITS = 24;

  /** Bits of the slot of a static body. */
  private static final int STATIC_BITS = 24;

  /** Substeps per second at the usual tick rate: a joint's force is its impulse times that. */
  private static final float SUBSTEP_RATE = 1 / (1 / 60f / 4);

  private static final int SETTINGS_HALF = JointRow.SETTING_INTS / 2;

  /** Impulses of a joint's point: x, y and angular; springs, motors and limits follow. */
  private static final int POINT_IMPULSES = 3;

  // Symbols of an end of a joint: how far it is from the likely one, or what else it is.
  private static final int END_MIDDLE = 16;
  private static final int FAR_END = 32;
  private static final int STATIC_END = 33;
  private static final int GROUND_END = 34;

  private OwnState own;
  private int endA;
  private int endB;
  private int lastStatic;
  private int lastJoint;
  private int lastJointA;
  private int lastPlace;
  private int lastArchetype;

  /** Creates a codec; call {@link #begin} before use. */
  public NearRowCodec() {}

  /**
   * Starts a part.
   *
   * @param own the section that the part belongs to; read from until the part ends
   */
  final void begin(OwnState own) {
    this.own = own;
    endA = 0;
    endB = 0;
    lastStatic = 0;
    lastJoint = 0;
    lastJointA = 0;
    lastPlace = 0;
    lastArchetype = 0;
  }

  /** Codes a symbol. */
  int symbol(BitCoder c, Quantity row, int context, int symbol) {
    int line = NearTables.line(row, context);
    return c.symbol(NearTables.TABLE, line, symbol, NearTables.SYMBOLS - 1);
  }

  /** Codes all rows of a part. */
  public final void part(BitCoder c, OwnState own) {
    NearState near = own.near;
    begin(own);
    Rows rows = near.rows;
    for (int row = 0; row < rows.count(); row++) {
      row(c, near.kind(row), rows.ints(), rows.at(row));
    }
  }

  /** Codes the next row of a part, except for the key of an entity. */
  final void row(BitCoder c, RowKind kind, int[] rows, int at) {
    switch (kind) {
      case BODY -> body(c, rows, at);
      case JOINT -> joint(c, rows, at);
      case CONTACT -> contact(c, rows, at);
      case FIELDS -> fields(c, rows, at);
    }
  }

  private void body(BitCoder c, int[] r, int at) {
    int rest = r[at + SLEEP_TIME];
    int kind = symbol(c, Quantity.REST_KIND, 0, rest == 0 ? 0 : rest == ASLEEP ? 1 : 2);
    r[at + SLEEP_TIME] = kind == 0 ? 0 : kind == 1 ? ASLEEP : real(c, Quantity.REST, 0, rest);
    r[at + X] = like(c, Quantity.PLACE, 0, r[at + X], own.motion(X));
    r[at + Y] = like(c, Quantity.PLACE, 1, r[at + Y], own.motion(Y));
    unit(c, 0, r, at + COS);
    int asleep = kind == 1 ? 1 : 0;
    r[at + VX] = real(c, Quantity.VELOCITY, asleep, r[at + VX]);
    int still = (r[at + VX] & Integer.MAX_VALUE) == 0 ? 2 : 0;
    r[at + VY] = real(c, Quantity.VELOCITY, 2 + asleep + still, r[at + VY]);
    still = (r[at + VY] & Integer.MAX_VALUE) == 0 ? still >> 1 : 0;
    r[at + OMEGA] = real(c, Quantity.OMEGA, asleep + 2 * still, r[at + OMEGA]);
    int which = symbol(c, Quantity.PUSHED, 0, notZero(r, at + LOADS, LOAD_INTS));
    for (int i = 0; i < LOAD_INTS; i++) {
      int to = at + LOADS + i;
      r[to] = (which >>> i & 1) == 0 ? 0 : real(c, Quantity.PUSH, 0, r[to]);
    }
    boolean same = c.plain(r[at + ARCHETYPE] == lastArchetype ? 1 : 0, 1) != 0;
    lastArchetype = same ? lastArchetype : c.plain(r[at + ARCHETYPE], OwnCodec.ARCHETYPE_BITS);
    r[at + ARCHETYPE] = lastArchetype;
  }

  private void fields(BitCoder c, int[] r, int at) {
    boolean same = c.plain(r[at + PLACE] == lastPlace ? 1 : 0, 1) != 0;
    lastPlace = same ? lastPlace : c.plain(r[at + PLACE], PLACE_BITS);
    r[at + PLACE] = lastPlace;
    r[at + CHUNK] = c.plain(r[at + CHUNK], CHUNK_BITS);
    int which = c.plain(notZero(r, at + WORDS, WORD_INTS), WORD_INTS);
    for (int i = 0; i < WORD_INTS; i++) {
      int to = at + WORDS + i;
      r[to] = (which >>> i & 1) == 0 ? 0 : difference(c, r[to]);
    }
  }

  /** Codes a number that is not 0 as its width, and then its zigzag form. */
  private static int difference(BitCoder c, int value) {
    int z = Bits.zigzag(value);
    int width = 1 + c.plain(Bits.width(z) - 1, WIDTH_BITS);
    return Bits.unzigzag(c.plain(z, width));
  }

  private static int notZero(int[] r, int at, int count) {
    int which = 0;
    for (int i = 0; i < count; i++) {
      which |= r[at + i] != 0 ? 1 << i : 0;
    }
    return which;
  }

  private void joint(BitCoder c, int[] r, int at) {
    int step = r[at + JointRow.KEY] - lastJoint;
    int symbol = symbol(c, Quantity.JOINT_KEY, 0, step > 0 && step < NearTables.SYMBOLS ? step : 0);
    lastJoint = symbol > 0 ? lastJoint + symbol : c.plain(r[at + JointRow.KEY], KEY_BITS);
    r[at + JointRow.KEY] = lastJoint;
    lastJointA = jointEnd(c, 0, r[at + JointRow.END_A], lastJointA);
    r[at + JointRow.END_A] = lastJointA;
    r[at + JointRow.END_B] = jointEnd(c, 1, r[at + JointRow.END_B], Math.max(0, lastJointA));
    some(c, Quantity.JOINT_SET, 0, r, at + JointRow.SETTINGS, SETTINGS_HALF);
    some(c, Quantity.JOINT_SET, 1, r, at + JointRow.SETTINGS + SETTINGS_HALF, SETTINGS_HALF);
    some(c, Quantity.JOINT_TURNED, 0, r, at + JointRow.TURNS, TURN_INTS);
    impulses(c, 0, r, at + JointRow.IMPULSES, POINT_IMPULSES);
    impulses(c, 1, r, at + JointRow.IMPULSES + POINT_IMPULSES, IMPULSE_INTS - POINT_IMPULSES);
    for (int i = 0; i < JointRow.LOAD_INTS; i++) {
      int impulse = r[at + JointRow.IMPULSES + i];
      int guess = Float.floatToIntBits(SUBSTEP_RATE * Float.intBitsToFloat(impulse));
      int to = at + JointRow.LOADS + i;
      r[to] = like(c, Quantity.JOINT_LOAD, i, r[to], guess);
    }
  }

  /** Codes ints of which most are zero, and of the others nothing is known. */
  private void some(BitCoder c, Quantity row, int context, int[] r, int at, int count) {
    int which = symbol(c, row, context, notZero(r, at, count));
    for (int i = 0; i < count; i++) {
      r[at + i] = (which >>> i & 1) == 0 ? 0 : c.plain(r[at + i], Integer.SIZE);
    }
  }

  private void impulses(BitCoder c, int context, int[] r, int at, int count) {
    int which = symbol(c, Quantity.JOINT_PUSHED, context, notZero(r, at, count));
    for (int i = 0; i < count; i++) {
      r[at + i] = (which >>> i & 1) == 0 ? 0 : real(c, Quantity.JOINT_IMPULSE, context, r[at + i]);
    }
  }

  /** Codes an end of a joint against another one that is probably near it in the list. */
  private int jointEnd(BitCoder c, int context, int end, int likely) {
    int symbol = end - likely + END_MIDDLE;
    if (end < 0) {
      symbol = end == JointRow.GROUND ? GROUND_END : STATIC_END;
    } else if (likely < 0 || symbol < 0 || symbol >= FAR_END) {
      symbol = FAR_END;
    }
    symbol = symbol(c, Quantity.JOINT_END, context, symbol);
    if (symbol == GROUND_END) {
      return JointRow.GROUND;
    }
    if (symbol >= STATIC_END) {
      return ~c.plain(~end, STATIC_BITS);
    }
    int near = likely + symbol - END_MIDDLE;
    return symbol == FAR_END || likely < 0 || near < 0 ? c.plain(end, PLACE_BITS) : near;
  }

  private void contact(BitCoder c, int[] r, int at) {
    ends(c, r, at);
    int more = r[at + POINTS_AND_FLAGS] - 1;
    int kind = symbol(c, Quantity.KIND, 0, r[at + PARTS] == 0 && more >>> 1 == 0 ? more : 2);
    r[at + PARTS] = kind < 2 ? 0 : c.plain(r[at + PARTS], PARTS_BITS);
    r[at + POINTS_AND_FLAGS] = kind < 2 ? kind + 1 : c.plain(r[at + POINTS_AND_FLAGS], POINTS_BITS);
    int two = (r[at + POINTS_AND_FLAGS] & POINTS_MASK) > 1 ? 1 : 0;
    r[at + ID_0] = id(c, two, r[at + ID_0]);
    r[at + ID_1] = id(c, 2 + two, r[at + ID_1]);
    unit(c, 1, r, at + NORMAL_X);
    r[at + NORMAL_IMPULSE_0] = real(c, Quantity.NORMAL, two, r[at + NORMAL_IMPULSE_0]);
    int first = r[at + NORMAL_IMPULSE_0] == 0 ? 0 : 1;
    r[at + TANGENT_IMPULSE_0] = real(c, Quantity.TANGENT, first, r[at + TANGENT_IMPULSE_0]);
    r[at + NORMAL_IMPULSE_1] =
        like(
            c,
            Quantity.SECOND,
            2 * first + two,
            r[at + NORMAL_IMPULSE_1],
            r[at + NORMAL_IMPULSE_0]);
    int second = r[at + NORMAL_IMPULSE_1] == 0 ? 0 : 1;
    r[at + TANGENT_IMPULSE_1] =
        real(c, Quantity.TANGENT, 2 + 2 * second + two, r[at + TANGENT_IMPULSE_1]);
    r[at + ROLLING_IMPULSE] = real(c, Quantity.ROLLING, 0, r[at + ROLLING_IMPULSE]);
    r[at + TOTAL_IMPULSE_0] =
        like(c, Quantity.LAST, first, r[at + TOTAL_IMPULSE_0], all(r[at + NORMAL_IMPULSE_0]));
    r[at + TOTAL_IMPULSE_1] =
        like(
            c,
            Quantity.LAST,
            2 + 2 * second + two,
            r[at + TOTAL_IMPULSE_1],
            all(r[at + NORMAL_IMPULSE_1]));
  }

  /**
   * Returns the bits of the total impulse if every substep applies the same impulse. All NaNs give
   * one bit pattern.
   */
  private static int all(int bits) {
    return Float.floatToIntBits(SUBSTEPS * Float.intBitsToFloat(bits));
  }

  /** Codes both ends of a contact. Contacts are sorted by their first end, then by their second. */
  private void ends(BitCoder c, int[] r, int at) {
    int before = endA;
    endA = end(c, 0, r[at + END_A], before);
    boolean same = endA == before;
    endB = end(c, same ? 2 : 1, r[at + END_B], same ? endB : Math.max(0, endA));
    r[at + END_A] = endA;
    r[at + END_B] = endB;
  }

  private int end(BitCoder c, int context, int end, int before) {
    int symbol = end - before;
    if (end < 0) {
      symbol = end == lastStatic ? STATIC_AGAIN : STATIC;
    } else if (before < 0 || symbol < 0 || symbol >= FAR_PLACE) {
      symbol = FAR_PLACE;
    }
    symbol = symbol(c, Quantity.END, context, symbol);
    if (symbol == STATIC_AGAIN) {
      return lastStatic;
    }
    if (symbol > STATIC_AGAIN) {
      int width = c.plain(Bits.width(~end), WIDTH_BITS);
      lastStatic = ~c.plain(~end, width);
      return lastStatic;
    }
    if (symbol == FAR_PLACE) {
      return c.plain(end, PLACE_BITS);
    }
    return Math.max(0, before) + symbol & (1 << PLACE_BITS) - 1;
  }

  private int id(BitCoder c, int context, int id) {
    boolean small = (id & ~0x707) == 0;
    int symbol = symbol(c, Quantity.ID, context, small ? id >>> 5 | id & 7 : ANY_ID);
    return symbol < ANY_ID ? symbol >>> 3 << 8 | symbol & 7 : c.plain(id, Integer.SIZE);
  }

  /**
   * Codes two numbers whose squares add up to about 1. The larger one is coded against a guess from
   * the smaller one.
   */
  private void unit(BitCoder c, int context, int[] r, int at) {
    int a = r[at] & Integer.MAX_VALUE;
    int b = r[at + 1] & Integer.MAX_VALUE;
    int symbol = b > a ? 2 | r[at + 1] >>> 31 : r[at] >>> 31;
    symbol = symbol(c, Quantity.LARGER, context, symbol);
    int larger = at + (symbol >>> 1 & 1);
    int smaller = at + 1 - (symbol >>> 1 & 1);
    r[smaller] = real(c, Quantity.SMALLER, context, r[smaller]);
    double s = Float.intBitsToFloat(r[smaller]);
    int guess = Float.floatToIntBits((float) Math.sqrt(1 - s * s));
    int value = like(c, Quantity.OTHER, context, r[larger] & Integer.MAX_VALUE, guess);
    r[larger] = value & Integer.MAX_VALUE | symbol << 31;
  }

  /** Codes a float of which only the usual magnitude is known. */
  private int real(BitCoder c, Quantity row, int context, int bits) {
    int symbol = ANYTHING;
    int exponent = (bits >>> MANTISSA_BITS & 0xff) - LEAST_EXPONENT;
    if ((bits & Integer.MAX_VALUE) == 0) {
      symbol = bits == 0 ? ZERO : MINUS_ZERO;
    } else if (exponent >= 0 && exponent < EXPONENTS) {
      symbol = USUAL + 2 * exponent + (bits >>> 31);
    }
    symbol = symbol(c, row, context, symbol);
    if (symbol < ANYTHING) {
      return symbol << 31;
    }
    if (symbol == ANYTHING) {
      return c.plain(bits, Integer.SIZE);
    }
    exponent = (symbol - USUAL >> 1) + LEAST_EXPONENT;
    return (symbol - USUAL & 1) << 31 | exponent << MANTISSA_BITS | c.plain(bits, MANTISSA_BITS);
  }

  /** Codes a float that is mostly near a guess. */
  private int like(BitCoder c, Quantity row, int context, int bits, int guess) {
    int from = Bits.orderedBits(guess);
    int off = Bits.orderedBits(bits) - from;
    int digits = Bits.width(Math.abs(off));
    int symbol = ANYTHING;
    if ((bits & Integer.MAX_VALUE) == 0) {
      symbol = bits == 0 ? ZERO : MINUS_ZERO;
    } else if (digits <= MAX_OFF) {
      symbol = digits == 0 ? EQUAL : OFF + 2 * (digits - 1) + (off >>> 31);
    }
    symbol = symbol(c, row, context, symbol);
    if (symbol < ANYTHING) {
      return symbol << 31;
    }
    if (symbol == ANYTHING) {
      return c.plain(bits, Integer.SIZE);
    }
    if (symbol == EQUAL) {
      return guess;
    }
    int low = symbol - OFF >> 1;
    int magnitude = 1 << low | c.plain(Math.abs(off), low);
    return Bits.rawBits(from + ((symbol - OFF & 1) == 0 ? magnitude : -magnitude));
  }
}
