package carom.physics.geometry;

import carom.physics.math.Limits;
import carom.physics.math.Trig;
import carom.physics.math.Vec2;
import java.util.Arrays;

/**
 * A convex polygon with 3 to {@value Convex#MAX_VERTICES} vertices, counter-clockwise. Its corners
 * are sharp or rounded by a radius.
 *
 * <p>{@link #of} takes the outline of a convex polygon, in either winding, and refuses a concave
 * one; {@link Compound#ofOutline} cuts that into convex parts. {@link #hull} takes any points in
 * any order, and drops those inside their hull.
 *
 * <p>Both drop points that would make contacts ill-conditioned: near-duplicates (closer than 1e-4
 * of the size of the bounding box, or 0.1 mm if that is less) and points nearly on the line through
 * their neighbours (nearer than a tenth of that). Vertex 0 is the leftmost one (of these the
 * lowest).
 */
public final class Polygon extends Convex {
  private static final double DUPLICATE = 1e-4;
  private static final double COLLINEAR = 1e-5;
  private static final int MAX_POINTS = 4096;

  private final float radius;

  private Polygon(float[] vx, float[] vy, float[] nx, float[] ny, float radius) {
    super(vx, vy, nx, ny, radius == 0);
    this.radius = radius;
  }

  /**
   * Creates a convex polygon from its outline, rounded by a radius.
   *
   * @param radius rounding, metres; 0 for sharp corners, else {@link Shape#MIN_SIZE} to {@link
   *     Shape#MAX_SIZE}
   * @param xy points as for {@link #of(float...)}
   */
  public static Polygon rounded(float radius, float... xy) {
    return of(xy).withRadius(radius);
  }

  /**
   * Returns a polygon with these vertices, rounded by a radius.
   *
   * @param newRadius rounding, metres; 0 for sharp corners, else {@link Shape#MIN_SIZE} to {@link
   *     Shape#MAX_SIZE}
   */
  public Polygon withRadius(float newRadius) {
    float checked = newRadius == 0 ? 0 : checkSize("polygon radius", newRadius);
    return new Polygon(vx, vy, nx, ny, checked);
  }

  /** Creates a convex polygon from its outline, see {@link #of(float...)}. */
  public static Polygon of(Vec2... points) {
    float[] xy = new float[2 * Limits.notNull("points", points).length];
    for (int i = 0; i < points.length; i++) {
      xy[2 * i] = Limits.notNull("point", points[i]).x();
      xy[2 * i + 1] = points[i].y();
    }
    return of(xy);
  }

  /**
   * Creates a convex polygon from its outline.
   *
   * @param xy x0, y0, x1, y1, ... in metres, along the outline in either winding
   * @throws IllegalArgumentException when the outline is concave or its points are not in order,
   *     and as {@link #hull}
   */
  public static Polygon of(float... xy) {
    Vec2[] points = points(xy);
    Vec2[] hull = convexHull(points);
    refuseConcave(points, hull);
    return build(hull, points.length);
  }

  /**
   * Creates the hull of 3 or more points in any order, by Andrew's monotone chain (1979).
   *
   * @param xy x0, y0, x1, y1, ... in metres
   * @throws IllegalArgumentException when a coordinate is not a number within {@link
   *     Shape#MAX_SIZE}, when the hull is thinner than {@link Shape#MIN_SIZE} or has more than
   *     {@value Convex#MAX_VERTICES} vertices
   */
  public static Polygon hull(float... xy) {
    Vec2[] points = points(xy);
    return build(convexHull(points), points.length);
  }

