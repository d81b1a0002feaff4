package carom.physics.broadphase;

/**
 * Finds the overlapping pairs of a {@link KdTree}, among its own boxes or with those of another. It
 * walks pairs of nodes with an explicit stack, and tests leaf against leaf in short loops without
 * branches. It only reads the trees, so several threads may search one tree, each with its own
 * instance.
 */
final class KdJoin {
  private final KdTree tree;

  /** Boxes of one leaf that overlap the bounds of another, as indexes into {@link KdTree#slots}. */
  private final int[] nearby = new int[KdTree.SLOTS];

  /** Pairs found but not yet reported, each as two indexes into {@link KdTree#slots}. */
  private final long[] hits = new long[4 * KdTree.SLOTS * KdTree.SLOTS];

  /** Stack of node pairs still to visit; each level leaves at most three behind. */
  private final int[] stack = new int[2 * (4 * 32)];

  KdJoin(KdTree tree) {
    this.tree = tree;
  }

  /**
   * Visits every pair of overlapping boxes below two nodes of the same level once.
   *
   * @param nodeA 1 for the whole tree
   * @param nodeB the same node, or one to the right of it
   * @param selective whether to skip pairs of nodes of which none is {@link KdTree#hot}
   */
  void pairs(int nodeA, int nodeB, boolean selective, PairVisitor visitor) {
    int found = 0;
    int top = push(nodeA, nodeB, 0);
    while (top > 0) {
      int b = stack[--top];
      int a = stack[--top];
      if (selective && !tree.hot[a] && !tree.hot[b]) {
        continue;
      }
      if (a >= tree.leaves) {
        if (a == b) {
          found = pairsInLeaf(a - tree.leaves, found);
        } else {
          found = pairsOfLeaves(a - tree.leaves, tree, b - tree.leaves, found);
        }
        if (found >= hits.length - KdTree.SLOTS * KdTree.SLOTS) {
          reportPairs(found, visitor);
          found = 0;
        }
        continue;
      }
      top = pushChildren(a, b, top);
    }
    reportPairs(found, visitor);
  }

  /**
   * Replaces pairs of nodes of the tree by the overlapping pairs of their children. Pairs of leaves
   * stay.
   *
   * @param from pairs of nodes, two numbers each
   * @param count how many pairs
   * @param selective as for {@link #pairs}
   * @param to receives the pairs, at most four times as many
   * @return how many
   */
  int descend(int[] from, int count, boolean selective, int[] to) {
    int total = 0;
    for (int i = 0; i < count; i++) {
      int a = from[2 * i];
      int b = from[2 * i + 1];
      if (!selective || tree.hot[a] || tree.hot[b]) {
        int top = a >= tree.leaves ? push(a, b, 0) : pushChildren(a, b, 0);
        System.arraycopy(stack, 0, to, total, top);
        total += top;
      }
    }
    return total / 2;
  }

  /**
   * Pushes the pairs of children of two inner nodes that may hold overlapping boxes. The two nodes
   * may be the same.
   */
  private int pushChildren(int a, int b, int top) {
    int a0 = 2 * a;
    int a1 = a0 + 1;
    int end = top;
    if (a == b) {
      end = push(a0, a0, end);
      end = push(a1, a1, end);
      return pushIfOverlapping(a0, tree, a1, end);
    }
    int b0 = 2 * b;
    int b1 = b0 + 1;
    end = pushIfOverlapping(a0, tree, b0, end);
    end = pushIfOverlapping(a0, tree, b1, end);
    end = pushIfOverlapping(a1, tree, b0, end);
    return pushIfOverlapping(a1, tree, b1, end);
  }

  private int push(int a, int b, int top) {
    stack[top] = a;
    stack[top + 1] = b;
    return top + 2;
  }

  /**
   * Pushes a pair of nodes if their bounds overlap. To avoid a branch, it always writes the pair
   * and advances only if they do.
   */
  private int pushIfOverlapping(int a, KdTree other, int b, int top) {
    push(a, b, top);
    return top + 2 + (apart(tree.bounds, 4 * a, other.bounds, 4 * b) >> 31 << 1);
  }

  /**
   * Returns a negative number if two boxes are apart, else one that isn't negative. The sign bit of
   * a difference of floats tells which is larger, also for denormals and infinities, as long as
   * there are no negative zeros and no NaN; or-ing the four sign bits makes one test of four.
   */
  private static int apart(
      float ax0, float ay0, float ax1, float ay1, float bx0, float by0, float bx1, float by1) {
    return Float.floatToRawIntBits(bx1 - ax0)
        | Float.floatToRawIntBits(ax1 - bx0)
        | Float.floatToRawIntBits(by1 - ay0)
        | Float.floatToRawIntBits(ay1 - by0);
  }

  /** Returns a negative number if two nodes are apart, else one that isn't negative. */
  private static int apart(float[] p, int a, float[] q, int b) {
    return apart(p[a], p[a + 1], p[a + 2], p[a + 3], q[b], q[b + 1], q[b + 2], q[b + 3]);
  }

  private int pairsInLeaf(int leaf, int found) {
    int end = leaf * KdTree.BLOCK + tree.fill[leaf];
    int total = found;
    for (int i = leaf * KdTree.BLOCK; i < end - 1; i++) {
      total = pairsOfBox(i, tree.slots, i + 1, end, total);
    }
    return total;
  }

