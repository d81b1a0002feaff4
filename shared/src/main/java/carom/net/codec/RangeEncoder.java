package carom.net.codec;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Arithmetic coder that writes bits of known probability into a caller's array, each at the cost of
 * its information content. The message so far is an interval of fractions, of which the coder keeps
 * 64 bits. Each slice narrows the interval to a part. Bytes leave when the interval is so short
 * that only a carry can still change them; a carry then runs back through them.
 *
 * <p>A message longer than the room sets a sticky overflow flag. The coder writes to the caller's
 * array in {@link #finish} only. Use it from one thread; it allocates only when the room is larger
 * than ever before.
 */
public final class RangeEncoder extends SliceWriter {

  /** Shortest length of the interval between two slices, as a power of two. */
  static final int RANGE_BITS = 56;

  /** Mask that rounds a number of leading zeros down to whole bytes, which can leave. */
  static final int WHOLE_BYTES = RANGE_BITS;

  /**
   * Bytes by which an unfinished message may exceed the room, because zeros at its end are dropped.
   */
  private static final int SLACK = 2 * Long.BYTES;

  private static final VarHandle LONGS =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);

  private byte[] target = new byte[0];
  private int start;
  private int room;

  /** Bytes that have left the interval; those from {@link #position} on are undefined. */
  private byte[] bytes = new byte[SLACK];

  private int position;
  private boolean overflow;

  // The interval after the bytes that left: its start and its length, both unsigned.
  private long low;
  private long range = -1;

  /** Scratch list that holds a single slice. */
  private final SliceList one = new SliceList();

  private int markedPosition;
  private long markedLow;
  private long markedRange;
  private boolean markedOverflow;
  private long markedFirst;
  private long markedWidth;

  /** True if a carry changed a byte from before the mark; that can happen once at most. */
  private boolean carriedOver;

  /** Creates an encoder without room; call {@link #reset}. */
  public RangeEncoder() {}

  /** Starts writing at {@code offset} of an array, with room for {@code length} bytes. */
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

  /** Marks the current state for {@link #rewind}. */
  public void mark() {
    markedPosition = position;
    markedLow = low;
    markedRange = range;
    markedOverflow = overflow;
    markedFirst = first();
    markedWidth = width;
    carriedOver = false;
  }

  /** Restores the state at the last {@link #mark}, including the overflow flag. */
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
   * Returns the number of bits written after {@link #reset}, rounded down. For n bits, {@link
   * #finish} writes at most n / 8 + 1 bytes.
   */
  public int bits() {
    long rest = width == ALL ? range : (range >>> BITS) * width;
    return Byte.SIZE * position + Long.numberOfLeadingZeros(rest);
  }

  /**
   * Writes precomputed slices from index {@code from} to before {@code to} of a list. Call it only
   * right after a cut.
   */
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

  /** Adds one to the bytes that left. */
  private void carry(int position) {
    int at = position - 1;
    while (++bytes[at] == 0) {
      at--;
    }
    carriedOver |= at < markedPosition;
  }

  /**
   * Ends the message with the fewest bytes that identify the interval; the reader assumes zeros
   * after them.
   *
   * @return bytes written after {@link #reset}
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

  /**
   * Returns the distance from {@code low} to the number in the interval that ends in the most zero
   * bytes.
   */
  static long toShortest(long low, long range) {
    for (int bits = Long.SIZE; bits > 0; bits -= Byte.SIZE) {
      long far = bits == Long.SIZE ? -low : -low & (1L << bits) - 1;
      if (Long.compareUnsigned(far, range) < 0) {
        return far;
      }
    }
    return 0;
  }

  /**
   * Returns whether the message did not fit. Only after {@link #finish} does this include the bytes
   * that {@code finish} adds.
   */
  public boolean overflow() {
    return overflow;
  }
}
