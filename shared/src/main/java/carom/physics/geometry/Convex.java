package carom.physics.geometry;

import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;
import java.util.Arrays;
import java.util.List;

/**
 * A convex shape: the vertices of a convex polygon with a {@link #radius()} around them, which may
 * be 0. A {@link Circle} has a single vertex, a {@link Capsule} and a {@link Segment} have two.
 *
 * <p>Vertices go counter-clockwise. Edge i leads from vertex i to vertex i + 1 (the last one back
 * to vertex 0), and its unit normal points outwards. A circle has no edges; its only normal is (0,
 * 0). Two vertices have two edges, one for each side.
 */
public abstract sealed class Convex extends Shape permits Circle, Box, Polygon, Capsule, Segment {
  /** Largest number of vertices of a convex shape. */
  public static final int MAX_VERTICES = 64;

  final float[] vx;
  final float[] vy;
  final float[] nx;
  final float[] ny;
  private final boolean simple;
  private final List<Convex> self = List.of(this);

  Convex(float[] vx, float[] vy, float[] nx, float[] ny) {
    this(vx, vy, nx, ny, true);
  }

  Convex(float[] vx, float[] vy, float[] nx, float[] ny, boolean simple) {
    this.simple = simple;
    this.vx = vx;
    this.vy = vy;
    this.nx = nx;
    this.ny = ny;
  }

  /**
   * Returns the number of vertices: 1 for a circle, 2 for a capsule or segment, 4 for a box, 3 to
   * {@value #MAX_VERTICES} for a polygon.
   */
  public final int vertexCount() {
    return vx.length;
  }

  /**
   * Returns the x of a vertex, or of a circle's centre, in metres. An {@code index} outside 0 ..
   * vertexCount() - 1 throws an IndexOutOfBoundsException.
   */
  public final float vertexX(int index) {
    return vx[check(index)];
  }

  /**
   * Returns the y of a vertex, or of a circle's centre, in metres. An {@code index} outside 0 ..
   * vertexCount() - 1 throws an IndexOutOfBoundsException.
   */
  public final float vertexY(int index) {
    return vy[check(index)];
  }

  /**
   * Returns the x of the outward unit normal of the edge that starts at vertex {@code index}; 0 for
   * a circle.
   */
  public final float normalX(int index) {
    return nx[check(index)];
  }

  /**
   * Returns the y of the outward unit normal of the edge that starts at vertex {@code index}; 0 for
   * a circle.
   */
  public final float normalY(int index) {
    return ny[check(index)];
  }

  private int check(int index) {
    return Limits.index("vertex", index, vx.length);
  }

  /** Returns the radius of the rounding around the vertices in metres, or 0 for sharp corners. */
  public abstract float radius();

  /**
   * Returns the radius of the largest disc around the mean of the vertices that fits into the
   * shape, in metres. A body may sink in that far before it reaches the middle. It is 0 for a
   * segment.
   */
  public final float innerRadius() {
    int count = vx.length;
    double least = count > 2 ? Double.MAX_VALUE : 0;
    double x = 0;
    double y = 0;
    for (int i = 0; i < count; i++) {
      x += (double) vx[i] / count;
      y += (double) vy[i] / count;
    }
    for (int i = 0; count > 2 && i < count; i++) {
      least = Math.min(least, nx[i] * (vx[i] - x) + ny[i] * (vy[i] - y));
    }
    return (float) least + radius();
  }

  /**
   * Refuses a shape that is so small and so far from the origin that rounding has merged vertices.
   */
  final void checkEdges(String what) {
    for (int i = 0; i < vx.length; i++) {
      int next = i + 1 == vx.length ? 0 : i + 1;
      if (vx[i] == vx[next] && vy[i] == vy[next]) {
        throw new IllegalArgumentException(
            what
                + " edge"
                + i
                + "=0.0 m at "
                + vx[i]
                + ", "
                + vy[i]
                + ": too small for a place where floats are "
                + Math.ulp(Math.max(Math.abs(vx[i]), Math.abs(vy[i])))
                + " m apart; place the body there, and the shape near the body's origin");
      }
    }
  }

  /**
   * Returns true for discs and for polygons with sharp corners, which have a cheaper collision
   * algorithm.
   */
  public final boolean isSimple() {
    return simple;
  }

  /**
   * Returns whether another shape is interchangeable with this one: of the same class, with the
   * same bits. It compares every vertex.
   *
   * @param other another shape, which may be this one
   * @return true if one shape can replace the other
   */
  public boolean isSame(Convex other) {
    return Limits.notNull("other", other).getClass() == getClass()
        && other.radius() == radius()
        && Arrays.equals(vx, other.vx)
        && Arrays.equals(vy, other.vy)
        && Arrays.equals(nx, other.nx)
        && Arrays.equals(ny, other.ny);
  }

  /**
   * Returns one component of the unit normals of both sides of a line, computed from (component,
   * other).
   */
  static float[] pairNormal(double component, double other) {
    double length = Math.sqrt(component * component + other * other);
    float n = (float) (component / length);
    return new float[] {n, -n};
  }

