package carom.physics.dynamics.contact;

import java.util.Arrays;

/**
 * The storage of kept manifolds, one block of floats per row of a contact table, which moves as the
 * table's rows do. When the table takes over the rows of a copy, the blocks stay where they are and
 * find their rows later: a world that is restored and steps on has most of the same pairs in much
 * the same poses.
 */
final class KeptRows {
  /** Number of floats per row. */
  static final int STRIDE = 16;

  /** Place of the float that says whether a row is known: {@link #UNKNOWN} or a cosine. */
  static final int COS = 0;

  /** Value that is no cosine: nothing is known of the row. */
  static final float UNKNOWN = 2;

  /** The floats, {@value #STRIDE} per row; replaced when the storage grows. */
  float[] numbers = new float[0];

  /** The pairs that the blocks are of, if the table has taken others over since; else null. */
  private RowArrays before;

  private int beforeCount;

  /** Makes room for rows, if any were ever kept. */
  void grow(int count) {
    if (numbers.length > 0) {
      ensure(count);
    }
  }

  /** Makes room for rows; new ones are unknown. */
  void ensure(int count) {
    int old = numbers.length / STRIDE;
    if (count > old) {
      numbers = Arrays.copyOf(numbers, Math.max(count, 2 * old) * STRIDE);
      for (int row = old; row < numbers.length / STRIDE; row++) {
        forget(row);
      }
    }
  }

  /** Forgets a row. Does nothing if there is no room for it yet. */
  void forget(int row) {
    if (row * STRIDE < numbers.length) {
      numbers[row * STRIDE + COS] = UNKNOWN;
    }
  }

  /** Forgets all rows. */
  void clear() {
    if (before != null) {
      before.release();
      before = null;
    }
    for (int at = 0; at < numbers.length; at += STRIDE) {
      numbers[at + COS] = UNKNOWN;
    }
  }

  /** Plans to move rows, for all of which there must be room. */
  void plan(RowShifts shifts) {
    if (numbers.length > 0) {
      shifts.plan(numbers, numbers, STRIDE);
    }
  }

  /**
   * Notes that the table is about to take over other rows of the same shapes.
   *
   * @param pairs the pairs so far, as in {@link ContactColumns}
   * @param count their number
   */
  void rowsReplaced(RowArrays pairs, int count) {
    if (numbers.length > 0 && before == null) {
      before = pairs.share();
      beforeCount = count;
    }
  }

  /** Returns the number of rows that there must be room for before {@link #realign}. */
  int rowsBefore() {
    return before == null ? 0 : beforeCount;
  }

  /**
   * Moves the blocks to the rows that the table has now. The table calls it before rows move and
   * before a block is read or forgotten.
   *
   * @param key of each row, ascending
   * @param count number of rows
   * @param shifts scratch
   */
  void realign(long[] key, int count, RowShifts shifts) {
    if (before == null) {
      return;
    }
    long[] old = (long[]) before.array(0);
    shifts.clear(false);
    int from = 0;
    int fresh = 0;
    for (int row = 0; row < count; row++) {
      while (from < beforeCount && old[from] < key[row]) {
        from++;
      }
      if (from < beforeCount && old[from] == key[row]) {
        shifts.keep(from++, row);
      } else {
        shifts.insert(fresh++, row);
      }
    }
    plan(shifts);
    shifts.carryOut(null);
    for (int i = 0; i < fresh; i++) {
      forget(shifts.inserted[i]);
    }
    before.release();
    before = null;
  }
}
