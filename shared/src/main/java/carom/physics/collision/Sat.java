package carom.physics.collision;

import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import carom.physics.math.Limits;
import carom.physics.math.Transform;
import java.util.List;

/**
 * Tests shapes for overlap and computes minimum translation vectors. An instance holds scratch
 * memory, so use one per thread; no call allocates.
 *
 * <p>For convex shapes the answer is the true minimum, deep overlap and containment included: the
 * shortest way out is the distance to the border of the Minkowski difference, whose faces are the
 * faces of A and B (separating axis theorem), and whose rounded corners matter only while a
 * circle's centre is outside the polygon. It computes in double precision.
 *
 * <p>For compounds the answer is the deepest MTV among all pairs of parts. It moves that pair
 * apart; other pairs may still overlap, and callers that must be free of them apply the move and
 * ask again.
 *
 * <p>The pair is sorted by its values only (shape, then pose), and the result is negated if that
 * swapped the two. So swapping A and B gives exactly the negated result, ties included; only two
 * equal shapes in equal poses cannot be told apart and get the same result both ways. Of equally
 * good faces the first in order is taken, the first shape's faces before the second's. If the
 * centres of two circles coincide, the MTV is along the y axis. If a circle's centre is on an edge
 * or vertex of a polygon, it is along the edge's normal.
 *
 * <p>A chain's segments collide from both sides here, because they are lines, and a line has a
 * shortest way out.
 */
public final class Sat {
  private final double[] ax = new double[Convex.MAX_VERTICES];
  private final double[] ay = new double[Convex.MAX_VERTICES];
  private final double[] bx = new double[Convex.MAX_VERTICES];
  private final double[] by = new double[Convex.MAX_VERTICES];

  private final Core coreA = new Core();
  private final Core coreB = new Core();
  private final Gjk gjk = new Gjk();

  // The best answer so far: depth and direction in which the first shape has to go.
  private double depth;
  private double pushX;
  private double pushY;

  /** Makes an instance with its own scratch memory. */
  public Sat() {}

  /**
   * Finds the shortest move that takes A out of B.
   *
   * @param a shape A in its body's frame
   * @param ta pose of A, read only, finite
   * @param b shape B in its body's frame
   * @param tb pose of B, read only, finite
   * @param out receives the move of A in world axes, metres; zero when the result is false
   * @return true when the shapes overlap; false when they are apart or only touch
   */
  public boolean mtv(Shape a, Transform ta, Shape b, Transform tb, Mtv out) {
    Core.checkPair(a, ta, b, tb);
    Limits.notNull("out", out);
    boolean swapped = compare(a, ta, b, tb) > 0;
    Shape first = swapped ? b : a;
    Shape second = swapped ? a : b;
    Transform t1 = swapped ? tb : ta;
    Transform t2 = swapped ? ta : tb;
    double deepest = 0;
    double x = 0;
    double y = 0;
    List<Convex> parts1 = first.parts();
    List<Convex> parts2 = second.parts();
    for (int i = 0; i < parts1.size(); i++) {
      for (int j = 0; j < parts2.size(); j++) {
        if (convex(parts1.get(i), t1, parts2.get(j), t2) && depth > deepest) {
          deepest = depth;
          x = pushX;
          y = pushY;
        }
      }
    }
    if (!(deepest > 0)) {
      out.set(0, 0);
      return false;
    }
    double length = swapped ? -deepest : deepest;
    out.set((float) (x * length), (float) (y * length));
    return true;
  }

  private boolean convex(Convex a, Transform ta, Convex b, Transform tb) {
    if (!(a.isSimple() && b.isSimple())) {
      return rounded(a, ta, b, tb);
    }
    int countA = place(a, ta, 0, 0, ax, ay);
    int countB = place(b, tb, (double) tb.x - ta.x, (double) tb.y - ta.y, bx, by);
    double radii = (double) a.radius() + b.radius();
    depth = Double.POSITIVE_INFINITY;
    if (countA == 1 && countB == 1) {
      corner(ax[0] - bx[0], ay[0] - by[0], radii);
      return depth > 0;
    }
    if (countA > 1 && !faces(ax, ay, countA, bx, by, countB, radii, -1)) {
      return false;
    }
    if (countB > 1 && !faces(bx, by, countB, ax, ay, countA, radii, 1)) {
      return false;
    }
    // Depth beyond the radius means that the circle's centre is inside, where faces are nearest.
    if (radii > 0 && depth < radii) {
      if (countA == 1) {
        roundCorners(bx, by, countB, ax[0], ay[0], radii, 1);
      } else {
        roundCorners(ax, ay, countA, bx[0], by[0], radii, -1);
      }
    }
    return depth > 0;
  }

