package carom.physics.archive;

/**
 * What a state's numbers pass through, to be written or read: the same lines describe both, so that
 * they can't disagree. A writer gives every number back as it is; a reader gives the one that was
 * written, or refuses it, and then what was filled so far means nothing.
 *
 * <p>Scalars take 4 bytes, {@link #bits} 8, columns what their elements need; big-endian. Limits
 * are checked in both directions, so nothing can be written that could not be read.
 */
public abstract class Archive {
  Archive() {}

  /**
   * Returns whether numbers come from the archive.
   *
   * @return false if they go to it
   */
  public abstract boolean reads();

  /**
   * Returns a whole number.
   *
   * @param what its name, for messages
   * @param value ignored when reading
   * @param least smallest allowed
   * @param most largest allowed
   * @return the number
   * @throws ArchiveException if it is outside
   */
  public abstract int integer(String what, int value, int least, int most);

  /**
   * 64 bits that may be anything.
   *
   * @param what their name, for messages
   * @param value ignored when reading
   * @return the bits
   */
  public abstract long bits(String what, long value);

  /**
   * Returns a number.
   *
   * @param what its name, for messages
   * @param value ignored when reading
   * @param least smallest allowed
   * @param most largest allowed
   * @return the number, bit for bit, never NaN
   * @throws ArchiveException if it is outside
   */
  public abstract float number(String what, float value, float least, float most);

  /**
   * Returns how many of something follow. A reader refuses more than it has bytes for, so that what
   * is allocated for them is bounded by what was read.
   *
   * @param what their name, for messages
   * @param value ignored when reading
   * @param most largest allowed
   * @param bytesEach how many bytes each takes at least
   * @return the number
   * @throws ArchiveException if it is negative or too large
   */
  public abstract int count(String what, int value, int most, int bytesEach);

  /**
   * A column of bytes.
   *
   * @param what its name, for messages
   * @param values written from or read into
   * @param count how many
   * @param least smallest allowed
   * @param most largest allowed
   */
  public abstract void bytes(String what, byte[] values, int count, int least, int most);

  /**
   * A column of whole numbers.
   *
   * @param what its name, for messages
   * @param values written from or read into
   * @param count how many
   * @param least smallest allowed
   * @param most largest allowed
   */
  public abstract void integers(String what, int[] values, int count, int least, int most);

  /**
   * A column of 64 bits each.
   *
   * @param what its name, for messages
   * @param values written from or read into
   * @param count how many
   */
  public abstract void bits(String what, long[] values, int count);

  /**
   * A column of numbers.
   *
   * @param what its name, for messages
   * @param values written from or read into, bit for bit
   * @param count how many
   * @param most largest magnitude allowed; NaN never is
   */
  public abstract void numbers(String what, float[] values, int count, float most);

  /**
   * Returns a flag.
   *
   * @param what its name, for messages
   * @param value ignored when reading
   * @return the flag
   */
  public final boolean flag(String what, boolean value) {
    return integer(what, value ? 1 : 0, 0, 1) != 0;
  }

  /**
   * Returns a text, 2 bytes a character.
   *
   * @param what its name, for messages
   * @param value ignored when reading
   * @param most longest allowed, characters
   * @return the text
   */
  public final String text(String what, String value, int most) {
    int length = count(what, reads() ? 0 : value.length(), most, Integer.BYTES);
    char[] chars = new char[length];
    for (int i = 0; i < length; i++) {
      chars[i] = (char) integer(what, reads() ? 0 : value.charAt(i), 0, Character.MAX_VALUE);
    }
    return new String(chars);
  }

  /**
   * Requires something of what was read; when writing, that is so.
   *
   * @param holds whether it is so
   * @param what what is wrong otherwise
   * @throws ArchiveException if it isn't so
   */
  public final void require(boolean holds, String what) {
    if (!holds) {
      throw refused(what);
    }
  }

  /** Returns the exception to throw, with the place. */
  abstract ArchiveException refused(String what);

  final ArchiveException outside(String what, Object value, Object least, Object most) {
    return refused(what + "=" + value + " is outside " + least + ".." + most);
  }
}