  private static Vec2[] points(float[] xy) {
    if (Limits.notNull("xy", xy).length % 2 != 0) {
      throw new IllegalArgumentException(
          "polygon coordinates=" + xy.length + " must be even: x and y of each vertex");
    }
    int given = xy.length / 2;
    if (given < 3 || given > MAX_POINTS) {
      throw new IllegalArgumentException(
          "polygon vertices=" + given + " must be in 3.." + MAX_POINTS);
    }
    Vec2[] points = new Vec2[given];
    for (int i = 0; i < given; i++) {
      // Adding 0 turns -0 into 0, which the sort below would tell apart from -0.
      points[i] =
          new Vec2(
              checkCoordinate("polygon x", i, xy[2 * i]) + 0f,
              checkCoordinate("polygon y", i, xy[2 * i + 1]) + 0f);
    }
    return points;
  }

  private static Vec2[] convexHull(Vec2[] points) {
    Vec2[] hull = cleaned(strictHull(points));
    if (hull.length > MAX_VERTICES) {
      throw new IllegalArgumentException(
          "polygon hull vertices=" + hull.length + " must be <= " + MAX_VERTICES);
    }
    return hull;
  }

  /**
   * Refuses points that aren't the outline of their hull: one of them is inside it, or they go
   * round it in another order. What is cleaned away is forgiven.
   */
  private static void refuseConcave(Vec2[] points, Vec2[] hull) {
    if (hull.length < 3) {
      return; // refused for its area
    }
    double slack = 2 * DUPLICATE * size(points);
    double perimeter = 0;
    for (int k = 0; k < hull.length; k++) {
      perimeter += distance(hull[k], hull[(k + 1) % hull.length]);
    }
    for (int i = 0; i < points.length; i++) {
      double inside = Double.POSITIVE_INFINITY;
      for (int k = 0; k < hull.length; k++) {
        Vec2 p = hull[k];
        Vec2 q = hull[(k + 1) % hull.length];
        inside = Math.min(inside, turn(p, q, points[i]) / distance(p, q));
      }
      if (inside > slack) {
        throw new IllegalArgumentException(
            "polygon point="
                + i
                + " is inside the hull, so the outline is concave; Compound.ofOutline cuts it into"
                + " convex parts, Polygon.hull takes its hull");
      }
    }
    double missing = Math.abs(twiceArea(hull)) - Math.abs(twiceArea(points));
    if (Math.abs(missing) > 2 * slack * perimeter) {
      throw new IllegalArgumentException(
          "polygon points are not in the order of an outline; sort them, or use Polygon.hull, which"
              + " takes any order");
    }
  }

  /** Returns twice the signed area that a way along points and back to the first one encloses. */
  private static double twiceArea(Vec2[] points) {
    double twice = 0;
    for (int i = 1; i + 1 < points.length; i++) {
      twice += turn(points[0], points[i], points[i + 1]);
    }
    return twice;
  }

  /**
   * Creates a regular polygon around the frame's origin with one vertex on the positive x axis.
   *
   * @param count number of vertices, 3 to {@value Convex#MAX_VERTICES}
   * @param radius distance of the vertices from the origin, metres
   */
  public static Polygon regular(int count, float radius) {
    if (count < 3 || count > MAX_VERTICES) {
      throw new IllegalArgumentException(
          "polygon vertices=" + count + " must be in 3.." + MAX_VERTICES);
    }
    checkSize("polygon radius", radius);
    float[] xy = new float[2 * count];
    for (int i = 0; i < count; i++) {
      float angleRad = 2 * Trig.PI * i / count;
      xy[2 * i] = radius * Trig.cos(angleRad);
      xy[2 * i + 1] = radius * Trig.sin(angleRad);
    }
    return of(xy);
  }