  /**
   * Finds the way out of a pair with a capsule, a segment or a rounded polygon. While the shapes
   * without their rounding are apart, it is along their shortest connection; if they overlap too,
   * along a face's normal.
   */
  private boolean rounded(Convex a, Transform ta, Convex b, Transform tb) {
    coreA.place(a, ta, ta.x, ta.y);
    coreB.place(b, tb, ta.x, ta.y);
    gjk.run(coreA, coreB);
    double radii = coreA.radius + coreB.radius;
    depth = Double.POSITIVE_INFINITY;
    if (gjk.distance > 0) {
      depth = radii - gjk.distance;
      pushX = -gjk.normalX;
      pushY = -gjk.normalY;
    } else {
      boolean apart =
          coreA.count > 1
              && !faces(coreA.x, coreA.y, coreA.count, coreB.x, coreB.y, coreB.count, radii, -1);
      apart |=
          coreB.count > 1
              && !faces(coreB.x, coreB.y, coreB.count, coreA.x, coreA.y, coreA.count, radii, 1);
      depth = apart ? 0 : depth;
    }
    return depth > 0;
  }

  /**
   * Writes the vertices of a shape in world axes, relative to the position of A, and returns their
   * number.
   */
  private static int place(
      Convex shape, Transform t, double x, double y, double[] xs, double[] ys) {
    int count = shape.vertexCount();
    for (int i = 0; i < count; i++) {
      double vx = shape.vertexX(i);
      double vy = shape.vertexY(i);
      xs[i] = x + t.cos * vx - t.sin * vy;
      ys[i] = y + t.sin * vx + t.cos * vy;
    }
    return count;
  }

  /**
   * Tries all faces of one polygon as the way out. Returns false if one separates the shapes. A
   * push along an outward normal n moves the other shape; {@code sign} -1 says that the owner of
   * the faces is the one to move, hence against n.
   */
  private boolean faces(
      double[] xs,
      double[] ys,
      int count,
      double[] otherXs,
      double[] otherYs,
      int otherCount,
      double radii,
      int sign) {
    for (int i = 0; i < count; i++) {
      int next = i + 1 == count ? 0 : i + 1;
      double ex = xs[next] - xs[i];
      double ey = ys[next] - ys[i];
      double length = Math.sqrt(ex * ex + ey * ey);
      double nx = ey / length;
      double ny = -ex / length;
      double low = Double.POSITIVE_INFINITY;
      for (int j = 0; j < otherCount; j++) {
        low = Math.min(low, nx * (otherXs[j] - xs[i]) + ny * (otherYs[j] - ys[i]));
      }
      double overlap = radii - low;
      if (!(overlap > 0)) {
        return false;
      }
      if (overlap < depth) {
        depth = overlap;
        pushX = sign * nx;
        pushY = sign * ny;
      }
    }
    return true;
  }

  /**
   * Corrects the way out for a circle's centre (cx, cy) outside a polygon. If it faces a vertex,
   * the way out leads away from that vertex.
   */
  private void roundCorners(
      double[] xs, double[] ys, int count, double cx, double cy, double radii, int sign) {
    double nearest = Double.POSITIVE_INFINITY;
    int vertex = 0;
    for (int i = 0; i < count; i++) {
      double dx = cx - xs[i];
      double dy = cy - ys[i];
      double squared = dx * dx + dy * dy;
      if (squared < nearest) {
        nearest = squared;
        vertex = i;
      }
    }
    int before = vertex == 0 ? count - 1 : vertex - 1;
    int after = vertex + 1 == count ? 0 : vertex + 1;
    double dx = cx - xs[vertex];
    double dy = cy - ys[vertex];
    boolean beyondBefore = dx * (xs[vertex] - xs[before]) + dy * (ys[vertex] - ys[before]) > 0;
    boolean beyondAfter = dx * (xs[vertex] - xs[after]) + dy * (ys[vertex] - ys[after]) > 0;
    if (beyondBefore && beyondAfter && nearest > 0) {
      corner(sign * dx, sign * dy, radii);
    }
  }

  /** Sets the way out between two centres, given (dx, dy) from the second's to the first's. */
  private void corner(double dx, double dy, double radii) {
    double distance = Math.sqrt(dx * dx + dy * dy);
    depth = radii - distance;
    pushX = distance > 0 ? dx / distance : 0;
    pushY = distance > 0 ? dy / distance : -1;
  }

  private static int compare(Shape a, Transform ta, Shape b, Transform tb) {
    int order = a == b ? 0 : compare(a.parts(), b.parts());
    if (order == 0) {
      order = Float.compare(ta.x, tb.x);
    }
    if (order == 0) {
      order = Float.compare(ta.y, tb.y);
    }
    if (order == 0) {
      order = Float.compare(ta.cos, tb.cos);
    }
    return order == 0 ? Float.compare(ta.sin, tb.sin) : order;
  }

  private static int compare(List<Convex> a, List<Convex> b) {
    int order = Integer.compare(a.size(), b.size());
    for (int i = 0; i < a.size() && order == 0; i++) {
      order = compare(a.get(i), b.get(i));
    }
    return order;
  }

  private static int compare(Convex a, Convex b) {
    int order = Integer.compare(a.vertexCount(), b.vertexCount());
    if (order == 0) {
      order = Float.compare(a.radius(), b.radius());
    }
    for (int i = 0; order == 0 && i < a.vertexCount(); i++) {
      order = Float.compare(a.vertexX(i), b.vertexX(i));
      if (order == 0) {
        order = Float.compare(a.vertexY(i), b.vertexY(i));
      }
    }
    return order;
  }
}
