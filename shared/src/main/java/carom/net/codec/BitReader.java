package carom.net.codec;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Reads what {@link BitWriter} wrote. Reading past the end answers zeros and sets a sticky {@link
 * #failed} instead of throwing, so that a decoder reads straight on and looks once. One thread, no
 * allocation.
 */
public final class BitReader implements BitPass {

  private static final VarHandle LONGS =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

  private byte[] bytes = new byte[0];
  private int limitBit;
  private int position;
  private boolean failed;

  /** Creates a reader of nothing; call {@link #reset}. */
  public BitReader() {}

  /** Starts at {@code offset} of an array, with {@code length} bytes. */
  public void reset(byte[] bytes, int offset, int length) {
    if (offset < 0 || length < 0 || length > bytes.length - offset) {
      throw new IndexOutOfBoundsException(
          "offset=" + offset + " length=" + length + " array=" + bytes.length);
    }
    this.bytes = bytes;
    position = offset << 3;
    limitBit = (offset + length) << 3;
    failed = false;
  }

  /**
   * Reads an unsigned number; with 32 bits the sign bit is as written.
   *
   * @param count 0..32
   */
  public int read(int count) {
    if (failed || count > limitBit - position) {
      failed = true;
      return 0;
    }
    int used = position & 7;
    int index = position >> 3;
    if (index + Long.BYTES <= limitBit >> 3) {
      position += count;
      return (int) (((long) LONGS.get(bytes, index) >>> used) & ((1L << count) - 1));
    }
    return readSlowly(count);
  }

  private int readSlowly(int count) {
    long value = 0;
    int got = 0;
    while (got < count) {
      int used = position & 7;
      int take = Math.min(8 - used, count - got);
      long piece = (bytes[position >> 3] >> used) & ((1 << take) - 1);
      value |= piece << got;
      got += take;
      position += take;
    }
    return (int) value;
  }

  /** Reads a number, as {@link #read}; the value given is ignored. */
  @Override
  public int plain(int value, int count) {
    return read(count);
  }

  @Override
  public boolean isReading() {
    return true;
  }

  @Override
  public boolean require(boolean holds) {
    if (!holds) {
      failed = true;
    }
    return holds;
  }

  /** Reads one bit. */
  public boolean readBit() {
    return read(1) != 0;
  }

  /** Reads 64 bits. */
  public long readLong() {
    long low = read(32) & 0xffffffffL;
    return low | ((long) read(32) << 32);
  }

  /**
   * Ends the bits at a whole byte: what is left of the current one must be zero.
   *
   * @return index in the array of what follows
   */
  public int align() {
    if (!failed && read(-position & 7) != 0) {
      failed = true;
    }
    return position >> 3;
  }

  /** Bits not yet read. */
  public int remaining() {
    return failed ? 0 : limitBit - position;
  }

  /** Marks what was read as wrong: a decoder found a value that no encoder writes. */
  public void fail() {
    failed = true;
  }

  /** Whether anything was read past the end or {@link #fail} was called. */
  public boolean failed() {
    return failed;
  }

  /**
   * Whether everything was read well and to the end: less than a byte remains, and that is zero.
   */
  public boolean finished() {
    if (failed || limitBit - position >= 8) {
      return false;
    }
    return read(limitBit - position) == 0;
  }
}