  private int pairsOfLeaves(int leafA, KdTree other, int leafB, int found) {
    float[] s = tree.slots;
    float[] b = other.bounds;
    int node = 4 * (leafB + other.leaves);
    float left = b[node];
    float bottom = b[node + 1];
    float right = b[node + 2];
    float top = b[node + 3];
    int near = 0;
    int from = leafA * KdTree.BLOCK;
    int to = from + tree.fill[leafA];
    for (int i = from; i < to; i++) {
      nearby[near] = i;
      near +=
          1
              + (apart(
                      left,
                      bottom,
                      right,
                      top,
                      s[i],
                      s[i + KdTree.ROW],
                      s[i + 2 * KdTree.ROW],
                      s[i + 3 * KdTree.ROW])
                  >> 31);
    }
    int total = found;
    int fromB = leafB * KdTree.BLOCK;
    int toB = fromB + other.fill[leafB];
    for (int k = 0; k < near; k++) {
      total = pairsOfBox(nearby[k], other.slots, fromB, toB, total);
    }
    return total;
  }

  /**
   * Appends the pairs of a box with a range of others to {@link #hits}. To avoid a branch, it
   * writes every candidate, and the next one overwrites it if the boxes are apart.
   */
  private int pairsOfBox(int i, float[] others, int from, int to, int found) {
    long[] h = hits;
    float[] own = tree.slots;
    float x0 = own[i];
    float y0 = own[i + KdTree.ROW];
    float x1 = own[i + 2 * KdTree.ROW];
    float y1 = own[i + 3 * KdTree.ROW];
    int total = found;
    for (int j = from; j < to; j++) {
      h[total] = (long) i << 32 | j;
      total +=
          1
              + (apart(
                      x0,
                      y0,
                      x1,
                      y1,
                      others[j],
                      others[j + KdTree.ROW],
                      others[j + 2 * KdTree.ROW],
                      others[j + 3 * KdTree.ROW])
                  >> 31);
    }
    return total;
  }

  /** Returns the index into {@link KdTree#ids} of the box at an index into {@link KdTree#slots}. */
  private static int slot(int at) {
    return (at >>> KdTree.SHIFT) * KdTree.SLOTS + (at & KdTree.BLOCK - 1);
  }

  private void reportPairs(int found, PairVisitor visitor) {
    for (int k = 0; k < found; k++) {
      int a = tree.ids[slot((int) (hits[k] >>> 32))];
      int b = tree.ids[slot((int) hits[k])];
      visitor.pair(Math.min(a, b), Math.max(a, b));
    }
  }

  private void reportJoin(int found, KdTree other, PairVisitor visitor) {
    for (int k = 0; k < found; k++) {
      visitor.pair(tree.ids[slot((int) (hits[k] >>> 32))], other.ids[slot((int) hits[k])]);
    }
  }

  /**
   * Visits every pair of overlapping boxes below a node of this tree and one of another.
   *
   * @param nodeA node of this tree, 1 for all of it
   * @param nodeB node of the other
   * @param selective whether to skip nodes of this tree that aren't {@link KdTree#hot}
   */
  void join(KdTree other, int nodeA, int nodeB, boolean selective, PairVisitor visitor) {
    int found = 0;
    int top = pushIfOverlapping(nodeA, other, nodeB, 0);
    while (top > 0) {
      int b = stack[--top];
      int a = stack[--top];
      if (selective && !tree.hot[a]) {
        continue;
      }
      if (a >= tree.leaves && b >= other.leaves) {
        found = pairsOfLeaves(a - tree.leaves, other, b - other.leaves, found);
        if (found >= hits.length - KdTree.SLOTS * KdTree.SLOTS) {
          reportJoin(found, other, visitor);
          found = 0;
        }
      } else {
        top = pushChildren(a, other, b, top);
      }
    }
    reportJoin(found, other, visitor);
  }

  /**
   * Replaces pairs of nodes of this tree and another by overlapping pairs of their children, as
   * {@link #descend(int[], int, boolean, int[])} does within one tree.
   */
  int descend(KdTree other, int[] from, int count, boolean selective, int[] to) {
    int total = 0;
    for (int i = 0; i < count; i++) {
      int a = from[2 * i];
      int b = from[2 * i + 1];
      if (!selective || tree.hot[a]) {
        boolean leaves = a >= tree.leaves && b >= other.leaves;
        int top = leaves ? push(a, b, 0) : pushChildren(a, other, b, 0);
        System.arraycopy(stack, 0, to, total, top);
        total += top;
      }
    }
    return total / 2;
  }

  /**
   * Pushes the children of one of two nodes, each paired with the other node if they overlap. The
   * wider node is split, unless it is a leaf.
   */
  private int pushChildren(int a, KdTree other, int b, int top) {
    if (b >= other.leaves
        || (a < tree.leaves && extent(tree.bounds, a) >= extent(other.bounds, b))) {
      int end = pushIfOverlapping(2 * a, other, b, top);
      return pushIfOverlapping(2 * a + 1, other, b, end);
    }
    int end = pushIfOverlapping(a, other, 2 * b, top);
    return pushIfOverlapping(a, other, 2 * b + 1, end);
  }

  private static float extent(float[] bounds, int node) {
    int b = 4 * node;
    return bounds[b + 2] - bounds[b] + (bounds[b + 3] - bounds[b + 1]);
  }
}
