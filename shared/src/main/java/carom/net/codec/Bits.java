package carom.net.codec;

/** Number forms for the wire. */
public final class Bits {

  private Bits() {}

  /** Folds the sign into the lowest bit: 0, -1, 1, -2, 2 become 0, 1, 2, 3, 4. */
  public static int zigzag(int value) {
    return (value << 1) ^ (value >> 31);
  }

  /** Undoes {@link #zigzag}. */
  public static int unzigzag(int value) {
    return (value >>> 1) ^ -(value & 1);
  }

  /** Bits needed for an unsigned value: 0 for 0, 32 when the sign bit is set. */
  public static int width(int value) {
    return 32 - Integer.numberOfLeadingZeros(value);
  }

  /**
   * A float's bits in an order that follows the numbers: neighbouring floats are neighbouring
   * integers, across zero too. Exact for every bit pattern, so that a difference of two ordered
   * values restores the float bit by bit.
   */
  public static int ordered(float value) {
    return orderedBits(Float.floatToRawIntBits(value));
  }

  /** As {@link #ordered}, from raw float bits. */
  public static int orderedBits(int raw) {
    return raw ^ ((raw >> 31) & 0x7fffffff);
  }

  /** Undoes {@link #orderedBits}; it is its own inverse. */
  public static int rawBits(int ordered) {
    return ordered ^ ((ordered >> 31) & 0x7fffffff);
  }

  /**
   * Writes a number with its width before it: 5 bits hold 0..31, the width of its zigzag form.
   * Magnitudes below 2^30.
   */
  public static void writeSized(BitWriter w, int value) {
    int z = zigzag(value);
    int width = width(z);
    w.write(width, 5);
    w.write(z, width);
  }

  /** Reads what {@link #writeSized} wrote. */
  public static int readSized(BitReader r) {
    return unzigzag(r.read(r.read(5)));
  }
}
