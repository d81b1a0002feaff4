package carom.physics.collision;

import carom.physics.geometry.Convex;
import carom.physics.math.Limits;

/**
 * The signed distance of a point to a convex shape, and the direction out of it. It is computed in
 * float, for frequent use such as particles. {@code Distance} is more exact, but has no distance
 * inside.
 *
 * <p>Outside: the distance to the nearest point of the surface, rounding included. Inside: minus
 * the distance to the surface for discs, capsules and polygons without rounding; a rounded
 * polygon's corners count as sharp there. On a tie the first edge wins. A point on a line without
 * thickness gets the normal of edge 0. Mutable and reused; use one per thread; nothing allocates.
 */
public final class SignedDistance {
  /** Distance to the surface, m; negative inside. */
  public float distance;

  /** X of the unit normal out of the surface, in the shape's frame. */
  public float normalX;

  /** Y of the unit normal out of the surface, in the shape's frame. */
  public float normalY;

  /** Makes a result with all zeros. */
  public SignedDistance() {}

  /**
   * Measures from a shape to a point.
   *
   * @param shape the shape
   * @param x the point, in the shape's frame, m
   * @param y the point, in the shape's frame, m
   * @return {@link #distance}
   */
  public float measure(Convex shape, float x, float y) {
    Limits.notNull("shape", shape);
    int count = shape.vertexCount();
    if (count == 1) {
      from(x - shape.vertexX(0), y - shape.vertexY(0), 0, 1);
    } else if (count == 2) {
      fromEdge(shape, 0, 1, x, y);
    } else {
      int edge = 0;
      float most = Float.NEGATIVE_INFINITY;
      for (int i = 0; i < count; i++) {
        float height =
            shape.normalX(i) * (x - shape.vertexX(i)) + shape.normalY(i) * (y - shape.vertexY(i));
        if (height > most) {
          most = height;
          edge = i;
        }
      }
      if (most > 0) {
        fromEdge(shape, edge, edge + 1 == count ? 0 : edge + 1, x, y);
      } else {
        distance = most;
        normalX = shape.normalX(edge);
        normalY = shape.normalY(edge);
      }
    }
    distance -= shape.radius();
    return distance;
  }

  /**
   * Measures from the edge that the point is highest above. Of a polygon that is not always the
   * nearest edge. Then the nearest point is a corner beyond one end of this edge: walking from
   * corner to corner while distances fall finds it.
   */
  private void fromEdge(Convex shape, int from, int to, float x, float y) {
    float ax = shape.vertexX(from);
    float ay = shape.vertexY(from);
    float ex = shape.vertexX(to) - ax;
    float ey = shape.vertexY(to) - ay;
    float dx = x - ax;
    float dy = y - ay;
    float along = dx * ex + dy * ey;
    float whole = ex * ex + ey * ey;
    if (along > 0 && along < whole) {
      float height = shape.normalX(from) * dx + shape.normalY(from) * dy;
      float side = height < 0 ? -1 : 1;
      distance = side * height;
      normalX = side * shape.normalX(from);
      normalY = side * shape.normalY(from);
      return;
    }
    int count = shape.vertexCount();
    int corner = along <= 0 ? from : to;
    int step = along <= 0 ? count - 1 : 1;
    int next = (corner + step) % count;
    while (count > 2 && squared(shape, next, x, y) < squared(shape, corner, x, y)) {
      corner = next;
      next = (corner + step) % count;
    }
    float cx = x - shape.vertexX(corner);
    float cy = y - shape.vertexY(corner);
    from(cx, cy, shape.normalX(from), shape.normalY(from));
    if (count > 2) {
      beside(shape, along <= 0 ? (corner + count - 1) % count : corner, x, y);
      beside(shape, along <= 0 ? corner : (corner + count - 1) % count, x, y);
    }
  }

  /**
   * Measures from an edge that meets the nearest corner, if the point is beside that edge and
   * nearer to it.
   */
  private void beside(Convex shape, int edge, float x, float y) {
    int to = edge + 1 == shape.vertexCount() ? 0 : edge + 1;
    float dx = x - shape.vertexX(edge);
    float dy = y - shape.vertexY(edge);
    float ex = shape.vertexX(to) - shape.vertexX(edge);
    float ey = shape.vertexY(to) - shape.vertexY(edge);
    float along = dx * ex + dy * ey;
    float height = shape.normalX(edge) * dx + shape.normalY(edge) * dy;
    if (along > 0 && along < ex * ex + ey * ey && height > 0 && height < distance) {
      distance = height;
      normalX = shape.normalX(edge);
      normalY = shape.normalY(edge);
    }
  }

  private static float squared(Convex shape, int vertex, float x, float y) {
    float dx = x - shape.vertexX(vertex);
    float dy = y - shape.vertexY(vertex);
    return dx * dx + dy * dy;
  }

  private void from(float dx, float dy, float elseX, float elseY) {
    float length = (float) Math.sqrt(dx * dx + dy * dy);
    distance = length;
    normalX = length > 0 ? dx / length : elseX;
    normalY = length > 0 ? dy / length : elseY;
  }
}
