package carom.physics.broadphase;

/**
 * Functions on the bounds of a {@link KdTree}'s nodes. The bounds are one array of four edges per
 * node: left, lower, right, upper. An empty node has inverted infinities.
 */
final class KdBounds {
  private KdBounds() {}

  static void set(float[] b, int node, float left, float bottom, float right, float top) {
    b[4 * node] = left;
    b[4 * node + 1] = bottom;
    b[4 * node + 2] = right;
    b[4 * node + 3] = top;
  }

  /** Extends the bounds of a node to contain a box. */
  static void extend(float[] b, int node, float left, float bottom, float right, float top) {
    int at = 4 * node;
    b[at] = Math.min(b[at], left);
    b[at + 1] = Math.min(b[at + 1], bottom);
    b[at + 2] = Math.max(b[at + 2], right);
    b[at + 3] = Math.max(b[at + 3], top);
  }

  /** Fits a node to its children. */
  private static void fit(float[] b, int node) {
    int to = 4 * node;
    int from = 8 * node;
    b[to] = Math.min(b[from], b[from + 4]);
    b[to + 1] = Math.min(b[from + 1], b[from + 5]);
    b[to + 2] = Math.max(b[from + 2], b[from + 6]);
    b[to + 3] = Math.max(b[from + 3], b[from + 7]);
  }

  /**
   * Fits the inner nodes of a subtree to their children, deepest first. Leaves begin at {@code
   * endNode}.
   */
  static void fitInner(float[] b, int top, int endNode) {
    int first = top;
    int last = top;
    while (2 * first < endNode) {
      first = 2 * first;
      last = 2 * last + 1;
    }
    while (first >= top && first < endNode) {
      for (int node = last; node >= first; node--) {
        fit(b, node);
      }
      first >>= 1;
      last >>= 1;
    }
  }

  /** Fits all ancestors of a node to their children. */
  static void fitAncestors(float[] b, int node) {
    for (int above = node >> 1; above > 0; above >>= 1) {
      fit(b, above);
    }
  }
}
