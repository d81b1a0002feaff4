package carom.lab.broadphase;

import carom.physics.broadphase.AabbArray;
import java.util.Arrays;

/**
 * The order of a KD-tree's leaves, found by sorting, as textbooks do: parts are cut at the median
 * of their wider extent until they hold at most {@value #LEAF} boxes. It is compared with {@link
 * carom.physics.broadphase.KdTree}, which never sorts. Both ways give the same order of parts. One
 * thread at a time; allocates only to grow.
 */
final class SortedKd {
  static final int LEAF = 8;

  private final AabbArray boxes;
  private long[] byX = new long[0];
  private long[] byY = new long[0];
  private long[] spare = new long[0];
  private boolean[] isLow = new boolean[0];

  /** Creates an order of these boxes, whose ids are 0 to count - 1. */
  SortedKd(AabbArray boxes) {
    this.boxes = boxes;
  }

  /**
   * Returns the box at a place in the order of the leaves, after a build.
   *
   * @return its id
   */
  int at(int place) {
    return (int) byX[place];
  }

  /** Sorts all boxes by x and by y, then divides both orders level by level. */
  void buildWithTwoSorts(int count) {
    begin(count);
    Arrays.sort(byX, 0, count);
    Arrays.sort(byY, 0, count);
    divide(0, count);
  }

  private void divide(int from, int to) {
    if (to - from <= LEAF) {
      return;
    }
    double width = coordinate(byX[to - 1]) - coordinate(byX[from]);
    double height = coordinate(byY[to - 1]) - coordinate(byY[from]);
    int middle = (from + to) >>> 1;
    long[] ordered = width >= height ? byX : byY;
    long[] other = width >= height ? byY : byX;
    for (int i = from; i < to; i++) {
      isLow[(int) ordered[i]] = i < middle;
    }
    int low = from;
    int high = middle;
    for (int i = from; i < to; i++) {
      if (isLow[(int) other[i]]) {
        spare[low++] = other[i];
      } else {
        spare[high++] = other[i];
      }
    }
    System.arraycopy(spare, from, other, from, to - from);
    divide(from, middle);
    divide(middle, to);
  }

  /** Sorts every part anew by the coordinate along which it is cut. */
  void buildWithSortPerLevel(int count) {
    begin(count);
    cut(0, count);
  }

  private void cut(int from, int to) {
    if (to - from <= LEAF) {
      return;
    }
    float minX = Float.POSITIVE_INFINITY;
    float maxX = Float.NEGATIVE_INFINITY;
    float minY = Float.POSITIVE_INFINITY;
    float maxY = Float.NEGATIVE_INFINITY;
    for (int i = from; i < to; i++) {
      int id = (int) byX[i];
      minX = Math.min(minX, centerX(id));
      maxX = Math.max(maxX, centerX(id));
      minY = Math.min(minY, centerY(id));
      maxY = Math.max(maxY, centerY(id));
    }
    boolean alongX = (double) maxX - minX >= (double) maxY - minY;
    for (int i = from; i < to; i++) {
      int id = (int) byX[i];
      byX[i] = key(alongX ? centerX(id) : centerY(id), id);
    }
    Arrays.sort(byX, from, to);
    int middle = (from + to) >>> 1;
    cut(from, middle);
    cut(middle, to);
  }

  private void begin(int count) {
    if (byX.length < count) {
      byX = new long[count];
      byY = new long[count];
      spare = new long[count];
      isLow = new boolean[count];
    }
    for (int id = 0; id < count; id++) {
      byX[id] = key(centerX(id), id);
      byY[id] = key(centerY(id), id);
    }
  }

  private float centerX(int id) {
    return 0.5f * (boxes.minX(id) + boxes.maxX(id));
  }

  private float centerY(int id) {
    return 0.5f * (boxes.minY(id) + boxes.maxY(id));
  }

  /** Returns a key that sorts by coordinate, and by id among equal coordinates. */
  private static long key(float coordinate, int id) {
    int bits = Float.floatToIntBits(coordinate);
    int ordered = bits >= 0 ? bits : bits ^ Integer.MAX_VALUE;
    return (long) ordered << 32 | id;
  }

  private static float coordinate(long key) {
    int ordered = (int) (key >> 32);
    return Float.intBitsToFloat(ordered >= 0 ? ordered : ordered ^ Integer.MAX_VALUE);
  }
}
