package carom.physics.effects;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.BodyVisitor;
import carom.physics.World;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import java.util.Arrays;

/**
 * The dynamic bodies in a place, by ascending index. An effect first collects the bodies and then
 * changes them, because a query must not change what it visits.
 */
final class Nearby {
  private Body<?>[] bodies = new Body<?>[16];
  private int count;
  private final BodyVisitor<Object> collect = this::add;

  /** Collects the bodies whose box overlaps an area. */
  <T> void find(World<T> world, Aabb area) {
    clear();
    Limits.notNull("world", world);
    world.queryAabb(area.minX, area.minY, area.maxX, area.maxY, collector());
  }

  /** Collects the bodies that were in a body's sensors in the last step. */
  <T> void findInside(Body<T> sensor) {
    clear();
    Limits.notNull("sensor", sensor).forEachOverlap(collector());
  }

  int count() {
    return count;
  }

  Body<?> get(int i) {
    return bodies[i];
  }

  /** Releases the bodies, so that the garbage collector can free an unused world. */
  void clear() {
    Arrays.fill(bodies, 0, count, null);
    count = 0;
  }

  /**
   * Returns the collecting visitor for bodies of T. The cast is safe, because the visitor never
   * looks at the user object.
   */
  @SuppressWarnings("unchecked")
  private <T> BodyVisitor<T> collector() {
    return (BodyVisitor<T>) (BodyVisitor<?>) collect;
  }

  private boolean add(Body<?> body) {
    if (body.type() == BodyType.DYNAMIC && body.isEnabled()) {
      if (count == bodies.length) {
        bodies = Arrays.copyOf(bodies, count * 2);
      }
      bodies[count++] = body;
    }
    return true;
  }

  /** Returns whether effects act on a body: it is dynamic, enabled and awake. */
  static boolean isActedOn(Body<?> body) {
    return body.type() == BodyType.DYNAMIC && body.isEnabled() && body.awake();
  }

  /** Returns whether one of a body's solid shapes has one of the categories. */
  static boolean isOf(Body<?> body, int categories) {
    for (int i = 0; i < body.shapeCount(); i++) {
      if (!body.sensor(i) && (body.filter(i).category() & categories) != 0) {
        return true;
      }
    }
    return false;
  }
}
