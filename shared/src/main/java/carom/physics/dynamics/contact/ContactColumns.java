package carom.physics.dynamics.contact;

import carom.physics.dynamics.store.ParallelFor;
import carom.physics.dynamics.store.Stamp;
import java.util.Arrays;

/**
 * The storage of a {@link ContactTable}: which numbers a row has and where they are, and how copies
 * of a table share them.
 *
 * <pre>
 *   "pairs": which parts; changes       "touches": changes in every step
 *   when rows come or go
 *   +-----+---------+------------+      +-------+--------+---------+---------------+------+
 *   | key | part A  | material   |      | flags | points | id 0    | contact       | roll |
 *   |     | part B  | 6 floats   |      |       | 0..2   | id 1    | 16 floats     |      |
 *   +-----+---------+------------+      +-------+--------+---------+---------------+------+
 *
 *   contact[{@value #CONTACT} * row + ...]
 *   +----+----+----+----+------+----+----+------+---------+----------+--------+--------+-- ...
 *   | NX | NY | X0 | Y0 | GAP0 | X1 | Y1 | GAP1 | NORMAL0 | TANGENT0 | TOTAL0 | SLIDE0 | same of 1
 *   +----+----+----+----+------+----+----+------+---------+----------+--------+--------+-- ...
 *     normal     point 0          point 1         impulses of point 0
 * </pre>
 *
 * <p>Rows are dense and ascend by key, so every pass streams through memory in the canonical order.
 * Copies share both groups of arrays ({@link RowArrays}): saving costs nothing, and the first that
 * writes pays. Therefore a method that writes must first call {@link #beginUpdate} (for "touches")
 * or {@link #beginRowChange} (for both); the stages of a step do so once for all rows.
 *
 * <p>The arrays are replaced when the table grows or is copied; no stage keeps one for the next.
 */
abstract class ContactColumns {
  /** Flag: the parts touch. Unless one is a sensor, the manifold has points. */
  public static final byte TOUCHING = 1;

  /** Flag: a callback refused the response in this step. */
  public static final byte VETOED = 2;

  /** Flag: the parts touched in the step before. */
  public static final byte WAS_TOUCHING = 4;

  /** Flag: one of the parts is a sensor. The row then has no points, and no response. */
  static final byte SENSOR = 8;

  /** Flag: since a change, filters, joints or the bodies' types keep the parts from touching. */
  public static final byte IGNORED = 16;

  /** Flag: the step before pushed the parts apart. Tells impacts only and is not hashed. */
  public static final byte WAS_PUSHED = 64;

  /** Flag: the row came after rows were last updated. */
  public static final byte FRESH = 32;

  /** Flag: neither body is dynamic and awake, so there is nothing to solve. */
  public static final byte DORMANT = -128;

  /** Number of floats per row in {@link #contact}; 64 bytes, one cache line. */
  public static final int CONTACT = 16;

  /** Place of the x of the unit normal from A to B. */
  public static final int NX = 0;

  /** Place of the y of the unit normal from A to B. */
  public static final int NY = 1;

  /** Place of point 0's x, relative to A's centre of mass, world axes, m. */
  public static final int X0 = 2;

  /** Place of point 0's y, relative to A's centre of mass, world axes, m. */
  public static final int Y0 = 3;

  /** Place of point 0's gap, m; negative if the parts overlap. */
  public static final int GAP0 = 4;

  /** Place of point 1's x, relative to A's centre of mass, world axes, m. */
  public static final int X1 = 5;

  /** Place of point 1's y, relative to A's centre of mass, world axes, m. */
  public static final int Y1 = 6;

  /** Place of point 1's gap, m; negative if the parts overlap. */
  public static final int GAP1 = 7;

  /** Place of the normal impulse that point 0 starts the next step with, N s per substep. */
  public static final int NORMAL0 = 8;

  /** Place of the friction impulse that point 0 starts the next step with, N s per substep. */
  public static final int TANGENT0 = 9;

  /** Place of point 0's normal impulse over the whole step, N s. */
  public static final int TOTAL0 = 10;

  /** Place of point 0's friction impulse over the whole step, N s. */
  public static final int SLIDE0 = 11;

