package carom.physics.dynamics;

import java.util.Arrays;

/**
 * How the rows of a sorted table move when some are dropped and others come in between: runs of
 * rows that move equally far, so that each array of the table is moved run by run, in place.
 *
 * <p>A run that moves back only ever overwrites rows of earlier runs that move back, one that moves
 * on only those of later runs that move on; hence the former are moved in ascending order, the
 * latter in descending order, and nothing is lost.
 */
final class RowMoves {
  /** Below this length a loop is faster than a call. */
  private static final int SHORT = 6;

  /** Where new rows go, by their number. */
  int[] inserted = new int[64];

  /** Per run: first row, how many, how far. */
  private int[] from = new int[64];

  private int[] length = new int[64];
  private int[] offset = new int[64];
  private int count;

  /** Forgets all. */
  void clear() {
    count = 0;
  }

  /** The number of runs that move at all. */
  int count() {
    return count;
  }

  /** Notes that a row stays in the table; in ascending order. */
  void keep(int row, int to) {
    if (row == to) {
      return;
    }
    int last = count - 1;
    if (last >= 0 && offset[last] == to - row && from[last] + length[last] == row) {
      length[last]++;
      return;
    }
    if (count == from.length) {
      from = Arrays.copyOf(from, 2 * count);
      length = Arrays.copyOf(length, 2 * count);
      offset = Arrays.copyOf(offset, 2 * count);
    }
    from[count] = row;
    length[count] = 1;
    offset[count++] = to - row;
  }

  /** Notes where a new row goes; in ascending order of both. */
  void insert(int number, int to) {
    if (number == inserted.length) {
      inserted = Arrays.copyOf(inserted, 2 * number);
    }
    inserted[number] = to;
  }

  /** Moves the rows of an array. */
  void apply(float[] a) {
    for (int i = 0; i < count; i++) {
      if (offset[i] < 0) {
        back(a, from[i], length[i], offset[i]);
      }
    }
    for (int i = count - 1; i >= 0; i--) {
      if (offset[i] > 0) {
        on(a, from[i], length[i], offset[i]);
      }
    }
  }

  /** Moves the rows of an array in which each takes several places. */
  void apply(float[] a, int stride) {
    for (int i = 0; i < count; i++) {
      if (offset[i] < 0) {
        back(a, from[i] * stride, length[i] * stride, offset[i] * stride);
      }
    }
    for (int i = count - 1; i >= 0; i--) {
      if (offset[i] > 0) {
        on(a, from[i] * stride, length[i] * stride, offset[i] * stride);
      }
    }
  }

  private static void back(float[] a, int first, int n, int by) {
    if (n >= SHORT) {
      System.arraycopy(a, first, a, first + by, n);
      return;
    }
    for (int i = first; i < first + n; i++) {
      a[i + by] = a[i];
    }
  }

  private static void on(float[] a, int first, int n, int by) {
    if (n >= SHORT) {
      System.arraycopy(a, first, a, first + by, n);
      return;
    }
    for (int i = first + n - 1; i >= first; i--) {
      a[i + by] = a[i];
    }
  }

  /** Moves the rows of an array. */
  void apply(int[] a) {
    applyTo(a);
  }

  /** Moves the rows of an array. */
  void apply(long[] a) {
    applyTo(a);
  }

  /** Moves the rows of an array. */
  void apply(byte[] a) {
    applyTo(a);
  }

  private void applyTo(Object array) {
    for (int i = 0; i < count; i++) {
      if (offset[i] < 0) {
        System.arraycopy(array, from[i], array, from[i] + offset[i], length[i]);
      }
    }
    for (int i = count - 1; i >= 0; i--) {
      if (offset[i] > 0) {
        System.arraycopy(array, from[i], array, from[i] + offset[i], length[i]);
      }
    }
  }
}
