package carom.net.codec;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Writes bits into a caller's array. The first bit goes to the lowest bit of the first byte; a
 * number's lowest bit goes first.
 *
 * <p>Writing past the limit sets a sticky overflow and writes nothing more, so that a codec can
 * try, look and {@link #rewind}. One thread, no allocation.
 */
public final class BitWriter implements BitPass {

  private static final VarHandle LONGS =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

  private byte[] bytes = new byte[0];
  private int startBit;
  private int limitBit;
  private int position;
  private boolean overflow;

  /** Creates a writer without room; call {@link #reset}. */
  public BitWriter() {}

  /** Starts at {@code offset}, with room for {@code length} bytes. */
  public void reset(byte[] bytes, int offset, int length) {
    if (offset < 0 || length < 0 || length > bytes.length - offset) {
      throw new IndexOutOfBoundsException(
          "offset=" + offset + " length=" + length + " array=" + bytes.length);
    }
    this.bytes = bytes;
    startBit = offset << 3;
    limitBit = (offset + length) << 3;
    position = startBit;
    overflow = false;
  }

  /**
   * Writes the lowest {@code count} bits of a value.
   *
   * @param count 0..32
   */
  public void write(int value, int count) {
    if (count > limitBit - position) {
      overflow = true;
      return;
    }
    long rest = value & ((1L << count) - 1);
    int used = position & 7;
    int index = position >> 3;
    if (index + Long.BYTES <= limitBit >> 3) {
      long before = (long) LONGS.get(bytes, index) & ((1L << used) - 1);
      LONGS.set(bytes, index, before | (rest << used));
    } else {
      writeSlowly(rest, count);
    }
    position += count;
  }

  /** Near the end of the room: byte by byte, so that nothing behind it is touched. */
  private void writeSlowly(long value, int count) {
    long rest = value;
    int left = count;
    int at = position;
    while (left > 0) {
      int used = at & 7;
      int index = at >> 3;
      int take = Math.min(8 - used, left);
      int low = (1 << used) - 1;
      bytes[index] = (byte) ((bytes[index] & low) | ((int) rest << used));
      rest >>>= take;
      at += take;
      left -= take;
    }
  }

  /** Writes a number, as {@link #write(int, int)}. */
  @Override
  public int plain(int value, int count) {
    write(value, count);
    return (int) (value & (1L << count) - 1);
  }

  @Override
  public boolean isReading() {
    return false;
  }

  @Override
  public boolean require(boolean holds) {
    assert holds : "a value is outside of what its section allows";
    return holds;
  }

  /** Writes one bit. */
  public void write(boolean bit) {
    write(bit ? 1 : 0, 1);
  }

  /** Writes 64 bits. */
  public void writeLong(long value) {
    write((int) value, 32);
    write((int) (value >>> 32), 32);
  }

  /** Bits written since {@link #reset}. */
  public int bits() {
    return position - startBit;
  }

  /** Bytes touched since {@link #reset}; the unused bits of the last one are zero. */
  public int bytes() {
    return (position - startBit + 7) >> 3;
  }

  /** Bits that still fit. */
  public int room() {
    return limitBit - position;
  }

  /** Whether something did not fit since {@link #reset} or {@link #rewind}. */
  public boolean overflow() {
    return overflow;
  }

  /**
   * Goes back to an earlier place and forgets an overflow.
   *
   * @param bits an earlier value of {@link #bits()}
   */
  public void rewind(int bits) {
    if (bits < 0 || bits > bits()) {
      throw new IllegalArgumentException("bits=" + bits + " is outside 0.." + bits());
    }
    position = startBit + bits;
    overflow = false;
    if ((position & 7) != 0) {
      bytes[position >> 3] &= (byte) ((1 << (position & 7)) - 1);
    }
  }
}
