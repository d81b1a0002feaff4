package carom.net.codec;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Reads what {@link RangeEncoder} wrote. Total: behind the end it reads zeros, and any bytes decode
 * to something; whether they are what an encoder would have written is told by {@link #finished}.
 * One thread, no allocation.
 */
public final class RangeDecoder extends BitCoder {

  /** An encoder drops zeros at its end, but never so many of them by chance. */
  private static final int MAX_MISSING = 64;

  private static final VarHandle LONGS =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);

  private byte[] bytes = new byte[0];
  private int start;
  private int limit;
  private int position;
  private int missing;
  private boolean failed;

  // How long the encoder's interval is, and how far from its begin the message is: unsigned.
  private long range = -1;
  private long ahead;

  // The slice that was begun: how much of the interval each of its numbers is, how many are left,
  // how far behind the first of them the message's is, and where in that the message is.
  private long step;
  private long width = SliceWriter.ALL;
  private long rest;
  private long within;

  /** The last 64 bits of the message that were read. */
  private long read;

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
    range = -1;
    width = SliceWriter.ALL;
    read = next();
    ahead = read;
    skip(Long.BYTES);
  }

  /** The next 64 bits, zeros behind the end. */
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

  /** Which of some parts of the slice the message is in. */
  private int share(long part, int parts) {
    long share = rest / part;
    if (share >= parts) {
      failed = true; // of what is left over by the division, an encoder uses nothing
      return parts - 1;
    }
    return (int) share;
  }

  private void begin() {
    step = range >>> SliceWriter.BITS;
    rest = Long.divideUnsigned(ahead, step);
    if (rest < 0 || rest >= SliceWriter.ALL) {
      failed = true; // as there
      rest = SliceWriter.ALL - 1;
    }
    within = ahead - rest * step;
  }

  /** Ends the slice that was begun, where the encoder did. */
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
    if (failed || ahead != RangeEncoder.toShortest(read - ahead, range)) {
      return false;
    }
    // No byte may be left over, and the last one isn't a zero, as the encoder drops those.
    return position == limit && (limit == start || bytes[limit - 1] != 0);
  }
}
