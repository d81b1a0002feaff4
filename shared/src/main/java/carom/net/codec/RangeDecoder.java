package carom.net.codec;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Reader of a message that {@link RangeEncoder} wrote. Any bytes decode to something, and a read
 * past the end gets zeros; {@link #finished} tells whether an encoder could have written them. Use
 * it from one thread; it doesn't allocate.
 */
public final class RangeDecoder extends BitCoder {

  /**
   * Limit of zero bytes read past the end. An encoder drops the zeros at the end of a message, but
   * a valid message never lacks that many.
   */
  private static final int MAX_MISSING = 64;

  private static final VarHandle LONGS =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);

  private byte[] bytes = new byte[0];
  private int start;
  private int limit;
  private int position;
  private int missing;
  private boolean failed;

  // The length of the encoder's interval, and the distance of the message from the start of that
  // interval; both are unsigned.
  private long range = -1;
  private long ahead;

  // The current slice: the part of the interval that each of its numbers covers, the count of
  // numbers left, the message's number relative to the first of them, and the message's offset
  // within that number.
  private long step;
  private long width = SliceWriter.ALL;
  private long rest;
  private long within;

  /** The last 64 bits read from the message. */
  private long read;

  /** Creates an empty decoder; call {@link #reset} before reading. */
  public RangeDecoder() {}

  /** Starts reading {@code length} bytes of an array at {@code offset}. */
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
    range = -1;
    width = SliceWriter.ALL;
    read = next();
    ahead = read;
    skip(Long.BYTES);
  }

  /** Returns the next 64 bits, with zeros past the end. */
  private long next() {
    if (limit - position >= Long.BYTES) {
      return (long) LONGS.get(bytes, position);
    }
    long next = 0;
    for (int i = 0; i < Long.BYTES; i++) {
      next = next << Byte.SIZE | (position + i < limit ? bytes[position + i] & 0xff : 0);
    }
    return next;
  }

  private void skip(int count) {
    int there = Math.min(count, limit - position);
    position += there;
    missing += count - there;
  }

  /**
   * Returns whether reads went further past the end than any valid message allows. A decoder that
   * loops until the message tells it to stop must check this, or it may never stop.
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
      width -= ones;
      result = 0;
    }
    if (width >>> SliceWriter.LEAST_BITS == 0) {
      cut();
    }
    return result;
  }

  @Override
  public int symbol(SymbolTable table, int row, int symbol, int most) {
    if (width == SliceWriter.ALL) {
      begin();
    }
    long part = width >>> SymbolTable.BITS;
    int result = Math.min(table.find(row, share(part, SymbolTable.ALL)), most);
    int from = table.from(row, result);
    int to = result < most ? table.from(row, result + 1) : SymbolTable.ALL;
    rest -= from * part;
    width = (to - from) * part;
    if (width >>> SliceWriter.LEAST_BITS == 0) {
      cut();
    }
    return result;
  }

  @Override
  public int even(int value, int count) {
    if (count == 0) {
      return 0;
    }
    if (width == SliceWriter.ALL) {
      begin();
    }
    width >>>= count;
    int result = share(width, 1 << count);
    rest -= result * width;
    if (width >>> SliceWriter.LEAST_BITS == 0) {
      cut();
    }
    return result;
  }

  /** Returns the index of the part of the slice that contains the message, for equal parts. */
  private int share(long part, int parts) {
    long share = rest / part;
    if (share >= parts) {
      failed = true; // an encoder never uses the remainder of the division
      return parts - 1;
    }
    return (int) share;
  }

  private void begin() {
    step = range >>> SliceWriter.BITS;
    rest = Long.divideUnsigned(ahead, step);
    if (rest < 0 || rest >= SliceWriter.ALL) {
      failed = true; // an encoder never uses the remainder of this division either
      rest = SliceWriter.ALL - 1;
    }
    within = ahead - rest * step;
  }

  /** Ends the current slice, at the same place as the encoder did. */
  public void cut() {
    if (width == SliceWriter.ALL) {
      return;
    }
    ahead = rest * step + within;
    range = width * step;
    width = SliceWriter.ALL;
    int gone = Long.numberOfLeadingZeros(range) & RangeEncoder.WHOLE_BYTES;
    if (gone != 0) {
      long next = next() >>> -gone;
      range <<= gone;
      ahead = ahead << gone | next;
      read = read << gone | next;
      skip(gone / Byte.SIZE);
    }
  }

  /**
   * Sets the sticky failure flag. A decoder calls this when it reads a value that no encoder
   * writes.
   */
  public void fail() {
    failed = true;
  }

  /** Returns whether the message contained a value that no encoder writes. */
  public boolean failed() {
    return failed;
  }

  /**
   * Returns whether the bytes are exactly those that an encoder writes for the values read: none is
   * superfluous and none is missing. This call ends the message.
   */
  public boolean finished() {
    cut();
    if (failed || ahead != RangeEncoder.toShortest(read - ahead, range)) {
      return false;
    }
    // No byte may remain, and the last byte can't be zero, because an encoder drops zeros.
    return position == limit && (limit == start || bytes[limit - 1] != 0);
  }
}
