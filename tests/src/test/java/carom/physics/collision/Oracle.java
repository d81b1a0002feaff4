package carom.physics.collision;

import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import carom.physics.math.Transform;
import java.util.SplittableRandom;

/** Slow and obvious answers, and random questions. */
public final class Oracle {
  /** Kinds of shapes {@link #shape} makes. */
  public static final int KINDS = 6;

  private Oracle() {}

  public static Convex shape(int kind, SplittableRandom random) {
    return shape(kind, random, 1);
  }

  /** A shape of about a given size, m. */
  public static Convex shape(int kind, SplittableRandom random, double size) {
    float cx = (float) (size * random.nextDouble(-0.3, 0.3));
    float cy = (float) (size * random.nextDouble(-0.3, 0.3));
    float w = (float) (size * random.nextDouble(0.2, 1));
    float h = (float) (size * random.nextDouble(0.2, 1));
    if (kind == 0) {
      return new Circle(w, cx, cy);
    }
    if (kind == 1) {
      return new Box(w, h, cx, cy);
    }
    if (kind == 3) {
      return new Capsule(cx, cy, cx + w, cy - h, 0.3f * h);
    }
    if (kind == 4) {
      return new Segment(cx, cy, cx - w, cy - h);
    }
    float[] xy = new float[2 * random.nextInt(5, 12)];
    for (int i = 0; i < xy.length; i++) {
      xy[i] = (float) (size * random.nextDouble(-1, 1));
    }
    return Polygon.hull(xy).withRadius(kind == 5 ? 0.2f * w : 0);
  }

  public static Transform pose(SplittableRandom random, double spread) {
    return new Transform(
        (float) random.nextDouble(-spread, spread),
        (float) random.nextDouble(-spread, spread),
        (float) random.nextDouble(-4, 4));
  }

  static double x(Convex s, Transform t, int i) {
    return t.x + (double) t.cos * s.vertexX(i) - (double) t.sin * s.vertexY(i);
  }

  static double y(Convex s, Transform t, int i) {
    return t.y + (double) t.sin * s.vertexX(i) + (double) t.cos * s.vertexY(i);
  }

  /** Farthest extent of a shape along (cos a, sin a). */
  private static double support(Convex s, Transform t, double ux, double uy) {
    double best = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < s.vertexCount(); i++) {
      best = Math.max(best, ux * x(s, t, i) + uy * y(s, t, i));
    }
    return best + s.radius();
  }

  private static double gap(Convex a, Transform ta, Convex b, Transform tb, double angle) {
    double ux = Math.cos(angle);
    double uy = Math.sin(angle);
    return -support(b, tb, -ux, -uy) - support(a, ta, ux, uy);
  }

  /** Largest gap over all directions from A to B: the distance, or minus the least overlap. */
  public static double separation(Convex a, Transform ta, Convex b, Transform tb) {
    return separation(a, ta, b, tb, 1);
  }

  /** The same for shapes of about a given size, m. */
  public static double separation(Convex a, Transform ta, Convex b, Transform tb, double size) {
    int steps = 1440;
    double step = 2 * Math.PI / steps;
    double[] gaps = new double[steps];
    double best = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < steps; i++) {
      gaps[i] = gap(a, ta, b, tb, i * step);
      best = Math.max(best, gaps[i]);
    }
    double coarse = best;
    for (int i = 0; i < steps; i++) {
      double before = gaps[(i + steps - 1) % steps];
      boolean peak = gaps[i] >= before && gaps[i] >= gaps[(i + 1) % steps];
      if (peak && gaps[i] > coarse - 0.03 * size) {
        double low = (i - 1) * step;
        double high = (i + 1) * step;
        for (int k = 0; k < 40; k++) {
          double p = low + (high - low) / 3;
          double q = high - (high - low) / 3;
          if (gap(a, ta, b, tb, p) < gap(a, ta, b, tb, q)) {
            low = p;
          } else {
            high = q;
          }
        }
        best = Math.max(best, gap(a, ta, b, tb, (low + high) / 2));
      }
    }
    return best;
  }

  /**
   * Signed distance of a point from a shape's border, exact outside; inside minus the distance to
   * the nearest face.
   */
  public static double distance(Convex s, Transform t, double px, double py) {
    int n = s.vertexCount();
    double inside = n <= 2 ? 1 : Double.NEGATIVE_INFINITY;
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < n; i++) {
      int k = (i + 1) % n;
      double ex = x(s, t, k) - x(s, t, i);
      double ey = y(s, t, k) - y(s, t, i);
      double dx = px - x(s, t, i);
      double dy = py - y(s, t, i);
      double length = Math.hypot(ex, ey);
      double u = n == 1 ? 0 : Math.max(0, Math.min(1, (dx * ex + dy * ey) / (length * length)));
      nearest = Math.min(nearest, Math.hypot(dx - u * ex, dy - u * ey));
      if (n > 1) {
        inside = Math.max(inside, (ey * dx - ex * dy) / length);
      }
    }
    return (inside > 0 ? nearest : inside) - s.radius();
  }
}
