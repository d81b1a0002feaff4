package carom.physics.collision;

import carom.physics.math.Limits;

/**
 * Measures the distance of two convex polygons by the algorithm of Gilbert, Johnson and Keerthi
 * (1988). It finds the closest point of the Minkowski difference B - A to the origin by walking
 * from edge to edge of the difference. Each step goes towards the vertex that lies farthest against
 * the present direction.
 *
 * <p>It computes in double precision, and directions of edges come from the edges themselves. So a
 * gap of a nanometre between shapes of a metre still has the right normal. The search ends when no
 * vertex is nearer by more than rounding; the number of steps is bounded. The result depends on the
 * arguments alone.
 */
public final class Gjk {
  private static final int MAX_STEPS = 96;

  /** Fraction of the coordinates' size by which a vertex must be nearer to count. */
  private static final double PROGRESS = 1e-14;

  /** True if the polygons share a point; then distance and normal are 0. */
  boolean overlap;

  /** Smallest distance of the polygons, m, not counting their radii. */
  public double distance;

  /** Unit direction from A's closest point to B's. */
  public double normalX;

  public double normalY;

  /** Closest point of A. */
  public double ax;

  public double ay;

  /** Closest point of B. */
  double bx;

  double by;

  /** Vertices of A whose connection holds the closest point; equal when it is a vertex. */
  public int a0;

  public int a1;

  /** Vertices of B whose connection holds the closest point; equal when it is a vertex. */
  public int b0;

  public int b1;

  // The simplex: up to three vertices of B - A, and the vertices of A and B they come from.
  private final double[] wx = new double[3];
  private final double[] wy = new double[3];
  private final int[] ia = new int[3];
  private final int[] ib = new int[3];
  private int count;

  /** Position of the closest point between simplex vertices 0 and 1, from 0 to 1. */
  private double along;

  /** Searches for the closest points of two cores, and sets all results. */
  public void run(Core a, Core b) {
    Limits.notNull("a", a);
    Limits.notNull("b", b);
    count = 0;
    add(a, 0, b, 0);
    double size = Math.abs(wx[0]) + Math.abs(wy[0]);
    closestOfOne();
    for (int step = 0; step < MAX_STEPS && !overlap; step++) {
      int i = a.support(normalX, normalY);
      int j = b.support(-normalX, -normalY);
      double x = b.x[j] - a.x[i];
      double y = b.y[j] - a.y[i];
      size = Math.max(size, Math.abs(x) + Math.abs(y));
      double height = normalX * x + normalY * y;
      if (!(height < distance - PROGRESS * size) || known(i, j)) {
        break;
      }
      add(a, i, b, j);
      if (count == 2) {
        closestOfTwo();
      } else {
        closestOfThree();
      }
    }
    finish(a, b);
  }

  private boolean known(int i, int j) {
    for (int k = 0; k < count; k++) {
      if (ia[k] == i && ib[k] == j) {
        return true;
      }
    }
    return false;
  }

  private void add(Core a, int i, Core b, int j) {
    int k = count;
    wx[k] = b.x[j] - a.x[i];
    wy[k] = b.y[j] - a.y[i];
    ia[k] = i;
    ib[k] = j;
    count = k + 1;
  }

  private void copy(int from, int to) {
    wx[to] = wx[from];
    wy[to] = wy[from];
    ia[to] = ia[from];
    ib[to] = ib[from];
  }

  private void closestOfOne() {
    distance = Math.sqrt(wx[0] * wx[0] + wy[0] * wy[0]);
    overlap = !(distance > 0);
    normalX = overlap ? 0 : wx[0] / distance;
    normalY = overlap ? 0 : wy[0] / distance;
    along = 0;
    count = 1;
  }

  private void closestOfTwo() {
    double ex = wx[1] - wx[0];
    double ey = wy[1] - wy[0];
    double squared = ex * ex + ey * ey;
    double t = -(wx[0] * ex + wy[0] * ey);
    if (!(t > 0)) {
      closestOfOne();
    } else if (!(t < squared)) {
      copy(1, 0);
      closestOfOne();
    } else {
      double length = Math.sqrt(squared);
      double side = wx[0] * wy[1] - wy[0] * wx[1];
      double sign = side >= 0 ? 1 : -1;
      distance = sign * side / length;
      overlap = !(distance > 0);
      normalX = overlap ? 0 : sign * ey / length;
      normalY = overlap ? 0 : -sign * ex / length;
      along = t / squared;
      count = 2;
    }
  }

  /**
   * Reduces a simplex of three vertices. The third vertex is nearer than the edge of the first two,
   * so one of its two edges has the closest point, unless the triangle holds the origin.
   */
  private void closestOfThree() {
    double turn01 = wx[0] * wy[1] - wy[0] * wx[1];
    double turn12 = wx[1] * wy[2] - wy[1] * wx[2];
    double turn20 = wx[2] * wy[0] - wy[2] * wx[0];
    if ((turn01 >= 0 && turn12 >= 0 && turn20 >= 0)
        || (turn01 <= 0 && turn12 <= 0 && turn20 <= 0)) {
      overlap = true;
      distance = 0;
      normalX = 0;
      normalY = 0;
      return;
    }
    if (squaredDistance(0, 2) <= squaredDistance(1, 2)) {
      copy(2, 1);
    } else {
      copy(1, 0);
      copy(2, 1);
    }
    closestOfTwo();
  }

  private double squaredDistance(int p, int q) {
    double ex = wx[q] - wx[p];
    double ey = wy[q] - wy[p];
    double squared = ex * ex + ey * ey;
    double t = squared > 0 ? -(wx[p] * ex + wy[p] * ey) / squared : 0;
    t = Math.max(0, Math.min(1, t));
    double x = wx[p] + t * ex;
    double y = wy[p] + t * ey;
    return x * x + y * y;
  }

  private void finish(Core a, Core b) {
    if (count == 3) {
      common(a);
      return;
    }
    int last = count - 1;
    a0 = ia[0];
    a1 = ia[last];
    b0 = ib[0];
    b1 = ib[last];
    ax = a.x[a0] + along * (a.x[a1] - a.x[a0]);
    ay = a.y[a0] + along * (a.y[a1] - a.y[a0]);
    bx = b.x[b0] + along * (b.x[b1] - b.x[b0]);
    by = b.y[b0] + along * (b.y[b1] - b.y[b0]);
  }

  /**
   * Sets a common point of both shapes. The origin lies in the triangle, and its barycentric
   * coordinates give the point.
   */
  private void common(Core a) {
    double u0 = wx[1] * wy[2] - wy[1] * wx[2];
    double u1 = wx[2] * wy[0] - wy[2] * wx[0];
    double u2 = wx[0] * wy[1] - wy[0] * wx[1];
    double sum = u0 + u1 + u2;
    if (sum == 0) {
      u0 = 1;
      u1 = 0;
      u2 = 0;
      sum = 1;
    }
    ax = (u0 * a.x[ia[0]] + u1 * a.x[ia[1]] + u2 * a.x[ia[2]]) / sum;
    ay = (u0 * a.y[ia[0]] + u1 * a.y[ia[1]] + u2 * a.y[ia[2]]) / sum;
    bx = ax;
    by = ay;
    a0 = ia[0];
    a1 = ia[0];
    b0 = ib[0];
    b1 = ib[0];
  }
}
