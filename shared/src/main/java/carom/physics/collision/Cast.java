package carom.physics.collision;

import carom.physics.geometry.Convex;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * Casts rays and moving shapes against a shape at rest. An instance holds scratch memory, so use
 * one per thread; no call allocates. It computes in double precision.
 *
 * <p>A cast goes from its start along (dx, dy), metres, and ends at the largest fraction of that
 * way: a finite number, not negative, where 1 is the whole way.
 *
 * <h2>Beginning inside</h2>
 *
 * A cast that begins inside the shape or on its border hits at fraction 0 with the normal (0, 0),
 * see {@link CastHit#isInside()}, whichever way it goes. A cast of length zero hits in no other
 * case.
 */
public final class Cast {
  /** Gap, metres, up to which a moving shape has arrived. */
  private static final double ARRIVED = 1e-7;

  /** Distance, metres, above which the direction between closest points is exact enough. */
  private static final double SURE = 1e-9;

  private static final int MAX_STEPS = 64;

  private final Core coreA = new Core();
  private final Core coreB = new Core();
  private final Gjk gjk = new Gjk();

  // The ray in the frame of the shape, and the best hit so far.
  private double originX;
  private double originY;
  private double dirX;
  private double dirY;
  private double best;
  private double bestX;
  private double bestY;

  /** Makes an instance with its own scratch memory. */
  public Cast() {}

  /**
   * Casts a ray against a shape. The hit is exact up to the rounding of the result, for edges and
   * rounded corners alike.
   *
   * <p>Shapes are closed: a ray that merely touches a corner or slides along an edge hits; only one
   * along a {@code Segment} itself, which has no inside, misses.
   *
   * @param shape in its body's frame
   * @param t its pose, read only, finite
   * @param x world x of the ray's start, metres
   * @param y world y of the ray's start, metres
   * @param dx way of the ray along x, metres
   * @param dy way of the ray along y, metres
   * @param maxFraction where the ray ends, in units of its way
   * @param out receives the hit; untouched when there is none
   * @return whether the ray meets the shape
   */
  public boolean ray(
      Convex shape,
      Transform t,
      float x,
      float y,
      float dx,
      float dy,
      float maxFraction,
      CastHit out) {
    Limits.notNull("shape", shape);
    Limits.notNull("t", t);
    Limits.notNull("out", out);
    double rx = (double) x - t.x;
    double ry = (double) y - t.y;
    originX = t.cos * rx + t.sin * ry;
    originY = t.cos * ry - t.sin * rx;
    dirX = (double) t.cos * dx + (double) t.sin * dy;
    dirY = (double) t.cos * dy - (double) t.sin * dx;
    best = Double.POSITIVE_INFINITY;
    bestX = 0;
    bestY = 0;
    if (shape.vertexCount() > 2 && shape.radius() == 0) {
      clip(shape);
    } else {
      rounded(shape);
    }
    if (!(best <= maxFraction)) {
      return false;
    }
    out.set(
        best,
        t.cos * bestX - t.sin * bestY,
        t.sin * bestX + t.cos * bestY,
        x + best * dx,
        y + best * dy);
    return true;
  }

  /**
   * Casts the ray against a polygon without rounding, by clipping it to the half planes (Cyrus and
   * Beck 1978).
   */
  private void clip(Convex shape) {
    double enter = -1;
    double leave = Double.POSITIVE_INFINITY;
    int edge = -1;
    for (int i = 0; i < shape.vertexCount(); i++) {
      double nx = shape.normalX(i);
      double ny = shape.normalY(i);
      double height = nx * (originX - shape.vertexX(i)) + ny * (originY - shape.vertexY(i));
      double rate = nx * dirX + ny * dirY;
      if (rate < 0) {
        double at = -height / rate;
        if (height > 0 && at > enter) {
          enter = at;
          edge = i;
        }
      } else if (height > 0) {
        return;
      } else if (rate > 0) {
        leave = Math.min(leave, -height / rate);
      }
    }
    if (edge < 0) {
      best = 0;
    } else if (enter <= leave) {
      best = enter;
      bestX = shape.normalX(edge);
      bestY = shape.normalY(edge);
    }
  }

  /**
   * Casts the ray against a rounded shape. Its surface consists of edges moved outwards and of
   * discs at the corners.
   */
  private void rounded(Convex shape) {
    int count = shape.vertexCount();
    double radius = shape.radius();
    if (radius > 0 && isInside(shape, radius)) {
      best = 0;
      return;
    }
    for (int i = 0; i < count; i++) {
      if (count > 1) {
        edge(shape, i, i + 1 == count ? 0 : i + 1, radius);
      }
      if (radius > 0) {
        corner(shape.vertexX(i), shape.vertexY(i), radius);
      }
    }
  }

  private boolean isInside(Convex shape, double radius) {
    coreA.place(shape, 0, 0, 1, 0);
    coreB.point(originX, originY);
    gjk.run(coreA, coreB);
    return gjk.distance <= radius;
  }

  private void edge(Convex shape, int from, int to, double radius) {
    double nx = shape.normalX(from);
    double ny = shape.normalY(from);
    double px = shape.vertexX(from) + radius * nx;
    double py = shape.vertexY(from) + radius * ny;
    double ex = (double) shape.vertexX(to) - shape.vertexX(from);
    double ey = (double) shape.vertexY(to) - shape.vertexY(from);
    double height = nx * (originX - px) + ny * (originY - py);
    double rate = nx * dirX + ny * dirY;
    if (!(rate < 0 && height >= 0)) {
      return;
    }
    double at = -height / rate;
    double along = (originX + at * dirX - px) * ex + (originY + at * dirY - py) * ey;
    if (at < best && along >= 0 && along <= ex * ex + ey * ey) {
      best = at;
      bestX = nx;
      bestY = ny;
    }
  }

  private void corner(double cx, double cy, double radius) {
    double squared = dirX * dirX + dirY * dirY;
    if (!(squared > 0)) {
      return;
    }
    // From the point of the ray's line that is nearest to the centre: no digits cancel.
    double nearest = ((cx - originX) * dirX + (cy - originY) * dirY) / squared;
    double x = originX + nearest * dirX - cx;
    double y = originY + nearest * dirY - cy;
    double half = radius * radius - (x * x + y * y);
    if (half < 0) {
      return;
    }
    double at = nearest - Math.sqrt(half / squared);
    if (at >= 0 && at < best) {
      double nx = originX + at * dirX - cx;
      double ny = originY + at * dirY - cy;
      double length = Math.sqrt(nx * nx + ny * ny);
      best = at;
      bestX = nx / length;
      bestY = ny / length;
    }
  }

  /**
   * Moves shape A without turning it until it touches shape B.
   *
   * <p>The method is conservative advancement (Mirtich 1996): advance by the gap divided by the
   * speed at which it closes along the normal, then measure again. It never advances too far, and
   * for shapes with corners it arrives after a few steps. The result is at most {@code 1e-7} m of
   * gap early; a motion that grazes B within that distance may count as a hit.
   *
   * @param a moving shape, in its body's frame
   * @param ta where it begins, read only, finite
   * @param dx way of A along x, metres
   * @param dy way of A along y, metres
   * @param b shape at rest, in its body's frame
   * @param tb pose of B, read only, finite
   * @param maxFraction where the motion ends, in units of the way
   * @param out receives the hit, the normal being B's; untouched when there is none
   * @return whether A meets B
   */
  public boolean shape(
      Convex a,
      Transform ta,
      float dx,
      float dy,
      Convex b,
      Transform tb,
      float maxFraction,
      CastHit out) {
    Core.checkPair(a, ta, b, tb);
    Limits.notNull("out", out);
    coreA.place(a, ta, ta.x, ta.y);
    coreB.place(b, tb, ta.x, ta.y);
    double radii = coreA.radius + coreB.radius;
    double at = 0;
    double nx = 0;
    double ny = 0;
    for (int step = 0; step < MAX_STEPS; step++) {
      gjk.run(coreA, coreB);
      double gap = gjk.distance - radii;
      boolean arrived = gap <= ARRIVED;
      // At a gap of zero the previous direction, along which A arrived, is the better one.
      if (step == 0 || gjk.distance > SURE) {
        nx = gjk.normalX;
        ny = gjk.normalY;
      }
      double rate = nx * dx + ny * dy;
      if (arrived || step == MAX_STEPS - 1) {
        boolean inside = at == 0 && gap <= 0;
        if (!inside && !(rate > 0)) {
          return false;
        }
        double px = ta.x + gjk.ax + at * dx + coreA.radius * nx;
        double py = ta.y + gjk.ay + at * dy + coreA.radius * ny;
        out.set(at, inside ? 0 : -nx, inside ? 0 : -ny, px, py);
        return true;
      }
      if (!(rate > 0)) {
        return false;
      }
      double next = at + gap / rate;
      if (!(next <= maxFraction)) {
        return false;
      }
      // B comes to A: the difference is the same, and A's own points need no correction.
      coreB.shift(-(next - at) * dx, -(next - at) * dy);
      at = next;
    }
    return false;
  }
}
