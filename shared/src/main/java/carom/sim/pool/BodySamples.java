package carom.sim.pool;

import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.Arrays;
import java.util.List;

/**
 * Points spread over the shapes of a kind of body, each with its share of the area. A pool acts on
 * a body at these points. Immutable.
 */
final class BodySamples {
  /** Distance of points that is aimed at, metres. */
  private static final float PITCH = 0.35f;

  private static final int MOST_PER_AXIS = 6;

  /** By point: x, y in the body's frame, m, and area, m^2. */
  final float[] points;

  /** The whole area, m^2. */
  final float area;

  BodySamples(List<Shape> shapes) {
    float[] found = new float[3 * 16];
    int n = 0;
    float sum = 0;
    Aabb box = new Aabb();
    Transform identity = new Transform();
    for (Shape shape : shapes) {
      for (Convex part : shape.parts()) {
        float of = part.area();
        if (!(of > 0)) {
          continue;
        }
        part.aabb(identity, box);
        int columns = perAxis(box.width());
        int rows = perAxis(box.height());
        if (found.length < n + 3 * columns * rows) {
          found = Arrays.copyOf(found, 2 * (n + 3 * columns * rows));
        }
        int first = n;
        for (int i = 0; i < columns * rows; i++) {
          int row = i / columns;
          float x = box.minX + (i % columns + 0.5f) * box.width() / columns;
          float y = box.minY + (row + 0.5f) * box.height() / rows;
          if (part.containsPoint(x, y)) {
            found[n] = x;
            found[n + 1] = y;
            n += 3;
          }
        }
        for (int i = first; i < n; i += 3) {
          found[i + 2] = 3 * of / (n - first);
        }
        sum += n > first ? of : 0;
      }
    }
    points = Arrays.copyOf(found, n);
    area = sum;
  }

  private static int perAxis(float size) {
    return Math.max(2, Math.min(MOST_PER_AXIS, Math.round(size / PITCH)));
  }
}
