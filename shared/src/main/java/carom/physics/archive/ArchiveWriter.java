package carom.physics.archive;

import java.util.Arrays;

/**
 * Archive that collects numbers as bytes. It is mutable and reused, and it allocates only to grow.
 */
public final class ArchiveWriter extends Archive {
  private byte[] bytes = new byte[1 << 12];
  private int length;

  /** Creates an empty archive. */
  public ArchiveWriter() {}

  /** Removes what was written. */
  public void clear() {
    length = 0;
  }

  /**
   * Returns the backing array.
   *
   * @return the live array, which growth replaces; its first {@link #length} bytes are written
   */
  public byte[] array() {
    return bytes;
  }

  /**
   * Returns the number of bytes written.
   *
   * @return 0 or more
   */
  public int length() {
    return length;
  }

  /**
   * Returns what was written.
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
    put(bytes, length, (int) (value >>> 32));
    put(bytes, length + Integer.BYTES, (int) value);
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
      put(to, at, value);
      at += Integer.BYTES;
    }
    length = at;
  }

  @Override
  public void bits(String what, long[] values, int count) {
    ensure(count * (long) Long.BYTES);
    byte[] to = bytes;
    int at = length;
    for (int i = 0; i < count; i++) {
      put(to, at, (int) (values[i] >>> 32));
      put(to, at + Integer.BYTES, (int) values[i]);
      at += Long.BYTES;
    }
    length = at;
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
      put(to, at, Float.floatToRawIntBits(value));
      at += Float.BYTES;
    }
    length = at;
  }

  private void check(String what, int value, int least, int most) {
    if (value < least || value > most) {
      throw outside(what, value, least, most);
    }
  }

  private void put(int value) {
    put(bytes, length, value);
    length += Integer.BYTES;
  }

  private static void put(byte[] to, int at, int value) {
    to[at] = (byte) (value >>> 24);
    to[at + 1] = (byte) (value >>> 16);
    to[at + 2] = (byte) (value >>> 8);
    to[at + 3] = (byte) value;
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