  private static Polygon build(Vec2[] hull, int given) {
    int n = hull.length;
    if (n < 3) {
      throw new IllegalArgumentException(
          "polygon area=0 must be > 0: the "
              + given
              + " vertices are (nearly) on one line or in one point");
    }
    float[] vx = new float[n];
    float[] vy = new float[n];
    float[] nx = new float[n];
    float[] ny = new float[n];
    double width = Double.POSITIVE_INFINITY;
    for (int i = 0; i < n; i++) {
      Vec2 p = hull[i];
      Vec2 q = hull[(i + 1) % n];
      double ex = (double) q.x() - p.x();
      double ey = (double) q.y() - p.y();
      double length = Math.sqrt(ex * ex + ey * ey);
      double farthest = 0;
      for (Vec2 v : hull) {
        double d = (ex * ((double) v.y() - p.y()) - ey * ((double) v.x() - p.x())) / length;
        farthest = Math.max(farthest, d);
      }
      width = Math.min(width, farthest);
      vx[i] = p.x();
      vy[i] = p.y();
      nx[i] = (float) (ey / length);
      ny[i] = (float) (-ex / length);
    }
    checkSize("polygon width", (float) width);
    return new Polygon(vx, vy, nx, ny, 0);
  }

  /**
   * Returns a polygon with exactly these vertices and normals, as an earlier build computed them.
   */
  static Polygon exact(float[] vx, float[] vy, float[] nx, float[] ny, float radius) {
    Polygon polygon = new Polygon(vx, vy, nx, ny, radius);
    polygon.checkEdges("polygon");
    return polygon;
  }

  /** Returns the strict convex hull, counter-clockwise, from the leftmost lowest point. */
  private static Vec2[] strictHull(Vec2[] points) {
    Vec2[] sorted = points.clone();
    Arrays.sort(
        sorted,
        (p, q) -> p.x() != q.x() ? Float.compare(p.x(), q.x()) : Float.compare(p.y(), q.y()));
    int n = sorted.length;
    Vec2[] chain = new Vec2[2 * n];
    int k = 0;
    for (int i = 0; i < n; i++) {
      while (k >= 2 && turn(chain[k - 2], chain[k - 1], sorted[i]) <= 0) {
        k--;
      }
      chain[k++] = sorted[i];
    }
    int lower = k + 1;
    for (int i = n - 2; i >= 0; i--) {
      while (k >= lower && turn(chain[k - 2], chain[k - 1], sorted[i]) <= 0) {
        k--;
      }
      chain[k++] = sorted[i];
    }
    return Arrays.copyOf(chain, Math.max(1, k - 1));
  }

  /** Drops near-duplicates and nearly straight corners until none is left, and returns the rest. */
  private static Vec2[] cleaned(Vec2[] hull) {
    Vec2[] kept = hull.clone();
    double size = size(kept);
    // Thin outlines are long: what is near is never a good part of the least width.
    double grain = 4 * Math.ulp((float) size);
    double near = Math.max(Math.min(DUPLICATE * size, 0.1 * MIN_SIZE), grain);
    double flat = Math.max(Math.min(COLLINEAR * size, 0.01 * MIN_SIZE), 0.25 * grain);
    int n = kept.length;
    boolean changed = true;
    while (changed && n >= 3) {
      changed = false;
      for (int i = 0; i < n && n >= 3; i++) {
        Vec2 before = kept[(i + n - 1) % n];
        Vec2 p = kept[i];
        Vec2 after = kept[(i + 1) % n];
        double chord = distance(before, after);
        boolean straight = Math.abs(turn(before, p, after)) <= flat * chord;
        if (straight || distance(before, p) <= near) {
          System.arraycopy(kept, i + 1, kept, i, n - i - 1);
          n--;
          i--;
          changed = true;
        }
      }
    }
    return Arrays.copyOf(kept, n);
  }

  private static double size(Vec2[] points) {
    double minX = Double.POSITIVE_INFINITY;
    double minY = Double.POSITIVE_INFINITY;
    double maxX = Double.NEGATIVE_INFINITY;
    double maxY = Double.NEGATIVE_INFINITY;
    for (Vec2 p : points) {
      minX = Math.min(minX, p.x());
      minY = Math.min(minY, p.y());
      maxX = Math.max(maxX, p.x());
      maxY = Math.max(maxY, p.y());
    }
    return Math.max(maxX - minX, maxY - minY);
  }

