package carom.physics.dynamics.body;

import java.util.Arrays;

/**
 * The bodies that are awake and not static: all that a step looks at. Their order depends on what
 * happened before, so no result may depend on it.
 */
public final class ActiveBodies {
  private static final int FIRST_CAPACITY = 64;

  /** The slots of the bodies, the first {@link #count} entries. */
  public int[] list = new int[FIRST_CAPACITY];

  /** The place of each slot's body in the list, -1 if it isn't there. */
  public int[] index = new int[0];

  /** Number of bodies in the list. */
  public int count;

  private int version;

  /** Returns a number that changes with every body that comes or goes. */
  public int version() {
    return version;
  }

  /** Makes room for the slots below a number; new ones are not in the list. */
  public void reserve(int slots) {
    if (index.length < slots) {
      int old = index.length;
      index = Arrays.copyOf(index, Math.max(slots, 2 * old));
      Arrays.fill(index, old, index.length, -1);
    }
  }

  /** Returns whether a body is in the list. */
  public boolean contains(int body) {
    return index[body] >= 0;
  }

  /** Adds a body, which must not be in the list. */
  public void add(int body) {
    if (count == list.length) {
      list = Arrays.copyOf(list, count * 2);
    }
    list[count] = body;
    index[body] = count++;
    version++;
  }

  /** Removes a body, which must be in the list; the last one takes its place. */
  public void remove(int body) {
    int at = index[body];
    int last = list[--count];
    list[at] = last;
    index[last] = at;
    index[body] = -1;
    version++;
  }

  /** Empties the list. */
  public void clear() {
    count = 0;
    version++;
    Arrays.fill(index, -1);
  }
}
