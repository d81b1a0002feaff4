package carom.physics.dynamics.contact;

import carom.physics.dynamics.store.ParallelFor;
import java.util.Arrays;

/**
 * A plan of how the rows of a sorted table move when some are removed and others come in between:
 * runs of rows that move equally far. Each array of the table is moved run by run, in place.
 *
 * <pre>
 *   before   0  1  2  3  4  5         run 1: rows 2..3 move by -1
 *                /  /  |  \           run 2: row 4 stays
 *   after    0  2  3  4  .  5         run 3: row 5 moves by +1, behind a new row
 * </pre>
 *
 * <p>A run that moves back only ever overwrites rows of earlier runs that move back, one that moves
 * on only those of later runs that move on; hence the former are moved in ascending order, the
 * latter in descending order, and nothing is lost.
 */
final class RowShifts {
  /** Largest number of arrays of a table. */
  private static final int MOST_ARRAYS = 16;

  private static final int FIRST_CAPACITY = 128;

  /** Number of rows below which one thread moves them all. */
  private static final int FEWEST_SHARED = 2_048;

  /** The places of new rows, by their number. */
  public int[] inserted = new int[FIRST_CAPACITY];

  /** Per run: first row, how many, how far. */
  private int[] from = new int[FIRST_CAPACITY];

  private int[] length = new int[FIRST_CAPACITY];
  private int[] offset = new int[FIRST_CAPACITY];
  private int count;
  private boolean all;

  /** The planned arrays to move from; the two after it hold the targets and elements per row. */
  private final Object[] sources = new Object[MOST_ARRAYS];

  private final Object[] targets = new Object[MOST_ARRAYS];
  private final int[] strides = new int[MOST_ARRAYS];
  private int planned;
  private final ParallelFor.Range carrying = (first, end, worker) -> carryOut(first, end);

  /**
   * Forgets all.
   *
   * @param elsewhere whether rows will be moved to another array, so that those count, too, that
   *     stay in their place
   */
  public void clear(boolean elsewhere) {
    count = 0;
    all = elsewhere;
  }

  /**
   * Makes room for a table of as many rows, so that the arrays grow with the table and not at the
   * first step in which so many rows move.
   */
  public void reserve(int rows) {
    if (rows > inserted.length) {
      inserted = Arrays.copyOf(inserted, rows);
    }
    if (rows > from.length) {
      from = Arrays.copyOf(from, rows);
      length = Arrays.copyOf(length, rows);
      offset = Arrays.copyOf(offset, rows);
    }
  }

  /** Notes that a row stays in the table; in ascending order. */
  public void keep(int row, int to) {
    keep(row, 1, to);
  }

  /** Notes that neighbouring rows stay in the table, and where the first of them goes. */
  public void keep(int row, int rows, int to) {
    if ((row == to && !all) || rows == 0) {
      return;
    }
    int last = count - 1;
    if (last >= 0 && offset[last] == to - row && from[last] + length[last] == row) {
      length[last] += rows;
      return;
    }
    if (count == from.length) {
      reserve(2 * count);
    }
    from[count] = row;
    length[count] = rows;
    offset[count++] = to - row;
  }

  /** Notes where a new row goes; in ascending order of both. */
  public void insert(int number, int to) {
    if (number == inserted.length) {
      reserve(2 * number);
    }
    inserted[number] = to;
  }

  /**
   * Plans to move the rows of an array within it, or to another one if {@link #clear(boolean)} was
   * told so. No two plans may have the same target.
   *
   * @param source of floats, ints, longs or bytes
   * @param target the same, or one that has nothing yet
   * @param stride how many elements a row has
   */
  public void plan(Object source, Object target, int stride) {
    sources[planned] = source;
    targets[planned] = target;
    strides[planned++] = stride;
  }

  /**
   * Carries out all plans.
   *
   * @param parallel does it, an array each; null for the caller alone
   */
  public void carryOut(ParallelFor parallel) {
    long rows = 0;
    for (int i = 0; i < count; i++) {
      rows += length[i];
    }
    if (parallel == null || rows < FEWEST_SHARED) {
      carryOut(0, planned);
    } else {
      parallel.run(0, planned, 1, carrying);
    }
    Arrays.fill(sources, 0, planned, null);
    Arrays.fill(targets, 0, planned, null);
    planned = 0;
  }

  private void carryOut(int first, int end) {
    for (int i = first; i < end; i++) {
      apply(sources[i], targets[i], strides[i]);
    }
  }

  private void apply(Object source, Object target, int stride) {
    boolean within = source == target;
    for (int i = 0; i < count; i++) {
      if (offset[i] < 0 || !within) {
        move(source, target, i, stride);
      }
    }
    for (int i = count - 1; i >= 0 && within; i--) {
      if (offset[i] > 0) {
        move(source, target, i, stride);
      }
    }
  }

  private void move(Object source, Object target, int run, int stride) {
    int first = from[run] * stride;
    System.arraycopy(source, first, target, first + offset[run] * stride, length[run] * stride);
  }
}
