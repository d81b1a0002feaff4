package carom.physics.geometry;

import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.List;

/**
 * A convex shape: the vertices of a convex polygon, or for a {@link Circle} a single vertex with a
 * {@link #radius()} around it.
 *
 * <p>Vertices go counter-clockwise; edge i leads from vertex i to vertex i + 1 (the last one back
 * to vertex 0), and its normal of length one points outwards. A circle has no edges; its only
 * normal is (0, 0).
 */
public abstract sealed class Convex extends Shape permits Circle, Box, Polygon {
  /** Most vertices a convex shape can have. */
  public static final int MAX_VERTICES = 64;

  final float[] vx;
  final float[] vy;
  final float[] nx;
  final float[] ny;
  private final List<Convex> self = List.of(this);

  Convex(float[] vx, float[] vy, float[] nx, float[] ny) {
    this.vx = vx;
    this.vy = vy;
    this.nx = nx;
    this.ny = ny;
  }

  /**
   * How many vertices there are: 1 for a circle, 4 for a box, 3 to {@value #MAX_VERTICES} for a
   * polygon.
   */
  public final int vertexCount() {
    return vx.length;
  }

  /**
   * X of a vertex (a circle's centre); {@code index} in 0 .. vertexCount() - 1, else
   * IndexOutOfBoundsException.
   */
  public final float vertexX(int index) {
    return vx[index];
  }

  /**
   * Y of a vertex (a circle's centre); {@code index} in 0 .. vertexCount() - 1, else
   * IndexOutOfBoundsException.
   */
  public final float vertexY(int index) {
    return vy[index];
  }

  /**
   * X of the outward unit normal of the edge that starts at vertex {@code index}; 0 for a circle.
   */
  public final float normalX(int index) {
    return nx[index];
  }

  /**
   * Y of the outward unit normal of the edge that starts at vertex {@code index}; 0 for a circle.
   */
  public final float normalY(int index) {
    return ny[index];
  }

  /** Rounding around the vertices, metres: a circle's radius, 0 for the others. */
  public abstract float radius();

  /**
   * Copies vertices and normals into the caller's arrays, each of at least vertexCount() floats;
   * returns vertexCount().
   */
  public final int copyTo(float[] xs, float[] ys, float[] normalXs, float[] normalYs) {
    int count = vx.length;
    System.arraycopy(vx, 0, xs, 0, count);
    System.arraycopy(vy, 0, ys, 0, count);
    System.arraycopy(nx, 0, normalXs, 0, count);
    System.arraycopy(ny, 0, normalYs, 0, count);
    return count;
  }

  /** Refuses shapes so small and so far from the origin that rounding has merged vertices. */
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

  @Override
  public abstract Convex moved(float dx, float dy);

  @Override
  public final List<Convex> parts() {
    return self;
  }

  @Override
  public void aabb(Transform t, Aabb out) {
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
