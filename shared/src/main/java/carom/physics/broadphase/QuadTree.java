package carom.physics.broadphase;

import java.util.Arrays;

/**
 * A region quadtree over the centres of the boxes, with tight bounds per node. It serves for
 * comparison.
 *
 * <p>Cells are cut in half in both directions until they hold at most {@value #LEAF} boxes or are
 * {@value #MAX_DEPTH} levels deep. Where boxes cluster, that takes many levels for few boxes, which
 * a {@code KdTree} avoids. Each rebuild builds the whole tree. There are no node objects: the four
 * children of a node are adjacent in the arrays, and each node owns a range of the sorted boxes.
 *
 * <p>Identical centres all end in one leaf and are compared with each other, which costs no more
 * than reporting them when they overlap. Cost: build O(n depth), query and pairs as for any tree.
 */
public final class QuadTree implements SpatialIndex {
  /** Largest number of boxes in a leaf above the deepest level. */
  static final int LEAF = 8;

  /** Largest number of levels below the root. */
  static final int MAX_DEPTH = 24;

  private static final int[] NONE = new int[0];

  private int size;
  private int nodes;

  /** Index of the first of a node's four children, or 0 for a leaf; by node. */
  private int[] child = NONE;

  /** A node's first box, and the one after its last, in tree order; by node. */
  private int[] from = NONE;

  private int[] to = NONE;

  /** Bounds by node. */
  private final AabbArray bounds = new AabbArray(0);

  /** Ids and boxes in tree order. */
  private int[] ids = NONE;

  private int[] sorted = NONE;
  private final AabbArray slots = new AabbArray(0);
  private int[] stack = new int[64];
  private final MovingBox moving = new MovingBox();

  /** Makes an empty index. */
  public QuadTree() {
    // empty until the first rebuild
  }

  @Override
  public int size() {
    return size;
  }

  @Override
  public void rebuild(AabbArray boxes, int[] newIds, int count) {
    if (count < 0 || count > newIds.length) {
      throw new IllegalArgumentException("count=" + count + ", limit 0.." + newIds.length);
    }
    size = 0;
    nodes = 0;
    float left = Float.POSITIVE_INFINITY;
    float bottom = Float.POSITIVE_INFINITY;
    float right = Float.NEGATIVE_INFINITY;
    float top = Float.NEGATIVE_INFINITY;
    if (ids.length < count) {
      int grown = Math.max(count, ids.length + (ids.length >> 1));
      ids = new int[grown];
      sorted = new int[grown];
      slots.ensureCapacity(grown);
    }
    for (int i = 0; i < count; i++) {
      int id = newIds[i];
      boxes.check(id);
      ids[i] = id;
      float x = centerX(boxes, id);
      float y = centerY(boxes, id);
      left = Math.min(left, x);
      right = Math.max(right, x);
      bottom = Math.min(bottom, y);
      top = Math.max(top, y);
    }
    size = count;
    if (count > 0) {
      nodes = 1;
      ensureNodes(1);
      build(boxes, 0, 0, count, 0, left, bottom, right, top);
    }
  }

  /**
   * Divides the ids from {@code lo} to {@code hi} - 1 among the cells below a node, at most to
   * MAX_DEPTH.
   */
  private void build(
      AabbArray boxes,
      int node,
      int lo,
      int hi,
      int depth,
      float left,
      float bottom,
      float right,
      float top) {
    from[node] = lo;
    to[node] = hi;
    child[node] = 0;
    if (hi - lo <= LEAF || depth == MAX_DEPTH) {
      for (int i = lo; i < hi; i++) {
        int id = ids[i];
        slots.set(i, boxes.minX(id), boxes.minY(id), boxes.maxX(id), boxes.maxY(id));
      }
      fit(node, slots, lo, hi);
      return;
    }
    float midX = 0.5f * left + 0.5f * right;
    float midY = 0.5f * bottom + 0.5f * top;
    int midRow = divide(boxes, true, lo, hi, midY);
    int midLow = divide(boxes, false, lo, midRow, midX);
    int midHigh = divide(boxes, false, midRow, hi, midX);
    int first = nodes;
    nodes += 4;
    ensureNodes(nodes);
    child[node] = first;
    build(boxes, first, lo, midLow, depth + 1, left, bottom, midX, midY);
    build(boxes, first + 1, midLow, midRow, depth + 1, midX, bottom, right, midY);
    build(boxes, first + 2, midRow, midHigh, depth + 1, left, midY, midX, top);
    build(boxes, first + 3, midHigh, hi, depth + 1, midX, midY, right, top);
    fit(node, bounds, first, first + 4);
  }

  /** Moves ids with centres below {@code mid} to the front and returns where the others begin. */
  private int divide(AabbArray boxes, boolean y, int lo, int hi, float mid) {
    int low = lo;
    int high = 0;
    for (int i = lo; i < hi; i++) {
      int id = ids[i];
      if ((y ? centerY(boxes, id) : centerX(boxes, id)) < mid) {
        ids[low++] = id;
      } else {
        sorted[high++] = id;
      }
    }
    System.arraycopy(sorted, 0, ids, low, high);
    return low;
  }

  private void fit(int node, AabbArray parts, int lo, int hi) {
    float left = Float.POSITIVE_INFINITY;
    float bottom = Float.POSITIVE_INFINITY;
    float right = Float.NEGATIVE_INFINITY;
    float top = Float.NEGATIVE_INFINITY;
    for (int i = lo; i < hi; i++) {
      left = Math.min(left, parts.minX(i));
      bottom = Math.min(bottom, parts.minY(i));
      right = Math.max(right, parts.maxX(i));
      top = Math.max(top, parts.maxY(i));
    }
    bounds.set(node, left, bottom, right, top);
  }

