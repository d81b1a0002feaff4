package carom.physics.rows;

import java.util.Arrays;

/**
 * A growing list of exact rows in one array, all at the same distance: either of one kind, or of
 * mixed kinds with room for the longest.
 *
 * <p>A row is named by its number; {@link #at} tells where its ints begin. Mutable, reused; one
 * thread; allocates only to grow.
 */
public final class Rows {
  private static final int FIRST_ROOM = 8;

  private final int stride;
  private int count;
  private int[] ints = {};

  private Rows(int stride) {
    this.stride = stride;
  }

  /** Creates an empty list of rows of one kind. */
  public static Rows of(RowKind kind) {
    return new Rows(kind.ints());
  }

  /** Creates an empty list that takes rows of all kinds. */
  public static Rows mixed() {
    return new Rows(RowKind.LONGEST);
  }

  /** Returns the number of rows. */
  public int count() {
    return count;
  }

  /** Returns where the ints of a row begin in {@link #ints}. */
  public int at(int row) {
    return row * stride;
  }

  /** Returns the rows' ints: the live array, which is replaced when the list grows. */
  public int[] ints() {
    return ints;
  }

  /**
   * Returns an int of a row.
   *
   * @param field offset that {@link BodyRow}, {@link JointRow} or {@link ContactRow} declares
   */
  public int get(int row, int field) {
    return ints[row * stride + field];
  }

  /**
   * Changes an int of a row.
   *
   * @param field offset that {@link BodyRow}, {@link JointRow} or {@link ContactRow} declares
   */
  public void set(int row, int field, int value) {
    ints[row * stride + field] = value;
  }

  /** Removes all rows. */
  public void clear() {
    count = 0;
  }

  /**
   * Adds a row of zeros.
   *
   * @return where its ints begin
   */
  public int add() {
    resize(count + 1);
    int at = at(count - 1);
    Arrays.fill(ints, at, at + stride, 0);
    return at;
  }

  /**
   * Adds a copy of a row.
   *
   * @param kind of the row; the list's own kind, unless it is mixed
   * @param from holds the row
   * @param at where it begins
   */
  public void add(RowKind kind, int[] from, int at) {
    resize(count + 1);
    System.arraycopy(from, at, ints, at(count - 1), kind.ints());
  }

  /**
   * Copies a row of another list over one of this.
   *
   * @param from a list of the same kind, or mixed as this
   */
  public void set(int row, Rows from, int fromRow) {
    System.arraycopy(from.ints, from.at(fromRow), ints, at(row), stride);
  }

  /** Takes over all rows of another list of the same kind, or mixed as this. */
  public void set(Rows from) {
    resize(from.count);
    System.arraycopy(from.ints, 0, ints, 0, at(count));
  }

  /** Changes the number of rows. Rows that are new hold anything. */
  public void resize(int rows) {
    count = rows;
    if (at(rows) > ints.length) {
      ints = Arrays.copyOf(ints, Math.max(at(Math.max(rows, FIRST_ROOM)), 2 * ints.length));
    }
  }
}
