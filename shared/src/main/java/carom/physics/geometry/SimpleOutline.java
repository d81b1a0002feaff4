package carom.physics.geometry;

import java.util.Arrays;

/**
 * The outline of a simple polygon, convex or not: counter-clockwise, without repeated points and
 * without points on the line through their neighbours. Making one refuses outlines that cross or
 * touch themselves, and names the edges.
 */
final class SimpleOutline {
  /** Points nearer than this, in sizes of the outline, are one. */
  private static final double DUPLICATE = 1e-6;

  /** Points nearer than this to the line through their neighbours, in sizes, are dropped. */
  private static final double COLLINEAR = 1e-6;

  final double[] x;
  final double[] y;

  /** The number that each point had in what was given. */
  private final int[] given;

  private int count;

  /**
   * Makes an outline.
   *
   * @param xy x0, y0, x1, y1, ... in metres, finite, in either winding
   * @throws IllegalArgumentException when it crosses or touches itself, has no area or too many
   *     points
   */
  public SimpleOutline(float[] xy, int mostPoints) {
    if (xy.length % 2 != 0) {
      throw new IllegalArgumentException(
          "outline coordinates=" + xy.length + " must be even: x and y of each point");
    }
    count = xy.length / 2;
    if (count < 3 || count > mostPoints) {
      throw new IllegalArgumentException(
          "outline points=" + count + " must be in 3.." + mostPoints);
    }
    x = new double[count];
    y = new double[count];
    given = new int[count];
    for (int i = 0; i < count; i++) {
      x[i] = xy[2 * i];
      y[i] = xy[2 * i + 1];
      given[i] = i;
    }
    clean();
    refuseTouching();
    if (twiceArea() < 0) {
      reverse();
    }
  }

  /** Returns the number of points. */
  int count() {
    return count;
  }

  /** Returns twice the area, negative for a clockwise outline, m^2. */
  private double twiceArea() {
    double twice = 0;
    for (int i = 1; i + 1 < count; i++) {
      twice += turn(0, i, i + 1);
    }
    return twice;
  }

  /** Returns twice the signed area of a triangle of points, positive for a left turn. */
  double turn(int a, int b, int c) {
    return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
  }

  private double size() {
    double minX = Double.POSITIVE_INFINITY;
    double minY = Double.POSITIVE_INFINITY;
    double maxX = Double.NEGATIVE_INFINITY;
    double maxY = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      minX = Math.min(minX, x[i]);
      minY = Math.min(minY, y[i]);
      maxX = Math.max(maxX, x[i]);
      maxY = Math.max(maxY, y[i]);
    }
    return Math.max(maxX - minX, maxY - minY);
  }

  /** Drops repeated and flat points until none is left. */
  private void clean() {
    double size = size();
    int checked = 0;
    for (int i = 0; checked < count && count >= 3; ) {
      i %= count;
      int before = (i + count - 1) % count;
      int after = (i + 1) % count;
      double chord = distance(before, after);
      boolean repeated = distance(before, i) <= DUPLICATE * size;
      boolean flat = Math.abs(turn(before, i, after)) <= COLLINEAR * size * chord;
      if (flat
          && !repeated
          && distance(i, after) > DUPLICATE * size
          && turnsBack(before, i, after)) {
        throw new IllegalArgumentException(
            "outline turns back on itself at point="
                + given[i]
                + "; leave a gap between the edges");
      }
      if (repeated || flat) {
        remove(i);
        i = Math.max(0, i - 1);
        checked = 0;
      } else {
        i++;
        checked++;
      }
    }
    if (count < 3) {
      throw new IllegalArgumentException(
          "outline area=0 must be > 0: its points are (nearly) on one line or in one point");
    }
  }

  private boolean turnsBack(int before, int i, int after) {
    return (x[i] - x[before]) * (x[after] - x[i]) + (y[i] - y[before]) * (y[after] - y[i]) < 0;
  }

  private double distance(int a, int b) {
    double dx = x[b] - x[a];
    double dy = y[b] - y[a];
    return Math.sqrt(dx * dx + dy * dy);
  }

  private void remove(int i) {
    count--;
    System.arraycopy(x, i + 1, x, i, count - i);
    System.arraycopy(y, i + 1, y, i, count - i);
    System.arraycopy(given, i + 1, given, i, count - i);
  }

  private void reverse() {
    for (int i = 0, j = count - 1; i < j; i++, j--) {
      double keptX = x[i];
      double keptY = y[i];
      x[i] = x[j];
      y[i] = y[j];
      x[j] = keptX;
      y[j] = keptY;
    }
  }

  /** Refuses edges that meet others than their neighbours; looks at edges that overlap along x. */
  private void refuseTouching() {
    Integer[] byLeft = new Integer[count];
    for (int i = 0; i < count; i++) {
      byLeft[i] = i;
    }
    Arrays.sort(byLeft, (a, b) -> Double.compare(left(a), left(b)));
    for (int k = 0; k < count; k++) {
      int i = byLeft[k];
      double end = Math.max(x[i], x[next(i)]);
      for (int l = k + 1; l < count && left(byLeft[l]) <= end; l++) {
        int j = byLeft[l];
        boolean neighbours = next(i) == j || next(j) == i;
        if (!neighbours && meet(i, j)) {
          int first = Math.min(given[i], given[j]);
          int second = Math.max(given[i], given[j]);
          throw new IllegalArgumentException(
              "outline edge="
                  + first
                  + " (from point "
                  + first
                  + ") meets edge="
                  + second
                  + " (from point "
                  + second
                  + "); draw it so that it neither crosses nor touches itself");
        }
      }
    }
  }

  private int next(int i) {
    return i + 1 == count ? 0 : i + 1;
  }

  private double left(int edge) {
    return Math.min(x[edge], x[next(edge)]);
  }

  /** Returns whether two edges have a point in common. */
  private boolean meet(int i, int j) {
    int endI = next(i);
    int endJ = next(j);
    double a = turn(i, endI, j);
    double b = turn(i, endI, endJ);
    double c = turn(j, endJ, i);
    double d = turn(j, endJ, endI);
    if (((a > 0 && b < 0) || (a < 0 && b > 0)) && ((c > 0 && d < 0) || (c < 0 && d > 0))) {
      return true;
    }
    return (a == 0 && within(i, j))
        || (b == 0 && within(i, endJ))
        || (c == 0 && within(j, i))
        || (d == 0 && within(j, endI));
  }

  /** Returns whether a point on the line of an edge is in the edge's box. */
  private boolean within(int edge, int point) {
    int end = next(edge);
    return Math.min(x[edge], x[end]) <= x[point]
        && x[point] <= Math.max(x[edge], x[end])
        && Math.min(y[edge], y[end]) <= y[point]
        && y[point] <= Math.max(y[edge], y[end]);
  }
}
