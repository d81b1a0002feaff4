package carom.net.codec;

/** Variable-length and order-preserving forms of numbers on the wire. */
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

  /**
   * Returns the number of bits that an unsigned value needs: 0 for 0, 32 when the sign bit is set.
   */
  public static int width(int value) {
    return 32 - Integer.numberOfLeadingZeros(value);
  }

  /**
   * Maps a float to an integer that keeps the order of floats: neighbouring floats become
   * neighbouring integers, across zero too. The map is exact for every bit pattern, so the
   * difference of two mapped values restores the float bit by bit.
   */
  public static int ordered(float value) {
    return orderedBits(Float.floatToRawIntBits(value));
  }

  /** Maps raw float bits as {@link #ordered} maps a float. */
  public static int orderedBits(int raw) {
    return raw ^ ((raw >> 31) & 0x7fffffff);
  }

  /** Undoes {@link #orderedBits}, which is its own inverse. */
  public static int rawBits(int ordered) {
    return ordered ^ ((ordered >> 31) & 0x7fffffff);
  }
}
