package carom.physics.math;

/**
 * 64-bit hash of numbers by their bits. Equal states give equal hashes, and one changed bit changes
 * about half of the hash.
 *
 * <p>Each word is multiplied by an odd constant, rotated and multiplied again, as in Austin
 * Appleby's MurmurHash3 (public domain). Zero and minus zero differ. Each word waits for the one
 * before it, so {@code ColumnHash} and {@code ContactHash} are better for thousands of numbers.
 */
public final class StateHash {
  /** Start value of a hash. */
  public static final long SEED = 0x43_61_72_6f_6dL;

  private static final long FIRST = 0x87c37b91114253d5L;
  private static final long SECOND = 0x4cf5ad432745937fL;

  /** First factor of {@link #finish}. */
  public static final long FINISH_FIRST = 0xff51afd7ed558ccdL;

  /** Second factor of {@link #finish}. */
  public static final long FINISH_SECOND = 0xc4ceb9fe1a85ec53L;

  private StateHash() {}

  /**
   * Adds a word.
   *
   * @param hash the hash so far
   * @param word 64 bits
   * @return the new hash
   */
  public static long mix(long hash, long word) {
    long k = Long.rotateLeft(word * FIRST, 31) * SECOND;
    return Long.rotateLeft(hash ^ k, 27) * 5 + 0x52dce729L;
  }

  /**
   * Adds two floats by their raw bits.
   *
   * @param hash the hash so far
   * @param a a number
   * @param b a number
   * @return the new hash
   */
  public static long mix(long hash, float a, float b) {
    long high = (long) Float.floatToRawIntBits(a) << 32;
    return mix(hash, high | (Float.floatToRawIntBits(b) & 0xffffffffL));
  }

  /**
   * Finishes a hash by spreading the last words over all bits.
   *
   * @param hash the hash so far
   * @return the finished hash
   */
  public static long finish(long hash) {
    long h = (hash ^ (hash >>> 33)) * FINISH_FIRST;
    h = (h ^ (h >>> 33)) * FINISH_SECOND;
    return h ^ (h >>> 33);
  }
}
