package carom.physics.dynamics.contact;

import carom.physics.archive.Archive;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.math.StateHash;
import java.util.Arrays;

/**
 * The touching contacts of sleeping bodies, kept so that the bodies wake as they fell asleep.
 *
 * <p>A contact is here if one of its bodies sleeps and the other one sleeps, too, or is static. No
 * step looks at these rows, however many there are. Each body has a list of its contacts, so waking
 * a body costs time in proportion to its own.
 *
 * <pre>
 *   body 3:  first --&gt; end 8 --&gt; end 5 --&gt; -1        row r has two ends:
 *   body 7:  first --&gt; end 9 --&gt; -1                  2r in the list of body A, 2r + 1 in that of B
 * </pre>
 *
 * <p>Rows are slots that are reused. Their numbers and the order of the lists depend on the past,
 * so code that takes rows out sorts them by {@link ContactKey}.
 */
public final class SleepingContacts {
  /** Key of a free row. */
  static final long FREE = -1;

  private static final int FIRST_CAPACITY = 64;

  /** The rows; some are unused. */
  public final ContactTable rows = new ContactTable();

  /** Per end: its neighbours in the list of its body, -1 for none. */
  private int[] next = new int[2 * FIRST_CAPACITY];

  private int[] previous = new int[2 * FIRST_CAPACITY];

  /** Per body: the first end, -1 for none. */
  private int[] first = new int[0];

  private int[] freeRows = new int[FIRST_CAPACITY];
  private int freeCount;

  /** The hash of the rows, as of {@link #hashedVersion}. */
  private long hash;

  private int hashedVersion = -1;

  /** Scratch: rows that are given out. */
  private int[] taken = new int[FIRST_CAPACITY];

  /** Returns whether the contacts of two bodies belong here. */
  public static boolean belongs(BodyStore bodies, int a, int b) {
    return !bodies.active(a) && !bodies.active(b) && (bodies.asleep(a) || bodies.asleep(b));
  }

  /** Returns one more than the largest row ever used. */
  int slots() {
    return rows.count();
  }

  /** Returns the first end of a body, -1 for none. */
  public int first(int body) {
    return body < first.length ? first[body] : -1;
  }

  /** Returns the next end of the same body, -1 for none. */
  public int next(int end) {
    return next[end];
  }

  /** Returns the body at the other end. */
  public int other(int end) {
    return (end & 1) == 0 ? rows.bodyB(end >> 1) : rows.bodyA(end >> 1);
  }

  /** Returns whether the row of an end ties its bodies together. */
  public boolean solid(int end) {
    int row = end >> 1;
    return rows.points[row] > 0 && (rows.flags[row] & ContactTable.VETOED) == 0;
  }

  /** Makes room for rows and for the lists of bodies. */
  public void reserve(int least, int bodies) {
    rows.reserve(least);
    if (2 * least > next.length) {
      next = Arrays.copyOf(next, Math.max(2 * least, 2 * next.length));
      previous = Arrays.copyOf(previous, next.length);
      freeRows = Arrays.copyOf(freeRows, next.length / 2);
      taken = new int[freeRows.length];
    }
    if (bodies > first.length) {
      int old = first.length;
      first = Arrays.copyOf(first, Math.max(bodies, 2 * old));
      Arrays.fill(first, old, first.length, -1);
    }
  }

  /** Adds copies of another table's rows. */
  void put(ContactTable from, int[] which, int n) {
    reserve(slots() + Math.max(0, n - freeCount), 0);
    if (taken.length < freeRows.length) { // they came with a copy
      taken = new int[freeRows.length];
    }
    for (int i = 0; i < n; i++) {
      taken[i] = freeCount > 0 ? freeRows[--freeCount] : rows.append();
    }
    rows.beginRowChange();
    rows.copyRows(from, which, taken, n);
    for (int i = 0; i < n; i++) {
      link(2 * taken[i], rows.bodyA(taken[i]));
      link(2 * taken[i] + 1, rows.bodyB(taken[i]));
    }
  }

  private void link(int end, int body) {
    reserve(0, body + 1);
    int after = first[body];
    next[end] = after;
    previous[end] = -1;
    if (after >= 0) {
      previous[after] = end;
    }
    first[body] = end;
  }

  /** Takes a row out of the lists of its bodies; it stays as it is until it is released. */
  public void unlink(int row) {
    unlink(2 * row, rows.bodyA(row));
    unlink(2 * row + 1, rows.bodyB(row));
  }

  private void unlink(int end, int body) {
    int before = previous[end];
    int after = next[end];
    if (before < 0) {
      first[body] = after;
    } else {
      next[before] = after;
    }
    if (after >= 0) {
      previous[after] = before;
    }
  }

  /** Frees an unlinked row. */
  public void release(int row) {
    rows.beginRowChange();
    rows.key[row] = FREE;
    rows.flags[row] = 0;
    freeRows[freeCount++] = row;
  }

  /** Adds all rows to a hash, independent of their numbers; without any, returns it as it is. */
  public long hash(long h) {
    if (freeCount == slots()) {
      return h;
    }
    if (rows.version() != hashedVersion) {
      hash = rows.hash(StateHash.SEED);
      hashedVersion = rows.version();
    }
    return StateHash.mix(h, hash);
  }

  /**
   * Copies everything into another store, which grows as needed; allocates only then.
   *
   * @return the bytes that were copied
   */
  public long copyTo(SleepingContacts to) {
    rows.copyTo(to.rows);
    if (to.next.length < next.length) {
      to.next = new int[next.length];
      to.previous = new int[next.length];
      to.freeRows = new int[next.length / 2];
    }
    System.arraycopy(next, 0, to.next, 0, 2 * slots());
    System.arraycopy(previous, 0, to.previous, 0, 2 * slots());
    if (to.first.length < first.length) {
      to.first = new int[first.length];
    }
    System.arraycopy(first, 0, to.first, 0, first.length);
    Arrays.fill(to.first, first.length, to.first.length, -1);
    System.arraycopy(freeRows, 0, to.freeRows, 0, freeCount);
    to.freeCount = freeCount;
    return (4L * slots() + first.length + freeCount) * Integer.BYTES;
  }

  /** Passes all rows through an archive; reading begins with an empty store. */
  public void pass(Archive a, BodyStore bodies, ShapeTable parts) {
    ContactTable packed = new ContactTable();
    int[] which = new int[slots() + 1];
    int used = 0;
    for (int row = 0; row < slots(); row++) {
      which[used] = row;
      used += rows.unused(row) ? 0 : 1;
    }
    rows.sortByKey(which, used);
    packed.take(rows, which, used);
    ContactArchive.pass(packed, a, bodies, parts);
    if (a.reads()) {
      which = new int[packed.count()];
      for (int row = 0; row < which.length; row++) {
        which[row] = row;
        int bodyA = packed.bodyA(row);
        int bodyB = packed.bodyB(row);
        a.require(
            belongs(bodies, bodyA, bodyB) && !bodies.disabled(bodyA) && !bodies.disabled(bodyB),
            "contact=" + row + " doesn't sleep");
      }
      put(packed, which, which.length);
    }
  }
}