  private static double distance(Vec2 p, Vec2 q) {
    double dx = (double) q.x() - p.x();
    double dy = (double) q.y() - p.y();
    return Math.sqrt(dx * dx + dy * dy);
  }

  /**
   * Returns twice the signed area of a triangle, positive for a left turn at q. It uses differences
   * of floats, so it is nearly exact in double.
   */
  private static double turn(Vec2 p, Vec2 q, Vec2 r) {
    double qx = (double) q.x() - p.x();
    double qy = (double) q.y() - p.y();
    double rx = (double) r.x() - p.x();
    double ry = (double) r.y() - p.y();
    return qx * ry - qy * rx;
  }

  @Override
  public float radius() {
    return radius;
  }

  @Override
  public boolean containsPoint(float x, float y) {
    return radius == 0 ? super.containsPoint(x, y) : isWithin(x, y, radius);
  }

  @Override
  public float area() {
    if (radius > 0) {
      return roundedMass(1).mass();
    }
    double twice = 0;
    for (int i = 1; i < vx.length - 1; i++) {
      twice += cross(i);
    }
    return (float) (0.5 * twice);
  }

  /**
   * Returns mass, centroid and inertia by the shoelace formula and its moments, over the fan of
   * triangles at vertex 0. A triangle with the edge vectors a and b has the area a x b / 2, the
   * centroid (a + b) / 3 and the second moment (a x b)(a.a + a.b + b.b) / 12 about vertex 0
   * (Green's theorem; e.g. Bourke, "Calculating the area and centroid of a polygon", and its
   * second-moment counterpart). The parallel axis theorem then moves the sum to the centroid.
   * Coordinates relative to vertex 0 keep far-away polygons accurate.
   */
  @Override
  public MassData mass(float density) {
    checkDensity(density);
    if (radius > 0) {
      return roundedMass(density);
    }
    double twice = 0;
    double momentX = 0;
    double momentY = 0;
    double second = 0;
    for (int i = 1; i < vx.length - 1; i++) {
      double ax = (double) vx[i] - vx[0];
      double ay = (double) vy[i] - vy[0];
      double bx = (double) vx[i + 1] - vx[0];
      double by = (double) vy[i + 1] - vy[0];
      double cross = cross(i);
      twice += cross;
      momentX += cross * (ax + bx);
      momentY += cross * (ay + by);
      second += cross * (ax * ax + ay * ay + ax * bx + ay * by + bx * bx + by * by);
    }
    double centerX = momentX / (3 * twice);
    double centerY = momentY / (3 * twice);
    double area = 0.5 * twice;
    double inertia = second / 12 - area * (centerX * centerX + centerY * centerY);
    return new MassData(
        (float) (density * area),
        (float) (vx[0] + centerX),
        (float) (vy[0] + centerY),
        (float) (density * inertia));
  }

  /** Returns twice the area of the triangle of vertex 0 and edge i. */
  private double cross(int i) {
    double ax = (double) vx[i] - vx[0];
    double ay = (double) vy[i] - vy[0];
    double bx = (double) vx[i + 1] - vx[0];
    double by = (double) vy[i + 1] - vy[0];
    return ax * by - ay * bx;
  }

  @Override
  public Polygon moved(float dx, float dy) {
    float[] xs = vx.clone();
    float[] ys = vy.clone();
    for (int i = 0; i < xs.length; i++) {
      xs[i] = checkCoordinate("polygon x", i, xs[i] + dx);
      ys[i] = checkCoordinate("polygon y", i, ys[i] + dy);
    }
    Polygon moved = new Polygon(xs, ys, nx, ny, radius);
    moved.checkEdges("polygon");
    return moved;
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder("Polygon(");
    for (int i = 0; i < vx.length; i++) {
      text.append(i == 0 ? "" : ", ").append(vx[i]).append(' ').append(vy[i]);
    }
    if (radius > 0) {
      text.append(", radius=").append(radius);
    }
    return text.append(')').toString();
  }
}
