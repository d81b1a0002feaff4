package carom.physics.archive;

/**
 * Archive that reads what an {@link ArchiveWriter} wrote. It trusts nothing and checks every read
 * against the end and the limits.
 */
public final class ArchiveReader extends Archive {
  private final byte[] bytes;
  private final int end;
  private int at;

  /**
   * Creates a reader of the first bytes of an array.
   *
   * @param bytes the array, which is not copied
   * @param length number of bytes to read
   */
  public ArchiveReader(byte[] bytes, int length) {
    this.bytes = bytes;
    end = length;
  }

  /**
   * Creates a reader of all bytes of an array.
   *
   * @param bytes the array, which is not copied
   */
  public ArchiveReader(byte[] bytes) {
    this(bytes, bytes.length);
  }

  /**
   * Returns whether all bytes were read.
   *
   * @return false if bytes are left
   */
  public boolean isEmpty() {
    return at == end;
  }

  @Override
  public boolean reads() {
    return true;
  }

  @Override
  public int integer(String what, int value, int least, int most) {
    need(what, Integer.BYTES);
    int read = take();
    check(what, read, least, most);
    return read;
  }

  @Override
  public long bits(String what, long value) {
    need(what, Long.BYTES);
    long high = take();
    return high << 32 | take() & 0xffffffffL;
  }

  @Override
  public float number(String what, float value, float least, float most) {
    need(what, Float.BYTES);
    float read = Float.intBitsToFloat(take());
    if (!(read >= least && read <= most)) {
      throw outside(what, read, least, most);
    }
    return read;
  }

  @Override
  public int count(String what, int value, int most, int bytesEach) {
    int read = integer(what, value, 0, most);
    if ((long) read * bytesEach > end - at) {
      throw refused(what + "=" + read + " is more than " + (end - at) + " bytes can hold");
    }
    return read;
  }

  @Override
  public void bytes(String what, byte[] values, int count, int least, int most) {
    need(what, count);
    for (int i = 0; i < count; i++) {
      values[i] = bytes[at++];
      check(what, values[i], least, most);
    }
  }

  @Override
  public void integers(String what, int[] values, int count, int least, int most) {
    need(what, count * (long) Integer.BYTES);
    for (int i = 0; i < count; i++) {
      values[i] = take();
      check(what, values[i], least, most);
    }
  }

  @Override
  public void bits(String what, long[] values, int count) {
    need(what, count * (long) Long.BYTES);
    for (int i = 0; i < count; i++) {
      long high = take();
      values[i] = high << 32 | take() & 0xffffffffL;
    }
  }

  @Override
  public void numbers(String what, float[] values, int count, float most) {
    need(what, count * (long) Float.BYTES);
    for (int i = 0; i < count; i++) {
      float read = Float.intBitsToFloat(take());
      if (!(Math.abs(read) <= most)) {
        throw outside(what, read, -most, most);
      }
      values[i] = read;
    }
  }

  private void check(String what, int value, int least, int most) {
    if (value < least || value > most) {
      throw outside(what, value, least, most);
    }
  }

  private int take() {
    byte[] b = bytes;
    int i = at;
    at = i + 4;
    return b[i] << 24 | (b[i + 1] & 0xff) << 16 | (b[i + 2] & 0xff) << 8 | b[i + 3] & 0xff;
  }

  private void need(String what, long count) {
    if (count > end - at) {
      throw refused(what + " needs " + count + " bytes, " + (end - at) + " are left");
    }
  }

  /**
   * Returns an exception for something wrong with what was read.
   *
   * @param what what is wrong
   * @return the exception, to be thrown
   */
  @Override
  public ArchiveException refused(String what) {
    return new ArchiveException("damaged state, before byte " + at + ": " + what);
  }
}
