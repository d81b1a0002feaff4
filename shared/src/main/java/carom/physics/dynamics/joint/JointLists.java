package carom.physics.dynamics.joint;

import carom.physics.math.StateHash;
import java.util.Arrays;

/**
 * Lists of each body's joints. Joint j has two ends, 2 j at body A and 2 j + 1 at body B; each end
 * points to the next one of the same body, by descending ends. So the order follows from the joints
 * alone, and another world with the same joints has the same lists.
 */
final class JointLists {
  /** Per end: the next end of a joint of the same body, -1 for none. */
  private int[] next;

  /** Per body: the first end, -1 for none. */
  private int[] first = new int[0];

  /** Makes empty lists with room for some joints. */
  JointLists(int capacity) {
    next = new int[2 * capacity];
  }

  /** Makes room for some joints in all. */
  void reserve(int capacity) {
    next = Arrays.copyOf(next, 2 * capacity);
  }

  /** Returns the first end of a body, -1 for none. */
  int first(int body) {
    return body < first.length ? first[body] : -1;
  }

  /** Returns the end behind another one of the same body, -1 for none. */
  int next(int end) {
    return next[end];
  }

  /** Returns a bound of the bodies that have joints. */
  int bodies() {
    return first.length;
  }

  /**
   * Puts an end into the list of a body, or into none if the body is negative. Takes as long as the
   * body has joints of larger slots.
   */
  void link(int end, int body) {
    next[end] = -1;
    if (body < 0) {
      return;
    }
    if (body >= first.length) {
      int old = first.length;
      first = Arrays.copyOf(first, Math.max(body + 1, 2 * old));
      Arrays.fill(first, old, first.length, -1);
    }
    if (first[body] < end) {
      next[end] = first[body];
      first[body] = end;
      return;
    }
    int before = first[body];
    while (next[before] > end) {
      before = next[before];
    }
    next[end] = next[before];
    next[before] = end;
  }

  /** Takes an end out of the list of a body. */
  void unlink(int end, int body) {
    if (body < 0) {
      return;
    }
    if (first[body] == end) {
      first[body] = next[end];
      return;
    }
    int before = first[body];
    while (next[before] != end) {
      before = next[before];
    }
    next[before] = next[end];
  }

  /** Begins to read lists: there are none yet. */
  void clear(int bodies) {
    first = new int[bodies];
    Arrays.fill(first, -1);
  }

  /** Reads an end that is the first one of a body. */
  void setFirst(int body, int end) {
    first[body] = end;
    next[end] = -1;
  }

  /** Reads an end that comes behind the last one so far of the same body. */
  void setNext(int last, int end) {
    next[last] = end;
    next[end] = -1;
  }

  /** Mixes all lists into a hash. */
  long hash(long h) {
    for (int end : first) {
      for (int e = end; e >= 0; e = next[e]) {
        h = StateHash.mix(h, e);
      }
    }
    return h;
  }

  /**
   * Copies the lists of so many joints.
   *
   * @return the bytes that were copied
   */
  long copyTo(JointLists to, int joints) {
    System.arraycopy(next, 0, to.next, 0, 2 * joints);
    if (to.first.length < first.length) {
      to.first = new int[first.length];
    }
    System.arraycopy(first, 0, to.first, 0, first.length);
    Arrays.fill(to.first, first.length, to.first.length, -1);
    return (2L * joints + first.length) * Integer.BYTES;
  }
}
