package carom.physics.effects;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.QueryFilter;
import carom.physics.World;
import carom.physics.collision.distance.ClosestPoints;
import carom.physics.collision.distance.Distance;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * A bang: kicks everything away from a point, once. Between steps:
 *
 * <pre>
 *   new Explosion(x, y, 5).impulse(300).blockedByStatics(true).explode(world);
 * </pre>
 *
 * <p>Each convex part is kicked at its point nearest to the centre, away from it, by {@code impulse
 * * width * (1 - distance / radius)}: width is the part's extent across the direction, in metres,
 * what it shows of itself to a blast from that side. So a plank that lies broadside flies, and a
 * body made of four boxes flies like one big box. A part that contains the centre is kicked from
 * the centre through its middle, at its middle.
 *
 * <p>Bodies are kicked, and woken, by ascending index; the kick acts in the next step. Not
 * thread-safe; a repeated call allocates nothing.
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
  private double middleX;
  private double middleY;
  private final QueryFilter<Object> walls =
      (body, shape) -> body.type() == BodyType.STATIC && !body.sensor(shape);

  /**
   * An explosion of 10 N s per metre.
   *
   * @param x its centre, m
   * @param y its centre, m
   * @param radius how far it reaches, 1e-3 to 1e6 m
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
   * @param perMetre impulse on a metre of width at the centre, N s/m; negative sucks in; within 1e9
   * @return this
   */
  public Explosion impulse(float perMetre) {
    impulse = Limits.range("impulse", perMetre, -1e9f, 1e9f);
    return this;
  }

  /**
   * Sets whether static bodies give shelter; default false. A part is sheltered if a solid shape of
   * a static body crosses the line from the centre to its nearest point; in a wall nothing is heard
   * outside.
   *
   * @param sheltered whether rays are cast
   * @return this
   */
  public Explosion blockedByStatics(boolean sheltered) {
    blocked = sheltered;
    return this;
  }

  /**
   * Sets which shapes are kicked; default all that are not sensors.
   *
   * @param bits a shape is kicked if its filter's category has one of them
   * @return this
   */
  public Explosion categories(int bits) {
    categories = bits;
    return this;
  }

  /**
   * Kicks what is within the radius.
   *
   * @param world the world
   * @param <T> its user type
   */
  public <T> void explode(World<T> world) {
    nearby.find(world, area);
    for (int i = 0; i < nearby.count(); i++) {
      Body<?> body = nearby.get(i);
      pose.set(body.x(), body.y(), body.cos(), body.sin());
      for (int k = 0; k < body.shapeCount(); k++) {
        if (!body.sensor(k) && (body.filter(k).category() & categories) != 0) {
          kick(world, body, body.shape(k));
        }
      }
    }
    nearby.clear();
  }

  private void kick(World<?> world, Body<?> body, Shape shape) {
    for (int i = 0; i < shape.parts().size(); i++) {
      Convex part = shape.parts().get(i);
      float distance = distances.toPoint(part, pose, x, y, points);
      if (distance < radius) {
        kick(world, body, part, distance);
      }
    }
  }

  private void kick(World<?> world, Body<?> body, Convex part, float distance) {
    double px = (double) pose.x + points.ax;
    double py = (double) pose.y + points.ay;
    double dx = -points.normalX;
    double dy = -points.normalY;
    if (distance == 0) {
      middle(part);
      px = middleX;
      py = middleY;
      dx = px - x;
      dy = py - y;
      double length = Math.sqrt(dx * dx + dy * dy);
      dx = length > 0 ? dx / length : 0;
      dy = length > 0 ? dy / length : 1;
    } else if (blocked && isSheltered(world, (float) (px - x), (float) (py - y))) {
      return;
    }
    double size = impulse * width(part, dx, dy) * (1 - distance / radius);
    body.applyImpulse((float) (size * dx), (float) (size * dy), (float) px, (float) py);
  }

  /** The mean of the vertices, in the world. */
  private void middle(Convex part) {
    double mx = 0;
    double my = 0;
    int count = part.vertexCount();
    for (int i = 0; i < count; i++) {
      mx += part.vertexX(i);
      my += part.vertexY(i);
    }
    mx /= count;
    my /= count;
    middleX = pose.x + (pose.cos * mx - pose.sin * my);
    middleY = pose.y + (pose.sin * mx + pose.cos * my);
  }

  /** Extent across a direction of length one, m. */
  private double width(Convex part, double dx, double dy) {
    double acrossX = pose.cos * -dy + pose.sin * dx;
    double acrossY = pose.cos * dx + pose.sin * dy;
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < part.vertexCount(); i++) {
      double at = acrossX * part.vertexX(i) + acrossY * part.vertexY(i);
      least = Math.min(least, at);
      most = Math.max(most, at);
    }
    return most - least + 2.0 * part.radius();
  }

  @SuppressWarnings("unchecked")
  private <T> boolean isSheltered(World<T> world, float wayX, float wayY) {
    return world.queries().rayAny(x, y, wayX, wayY, (QueryFilter<T>) (QueryFilter<?>) walls);
  }
}
