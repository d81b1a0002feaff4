package carom.physics.effects;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.QueryFilter;
import carom.physics.World;
import carom.physics.collision.ClosestPoints;
import carom.physics.collision.Distance;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * An explosion that pushes everything away from a point, once. Call it between steps:
 *
 * <pre>
 *   new Explosion(x, y, 5).impulse(300).blockedByStatics(true).explode(world);
 * </pre>
 *
 * <p>Each body gets the impulse {@code impulse * width * (1 - distance / radius)} at its point
 * nearest to the centre, directed away from the centre. The width is the body's extent across that
 * direction, in metres. So a plank that lies broadside flies far, and a body made of many boxes
 * flies like one big box, however it is cut. A body that contains the centre gets the impulse at
 * its centre of mass, directed there from the centre.
 *
 * <p>Bodies get the impulse, and wake, by ascending index; it acts in the next step. An explosion
 * is not thread-safe. A repeated call allocates nothing.
 */
public final class Explosion {
  private final float x;
  private final float y;
  private final float radius;
  private final Aabb area = new Aabb();
  private float impulse = 10;
  private boolean blocked;
  private int categories = -1;
  private final Nearby nearby = new Nearby();
  private final Distance distances = new Distance();
  private final ClosestPoints points = new ClosestPoints();
  private final Transform pose = new Transform();
  private double nearestGap;
  private double nearestX;
  private double nearestY;
  private double directionX;
  private double directionY;
  private final QueryFilter<Object> walls =
      (body, shape) -> body.type() == BodyType.STATIC && !body.sensor(shape);

  /**
   * Creates an explosion of 10 N s per metre.
   *
   * @param x x of the centre, m
   * @param y y of the centre, m
   * @param radius range, 1e-3 to 1e6 m
   */
  public Explosion(float x, float y, float radius) {
    this.x = Limits.coordinate("x", x);
    this.y = Limits.coordinate("y", y);
    this.radius = Limits.range("radius", radius, 1e-3f, 1e6f);
    area.set(x - radius, y - radius, x + radius, y + radius);
    Areas.check(area);
  }

  /**
   * Sets the strength; default 10.
   *
   * @param perMetre impulse on a metre of width at the centre, N s/m, within 1e9; a negative one
   *     pulls bodies in
   * @return this
   */
  public Explosion impulse(float perMetre) {
    impulse = Limits.range("impulse", perMetre, -1e9f, 1e9f);
    return this;
  }

  /**
   * Sets whether static bodies give shelter; default false. A body is sheltered if a solid shape of
   * a static body crosses the line from the centre to its nearest point. An explosion inside a wall
   * has no effect outside it.
   *
   * @param sheltered true if static bodies give shelter
   * @return this
   */
  public Explosion blockedByStatics(boolean sheltered) {
    blocked = sheltered;
    return this;
  }

  /**
   * Sets which shapes the explosion acts on; default all that are not sensors.
   *
   * @param bits category bits; the explosion acts on a shape if its filter's category has one of
   *     them
   * @return this
   */
  public Explosion categories(int bits) {
    categories = bits;
    return this;
  }

  /**
   * Applies the impulses to everything within the radius.
   *
   * @param world the world
   * @param <T> its user type
   */
  public <T> void explode(World<T> world) {
    nearby.find(world, area);
    for (int i = 0; i < nearby.count(); i++) {
      Body<?> body = nearby.get(i);
      pose.set(body.x(), body.y(), body.cos(), body.sin());
      push(world, body);
    }
    nearby.clear();
  }

  private void push(World<?> world, Body<?> body) {
    nearestGap = radius;
    for (int k = 0; k < body.shapeCount(); k++) {
      if (isActedOn(body, k)) {
        nearest(body.shape(k));
      }
    }
    float distance = (float) Math.max(0, nearestGap);
    if (!(distance < radius)) {
      return;
    }
    double px = nearestX;
    double py = nearestY;
    double dx = directionX;
    double dy = directionY;
    if (distance == 0) {
      px = body.centerX();
      py = body.centerY();
      dx = px - x;
      dy = py - y;
      double length = Math.sqrt(dx * dx + dy * dy);
      dx = length > 0 ? dx / length : 0;
      dy = length > 0 ? dy / length : 1;
    } else if (blocked && isSheltered(world, (float) (px - x), (float) (py - y))) {
      return;
    }
    double size = impulse * width(body, dx, dy) * (1 - distance / radius);
    body.applyImpulse((float) (size * dx), (float) (size * dy), (float) px, (float) py);
  }

  private boolean isActedOn(Body<?> body, int shape) {
    return !body.sensor(shape) && (body.filter(shape).category() & categories) != 0;
  }

  /** Notes the nearest point of a shape if it is nearer than that of the shapes before. */
  private void nearest(Shape shape) {
    for (int i = 0; i < shape.parts().size(); i++) {
      distances.toPoint(shape.parts().get(i), pose, x, y, points);
      // In double: beside a seam, the corner of the other part is as near but for a rounding.
      if (distances.gap() < nearestGap) {
        nearestGap = distances.gap();
        nearestX = (double) pose.x + points.ax;
        nearestY = (double) pose.y + points.ay;
        directionX = -points.normalX;
        directionY = -points.normalY;
      }
    }
  }

  /** Returns the extent of a body across a direction of length one, m. */
  private double width(Body<?> body, double dx, double dy) {
    double acrossX = pose.cos * -dy + pose.sin * dx;
    double acrossY = pose.cos * dx + pose.sin * dy;
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (int k = 0; k < body.shapeCount(); k++) {
      Shape shape = body.shape(k);
      for (int i = 0; isActedOn(body, k) && i < shape.parts().size(); i++) {
        Convex part = shape.parts().get(i);
        for (int v = 0; v < part.vertexCount(); v++) {
          double at = acrossX * part.vertexX(v) + acrossY * part.vertexY(v);
          least = Math.min(least, at - part.radius());
          most = Math.max(most, at + part.radius());
        }
      }
    }
    return most - least;
  }

  @SuppressWarnings("unchecked")
  private <T> boolean isSheltered(World<T> world, float wayX, float wayY) {
    return world.queries().rayAny(x, y, wayX, wayY, (QueryFilter<T>) (QueryFilter<?>) walls);
  }
}
