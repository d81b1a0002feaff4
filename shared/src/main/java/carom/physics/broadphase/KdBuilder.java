package carom.physics.broadphase;

import java.util.Arrays;

/**
 * Builds a {@link KdTree} or a subtree of it from a list of boxes. It splits at the median of the
 * centres, across the wider extent, by selection instead of sorting. Not thread-safe.
 */
final class KdBuilder {
  private static final float INF = Float.POSITIVE_INFINITY;
  private static final int LOW = (1 << 31) - 1;

  private final KdTree tree;

  /** The list of boxes to place: ids, boxes, and their centres in the frame of the tree's cells. */
  int[] ids = new int[KdTree.SLOTS];

  private final AabbArray boxes = new AabbArray(KdTree.SLOTS);
  private float[] centerX = new float[KdTree.SLOTS];
  private float[] centerY = new float[KdTree.SLOTS];

  /** Entries of the list in the low bits, with a coordinate to sort by in the high bits. */
  private long[] keys = new long[KdTree.SLOTS];

  private long placed;

  KdBuilder(KdTree tree) {
    this.tree = tree;
  }

  /** Returns how many boxes were ever placed, a measure of the work of repair. */
  long placed() {
    return placed;
  }

  /** Ensures room for a list of this many boxes, and keeps the ids. */
  void reserve(int count) {
    if (count > ids.length) {
      int grown = Math.max(count, ids.length + (ids.length >> 1));
      ids = Arrays.copyOf(ids, grown);
      boxes.ensureCapacity(grown);
      centerX = new float[grown];
      centerY = new float[grown];
      keys = new long[grown];
    }
  }

  /**
   * Begins the list with the boxes in a range of the tree's leaves and returns how many they are.
   */
  int gather(int firstLeaf, int endLeaf) {
    float[] s = tree.slots;
    int to = 0;
    for (int leaf = firstLeaf; leaf < endLeaf; leaf++) {
      int n = tree.fill[leaf];
      int block = leaf * KdTree.BLOCK;
      System.arraycopy(tree.ids, leaf * KdTree.SLOTS, ids, to, n);
      for (int at = block; at < block + n; at++) {
        boxes.set(
            to + at - block,
            s[at],
            s[at + KdTree.ROW],
            s[at + 2 * KdTree.ROW],
            s[at + 3 * KdTree.ROW]);
      }
      to += n;
    }
    return to;
  }

  /** Writes an id and its box, {@code from[id]}, into the list. */
  void put(int at, int id, AabbArray from) {
    ids[at] = id;
    boxes.set(at, from.minX(id), from.minY(id), from.maxX(id), from.maxY(id));
  }

  /**
   * Distributes the first boxes of the list among the leaves below a node. Only the bounds of the
   * leaves are set.
   */
  void build(int node, int count) {
    placed += count;
    for (int i = 0; i < count; i++) {
      centerX[i] = (float) (KdTree.center(boxes.minX(i), boxes.maxX(i)) - tree.frameX);
      centerY[i] = (float) (KdTree.center(boxes.minY(i), boxes.maxY(i)) - tree.frameY);
      keys[i] = i;
    }
    float left = -INF;
    float bottom = -INF;
    float right = INF;
    float top = INF;
    for (int h = 30 - Integer.numberOfLeadingZeros(node); h >= 0; h--) {
      int above = node >> (h + 1);
      boolean high = (node >> h & 1) == 1;
      float s = tree.split[above];
      if (tree.splitsY[above]) {
        bottom = high ? s : bottom;
        top = high ? top : s;
      } else {
        left = high ? s : left;
        right = high ? right : s;
      }
    }
    build(node, 0, count, left, bottom, right, top);
  }

  /** Splits the keys from {@code lo} to {@code hi} - 1 among the leaves below a node. */
  private void build(int node, int lo, int hi, float left, float bottom, float right, float top) {
    if (node >= tree.leaves) {
      int leaf = node - tree.leaves;
      tree.fill[leaf] = hi - lo;
      tree.setCell(leaf, left, bottom, right, top);
      for (int i = lo; i < hi; i++) {
        int e = (int) keys[i] & LOW;
        tree.store(leaf, i - lo, ids[e], boxes, e);
      }
      tree.fitLeaf(leaf);
      return;
    }
    boolean y = isTaller(lo, hi);
    float[] c = y ? centerY : centerX;
    for (int i = lo; i < hi; i++) {
      int e = (int) keys[i] & LOW;
      keys[i] = key(c[e], e);
    }
    int mid = (lo + hi) >>> 1;
    float s = 0;
    if (hi > lo) {
      Select.nth(keys, lo, hi - 1, mid);
      s = c[(int) keys[mid] & LOW];
    }
    tree.split[node] = s;
    tree.splitsY[node] = y;
    if (y) {
      build(2 * node, lo, mid, left, bottom, right, s);
      build(2 * node + 1, mid, hi, left, s, right, top);
    } else {
      build(2 * node, lo, mid, left, bottom, s, top);
      build(2 * node + 1, mid, hi, s, bottom, right, top);
    }
  }

  /** Returns whether the centres spread wider in y than in x. */
  private boolean isTaller(int lo, int hi) {
    float x0 = INF;
    float y0 = INF;
    float x1 = -INF;
    float y1 = -INF;
    for (int i = lo; i < hi; i++) {
      int e = (int) keys[i] & LOW;
      float x = centerX[e];
      float y = centerY[e];
      x0 = Math.min(x0, x);
      x1 = Math.max(x1, x);
      y0 = Math.min(y0, y);
      y1 = Math.max(y1, y);
    }
    return y1 - y0 > x1 - x0;
  }

  /**
   * Returns a number that sorts like (coordinate, entry). Differences of two never overflow. No two
   * are equal, so that a million boxes in one place split as evenly as any others.
   */
  private static long key(float c, int entry) {
    int bits = Float.floatToRawIntBits(c);
    int sortable = bits ^ (bits >> 31 & LOW);
    return ((long) sortable << 31) + entry;
  }
}
