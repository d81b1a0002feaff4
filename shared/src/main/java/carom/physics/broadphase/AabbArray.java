package carom.physics.broadphase;

import java.util.Arrays;

/**
 * An array of axis-aligned boxes, indexed by the caller's ids.
 *
 * <p>Edges are in metres; boxes are closed. The four edges of a box are adjacent in memory, so that
 * reading one box among a million costs one cache miss. The array is public for hot loops; it is
 * replaced when {@link #ensureCapacity} grows it, so don't keep it across that call. Not
 * thread-safe.
 */
public final class AabbArray {
  /** Edges of all boxes, m; those of box i start at index 4 i: left, lower, right, upper. */
  public float[] edges;

  /**
   * Makes room for boxes 0 to capacity - 1, all of zero size at the origin.
   *
   * @param capacity number of boxes, 0 or more
   */
  public AabbArray(int capacity) {
    edges = new float[4 * capacity];
  }

  /**
   * Returns the number of boxes there is room for.
   *
   * @return the number of boxes; valid ids are smaller
   */
  public int capacity() {
    return edges.length >> 2;
  }

  /**
   * Grows the array, at least by half, if it holds fewer boxes than this. The boxes are kept.
   *
   * @param capacity number of boxes wanted
   */
  public void ensureCapacity(int capacity) {
    int old = capacity();
    if (capacity > old) {
      edges = Arrays.copyOf(edges, 4 * Math.max(capacity, old + (old >> 1) + 8));
    }
  }

  /**
   * Returns the left edge of a box.
   *
   * @param id which, below {@link #capacity()}
   * @return m
   */
  public float minX(int id) {
    return edges[4 * id];
  }

  /**
   * Returns the lower edge of a box.
   *
   * @param id which, below {@link #capacity()}
   * @return m
   */
  public float minY(int id) {
    return edges[4 * id + 1];
  }

  /**
   * Returns the right edge of a box.
   *
   * @param id which, below {@link #capacity()}
   * @return m
   */
  public float maxX(int id) {
    return edges[4 * id + 2];
  }

  /**
   * Returns the upper edge of a box.
   *
   * @param id which, below {@link #capacity()}
   * @return m
   */
  public float maxY(int id) {
    return edges[4 * id + 3];
  }

  /**
   * Sets one box; nothing is checked.
   *
   * @param id which, below {@link #capacity()}
   * @param left left edge, m
   * @param bottom lower edge, m, finite
   * @param right right edge, m, not below {@code left}
   * @param top upper edge, m, not below {@code bottom}
   */
  public void set(int id, float left, float bottom, float right, float top) {
    edges[4 * id] = left;
    edges[4 * id + 1] = bottom;
    edges[4 * id + 2] = right;
    edges[4 * id + 3] = top;
  }

  /**
   * Returns whether two boxes overlap or touch.
   *
   * @param a one id
   * @param b another id
   * @return true if the closed boxes share a point
   */
  public boolean overlaps(int a, int b) {
    return overlaps(a, minX(b), minY(b), maxX(b), maxY(b));
  }

  /**
   * Returns whether a box overlaps or touches the given one.
   *
   * @param id which box
   * @param left left edge of the other, m
   * @param bottom lower edge of the other, m
   * @param right right edge of the other, m
   * @param top upper edge of the other, m
   * @return true if the closed boxes share a point
   */
  public boolean overlaps(int id, float left, float bottom, float right, float top) {
    return minX(id) <= right && maxX(id) >= left && minY(id) <= top && maxY(id) >= bottom;
  }

  /**
   * Returns whether a box contains the given one, edges included.
   *
   * @param outer id of the outer box
   * @param left left edge of the inner box, m
   * @param bottom lower edge of the inner box, m
   * @param right right edge of the inner box, m
   * @param top upper edge of the inner box, m
   * @return true if no part of the inner box lies outside
   */
  public boolean contains(int outer, float left, float bottom, float right, float top) {
    return minX(outer) <= left
        && maxX(outer) >= right
        && minY(outer) <= bottom
        && maxY(outer) >= top;
  }

  /**
   * Throws if no index can hold a box: if an edge is NaN or infinite, or the box is inside out or
   * wider than Float.MAX_VALUE.
   *
   * @param id which box
   * @throws IllegalArgumentException if the id is out of range or the box isn't {@link #valid}; the
   *     message has the id and the edges
   */
  public void check(int id) {
    if (id < 0 || id >= capacity()) {
      throw new IllegalArgumentException(
          "id=" + id + " is outside the box array, limit 0.." + (capacity() - 1));
    }
    if (!valid(minX(id), minY(id), maxX(id), maxY(id))) {
      throw invalid(id);
    }
  }

  /**
   * Returns whether a box is finite with min &lt;= max. One subtraction per axis detects NaN and
   * infinities alike.
   */
  public static boolean valid(float left, float bottom, float right, float top) {
    float width = right - left;
    float height = top - bottom;
    return width >= 0 && width <= Float.MAX_VALUE && height >= 0 && height <= Float.MAX_VALUE;
  }

  /** Returns the exception to throw for a box that isn't {@link #valid}. */
  public IllegalArgumentException invalid(int id) {
    return new IllegalArgumentException(
        "box id="
            + id
            + " must be finite with min <= max: minX="
            + minX(id)
            + " minY="
            + minY(id)
            + " maxX="
            + maxX(id)
            + " maxY="
            + maxY(id)
            + "; look for NaN in the body's pose or shape");
  }
}
