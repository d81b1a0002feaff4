package carom.physics.archive;

/**
 * Two-way channel for the numbers of a state. The same code describes writing and reading, so the
 * two can't disagree. A writer returns every number as given. A reader returns the number that was
 * written, or refuses it; the object filled so far is then unusable.
 *
 * <p>Scalars take 4 bytes, {@link #bits} 8, and columns the size of their elements, all big-endian.
 * Both directions check the limits, so nothing can be written that can't be read.
 */
public abstract class Archive {
  Archive() {}

  /**
   * Returns whether this archive reads.
   *
   * @return false if it writes
   */
  public abstract boolean reads();

  /**
   * Passes a whole number.
   *
   * @param what name of the number, for messages
   * @param value ignored when reading
   * @param least smallest allowed
   * @param most largest allowed
   * @return the number
   * @throws ArchiveException if the number is outside its range
   */
  public abstract int integer(String what, int value, int least, int most);

  /**
   * Passes 64 bits of any value.
   *
   * @param what name of the bits, for messages
   * @param value ignored when reading
   * @return the bits
   */
  public abstract long bits(String what, long value);

  /**
   * Passes a floating-point number.
   *
   * @param what name of the number, for messages
   * @param value ignored when reading
   * @param least smallest allowed
   * @param most largest allowed
   * @return the number, bit for bit, never NaN
   * @throws ArchiveException if the number is outside its range
   */
  public abstract float number(String what, float value, float least, float most);

  /**
   * Passes the count of the elements that follow. A reader refuses more elements than the remaining
   * bytes can hold, so the input bounds what is allocated for them.
   *
   * @param what name of the elements, for messages
   * @param value ignored when reading
   * @param most largest allowed
   * @param bytesEach smallest size of an element in bytes
   * @return the number
   * @throws ArchiveException if the count is negative or too large
   */
  public abstract int count(String what, int value, int most, int bytesEach);

  /**
   * Passes a column of bytes.
   *
   * @param what name of the column, for messages
   * @param values written from or read into
   * @param count number of elements
   * @param least smallest allowed
   * @param most largest allowed
   */
  public abstract void bytes(String what, byte[] values, int count, int least, int most);

  /**
   * Passes a column of whole numbers.
   *
   * @param what name of the column, for messages
   * @param values written from or read into
   * @param count number of elements
   * @param least smallest allowed
   * @param most largest allowed
   */
  public abstract void integers(String what, int[] values, int count, int least, int most);

  /**
   * Passes a column of 64-bit elements.
   *
   * @param what name of the column, for messages
   * @param values written from or read into
   * @param count number of elements
   */
  public abstract void bits(String what, long[] values, int count);

  /**
   * Passes a column of floating-point numbers.
   *
   * @param what name of the column, for messages
   * @param values written from or read into, bit for bit
   * @param count number of elements
   * @param most largest magnitude allowed; NaN is never allowed
   */
  public abstract void numbers(String what, float[] values, int count, float most);

  /**
   * Passes a flag.
   *
   * @param what name of the flag, for messages
   * @param value ignored when reading
   * @return the flag
   */
  public final boolean flag(String what, boolean value) {
    return integer(what, value ? 1 : 0, 0, 1) != 0;
  }

  /**
   * Passes a text, with 4 bytes for each character.
   *
   * @param what name of the text, for messages
   * @param value ignored when reading
   * @param most largest number of characters allowed
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
   * Checks a condition on what was read. When writing, the condition always holds.
   *
   * @param holds true if the condition holds
   * @param what what is wrong if it doesn't
   * @throws ArchiveException if the condition doesn't hold
   */
  public final void require(boolean holds, String what) {
    if (!holds) {
      throw refused(what);
    }
  }

  /** Returns an exception that says what is wrong and where. */
  abstract ArchiveException refused(String what);

  final ArchiveException outside(String what, Object value, Object least, Object most) {
    return refused(what + "=" + value + " is outside " + least + ".." + most);
  }
}
