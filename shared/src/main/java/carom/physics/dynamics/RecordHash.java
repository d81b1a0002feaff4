package carom.physics.dynamics;

import java.util.Arrays;

/**
 * The hash of thousands of equal structures, column by column: every word is multiplied by the odd
 * number of its place in the record and added to the record's sum, so that no multiplication waits
 * for another; the finished sums are added up. So the order of the records doesn't matter; each
 * must hold its own index or key.
 *
 * <p>Which records count is told by a list of their numbers. A word of zero adds nothing. One
 * thread; allocates only when there are more records than ever before.
 */
final class RecordHash {
  /** Words a record may have. */
  static final int PLACES = 32;

  /** Per place an odd number without a pattern: the steps of a Weyl sequence, finished. */
  private static final long[] FACTORS = new long[PLACES];

  static {
    for (int place = 0; place < PLACES; place++) {
      FACTORS[place] = StateHash.finish((place + 1) * 0x9e3779b97f4a7c15L) | 1;
    }
  }

  private int[] records = new int[0];
  private long[] sums = new long[0];
  private int count;

  /**
   * Makes room for so many records.
   *
   * @return the list to write their numbers to, ahead of {@link #begin}; it may be one too long, so
   *     that each can be written before it is known to count
   */
  int[] list(int most) {
    if (records.length <= most) {
      records = new int[most + (most >> 1) + 1];
      sums = new long[records.length];
    }
    return records;
  }

  /** Begins with so many listed records, without words. */
  void begin(int listed) {
    count = listed;
    Arrays.fill(sums, 0, count, 0);
  }

  /** How many records are listed. */
  int count() {
    return count;
  }

  /** The number of a listed record. */
  int record(int i) {
    return records[i];
  }

  /**
   * Adds a word to one record. The high half is folded into the low one first, as a product spreads
   * upwards only.
   *
   * @param i which of the listed ones
   * @param place 0..{@value #PLACES} - 1, another one for each word of a record
   * @param bits 64 bits
   */
  void add(int i, int place, long bits) {
    sums[i] += (bits ^ bits >>> 32) * FACTORS[place];
  }

  /** Adds a column of floats by their raw bits, as words at {@code place}. */
  void add(int place, float[] a) {
    int[] which = records;
    long[] to = sums;
    long factor = FACTORS[place];
    for (int i = 0; i < count; i++) {
      to[i] += Float.floatToRawIntBits(a[which[i]]) * factor;
    }
  }

  /** Adds two columns, as words at {@code place} and the one after it. */
  void add(int place, float[] a, float[] b) {
    int[] which = records;
    long[] to = sums;
    long factorA = FACTORS[place];
    long factorB = FACTORS[place + 1];
    for (int i = 0; i < count; i++) {
      int record = which[i];
      to[i] +=
          Float.floatToRawIntBits(a[record]) * factorA
              + Float.floatToRawIntBits(b[record]) * factorB;
    }
  }

  /** Adds four columns, as words at {@code place} and the three after it. */
  void add(int place, float[] a, float[] b, float[] c, float[] d) {
    int[] which = records;
    long[] to = sums;
    long factorA = FACTORS[place];
    long factorB = FACTORS[place + 1];
    long factorC = FACTORS[place + 2];
    long factorD = FACTORS[place + 3];
    for (int i = 0; i < count; i++) {
      int record = which[i];
      to[i] +=
          Float.floatToRawIntBits(a[record]) * factorA
              + Float.floatToRawIntBits(b[record]) * factorB
              + Float.floatToRawIntBits(c[record]) * factorC
              + Float.floatToRawIntBits(d[record]) * factorD;
    }
  }

  /**
   * Adds three neighbours of each record, as words at {@code place} and the two after it.
   *
   * @param place as in {@link #add(int, int, long)}
   * @param a the records
   * @param stride floats of {@code a} per record
   * @param offset the first of the three within a record
   */
  void addThree(int place, float[] a, int stride, int offset) {
    int[] which = records;
    long[] to = sums;
    long factorA = FACTORS[place];
    long factorB = FACTORS[place + 1];
    long factorC = FACTORS[place + 2];
    for (int i = 0; i < count; i++) {
      int at = which[i] * stride + offset;
      to[i] +=
          Float.floatToRawIntBits(a[at]) * factorA
              + Float.floatToRawIntBits(a[at + 1]) * factorB
              + Float.floatToRawIntBits(a[at + 2]) * factorC;
    }
  }

  /** The hash of all listed records. */
  long finish() {
    long all = 0;
    for (int i = 0; i < count; i++) {
      all += StateHash.finish(sums[i]);
    }
    return all;
  }
}
