package carom.physics.collision;

/**
 * The shortest connection of two convex shapes A and B. Points are in world axes, <b>relative to
 * A's transform position</b>, so they stay exact far from the world's origin. Mutable and reused.
 */
public final class ClosestPoints {
  /** Gap between the surfaces, metres; 0 when the shapes overlap or touch. */
  public float distance;

  /**
   * X of the unit normal from A to B. It is 0 when even the shapes without their rounding overlap,
   * because then there is no closest direction (see {@code Sat} for the way out).
   */
  public float normalX;

  /** Y of the unit normal from A to B, see {@link #normalX}. */
  public float normalY;

  /** X of the closest point on A's surface, metres from A's position. */
  public float ax;

  /** Y of the closest point on A's surface, metres from A's position. */
  public float ay;

  /**
   * X of the closest point on B's surface, metres from A's position; with overlap the same as A's.
   */
  public float bx;

  /**
   * Y of the closest point on B's surface, metres from A's position; with overlap the same as A's.
   */
  public float by;

  /** First vertex of A at the closest point. */
  public int vertexA0;

  /** Other vertex of A's edge at the closest point; equal to vertexA0 when it is a vertex. */
  public int vertexA1;

  /** First vertex of B at the closest point. */
  public int vertexB0;

  /** Other vertex of B's edge at the closest point; equal to vertexB0 when it is a vertex. */
  public int vertexB1;

  /** Makes a result with all zeros. */
  public ClosestPoints() {}

  @Override
  public String toString() {
    return "ClosestPoints(distance="
        + distance
        + ", normal="
        + normalX
        + " "
        + normalY
        + ", a="
        + ax
        + " "
        + ay
        + ", b="
        + bx
        + " "
        + by
        + ")";
  }
}
