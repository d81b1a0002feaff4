package carom.physics.collision;

import carom.physics.geometry.Convex;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * A point at which two shapes collide, found in one of the usual ways, for games and lessons that
 * work with a single point: three for all shapes, and two for circles. The solver itself uses the
 * {@link Manifold}'s two. Points are in world axes, relative to A's transform position, metres, as
 * in a manifold. Mutable and reused.
 */
public final class PointOfCollision {
  /** X of the point, metres from A's position. */
  public float x;

  /** Y of the point, metres from A's position. */
  public float y;

  /** Makes a point at A's position. */
  public PointOfCollision() {}

  /**
   * Sets the point to the mean of all vertices of either shape that are inside the other one. It is
   * simple and in the middle when faces overlap evenly, but jumps when a vertex comes or goes.
   *
   * @param a shape A in its body's frame
   * @param ta pose of A, read only
   * @param b shape B in its body's frame
   * @param tb pose of B, read only
   * @return false when there is no such vertex (edges that merely cross, discs beside each other);
   *     the point stays as it was
   */
  public boolean verticesInside(Convex a, Transform ta, Convex b, Transform tb) {
    Core.checkPair(a, ta, b, tb);
    double sumX = 0;
    double sumY = 0;
    int count = 0;
    for (int side = 0; side < 2; side++) {
      Convex own = side == 0 ? a : b;
      Transform t = side == 0 ? ta : tb;
      Convex other = side == 0 ? b : a;
      Transform otherPose = side == 0 ? tb : ta;
      for (int i = 0; i < own.vertexCount(); i++) {
        float wx = t.worldX(own.vertexX(i), own.vertexY(i));
        float wy = t.worldY(own.vertexX(i), own.vertexY(i));
        if (other.containsPoint(otherPose, wx, wy)) {
          sumX += wx - ta.x;
          sumY += wy - ta.y;
          count++;
        }
      }
    }
    if (count == 0) {
      return false;
    }
    x = (float) (sumX / count);
    y = (float) (sumY / count);
    return true;
  }

  /**
   * Sets the point to the deepest point of the manifold. Of equally deep points it takes the
   * middle, so that a box flat on the ground isn't tipped.
   *
   * @return false when the manifold has no point; the point stays as it was
   */
  public boolean deepest(Manifold m) {
    Limits.notNull("m", m);
    if (m.count == 0) {
      return false;
    }
    if (m.count == 2 && m.separation0 == m.separation1) {
      return clippedMiddle(m);
    }
    boolean second = m.count == 2 && m.separation1 < m.separation0;
    x = second ? m.x1 : m.x0;
    y = second ? m.y1 : m.y0;
    return true;
  }

  /**
   * Sets the point to the middle of the manifold's two points, or to its only one. That is the
   * middle of what is left of one shape's edge after clipping it against the other's. See {@link
   * Manifold#pointX()} for a mean weighted by depth, which moves continuously.
   *
   * @return false when the manifold has no point; the point stays as it was
   */
  public boolean clippedMiddle(Manifold m) {
    Limits.notNull("m", m);
    if (m.count == 0) {
      return false;
    }
    x = m.count == 2 ? 0.5f * (m.x0 + m.x1) : m.x0;
    y = m.count == 2 ? 0.5f * (m.y0 + m.y1) : m.y0;
    return true;
  }

  /**
   * Sets the point to that on the line between the centres of two circles which divides it as the
   * radii do, {@code c1 + r1 / (r1 + r2) (c2 - c1)}, relative to the first centre. It is the middle
   * of the overlap of equal circles, and the point of touching of any.
   *
   * @param wayX x of the way from the first circle's centre to the second's, m
   * @param wayY y of it, m
   * @param r1 radius of the first circle, more than 0, m
   * @param r2 radius of the second circle, more than 0, m
   */
  public void betweenCircles(float wayX, float wayY, float r1, float r2) {
    float part =
        Limits.range("r1", r1, Float.MIN_VALUE, Limits.MAX_COORDINATE)
            / (r1 + Limits.range("r2", r2, Float.MIN_VALUE, Limits.MAX_COORDINATE));
    x = part * wayX;
    y = part * wayY;
  }

  /**
   * Sets the point to that of a circle which is deepest in the other shape, {@code c - r mtv} of
   * shape A and {@code c + r mtv} of shape B, with the unit vector of the MTV.
   *
   * @param centerX x of the circle's centre, m
   * @param centerY y of the circle's centre, m
   * @param radius radius of the circle, m
   * @param mtv moves shape A out of shape B
   * @param isA whether the circle is shape A
   * @return false if the shapes don't overlap; the point stays as it was
   */
  public boolean onCircle(float centerX, float centerY, float radius, Mtv mtv, boolean isA) {
    float length = Limits.notNull("mtv", mtv).length();
    if (!(length > 0)) {
      return false;
    }
    float factor = (isA ? -radius : radius) / length;
    x = centerX + factor * mtv.x;
    y = centerY + factor * mtv.y;
    return true;
  }

  @Override
  public String toString() {
    return "PointOfCollision(" + x + ", " + y + ")";
  }
}
