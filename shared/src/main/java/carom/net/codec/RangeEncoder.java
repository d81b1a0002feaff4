package carom.net.codec;

/**
 * Writes bits of known probability into a caller's array, each at the cost of its surprise: an
 * arithmetic coder. The message so far is an interval of fractions, of which 64 bits are at hand;
 * each slice keeps its part of the interval, and words of 16 bits leave when the interval has
 * become so short that they are certain but for a carry.
 *
 * <p>What is longer than the room sets a sticky overflow. One thread, no allocation.
 */
public final class RangeEncoder extends SliceWriter {

  /** The interval is kept longer than 2^{@value}. */
  static final int RANGE_BITS = 48;

  static final int WORD_BITS = 16;
  static final int WORD = (1 << WORD_BITS) - 1;
  private static final int NONE = -1;

  private byte[] bytes = new byte[0];
  private int start;
  private int limit;
  private int position;
  private boolean overflow;

  // The interval behind what left: its begin, and its length, both unsigned.
  private long low;
  private long range = -1;

  /** The last word that isn't all ones, and how many such follow it: a carry may change them. */
  private int held = NONE;

  private int fullWords;

  private int markedPosition;
  private long markedLow;
  private long markedRange;
  private int markedHeld;
  private int markedFullWords;
  private long markedFirst;
  private long markedWidth;

  /** Creates an encoder without room; call {@link #reset}. */
  public RangeEncoder() {}

  /** Starts at {@code offset}, with room for {@code length} bytes. */
  public void reset(byte[] bytes, int offset, int length) {
    if (offset < 0 || length < 0 || length > bytes.length - offset) {
      throw new IndexOutOfBoundsException(
          "offset=" + offset + " length=" + length + " array=" + bytes.length);
    }
    this.bytes = bytes;
    start = offset;
    limit = offset + length;
    position = offset;
    overflow = false;
    low = 0;
    range = -1;
    held = NONE;
    fullWords = 0;
    begin(0, ALL);
    mark();
  }

  /** Remembers this place for {@link #rewind}. */
  public void mark() {
    markedPosition = position;
    markedLow = low;
    markedRange = range;
    markedHeld = held;
    markedFullWords = fullWords;
    markedFirst = first();
    markedWidth = width;
  }

  /** Goes back to the last {@link #mark} and forgets an overflow since. */
  public void rewind() {
    position = markedPosition;
    low = markedLow;
    range = markedRange;
    held = markedHeld;
    fullWords = markedFullWords;
    overflow = false;
    begin(markedFirst, markedWidth);
  }

  /**
   * Bits written since {@link #reset}, rounded down. A message of n bits takes {@link #finish} at
   * most n / 8 + 1 bytes.
   */
  public int bits() {
    long rest = width == ALL ? range : (range >>> BITS) * width;
    int words = fullWords + (held == NONE ? 0 : 1);
    return 8 * (position - start) + WORD_BITS * words + Long.numberOfLeadingZeros(rest);
  }

  /** Writes slices that were worked out before, at a cut. */
  public void slices(SliceList list, int from, int to) {
    for (int i = from; i < to; i++) {
      slice(list.first(i), list.width(i));
    }
  }

  @Override
  void slice(long first, long width) {
    long step = range >>> BITS;
    add(first * step);
    range = width * step;
    while (range >>> RANGE_BITS == 0) {
      shift();
      range <<= WORD_BITS;
    }
  }

  private void add(long forward) {
    low += forward;
    if (Long.compareUnsigned(low, forward) < 0) {
      carry();
    }
  }

  private void carry() {
    held++;
    if (fullWords > 0) {
      put(held);
      for (; fullWords > 1; fullWords--) {
        put(0);
      }
      held = 0;
      fullWords = 0;
    }
  }

  /** The highest word leaves. */
  private void shift() {
    int word = (int) (low >>> RANGE_BITS);
    if (word == WORD && held != NONE) {
      fullWords++;
    } else {
      flush();
      held = word;
    }
    low <<= WORD_BITS;
  }

  private void flush() {
    if (held != NONE) {
      put(held);
    }
    for (; fullWords > 0; fullWords--) {
      put(WORD);
    }
    held = NONE;
  }

  /**
   * Ends the message with the fewest bytes that decide it; the reader takes zeros behind them.
   *
   * @return bytes written since {@link #reset}
   */
  public int finish() {
    cut();
    add(toShortest(low, range));
    while (low != 0) {
      shift();
    }
    flush();
    while (!overflow && position > start && bytes[position - 1] == 0) {
      position--;
    }
    return position - start;
  }

  /** How far it is to the number of an interval that has the most zeros at its end, in bytes. */
  static long toShortest(long low, long range) {
    for (int bits = Long.SIZE; bits > 0; bits -= Byte.SIZE) {
      long far = bits == Long.SIZE ? -low : -low & (1L << bits) - 1;
      if (Long.compareUnsigned(far, range) < 0) {
        return far;
      }
    }
    return 0;
  }

  private void put(int word) {
    if (position + 1 < limit) {
      bytes[position] = (byte) (word >>> Byte.SIZE);
      bytes[position + 1] = (byte) word;
      position += 2;
      return;
    }
    putByte(word >>> Byte.SIZE);
    putByte(word);
  }

  private void putByte(int octet) {
    if (position == limit) {
      overflow |= (octet & 0xff) != 0; // zeros at the end are dropped anyway
      return;
    }
    bytes[position++] = (byte) octet;
  }

  /** Whether something did not fit since {@link #reset}. */
  public boolean overflow() {
    return overflow;
  }
}
