package carom.physics.collision;

import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * The vertices of a convex shape in a pose, without its rounding. They are in double precision,
 * relative to a near point that the caller chooses. Reused scratch memory.
 */
public final class Core {
  public final double[] x = new double[Convex.MAX_VERTICES];
  public final double[] y = new double[Convex.MAX_VERTICES];
  public int count;
  public double radius;

  /** Refuses shapes or poses that are null. */
  static void checkPair(Shape a, Transform ta, Shape b, Transform tb) {
    Limits.notNull("a", a);
    Limits.notNull("ta", ta);
    Limits.notNull("b", b);
    Limits.notNull("tb", tb);
  }

  /** Copies a shape's vertices in world axes, relative to the point (originX, originY). */
  public void place(Convex shape, Transform t, double originX, double originY) {
    Limits.notNull("t", t);
    place(shape, t.x - originX, t.y - originY, t.cos, t.sin);
  }

  /** Copies a shape's vertices, turned by (cos, sin) and moved by (dx, dy). */
  public void place(Convex shape, double dx, double dy, double cos, double sin) {
    Limits.notNull("shape", shape);
    count = shape.vertexCount();
    radius = shape.radius();
    for (int i = 0; i < count; i++) {
      double px = shape.vertexX(i);
      double py = shape.vertexY(i);
      x[i] = dx + (cos * px - sin * py);
      y[i] = dy + (sin * px + cos * py);
    }
  }

  /** Sets the core to a single point without radius. */
  void point(double px, double py) {
    count = 1;
    radius = 0;
    x[0] = px;
    y[0] = py;
  }

  /** Moves all vertices. */
  void shift(double dx, double dy) {
    for (int i = 0; i < count; i++) {
      x[i] += dx;
      y[i] += dy;
    }
  }

  /** Returns the vertex farthest along (dx, dy). Of equally far vertices it is the first. */
  public int support(double dx, double dy) {
    int best = 0;
    double high = x[0] * dx + y[0] * dy;
    for (int i = 1; i < count; i++) {
      double d = x[i] * dx + y[i] * dy;
      if (d > high) {
        high = d;
        best = i;
      }
    }
    return best;
  }
}
