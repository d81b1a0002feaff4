package carom.physics.collision;

import carom.physics.geometry.Convex;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * Measures the distance and closest points of convex shapes, rounding included. An instance holds
 * scratch memory, so use one per thread; no call allocates.
 *
 * <p>It runs GJK (Gilbert, Johnson, Keerthi 1988) on the vertices in double precision, then
 * subtracts the radii: a circle is its centre with a radius. The error is that of rounding the
 * result to float. Cost is proportional to the number of vertices, times three to six steps for
 * usual shapes.
 *
 * <h2>Degenerate cases</h2>
 *
 * Touching counts as distance 0. Parallel edges have many closest points; the result is one of
 * them, the same for the same arguments. If shapes overlap only by their rounding, both points are
 * one common point and the normal is valid. If they overlap by more, both points are one common
 * point and the normal is (0, 0). No zero is negative.
 */
public final class Distance {
  private final Core coreA = new Core();
  private final Core coreB = new Core();
  private final Gjk gjk = new Gjk();
  private double gap;

  /** Makes an instance with its own scratch memory. */
  public Distance() {}

  /**
   * Finds the shortest connection of two shapes.
   *
   * @param a shape A in its body's frame
   * @param ta pose of A, read only, finite
   * @param b shape B in its body's frame
   * @param tb pose of B, read only, finite
   * @param out receives the result
   * @return the gap in metres, 0 when they overlap or touch
   */
  public float between(Convex a, Transform ta, Convex b, Transform tb, ClosestPoints out) {
    Core.checkPair(a, ta, b, tb);
    Limits.notNull("out", out);
    coreA.place(a, ta, ta.x, ta.y);
    coreB.place(b, tb, ta.x, ta.y);
    return measure(out);
  }

  /**
   * Finds the point of a shape that is closest to a point.
   *
   * @param a the shape, in its body's frame
   * @param ta its pose, read only, finite
   * @param x world x of the point, metres
   * @param y world y of the point, metres
   * @param out receives the result; B is the point
   * @return the distance in metres, 0 when the point is inside or on the border
   */
  public float toPoint(Convex a, Transform ta, float x, float y, ClosestPoints out) {
    Limits.notNull("a", a);
    Limits.notNull("ta", ta);
    Limits.notNull("out", out);
    coreA.place(a, ta, ta.x, ta.y);
    coreB.point((double) x - ta.x, (double) y - ta.y);
    return measure(out);
  }

  /**
   * Returns the distance that was found last, in metres, negative where roundings overlap: of equal
   * {@code float} distances it tells which is the less.
   */
  public double gap() {
    return gap;
  }

  private float measure(ClosestPoints out) {
    gjk.run(coreA, coreB);
    gap = gjk.distance - (coreA.radius + coreB.radius);
    double fromA = coreA.radius;
    double fromB = coreB.radius;
    if (!(gap > 0)) {
      // Between the cores, where both roundings reach: that point is in both shapes.
      double low = Math.max(0, gjk.distance - fromB);
      double high = Math.min(gjk.distance, fromA);
      fromA = 0.5 * (low + high);
      fromB = gjk.distance - fromA;
    }
    out.distance = (float) Math.max(0, gap);
    out.normalX = (float) gjk.normalX + 0f;
    out.normalY = (float) gjk.normalY + 0f;
    out.ax = (float) (gjk.ax + fromA * gjk.normalX);
    out.ay = (float) (gjk.ay + fromA * gjk.normalY);
    out.bx = (float) (gjk.bx - fromB * gjk.normalX);
    out.by = (float) (gjk.by - fromB * gjk.normalY);
    out.vertexA0 = gjk.a0;
    out.vertexA1 = gjk.a1;
    out.vertexB0 = gjk.b0;
    out.vertexB1 = gjk.b1;
    return out.distance;
  }
}
