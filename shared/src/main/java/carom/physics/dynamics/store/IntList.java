package carom.physics.dynamics.store;

import java.util.Arrays;

/** A list of integers that grows as needed and keeps its memory when it is emptied. */
public final class IntList {
  /** The integers, the first {@link #count} entries; replaced when the list grows. */
  public int[] values = new int[64];

  /** Number of entries; set it to 0 to empty the list. */
  public int count;

  /** Makes an empty list. */
  public IntList() {}

  /** Appends a value. */
  public void add(int value) {
    if (count == values.length) {
      values = Arrays.copyOf(values, count * 2);
    }
    values[count++] = value;
  }

  /** Makes room for so many entries. What was in the list is lost if there was too little. */
  public void ensureRoom(int least) {
    if (values.length < least) {
      values = new int[2 * least];
    }
  }
}
