package carom.physics.collision.distance;

import carom.physics.geometry.Convex;
import carom.physics.math.Transform;

/**
 * A convex shape in a pose, without its rounding: the vertices, in double precision, relative to
 * some point that the user chooses near by. Reused scratch memory.
 */
public final class Core {
  public final double[] x = new double[Convex.MAX_VERTICES];
  public final double[] y = new double[Convex.MAX_VERTICES];
  public int count;
  public double radius;

  /** Takes the vertices over, in world axes, relative to the point (originX, originY). */
  public void place(Convex shape, Transform t, double originX, double originY) {
    place(shape, t.x - originX, t.y - originY, t.cos, t.sin);
  }

  /** Takes the vertices over, turned by (cos, sin) and moved by (dx, dy). */
  public void place(Convex shape, double dx, double dy, double cos, double sin) {
    count = shape.vertexCount();
    radius = shape.radius();
    for (int i = 0; i < count; i++) {
      double px = shape.vertexX(i);
      double py = shape.vertexY(i);
      x[i] = dx + (cos * px - sin * py);
      y[i] = dy + (sin * px + cos * py);
    }
  }

  /** Becomes a single point. */
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

  /** The vertex farthest along (dx, dy), of equal ones the first. */
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
