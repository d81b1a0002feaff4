package carom.physics.dynamics.store;

import carom.physics.math.StateHash;
import java.util.Arrays;

/**
 * The hash of columns of numbers by slot. Two neighbours make a word of 64 bits; each word is
 * {@linkplain #scramble scrambled}, multiplied by the odd number of its place and added up, so that
 * no word waits for another. A number of zero adds nothing: what slots hold that aren't in use must
 * be the same in equal states.
 *
 * <p>Vectors do it where the JVM has them ({@link ColumnHashLanes}), with the same bits. One
 * thread; allocates only when there are more slots than ever before.
 */
public final class ColumnHash {
  /** The golden ratio's fraction, odd. */
  public static final long SPREAD = 0x9e3779b97f4a7c15L;

  /** Per place an odd number without a pattern: the steps of a Weyl sequence, finished. */
  private long[] factors = new long[0];

  private final long[] sums = new long[ColumnHashLanes.SUMS];

  /**
   * Adds a column of floats by their raw bits.
   *
   * @param h the hash so far
   * @param n how many, from the first one on
   * @return the new hash
   */
  public long mix(long h, float[] column, int n) {
    ensure(n + 1 >> 1);
    Arrays.fill(sums, 0);
    int done =
        ColumnHashLanes.FOUND == null ? 0 : ColumnHashLanes.FOUND.column(column, factors, n, sums);
    long sum = sumOf(sums);
    for (int i = done; i < n; i += 2) {
      int low = Float.floatToRawIntBits(column[i]);
      int high = i + 1 < n ? Float.floatToRawIntBits(column[i + 1]) : 0;
      sum += scramble(low, high) * factors[i >> 1];
    }
    return StateHash.mix(h, sum);
  }

  /** Adds a column of bytes, eight to a word. */
  public long mix(long h, byte[] column, int n) {
    ensure(n + 7 >> 3);
    long sum = 0;
    for (int i = 0; i < n; i += 8) {
      long word = 0;
      for (int k = i; k < Math.min(i + 8, n); k++) {
        word |= (column[k] & 0xffL) << 8 * (k - i);
      }
      sum += scramble(word) * factors[i >> 3];
    }
    return StateHash.mix(h, sum);
  }

  /** Returns two numbers as one scrambled word. */
  public static long scramble(int low, int high) {
    return scramble(low & 0xffffffffL | (long) high << 32);
  }

  /**
   * Spreads every bit of a word to low bits, too, because the product to come spreads upwards only.
   * No few bits change the topmost one alone, which would let two words cancel out.
   */
  private static long scramble(long word) {
    long spread = word * SPREAD;
    return spread ^ spread >>> 32;
  }

  private static long sumOf(long[] lanes) {
    long sum = 0;
    for (long lane : lanes) {
      sum += lane;
    }
    return sum;
  }

  private void ensure(int places) {
    int old = factors.length;
    if (places > old) {
      factors = Arrays.copyOf(factors, Math.max(places, 2 * old));
      for (int place = old; place < factors.length; place++) {
        factors[place] = StateHash.finish((place + 1) * SPREAD) | 1;
      }
    }
  }
}
