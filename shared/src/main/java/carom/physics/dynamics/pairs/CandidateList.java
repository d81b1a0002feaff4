package carom.physics.dynamics.pairs;

import carom.physics.broadphase.IntVisitor;
import carom.physics.broadphase.PairVisitor;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.store.KeySorter;
import java.util.Arrays;

/**
 * The keys of the pairs that one worker found, in any order and perhaps twice. The trees call back
 * with the pairs of parts whose fat boxes overlap.
 */
final class CandidateList implements PairVisitor, IntVisitor {
  /** The keys, the first {@link #count} entries. */
  long[] keys = new long[64];

  int count;

  /** The keys of one range out of all workers' lists, which this worker sorts. */
  long[] range = new long[64];

  int rangeCount;

  private final KeySorter sorter = new KeySorter();
  private final ShapeTable parts;
  private final PairFilter filter;

  /** The part whose surroundings are searched. */
  private int around;

  /** True if pairs count of which neither part moved. */
  private boolean all;

  CandidateList(ShapeTable parts, PairFilter filter) {
    this.parts = parts;
    this.filter = filter;
  }

  /**
   * Empties the list.
   *
   * @param everyPair whether pairs count of which neither part moved
   */
  void begin(boolean everyPair) {
    all = everyPair;
    count = 0;
  }

  /** Sets the part that {@link #visit} pairs others with. */
  void searchAround(int part) {
    around = part;
  }

  @Override
  public void pair(int p, int q) {
    if (!all && !parts.moved[p] && !parts.moved[q]) {
      return;
    }
    long key = filter.keyOf(p, q);
    if (key >= 0) {
      ensureCapacity(count + 1);
      keys[count++] = key;
    }
  }

  @Override
  public boolean visit(int found) {
    pair(around, found);
    return true;
  }

  /** Makes room for so many keys. */
  void ensureCapacity(int least) {
    if (least > keys.length) {
      keys = Arrays.copyOf(keys, Math.max(least, 2 * keys.length));
    }
  }

  /**
   * Collects the keys of a range from all lists, and sorts them. Without a branch, because keys
   * come in any order.
   *
   * @param lists what all workers found
   * @param from least key of the range
   * @param to least key beyond
   */
  void sortRange(CandidateList[] lists, long from, long to) {
    int n = 0;
    for (CandidateList list : lists) {
      for (int i = 0; i < list.count; i++) {
        long key = list.keys[i];
        range[n] = key;
        n += (int) ((~(key - from) & (key - to)) >>> Long.SIZE - 1);
      }
    }
    rangeCount = n;
    range = sorter.sort(range, n);
  }
}
