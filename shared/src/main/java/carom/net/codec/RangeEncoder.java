package carom.net.codec;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Writes bits of known probability into a caller's array, each at the cost of its surprise: an
 * arithmetic coder. The message so far is an interval of fractions, of which 64 bits are at hand;
 * each slice keeps its part of the interval, and bytes leave when the interval has become so short
 * that they are certain but for a carry, which then runs back through them.
 *
 * <p>What is longer than the room sets a sticky overflow. The caller's array is written at {@link
 * #finish} only. One thread; allocates only for more room than it ever had.
 */
public final class RangeEncoder extends SliceWriter {

  /** The interval is kept longer than 2^{@value}. */
  static final int RANGE_BITS = 56;

  /** Of a number of leading zeros, those that fill whole bytes: they leave. */
  static final int WHOLE_BYTES = RANGE_BITS;

  /** Behind the room: so far a message may go on, as zeros at its end don't count. */
  private static final int SLACK = 2 * Long.BYTES;

  private static final VarHandle LONGS =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);

  private byte[] target = new byte[0];
  private int start;
  private int room;

  /** What left; bytes from {@link #position} on mean nothing. */
  private byte[] bytes = new byte[SLACK];

  private int position;
  private boolean overflow;

  // The interval behind what left: its begin, and its length, both unsigned.
  private long low;
  private long range = -1;

  /** A slice alone. */
  private final SliceList one = new SliceList();

  private int markedPosition;
  private long markedLow;
  private long markedRange;
  private boolean markedOverflow;
  private long markedFirst;
  private long markedWidth;

  /** Whether a carry since the mark ran into what left before it; there is no second one. */
  private boolean carriedOver;

  /** Creates an encoder without room; call {@link #reset}. */
  public RangeEncoder() {}

  /** Starts at {@code offset}, with room for {@code length} bytes. */
  public void reset(byte[] bytes, int offset, int length) {
    if (offset < 0 || length < 0 || length > bytes.length - offset) {
      throw new IndexOutOfBoundsException(
          "offset=" + offset + " length=" + length + " array=" + bytes.length);
    }
    target = bytes;
    start = offset;
    room = length;
    if (this.bytes.length < length + SLACK) {
      this.bytes = new byte[length + SLACK];
    }
    position = 0;
    overflow = false;
    low = 0;
    range = -1;
    begin(0, ALL);
    mark();
  }

  /** Remembers this place for {@link #rewind}. */
  public void mark() {
    markedPosition = position;
    markedLow = low;
    markedRange = range;
    markedOverflow = overflow;
    markedFirst = first();
    markedWidth = width;
    carriedOver = false;
  }

  /** Goes back to the last {@link #mark} and forgets an overflow since. */
  public void rewind() {
    position = markedPosition;
    low = markedLow;
    range = markedRange;
    overflow = markedOverflow;
    begin(markedFirst, markedWidth);
    if (carriedOver) {
      int at = position - 1;
      while (bytes[at]-- == 0) {
        at--;
      }
      carriedOver = false;
    }
  }

  /**
   * Bits written since {@link #reset}, rounded down. A message of n bits takes {@link #finish} at
   * most n / 8 + 1 bytes.
   */
  public int bits() {
    long rest = width == ALL ? range : (range >>> BITS) * width;
    return Byte.SIZE * position + Long.numberOfLeadingZeros(rest);
  }

  /** Writes slices that were worked out before, at a cut. */
  public void slices(SliceList list, int from, int to) {
    long[] numbers = list.numbers();
    byte[] left = bytes;
    int most = room + Long.BYTES;
    long begin = low;
    long length = range;
    int at = position;
    for (int i = 2 * from; i < 2 * to; i += 2) {
      long step = length >>> BITS;
      long before = begin;
      begin += numbers[i] * step;
      if (Long.compareUnsigned(begin, before) < 0 && !overflow) {
        carry(at);
      }
      length = numbers[i + 1] * step;
      int leaving = Long.numberOfLeadingZeros(length) & WHOLE_BYTES;
      LONGS.set(left, at, begin);
      begin <<= leaving;
      length <<= leaving;
      at += leaving / Byte.SIZE;
      if (at > most) {
        at = most;
        overflow = true;
      }
    }
    low = begin;
    range = length;
    position = at;
  }

  @Override
  void slice(long first, long width) {
    one.clear();
    one.slice(first, width);
    slices(one, 0, 1);
  }

  /** Adds one to what left. */
  private void carry(int position) {
    int at = position - 1;
    while (++bytes[at] == 0) {
      at--;
    }
    carriedOver |= at < markedPosition;
  }

  /**
   * Ends the message with the fewest bytes that decide it; the reader takes zeros behind them.
   *
   * @return bytes written since {@link #reset}
   */
  public int finish() {
    cut();
    long forward = toShortest(low, range);
    low += forward;
    if (Long.compareUnsigned(low, forward) < 0 && !overflow) {
      carry(position);
    }
    LONGS.set(bytes, position, low);
    int length = position + Long.BYTES;
    while (length > 0 && bytes[length - 1] == 0) {
      length--;
    }
    if (length > room) {
      overflow = true;
      length = room;
    }
    System.arraycopy(bytes, 0, target, start, length);
    return length;
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

  /** Whether something did not fit; of what {@link #finish} adds, after it. */
  public boolean overflow() {
    return overflow;
  }
}
