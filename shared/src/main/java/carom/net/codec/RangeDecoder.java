package carom.net.codec;

/**
 * Reads what {@link RangeEncoder} wrote. Total: behind the end it reads zeros, and any bytes decode
 * to something; whether they are what an encoder would have written is told by {@link #finished}.
 * One thread, no allocation.
 */
public final class RangeDecoder extends BitCoder {

  private static final int TOP = RangeEncoder.STATE_BITS - 8;

  /** An encoder drops zeros at its end, but never so many of them by chance. */
  private static final int MAX_MISSING = 64;

  private byte[] bytes = new byte[0];
  private int start;
  private int limit;
  private int position;
  private int missing;
  private boolean failed;
  private long low;
  private long high = RangeEncoder.MASK;
  private long value;

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
    high = RangeEncoder.MASK;
    value = 0;
    for (int i = 0; i < RangeEncoder.STATE_BITS / 8; i++) {
      value = value << 8 | next();
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
    long middle = RangeEncoder.split(low, high, probability);
    int result;
    if (value <= middle) {
      high = middle;
      result = 1;
    } else {
      low = middle + 1;
      result = 0;
    }
    while ((low ^ high) >>> TOP == 0) {
      low = low << 8 & RangeEncoder.MASK;
      high = high << 8 & RangeEncoder.MASK | 0xff;
      value = value << 8 & RangeEncoder.MASK | next();
    }
    return result;
  }

  /** Marks what was read as wrong: a decoder found a value that no encoder writes. */
  public void fail() {
    failed = true;
  }

  /** Whether {@link #fail} was called. */
  public boolean failed() {
    return failed;
  }

  /**
   * Whether the bytes are exactly those that an encoder writes for what was read: all of them
   * needed, none missing.
   */
  public boolean finished() {
    if (failed || value != RangeEncoder.shortest(low, high)) {
      return false;
    }
    // No byte may be left over, and the last one isn't a zero, as the encoder drops those.
    return position == limit && (limit == start || bytes[limit - 1] != 0);
  }
}
