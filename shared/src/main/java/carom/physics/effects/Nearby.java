package carom.physics.effects;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.BodyVisitor;
import carom.physics.World;
import carom.physics.math.Aabb;
import java.util.Arrays;

/**
 * The dynamic bodies in a place, by ascending index: collected first and changed afterwards, since
 * a query must not change what it visits.
 */
final class Nearby {
  private Body<?>[] bodies = new Body<?>[16];
  private int count;
  private final BodyVisitor<Object> collect = this::add;

  /** Whose box overlaps an area. */
  <T> void find(World<T> world, Aabb area) {
    clear();
    world.queryAabb(area.minX, area.minY, area.maxX, area.maxY, collector());
  }

  /** What was in a body's sensors in the last step. */
  <T> void findInside(Body<T> sensor) {
    clear();
    sensor.forEachOverlap(collector());
  }

  int count() {
    return count;
  }

  Body<?> get(int i) {
    return bodies[i];
  }

  /** Lets go of the bodies, so that a world that is no longer used can be collected. */
  void clear() {
    Arrays.fill(bodies, 0, count, null);
    count = 0;
  }

  /** Returns a visitor of any body is a visitor of bodies of T: it looks at no user. */
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

  /** Returns whether one of a body's solid shapes is of one of the categories. */
  static boolean isOf(Body<?> body, int categories) {
    for (int i = 0; i < body.shapeCount(); i++) {
      if (!body.sensor(i) && (body.filter(i).category() & categories) != 0) {
        return true;
      }
    }
    return false;
  }
}
