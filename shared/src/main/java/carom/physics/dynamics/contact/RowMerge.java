package carom.physics.dynamics.contact;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.store.ParallelFor;
import java.util.Arrays;

/**
 * Plans how the rows of a contact table move when pairs are merged in. Rows leave if they neither
 * touch nor have overlapping fat boxes, and new rows come in between.
 *
 * <p>Few rows come or go in a step, but all must be looked at. So each worker lists the changes in
 * a range of rows, together with the pairs whose keys belong there. One thread then turns the lists
 * into shifts.
 */
final class RowMerge {
  /** Number of rows in a piece of a worker's work. */
  private static final int GRAIN = 512;

  /** Number of new rows in a piece of a worker's work. */
  private static final int START_GRAIN = 64;

  // What is known of a range; the range that begins at a row is at RANGE * (row / GRAIN).
  private static final int END = 0;

  /** Place of the number of rows that leave. */
  private static final int LEAVING = 1;

  /** Place of the first candidate that is a new pair of the range. */
  private static final int FIRST_NEW = 2;

  /** Place of the number of new pairs. */
  private static final int NEW = 3;

  private static final int RANGE = 4;

  private final ContactTable table;
  private int[] ranges = new int[RANGE];

  /** The rows that leave, those of a range from its first row's place on. */
  private int[] leaving = new int[0];

  /** The row before which a new pair comes, in the places of candidates. */
  private int[] before = new int[0];

  private int rowCount;

  // The merge at present.
  private long[] candidates;
  private int candidateCount;
  private ShapeTable parts;
  private boolean all;
  private BodyStore bodies;
  private RowShifts shifts;
  private final ParallelFor.Range looking = (from, to, worker) -> look(from, to);
  private final ParallelFor.Range starting = (from, to, worker) -> start(from, to);

  /** Merges into this table. */
  RowMerge(ContactTable table) {
    this.table = table;
  }

  /**
   * Looks at every row.
   *
   * @param keys of pairs in ascending order, some perhaps twice or in the table already; what is
   *     new comes to the front
   * @param count how many
   * @param shapes have fat boxes, some of which {@link ShapeTable#moved}
   * @param every whether rows may leave whose parts didn't move
   * @param parallel looks
   * @param to is told how rows move
   * @return how many pairs are new
   */
  int find(
      long[] keys,
      int count,
      ShapeTable shapes,
      boolean every,
      ParallelFor parallel,
      RowShifts to) {
    int rows = table.count();
    if (leaving.length < table.key.length) {
      leaving = new int[table.key.length];
      ranges = Arrays.copyOf(ranges, RANGE * (leaving.length / GRAIN + 1));
    }
    if (before.length < keys.length) {
      before = new int[keys.length];
    }
    candidates = keys;
    candidateCount = count;
    parts = shapes;
    all = every;
    shifts = to;
    if (rows == 0) {
      look(0, 0);
    } else {
      parallel.run(0, rows, GRAIN, looking);
    }
    return note();
  }

  /** Fills in the rows of new pairs, after the others have moved. */
  void startNew(int count, BodyStore of, ParallelFor parallel) {
    bodies = of;
    parallel.run(0, count, START_GRAIN, starting);
  }

  private void start(int from, int to) {
    for (int i = from; i < to; i++) {
      table.start(shifts.inserted[i], candidates[i], bodies, parts);
    }
  }

  /** Returns the number of rows after the merge. */
  int rowCount() {
    return rowCount;
  }

  private void look(int from, int to) {
    int next = firstAfter(from);
    int end = to == table.count() ? candidateCount : firstAfter(to);
    int range = RANGE * (from / GRAIN);
    ranges[range + END] = to;
    ranges[range + FIRST_NEW] = next;
    int fresh = next;
    int gone = from;
    long last = -1;
    for (int row = from; row < to; row++) {
      long own = table.key[row];
      long k = next < end ? candidates[next] : Long.MAX_VALUE;
      while (k < own) {
        fresh = addNew(k, last, row, range, fresh);
        next++;
        k = next < end ? candidates[next] : Long.MAX_VALUE;
      }
      next += k == own ? 1 : 0; // most pairs that are found have rows, and which is not predicted
      last = own;
      leaving[gone] = row;
      gone += stays(row) ? 0 : 1;
    }
    for (; next < end; next++) {
      fresh = addNew(candidates[next], last, to, range, fresh);
    }
    ranges[range + LEAVING] = gone - from;
    ranges[range + NEW] = fresh - ranges[range + FIRST_NEW];
  }

  /** Lists a pair, unless it is that of the row before or was listed just now. */
  private int addNew(long k, long last, int row, int range, int fresh) {
    if (k == last || (fresh > ranges[range + FIRST_NEW] && candidates[fresh - 1] == k)) {
      return fresh;
    }
    candidates[fresh] = k;
    before[fresh] = row;
    return fresh + 1;
  }

  /** Returns the first candidate that belongs behind the row before this one. */
  private int firstAfter(int row) {
    if (row == 0) {
      return 0;
    }
    int found = Arrays.binarySearch(candidates, 0, candidateCount, table.key[row - 1]);
    int next = found < 0 ? -1 - found : found;
    while (next < candidateCount && candidates[next] == table.key[row - 1]) {
      next++;
    }
    return next;
  }

  private boolean stays(int row) {
    byte flags = table.flags[row];
    if ((flags & ContactTable.TOUCHING) != 0) {
      return true;
    }
    if ((flags & ContactTable.IGNORED) != 0) {
      return false;
    }
    int a = table.part[2 * row];
    int b = table.part[2 * row + 1];
    return !(all || parts.moved[a] || parts.moved[b]) || parts.fat.overlaps(a, b);
  }

  /** Turns the lists of the ranges into shifts; returns the number of new pairs. */
  private int note() {
    int rows = table.count();
    int to = 0;
    int row = 0;
    int fresh = 0;
    int from = 0;
    do {
      int range = RANGE * (from / GRAIN);
      int gone = from;
      int goneEnd = from + ranges[range + LEAVING];
      int come = ranges[range + FIRST_NEW];
      int comeEnd = come + ranges[range + NEW];
      while (gone < goneEnd || come < comeEnd) {
        boolean comes = come < comeEnd && (gone == goneEnd || before[come] <= leaving[gone]);
        int next = comes ? before[come] : leaving[gone];
        shifts.keep(row, next - row, to);
        to += next - row;
        row = next;
        if (comes) {
          candidates[fresh] = candidates[come++];
          shifts.insert(fresh++, to++);
        } else {
          gone++;
          row++;
        }
      }
      from = ranges[range + END];
    } while (from < rows);
    shifts.keep(row, rows - row, to);
    rowCount = to + rows - row;
    return fresh;
  }
}
