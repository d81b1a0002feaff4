package carom.net.codec;

/**
 * Reads what {@link RangeEncoder} wrote. Total: behind the end it reads zeros, and any bytes decode
 * to something; whether they are what an encoder would have written is told by {@link #finished}.
 * One thread, no allocation.
 */
public final class RangeDecoder extends BitCoder {

  /** An encoder drops zeros at its end, but never so many of them by chance. */
  private static final int MAX_MISSING = 64;

  private byte[] bytes = new byte[0];
  private int start;
  private int limit;
  private int position;
  private int missing;
  private boolean failed;

  // The encoder's interval, and how far from its begin the message is: unsigned.
  private long low;
  private long range = -1;
  private long ahead;

  // The slice that was begun: how much of the interval each of its numbers is, those that are left,
  // how many are before them, and how far behind the first of them the message's is.
  private long step;
  private long width = SliceWriter.ALL;
  private long first;
  private long rest;

  /** Creates a reader of nothing; call {@link #reset}. */
  public RangeDecoder() {}

  /** Starts at {@code offset} of an array, with {@code length} bytes. */
  public void reset(byte[] bytes, int offset, int length) {
    if (offset < 0 || length < 0 || length > bytes.length - offset) {
      throw new IndexOutOfBoundsException(
          "offset=" + offset + " length=" + length + " array=" + bytes.length);
    }
    this.bytes = bytes;
    start = offset;
    limit = offset + length;
    position = offset;
    missing = 0;
    failed = false;
    low = 0;
    range = -1;
    width = SliceWriter.ALL;
    ahead = 0;
    for (int i = 0; i < Long.BYTES; i++) {
      ahead = ahead << Byte.SIZE | next();
    }
  }

  private int next() {
    if (position < limit) {
      return bytes[position++] & 0xff;
    }
    missing++;
    return 0;
  }

  /**
   * Whether more was read than the bytes can hold: the zeros behind them are used up, too. A
   * decoder that reads until it is told to stop must look, or it never stops.
   */
  public boolean exhausted() {
    return missing > MAX_MISSING;
  }

  @Override
  public int code(int bit, int probability) {
    if (width == SliceWriter.ALL) {
      begin();
    }
    long ones = SliceWriter.ones(width, probability);
    int result;
    if (rest < ones) {
      width = ones;
      result = 1;
    } else {
      rest -= ones;
      first += ones;
      width -= ones;
      result = 0;
    }
    if (width >>> SliceWriter.LEAST_BITS == 0) {
      cut();
    }
    return result;
  }

  private void begin() {
    step = range >>> SliceWriter.BITS;
    rest = Long.divideUnsigned(ahead, step);
    first = 0;
    if (rest < 0 || rest >= SliceWriter.ALL) {
      failed = true; // of what is left over by the division, an encoder uses nothing
      rest = SliceWriter.ALL - 1;
    }
  }

  /** Ends the slice that was begun, where the encoder did. */
  public void cut() {
    if (width == SliceWriter.ALL) {
      return;
    }
    low += first * step;
    ahead -= first * step;
    range = width * step;
    width = SliceWriter.ALL;
    while (range >>> RangeEncoder.RANGE_BITS == 0) {
      low <<= RangeEncoder.WORD_BITS;
      range <<= RangeEncoder.WORD_BITS;
      int high = next();
      ahead = ahead << RangeEncoder.WORD_BITS | high << Byte.SIZE | next();
    }
  }

  /** Marks what was read as wrong: a decoder found a value that no encoder writes. */
  public void fail() {
    failed = true;
  }

  /** Whether something was read that no encoder writes. */
  public boolean failed() {
    return failed;
  }

  /**
   * Whether the bytes are exactly those that an encoder writes for what was read: all of them
   * needed, none missing. What was read ends here.
   */
  public boolean finished() {
    cut();
    if (failed || ahead != RangeEncoder.toShortest(low, range)) {
      return false;
    }
    // No byte may be left over, and the last one isn't a zero, as the encoder drops those.
    return position == limit && (limit == start || bytes[limit - 1] != 0);
  }
}