  /** Place of the normal impulse that point 1 starts the next step with, N s per substep. */
  public static final int NORMAL1 = 12;

  /** Place of the friction impulse that point 1 starts the next step with, N s per substep. */
  public static final int TANGENT1 = 13;

  /** Place of point 1's normal impulse over the whole step, N s. */
  public static final int TOTAL1 = 14;

  /** Place of point 1's friction impulse over the whole step, N s. */
  public static final int SLIDE1 = 15;

  /** Number of floats per row in {@link #material}. */
  public static final int MATERIAL = 6;

  /** Place of the mixed Coulomb coefficient. */
  public static final int FRICTION = 0;

  /** Place of the mixed restitution, speed after by speed before. */
  public static final int RESTITUTION = 1;

  /** Place of the torque against rolling per normal force, m. */
  public static final int ROLLING = 2;

  /** Place of both surfaces' speed together, along the normal turned right, m/s. */
  public static final int SURFACE = 3;

  /** Place of the radius of part A's rounding, m. */
  public static final int ROUND_A = 4;

  /** Place of the radius of part B's rounding, m. */
  public static final int ROUND_B = 5;

  private static final int FIRST_CAPACITY = 128;

  /** The {@link ContactKey} of each row, ascending. */
  public long[] key;

  /** Two per row: the part of A, and that of B. */
  public int[] part;

  /** The mixed materials of both parts, {@value #MATERIAL} floats per row. */
  public float[] material;

  /** The flags of each row, added up. */
  public byte[] flags;

  /** The number of points of each row, 0, 1 or 2. */
  public byte[] points;

  /** Two per row: the feature ids of the points. */
  public int[] id;

  /** The numbers that steps change, {@value #CONTACT} floats per row. */
  public float[] contact;

  /** The impulse against rolling that each row starts the next step with, N m s per substep. */
  public float[] roll;

  /** Face where the last search ended, by row. Changes no result, so it isn't saved. */
  public int[] hint = new int[FIRST_CAPACITY];

  /** The manifolds of earlier steps. They change no result, so they aren't saved. */
  public final KeptManifolds kept = new KeptManifolds();

  /** True once a row resisted rolling; {@link #bouncy} is true once one had restitution. */
  boolean rolls;

  boolean bouncy;

  /** Shifts of rows, which make room for others or close gaps. */
  final RowShifts shifts = new RowShifts();

  /** The arrays that change when rows come or go. Copies share them. */
  private RowArrays pairs =
      new RowArrays(
          FIRST_CAPACITY, new int[] {1, 2, MATERIAL}, new long[0], new int[0], new float[0]);

  /** The arrays that a step changes. Copies share them. */
  private RowArrays touches =
      new RowArrays(
          FIRST_CAPACITY,
          new int[] {1, 1, 2, CONTACT, 1},
          new byte[0],
          new byte[0],
          new int[0],
          new float[0],
          new float[0]);

  /** Tells whether two tables have the same pairs. */
  private final Stamp pairsStamp = new Stamp();

  private int count;
  private int version;

  ContactColumns() {
    bind();
  }

  /** Takes the arrays from the groups, after one of these was replaced. */
  private void bind() {
    key = (long[]) pairs.array(0);
    part = (int[]) pairs.array(1);
    material = (float[]) pairs.array(2);
    flags = (byte[]) touches.array(0);
    points = (byte[]) touches.array(1);
    id = (int[]) touches.array(2);
    contact = (float[]) touches.array(3);
    roll = (float[]) touches.array(4);
  }

  // ---------------------------------------------------------------- reading

  /** Returns the number of rows. */
  public final int count() {
    return count;
  }

  /** Returns a number that changes whenever rows came, went, or were written. */
  public final int version() {
    return version;
  }

  /** Returns the slot of the body with the smaller index. */
  public final int bodyA(int row) {
    return ContactKey.bodyA(key[row]);
  }

  /** Returns the slot of the body with the larger index. */
  public final int bodyB(int row) {
    return ContactKey.bodyB(key[row]);
  }

  /** Returns the part of body A, a number of the shape table. */
  public final int partA(int row) {
    return part[2 * row];
  }

