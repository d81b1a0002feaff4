package carom.physics.dynamics.contact;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.store.ParallelFor;

/**
 * Adds and removes rows of a {@link ContactTable} and keeps them in the order of their keys.
 *
 * <pre>
 *   rows            2  5  6  9            the parts of 6 are no longer close
 *   candidates      3  5  11              from the broadphase; 5 has a row
 *                    \      \
 *   rows            2  3  5  9  11        each row moves at most once, neighbours together
 * </pre>
 *
 * <p>Every change is planned first ({@link RowShifts}) and then carried out array by array, in
 * place unless a copy shares the arrays.
 */
public final class RowOrder {
  private final ContactTable table;
  private final RowShifts shifts;
  private final RowMerge merge;

  RowOrder(ContactTable table) {
    this.table = table;
    shifts = table.shifts;
    merge = new RowMerge(table);
  }

  /**
   * Removes the rows that neither touch nor have overlapping fat boxes, and adds rows for new
   * pairs.
   *
   * @param candidates keys in ascending order; those already present and repetitions are skipped;
   *     new ones are brought to the front
   * @param candidateCount number of keys
   * @param all whether to look at every row, or only at those of parts that {@link
   *     ShapeTable#moved}
   * @param parallel shares the work
   */
  public void merge(
      long[] candidates,
      int candidateCount,
      BodyStore bodies,
      ShapeTable parts,
      boolean all,
      ParallelFor parallel) {
    table.beginShifts();
    int fresh = merge.find(candidates, candidateCount, parts, all, parallel, shifts);
    if (fresh == 0 && merge.rowCount() == table.count()) {
      return;
    }
    table.shiftRows(merge.rowCount(), parallel);
    merge.startNew(fresh, bodies, parallel);
  }

  /**
   * Adds copies of another table's rows, which this table must not have yet.
   *
   * @param from the other table
   * @param which rows of it, by ascending key
   * @param n how many
   */
  public void insert(ContactTable from, int[] which, int n) {
    table.beginShifts();
    int count = table.count();
    int next = 0;
    for (int row = 0; row <= count; row++) {
      for (; next < n && (row == count || from.key[which[next]] < table.key[row]); next++) {
        shifts.insert(next, row + next);
      }
      if (row < count) {
        shifts.keep(row, row + next);
      }
    }
    table.shiftRows(count + n, null);
    table.copyRows(from, which, shifts.inserted, n);
    for (int i = 0; i < n; i++) {
      int to = shifts.inserted[i];
      table.flags[to] = (byte) ((table.flags[to] & ~ContactTable.DORMANT) | ContactTable.FRESH);
    }
  }

  /**
   * Makes pairs touch that include a sensor, and adds rows for those that have none.
   *
   * @param keys ascending, each once
   * @param n how many
   */
  public void touch(long[] keys, int n, BodyStore bodies, ShapeTable parts) {
    table.beginUpdate();
    table.beginShifts();
    int count = table.count();
    int fresh = 0;
    int from = 0;
    for (int i = 0; i < n; i++) {
      int row = table.find(keys[i]);
      if (row >= 0) {
        table.flags[row] = ContactTable.SENSOR | ContactTable.TOUCHING;
      } else {
        shifts.keep(from, -1 - row - from, from + fresh);
        from = -1 - row;
        shifts.insert(fresh, from + fresh);
        fresh++;
        keys[i] = ~keys[i]; // marks it until its row is filled in
      }
    }
    shifts.keep(from, count - from, from + fresh);
    table.shiftRows(count + fresh, null);
    fresh = 0;
    for (int i = 0; i < n; i++) {
      if (keys[i] < 0) {
        keys[i] = ~keys[i];
        int row = shifts.inserted[fresh++];
        table.start(row, keys[i], bodies, parts);
        table.flags[row] = ContactTable.SENSOR | ContactTable.TOUCHING;
      }
    }
  }

  /** Moves the touching rows of sleeping bodies to another store, and removes their other rows. */
  public void retire(BodyStore bodies, SleepingContacts to) {
    table.beginShifts();
    int[] retired = table.rowNumbers();
    int gone = 0;
    int kept = 0;
    for (int row = 0; row < table.count(); row++) {
      if (!SleepingContacts.belongs(bodies, table.bodyA(row), table.bodyB(row))) {
        shifts.keep(row, kept++);
      } else if ((table.flags[row] & ContactTable.TOUCHING) != 0) {
        retired[gone++] = row;
      }
    }
    to.put(table, retired, gone);
    table.shiftRows(kept, null);
  }

  /** Removes the rows of a body's parts with numbers from one on, to before another one. */
  public void removeParts(int body, int from, int to) {
    table.beginShifts();
    int kept = 0;
    for (int row = 0; row < table.count(); row++) {
      if (!table.isOfParts(row, body, from, to)) {
        shifts.keep(row, kept++);
      }
    }
    table.shiftRows(kept, null);
  }
}
