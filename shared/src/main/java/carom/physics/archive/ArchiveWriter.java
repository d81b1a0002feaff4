package carom.physics.archive;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;

/** Takes numbers and holds them as bytes. Mutable, reused; allocates only to grow. */
public final class ArchiveWriter extends Archive {
  private static final VarHandle INTS =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.BIG_ENDIAN);
  private static final VarHandle LONGS =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);

  private byte[] bytes = new byte[1 << 12];
  private int length;

  /** Makes an empty archive. */
  public ArchiveWriter() {}

  /** Forgets what was written. */
  public void clear() {
    length = 0;
  }

  /**
   * The bytes.
   *
   * @return the live array, replaced when it grows; the first {@link #length} count
   */
  public byte[] array() {
    return bytes;
  }

  /**
   * How many bytes were written.
   *
   * @return the number
   */
  public int length() {
    return length;
  }

  /**
   * What was written.
   *
   * @return a copy
   */
  public byte[] toBytes() {
    return Arrays.copyOf(bytes, length);
  }

  @Override
  public boolean reads() {
    return false;
  }

  @Override
  public int integer(String what, int value, int least, int most) {
    check(what, value, least, most);
    ensure(Integer.BYTES);
    put(value);
    return value;
  }

  @Override
  public long bits(String what, long value) {
    ensure(Long.BYTES);
    LONGS.set(bytes, length, value);
    length += Long.BYTES;
    return value;
  }

  @Override
  public float number(String what, float value, float least, float most) {
    if (!(value >= least && value <= most)) {
      throw outside(what, value, least, most);
    }
    ensure(Float.BYTES);
    put(Float.floatToRawIntBits(value));
    return value;
  }

  @Override
  public int count(String what, int value, int most, int bytesEach) {
    return integer(what, value, 0, most);
  }

  @Override
  public void bytes(String what, byte[] values, int count, int least, int most) {
    ensure(count);
    for (int i = 0; i < count; i++) {
      check(what, values[i], least, most);
      bytes[length++] = values[i];
    }
  }

  @Override
  public void integers(String what, int[] values, int count, int least, int most) {
    ensure(count * (long) Integer.BYTES);
    byte[] to = bytes;
    int at = length;
    for (int i = 0; i < count; i++) {
      int value = values[i];
      check(what, value, least, most);
      INTS.set(to, at + i * Integer.BYTES, value);
    }
    length = at + count * Integer.BYTES;
  }

  @Override
  public void bits(String what, long[] values, int count) {
    ensure(count * (long) Long.BYTES);
    byte[] to = bytes;
    int at = length;
    for (int i = 0; i < count; i++) {
      LONGS.set(to, at + i * Long.BYTES, values[i]);
    }
    length = at + count * Long.BYTES;
  }

  @Override
  public void numbers(String what, float[] values, int count, float most) {
    ensure(count * (long) Float.BYTES);
    byte[] to = bytes;
    int at = length;
    for (int i = 0; i < count; i++) {
      float value = values[i];
      if (!(Math.abs(value) <= most)) {
        throw outside(what, value, -most, most);
      }
      INTS.set(to, at + i * Float.BYTES, Float.floatToRawIntBits(value));
    }
    length = at + count * Float.BYTES;
  }

  private void check(String what, int value, int least, int most) {
    if (value < least || value > most) {
      throw outside(what, value, least, most);
    }
  }

  private void put(int value) {
    INTS.set(bytes, length, value);
    length += Integer.BYTES;
  }

  private void ensure(long more) {
    if (length + more > bytes.length) {
      long wanted = Math.max(length + more, 2L * bytes.length);
      if (length + more > Integer.MAX_VALUE - 8) {
        throw refused("the state is too large for one array: bytes=" + (length + more));
      }
      bytes = Arrays.copyOf(bytes, (int) Math.min(wanted, Integer.MAX_VALUE - 8));
    }
  }

  @Override
  ArchiveException refused(String what) {
    return new ArchiveException("can't be written: " + what);
  }
}