  /** Returns the part of body B, a number of the shape table. */
  public final int partB(int row) {
    return part[2 * row + 1];
  }

  /** Returns whether one of the parts is a sensor, so that there is no response. */
  public final boolean sensor(int row) {
    return (flags[row] & SENSOR) != 0;
  }

  /** Returns the number of contact points: 0, 1 or 2. */
  public final int points(int row) {
    return points[row];
  }

  /** Returns the x of the unit normal from A to B. */
  public final float normalX(int row) {
    return contact[row * CONTACT + NX];
  }

  /** Returns the y of the unit normal from A to B. */
  public final float normalY(int row) {
    return contact[row * CONTACT + NY];
  }

  /** Returns the mixed Coulomb coefficient. */
  public final float friction(int row) {
    return material[row * MATERIAL + FRICTION];
  }

  /** Returns the mixed restitution, speed after by speed before. */
  public final float restitution(int row) {
    return material[row * MATERIAL + RESTITUTION];
  }

  /** Returns the speed of both surfaces together, m/s. */
  public final float surface(int row) {
    return material[row * MATERIAL + SURFACE];
  }

  /** Returns the x of point 0 or 1, relative to A's centre of mass when the step began, m. */
  public final float pointX(int row, int point) {
    return contact[row * CONTACT + (point == 0 ? X0 : X1)];
  }

  /** Returns the y of point 0 or 1, relative to A's centre of mass when the step began, m. */
  public final float pointY(int row, int point) {
    return contact[row * CONTACT + (point == 0 ? Y0 : Y1)];
  }

  /** Returns the gap at point 0 or 1 when the step began, m; negative if the parts overlap. */
  public final float separation(int row, int point) {
    return contact[row * CONTACT + (point == 0 ? GAP0 : GAP1)];
  }

  /** Returns the smaller gap of the points, m; infinite if there are none. */
  public final float leastSeparation(int row) {
    if (points[row] == 0) {
      return Float.POSITIVE_INFINITY;
    }
    float gap = contact[row * CONTACT + GAP0];
    return points[row] == 1 ? gap : Math.min(gap, contact[row * CONTACT + GAP1]);
  }

  /** Returns the normal impulse at point 0 or 1 over the last step, N s. */
  public final float impulse(int row, int point) {
    return contact[row * CONTACT + (point == 0 ? TOTAL0 : TOTAL1)];
  }

  /** Returns the friction impulse at point 0 or 1 over the last step, N s. */
  public final float slide(int row, int point) {
    return contact[row * CONTACT + (point == 0 ? SLIDE0 : SLIDE1)];
  }

  /** Returns the normal impulse with which point 0 or 1 starts the next substep, N s. */
  public final float warmImpulse(int row, int point) {
    return contact[row * CONTACT + (point == 0 ? NORMAL0 : NORMAL1)];
  }

  /** Returns whether the last step, or this one once it is solved, pushed the parts apart. */
  public final boolean pushed(int row) {
    return contact[row * CONTACT + TOTAL0] > 0 || contact[row * CONTACT + TOTAL1] > 0;
  }

  /** Returns whether the parts touch; a sensor touches without points. */
  public final boolean touches(int row) {
    return (flags[row] & TOUCHING) != 0;
  }

  /** Returns whether the parts push each other if they touch. */
  public final boolean acts(int row) {
    return (flags[row] & (SENSOR | IGNORED)) == 0;
  }

  /** Returns whether the parts touch and push each other. */
  public final boolean responds(int row) {
    return (flags[row] & (TOUCHING | SENSOR | IGNORED)) == TOUCHING;
  }

  /** Returns whether a row holds no contact; never so in the table of awake bodies. */
  public final boolean unused(int row) {
    return key[row] == SleepingContacts.FREE;
  }

  /** Returns the row of a pair, negative if there is none. */
  public final int find(long pair) {
    return Arrays.binarySearch(key, 0, count, pair);
  }

  /** Lists the rows that touch, ascending; returns how many. */
  public final int touching(int[] to) {
    int found = 0;
    for (int row = 0; row < count; row++) {
      if ((flags[row] & TOUCHING) != 0) {
        to[found++] = row;
      }
    }
    return found;
  }