  private static float centerX(AabbArray boxes, int id) {
    return 0.5f * boxes.minX(id) + 0.5f * boxes.maxX(id);
  }

  private static float centerY(AabbArray boxes, int id) {
    return 0.5f * boxes.minY(id) + 0.5f * boxes.maxY(id);
  }

  private void ensureNodes(int count) {
    if (child.length < count) {
      int grown = Math.max(count, 2 * child.length);
      child = Arrays.copyOf(child, grown);
      from = Arrays.copyOf(from, grown);
      to = Arrays.copyOf(to, grown);
      bounds.ensureCapacity(grown);
    }
  }

  @Override
  public void query(float minX, float minY, float maxX, float maxY, IntVisitor visitor) {
    if (size > 0) {
      query(0, minX, minY, maxX, maxY, visitor);
    }
  }

  private boolean query(
      int node, float minX, float minY, float maxX, float maxY, IntVisitor visitor) {
    if (!bounds.overlaps(node, minX, minY, maxX, maxY)) {
      return true;
    }
    int first = child[node];
    if (first != 0) {
      return query(first, minX, minY, maxX, maxY, visitor)
          && query(first + 1, minX, minY, maxX, maxY, visitor)
          && query(first + 2, minX, minY, maxX, maxY, visitor)
          && query(first + 3, minX, minY, maxX, maxY, visitor);
    }
    for (int i = from[node]; i < to[node]; i++) {
      if (slots.overlaps(i, minX, minY, maxX, maxY) && !visitor.visit(ids[i])) {
        return false;
      }
    }
    return true;
  }

  @Override
  public void cast(
      float minX,
      float minY,
      float maxX,
      float maxY,
      float dx,
      float dy,
      float maxFraction,
      CastVisitor visitor) {
    moving.set(minX, minY, maxX, maxY, dx, dy);
    if (size > 0) {
      cast(0, maxFraction, visitor);
    }
  }

  /** Casts into a subtree and returns where the way ends now. */
  private float cast(int node, float maxFraction, CastVisitor visitor) {
    float end = maxFraction;
    if (!(moving.enter(bounds, node) <= end)) {
      return end;
    }
    int first = child[node];
    if (first != 0) {
      // The quarter entered first, then its neighbours: 0 1 2 3, xor'ed, keeps near before far.
      int nearest = 0;
      for (int i = 1; i < 4; i++) {
        if (moving.enter(bounds, first + i) < moving.enter(bounds, first + nearest)) {
          nearest = i;
        }
      }
      for (int i = 0; i < 4 && end >= 0; i++) {
        end = cast(first + (i ^ nearest), end, visitor);
      }
      return end;
    }
    for (int i = from[node]; i < to[node] && end >= 0; i++) {
      if (moving.enter(slots, i) <= end) {
        end = visitor.visit(ids[i], end);
      }
    }
    return end;
  }

  @Override
  public void pairs(PairVisitor visitor) {
    int top = size > 0 ? push(0, 0, 0) : 0;
    while (top > 0) {
      int b = stack[--top];
      int a = stack[--top];
      int childA = child[a];
      int childB = child[b];
      if (childA == 0 && childB == 0) {
        pairsOfLeaves(a, b, visitor);
      } else if (a == b) {
        for (int i = childA; i < childA + 4; i++) {
          top = push(i, i, top);
          for (int j = i + 1; j < childA + 4; j++) {
            top = pushIfOverlapping(i, j, top);
          }
        }
      } else if (childB == 0 || (childA != 0 && to[a] - from[a] > to[b] - from[b])) {
        for (int i = childA; i < childA + 4; i++) {
          top = pushIfOverlapping(i, b, top);
        }
      } else {
        for (int j = childB; j < childB + 4; j++) {
          top = pushIfOverlapping(a, j, top);
        }
      }
    }
  }

  private void pairsOfLeaves(int a, int b, PairVisitor visitor) {
    for (int i = from[a]; i < to[a]; i++) {
      if (!bounds.overlaps(b, slots.minX(i), slots.minY(i), slots.maxX(i), slots.maxY(i))) {
        continue;
      }
      for (int j = a == b ? i + 1 : from[b]; j < to[b]; j++) {
        if (slots.overlaps(i, j)) {
          visitor.pair(Math.min(ids[i], ids[j]), Math.max(ids[i], ids[j]));
        }
      }
    }
  }

  private int pushIfOverlapping(int a, int b, int top) {
    return bounds.overlaps(a, bounds.minX(b), bounds.minY(b), bounds.maxX(b), bounds.maxY(b))
        ? push(a, b, top)
        : top;
  }

  private int push(int a, int b, int top) {
    if (top + 2 > stack.length) {
      stack = Arrays.copyOf(stack, 2 * stack.length);
    }
    stack[top] = a;
    stack[top + 1] = b;
    return top + 2;
  }

  /**
   * Visits all nodes that hold a box, parents before children.
   *
   * @param visitor receives bounds and depths
   */
  public void cells(CellVisitor visitor) {
    if (size > 0) {
      cells(0, 0, visitor);
    }
  }

  private void cells(int node, int depth, CellVisitor visitor) {
    if (from[node] == to[node]) {
      return;
    }
    visitor.cell(bounds.minX(node), bounds.minY(node), bounds.maxX(node), bounds.maxY(node), depth);
    int first = child[node];
    if (first != 0) {
      for (int i = first; i < first + 4; i++) {
        cells(i, depth + 1, visitor);
      }
    }
  }
}
