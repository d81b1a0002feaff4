package carom.lab.trace;

import java.util.Arrays;

/** A hashed grid that finds points in the plane by place. It is filled anew for each snapshot. */
final class Grid {
  private static final int MIN_SHIFT = 4;
  private static final int MAX_SHIFT = 22;

  private final int count;
  private final int[] head;
  private final int[] next;
  private int[] xs;
  private int[] ys;
  private int shift = 8;

  Grid(int count) {
    this.count = count;
    head = new int[Math.max(64, 2 * Integer.highestOneBit(count))];
    next = new int[count];
  }

  /** Returns log2 of a cell's side in steps. */
  int shift() {
    return shift;
  }

  /** Fills the grid. The arrays of the points must not change while the grid is searched. */
  void fill(int[] newXs, int[] newYs) {
    xs = newXs;
    ys = newYs;
    Arrays.fill(head, -1);
    for (int i = count - 1; i >= 0; i--) {
      int h = hash(xs[i] >> shift, ys[i] >> shift);
      next[i] = head[h];
      head[h] = i;
    }
  }

  /**
   * Chooses the smallest cells of which the points use at most half as many as there are points.
   */
  void fit(int[] newXs, int[] newYs) {
    shift = MIN_SHIFT - 1;
    int used;
    do {
      shift++;
      fill(newXs, newYs);
      used = 0;
      for (int h : head) {
        used += h >= 0 ? 1 : 0;
      }
    } while (2 * used > count && shift < MAX_SHIFT);
  }

  private int hash(int cellX, int cellY) {
    int h = cellX * 0x9e3779b1 + cellY * 0x85ebca77;
    return (h ^ h >>> 15) & head.length - 1;
  }

  /**
   * Finds the points within a square, in no order that matters.
   *
   * @param out at least as long as there are points
   * @return the number of points found
   */
  int query(int x, int y, int reach, int[] out) {
    int found = 0;
    int x1 = x + reach >> shift;
    int y1 = y + reach >> shift;
    for (int cellY = y - reach >> shift; cellY <= y1; cellY++) {
      for (int cellX = x - reach >> shift; cellX <= x1; cellX++) {
        for (int i = head[hash(cellX, cellY)]; i >= 0; i = next[i]) {
          // Other cells may share the list, so the place is checked.
          if (xs[i] >> shift == cellX && ys[i] >> shift == cellY) {
            out[found++] = i;
          }
        }
      }
    }
    return found;
  }
}
