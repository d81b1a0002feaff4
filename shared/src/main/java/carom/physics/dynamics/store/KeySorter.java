package carom.physics.dynamics.store;

import java.util.Arrays;

/**
 * Sorts contact keys without garbage: insertion sort for few, a radix sort for many, whose digits
 * leave out the bits that all keys share.
 */
public final class KeySorter {
  private static final int FEW = 32;

  /** Number of bits of a digit. */
  private static final int DIGIT = 11;

  private static final int RADIX = 1 << DIGIT;

  private long[] other = new long[64];
  private int[] otherRows = new int[64];
  private final int[] counts = new int[RADIX];

  /**
   * Sorts the first n keys. Returns the array that holds them now; the other one becomes scratch.
   */
  public long[] sort(long[] keys, int n) {
    if (n <= FEW) {
      insertion(keys, n);
      return keys;
    }
    if (other.length < keys.length) {
      other = new long[keys.length];
    }
    long[] from = keys;
    long[] to = other;
    long all = -1;
    long any = 0;
    for (int i = 0; i < n; i++) {
      all &= keys[i];
      any |= keys[i];
    }
    long differs = all ^ any;
    for (int shift = 0; shift < 64 && differs >>> shift != 0; shift += DIGIT) {
      shift += Long.numberOfTrailingZeros(differs >>> shift);
      Arrays.fill(counts, 0);
      for (int i = 0; i < n; i++) {
        counts[(int) (from[i] >>> shift) & RADIX - 1]++;
      }
      addUp();
      for (int i = 0; i < n; i++) {
        to[counts[(int) (from[i] >>> shift) & RADIX - 1]++] = from[i];
      }
      long[] swap = from;
      from = to;
      to = swap;
    }
    other = to;
    return from;
  }

  /** Makes room for so many row numbers, so that sorting them allocates nothing. */
  public void ensureRoom(int rows) {
    if (otherRows.length < rows) {
      otherRows = new int[rows];
    }
  }

  /**
   * Sorts the first n row numbers by the keys of these rows.
   *
   * @param key of each row
   */
  public void sort(int[] rows, int n, long[] key) {
    if (n <= FEW) {
      insertion(rows, n, key);
      return;
    }
    if (otherRows.length < n) {
      ensureRoom(rows.length);
    }
    long all = -1;
    long any = 0;
    for (int i = 0; i < n; i++) {
      all &= key[rows[i]];
      any |= key[rows[i]];
    }
    long differs = all ^ any;
    for (int shift = 0; shift < 64 && differs >>> shift != 0; shift += DIGIT) {
      shift += Long.numberOfTrailingZeros(differs >>> shift);
      Arrays.fill(counts, 0);
      for (int i = 0; i < n; i++) {
        counts[(int) (key[rows[i]] >>> shift) & RADIX - 1]++;
      }
      addUp();
      for (int i = 0; i < n; i++) {
        otherRows[counts[(int) (key[rows[i]] >>> shift) & RADIX - 1]++] = rows[i];
      }
      System.arraycopy(otherRows, 0, rows, 0, n);
    }
  }

  /** Turns the counts of the digits into where each one's first goes. */
  private void addUp() {
    int sum = 0;
    for (int d = 0; d < RADIX; d++) {
      int c = counts[d];
      counts[d] = sum;
      sum += c;
    }
  }

  private static void insertion(int[] rows, int n, long[] key) {
    for (int i = 1; i < n; i++) {
      int row = rows[i];
      int j = i - 1;
      while (j >= 0 && key[rows[j]] > key[row]) {
        rows[j + 1] = rows[j];
        j--;
      }
      rows[j + 1] = row;
    }
  }

  private static void insertion(long[] keys, int n) {
    for (int i = 1; i < n; i++) {
      long k = keys[i];
      int j = i - 1;
      while (j >= 0 && keys[j] > k) {
        keys[j + 1] = keys[j];
        j--;
      }
      keys[j + 1] = k;
    }
  }
}
