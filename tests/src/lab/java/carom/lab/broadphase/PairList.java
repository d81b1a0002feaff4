package carom.lab.broadphase;

import carom.physics.broadphase.PairVisitor;
import java.util.Arrays;

/** A growing list of the pairs of ids that a search finds. */
final class PairList implements PairVisitor {
  private static final int MOST = 1 << 30;

  /**
   * The pairs, idA in the upper 32 bits and idB in the lower; the first {@link #count} are valid.
   */
  long[] list = new long[64];

  int count;

  void clear() {
    count = 0;
  }

  @Override
  public void pair(int idA, int idB) {
    ensure(1);
    list[count++] = (long) idA << 32 | idB;
  }

  /** Adds some pairs of another list, given by their indexes. */
  void addFrom(PairList other, int[] which, int more) {
    ensure(more);
    for (int i = 0; i < more; i++) {
      list[count + i] = other.list[which[i]];
    }
    count += more;
  }

  private void ensure(int more) {
    if (count + more > list.length) {
      if (count + more > MOST) {
        throw new IllegalStateException(
            "pairs=" + (count + more) + ", limit " + MOST + "; so many boxes can't all overlap");
      }
      list = Arrays.copyOf(list, Math.max(count + more, count + (count >> 1)));
    }
  }
}
