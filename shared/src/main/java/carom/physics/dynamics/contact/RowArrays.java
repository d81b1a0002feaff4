package carom.physics.dynamics.contact;

import java.lang.reflect.Array;
import java.util.Arrays;

/**
 * Arrays of a table that its copies share. A copy is made by {@link #share} and costs nothing. A
 * table that is about to write takes arrays of its own first, if another one still has these. So a
 * world that is saved in every step copies its rows once a step at most, and not at all where rows
 * move anyway.
 *
 * <p>Arrays that no copy needs any longer are used again, so that saving and stepping in turns
 * allocates nothing. What is garbage without having been {@linkplain #release released}, as the
 * state of a world that was thrown away, costs a copy more and nothing else.
 *
 * <p>One thread writes, shares and releases; others may read what they share meanwhile.
 */
final class RowArrays {
  private final int[] strides;
  private final Object[] arrays;
  private final Spares spares;
  private int capacity;
  private int holders = 1;

  /** The arrays that one world and its states no longer need. */
  private static final class Spares {
    private RowArrays[] list = new RowArrays[2];
    private int count;
  }

  /**
   * Makes arrays of their own.
   *
   * @param strides how many elements of each array belong to a row
   * @param empty an array of each type, of which the type alone counts
   */
  public RowArrays(int capacity, int[] strides, Object... empty) {
    this(capacity, strides, new Spares(), empty);
  }

  private RowArrays(int capacity, int[] strides, Spares spares, Object[] like) {
    this.capacity = capacity;
    this.strides = strides;
    this.spares = spares;
    arrays = new Object[like.length];
    for (int i = 0; i < arrays.length; i++) {
      arrays[i] = make(like[i], capacity * strides[i]);
    }
  }

  private static Object make(Object like, int length) {
    return Array.newInstance(like.getClass().getComponentType(), length);
  }

  /** Returns one of the arrays, which may be written only while it isn't {@link #shared}. */
  public Object array(int i) {
    return arrays[i];
  }

  /** Returns the number of rows that there is room for. */
  public int capacity() {
    return capacity;
  }

  /** Returns the capacity that holds a number of rows: the present one, or at least its double. */
  public int room(int least) {
    return least <= capacity ? capacity : Math.max(least, 2 * capacity);
  }

  /** Returns whether a copy shares these arrays, so that they must not be written. */
  public boolean shared() {
    return holders > 1;
  }

  /** Hands the arrays to a copy, which must release those it had. */
  public RowArrays share() {
    holders++;
    return this;
  }

  /** Gives the arrays back; a table that no longer needs them calls it once. */
  public void release() {
    if (--holders == 0) {
      if (spares.count == spares.list.length) {
        spares.list = Arrays.copyOf(spares.list, 2 * spares.count);
      }
      spares.list[spares.count++] = this;
    }
  }

  /**
   * Returns arrays to write to, with the same rows: these, unless they are shared.
   *
   * @param count rows in use; the others mean nothing
   * @param least rows to have room for
   */
  public RowArrays own(int count, int least) {
    if (!shared()) {
      grow(least);
      return this;
    }
    RowArrays own = another(least);
    for (int i = 0; i < arrays.length; i++) {
      System.arraycopy(arrays[i], 0, own.arrays[i], 0, count * strides[i]);
    }
    release();
    return own;
  }

  /**
   * Returns arrays to write to, with the same rows in other places once the moves are carried out.
   *
   * @param shifts tells of rows that stay, too, if these are shared; is to do the rest
   * @param least rows to have room for
   */
  public RowArrays moved(RowShifts shifts, int least) {
    RowArrays to = this;
    if (shared()) {
      to = another(least);
      release();
    } else {
      grow(least);
    }
    for (int i = 0; i < arrays.length; i++) {
      shifts.plan(arrays[i], to.arrays[i], strides[i]);
    }
    return to;
  }

  private RowArrays another(int least) {
    int enough = Math.max(least, capacity);
    while (spares.count > 0) {
      RowArrays spare = spares.list[--spares.count];
      spares.list[spares.count] = null;
      if (spare.capacity >= enough) {
        spare.holders = 1;
        return spare;
      }
    }
    return new RowArrays(enough, strides, spares, arrays);
  }

  private void grow(int least) {
    if (least <= capacity) {
      return;
    }
    capacity = least;
    for (int i = 0; i < arrays.length; i++) {
      Object grown = make(arrays[i], capacity * strides[i]);
      System.arraycopy(arrays[i], 0, grown, 0, Array.getLength(arrays[i]));
      arrays[i] = grown;
    }
  }
}
