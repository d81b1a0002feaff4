package carom.net.codec;

/**
 * Anything that plain bits pass through: a writer takes the values it is given, a reader ignores
 * them and answers its own. Code that uses only the answers describes a format once, for both.
 */
public interface PlainBits {

  /**
   * Passes an unsigned number.
   *
   * @param value what to write; its lowest {@code count} bits count, and a reader ignores it
   * @param count 0..32
   * @return the number written or read
   */
  int plain(int value, int count);

  /** Passes one bit and returns the bit written or read. */
  default boolean flag(boolean value) {
    return plain(value ? 1 : 0, 1) != 0;
  }
}