  /** Sorts row numbers by the rows' keys (Shell's sort: short, and needs no memory). */
  public final void sortByKey(int[] which, int n) {
    for (int gap = n / 2; gap > 0; gap = gap == 2 ? 1 : gap * 5 / 11) {
      for (int i = gap; i < n; i++) {
        int row = which[i];
        int j = i;
        for (; j >= gap && key[which[j - gap]] > key[row]; j -= gap) {
          which[j] = which[j - gap];
        }
        which[j] = row;
      }
    }
  }

  // ---------------------------------------------------------------- writing

  /** Begins to write the numbers that steps change: takes arrays of its own if they are shared. */
  public final void beginUpdate() {
    version++;
    ownTouches();
  }

  /** Begins to write all numbers, or to add and remove rows: takes arrays of its own. */
  final void beginRowChange() {
    version++;
    pairsStamp.change();
    ownPairs();
    ownTouches();
  }

  /** Notes that rows are about to move; {@link #shiftRows} will take arrays of its own. */
  final void beginShifts() {
    version++;
    realignManifolds();
    shifts.clear(pairs.shared() || touches.shared());
  }

  final void ownPairs() {
    if (pairs.shared()) {
      pairs = pairs.own(count, pairs.capacity());
      bind();
    }
  }

  final void ownTouches() {
    if (touches.shared()) {
      touches = touches.own(count, touches.capacity());
      bind();
    }
  }

  /**
   * Carries out the noted {@link #shifts}, to arrays that may be written.
   *
   * @param newCount number of rows from now on
   * @param parallel shares the work; null for the caller alone
   */
  final void shiftRows(int newCount, ParallelFor parallel) {
    pairsStamp.change();
    growCaches(Math.max(count, newCount));
    pairs = pairs.moved(shifts, pairs.room(newCount));
    touches = touches.moved(shifts, touches.room(newCount));
    bind();
    shifts.plan(hint, hint, 1);
    kept.rows().plan(shifts);
    shifts.carryOut(parallel);
    count = newCount;
  }

  /** Brings the kept manifolds to the rows' places, if a copy brought other rows. */
  final void realignManifolds() {
    growCaches(Math.max(count, kept.rows().rowsBefore()));
    kept.rows().realign(key, count, shifts);
  }

  /** Removes all rows. */
  public final void clear() {
    count = 0;
    beginRowChange();
  }

  /** Adds a row at the end, which the caller fills; returns its number. */
  public final int append() {
    reserve(count + 1);
    return count++;
  }

  /** Sets the number of rows; the caller fills them. */
  final void resize(int rowCount) {
    reserve(rowCount);
    count = rowCount;
  }

  /** Returns the number of rows that there is room for. */
  public final int capacity() {
    return hint.length;
  }

  /** Makes room for rows before they come. */
  public final void reserve(int least) {
    if (least > pairs.capacity() || least > touches.capacity()) {
      pairs = pairs.own(count, pairs.room(least));
      touches = touches.own(count, touches.room(least));
      bind();
    }
    growCaches(least);
  }

  /** Makes room for what is known of rows beside their state. */
  private void growCaches(int least) {
    if (least > hint.length) {
      int grown = Math.max(least, 2 * hint.length);
      hint = Arrays.copyOf(hint, grown);
      kept.rows().grow(grown);
      shifts.reserve(grown);
    }
  }

  // ---------------------------------------------------------------- copies

  /** Makes another table a copy of this one. Both share the rows until one of them writes. */
  public final void copyTo(ContactColumns to) {
    touches.share();
    to.touches.release();
    to.touches = touches;
    if (!pairsStamp.same(to.pairsStamp)) {
      to.kept.rows().rowsReplaced(to.pairs, to.count);
      pairsStamp.copyTo(to.pairsStamp);
    }
    pairs.share();
    to.pairs.release();
    to.pairs = pairs;
    to.count = count;
    to.bind();
    to.rolls = rolls;
    to.bouncy = bouncy;
    to.version++;
  }

  /** Makes a copy that was read from an archive differ from all that were copied from this. */
  public final void distinguish(ContactColumns copy) {
    pairsStamp.distinguish(copy.pairsStamp);
  }
}