  /** Returns the length of an edge, metres. */
  final double lengthOf(int edge) {
    int next = edge + 1 == vx.length ? 0 : edge + 1;
    double ex = (double) vx[next] - vx[edge];
    double ey = (double) vy[next] - vy[edge];
    return Math.sqrt(ex * ex + ey * ey);
  }

  /**
   * Returns whether a point is in the polygon of the vertices or within a distance of its edges.
   */
  final boolean isWithin(float x, float y, float distance) {
    int count = vx.length;
    boolean inside = count > 2;
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      int next = i + 1 == count ? 0 : i + 1;
      double dx = (double) x - vx[i];
      double dy = (double) y - vy[i];
      double ex = (double) vx[next] - vx[i];
      double ey = (double) vy[next] - vy[i];
      double u = Math.max(0, Math.min(1, (dx * ex + dy * ey) / (ex * ex + ey * ey)));
      double px = dx - u * ex;
      double py = dy - u * ey;
      nearest = Math.min(nearest, px * px + py * py);
      inside &= nx[i] * dx + ny[i] * dy <= 0;
    }
    return inside || nearest <= (double) distance * distance;
  }

  /**
   * Returns the mass of a rounded polygon of two vertices or more, which is the polygon, a
   * rectangle along each edge, and a sector of a disc at each corner.
   *
   * <p>A sector of radius r between the normals m and n has the area r&sup2; phi / 2, the first
   * moment r&sup3; / 3 (n.y - m.y, m.x - n.x) (the integral of the unit vector over the angle), and
   * the second moment r^4 phi / 4 about its corner. All moments are summed about vertex 0 and moved
   * to the centroid at the end.
   */
  final MassData roundedMass(float density) {
    double r = radius();
    double area = 0;
    double mx = 0;
    double my = 0;
    double second = 0;
    int count = vx.length;
    for (int i = 0; i < count; i++) {
      int next = i + 1 == count ? 0 : i + 1;
      int before = i == 0 ? count - 1 : i - 1;
      double px = (double) vx[i] - vx[0];
      double py = (double) vy[i] - vy[0];
      double qx = (double) vx[next] - vx[0];
      double qy = (double) vy[next] - vy[0];
      double cross = px * qy - py * qx;
      area += 0.5 * cross;
      mx += cross * (px + qx) / 6;
      my += cross * (py + qy) / 6;
      second += cross * (px * px + py * py + px * qx + py * qy + qx * qx + qy * qy) / 12;
      double length = lengthOf(i);
      double strip = length * r;
      double cx = 0.5 * (px + qx + r * nx[i]);
      double cy = 0.5 * (py + qy + r * ny[i]);
      area += strip;
      mx += strip * cx;
      my += strip * cy;
      second += strip * ((length * length + r * r) / 12 + cx * cx + cy * cy);
      double phi =
          StrictMath.atan2(
              (double) nx[before] * ny[i] - (double) ny[before] * nx[i],
              (double) nx[before] * nx[i] + (double) ny[before] * ny[i]);
      double turn = count == 2 ? Math.PI : phi;
      double sector = 0.5 * r * r * turn;
      double sx = r * r * r / 3 * ((double) ny[i] - ny[before]);
      double sy = r * r * r / 3 * ((double) nx[before] - nx[i]);
      area += sector;
      mx += sector * px + sx;
      my += sector * py + sy;
      second += 0.5 * r * r * sector + 2 * (px * sx + py * sy) + sector * (px * px + py * py);
    }
    double centerX = mx / area;
    double centerY = my / area;
    double inertia = second - area * (centerX * centerX + centerY * centerY);
    return new MassData(
        (float) (density * area),
        (float) (vx[0] + centerX),
        (float) (vy[0] + centerY),
        (float) (density * inertia));
  }

  @Override
  public abstract Convex moved(float dx, float dy);

  @Override
  public final List<Convex> parts() {
    return self;
  }

  @Override
  public void aabb(Transform t, Aabb out) {
    Limits.notNull("t", t);
    Limits.notNull("out", out);
    float minX = Float.POSITIVE_INFINITY;
    float minY = Float.POSITIVE_INFINITY;
    float maxX = Float.NEGATIVE_INFINITY;
    float maxY = Float.NEGATIVE_INFINITY;
    for (int i = 0; i < vx.length; i++) {
      float x = t.cos * vx[i] - t.sin * vy[i];
      float y = t.sin * vx[i] + t.cos * vy[i];
      minX = Math.min(minX, x);
      minY = Math.min(minY, y);
      maxX = Math.max(maxX, x);
      maxY = Math.max(maxY, y);
    }
    float r = radius();
    out.set(t.x + (minX - r), t.y + (minY - r), t.x + (maxX + r), t.y + (maxY + r));
  }

  @Override
  public boolean containsPoint(float x, float y) {
    for (int i = 0; i < vx.length; i++) {
      if (nx[i] * (x - vx[i]) + ny[i] * (y - vy[i]) > 0) {
        return false;
      }
    }
    return !Float.isNaN(x + y);
  }

  @Override
  public float reach() {
    double farthest = 0;
    for (int i = 0; i < vx.length; i++) {
      farthest = Math.max(farthest, (double) vx[i] * vx[i] + (double) vy[i] * vy[i]);
    }
    return (float) Math.sqrt(farthest) + radius();
  }
}
