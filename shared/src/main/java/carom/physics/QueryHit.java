package carom.physics;

import carom.physics.collision.distance.CastHit;

/**
 * What a query found. Mutable and reused; made by the caller or handed to a visitor.
 *
 * @param <T> the world's user type
 */
public final class QueryHit<T> {
  private Body<T> body;
  private int shape;
  private float fraction;
  private float distance;
  private float x;
  private float y;
  private float normalX;
  private float normalY;

  /** Makes an empty result. */
  public QueryHit() {}

  /**
   * Who was hit.
   *
   * @return the body, null when nothing was found yet
   */
  public Body<T> body() {
    return body;
  }

  /**
   * Which of the body's shapes.
   *
   * @return its number, see {@link Body#shape}
   */
  public int shape() {
    return shape;
  }

  /**
   * Where on the way a cast hit.
   *
   * @return 0 at the start, 1 at the end; 0 for other queries
   */
  public float fraction() {
    return fraction;
  }

  /**
   * How far away.
   *
   * @return for casts the way to the hit, for the nearest point its distance; m
   */
  public float distance() {
    return distance;
  }

  /**
   * The point of touch.
   *
   * @return world x, m
   */
  public float x() {
    return x;
  }

  /**
   * The point of touch.
   *
   * @return world y, m
   */
  public float y() {
    return y;
  }

  /**
   * Unit normal out of the surface that was hit.
   *
   * @return x; 0 with {@link #normalY} 0 when the query began inside
   */
  public float normalX() {
    return normalX;
  }

  /**
   * Unit normal out of the surface that was hit.
   *
   * @return y
   */
  public float normalY() {
    return normalY;
  }

  void set(Body<T> newBody, int newShape, float newFraction, float newDistance, CastHit hit) {
    body = newBody;
    shape = newShape;
    fraction = newFraction;
    distance = newDistance;
    x = hit.x;
    y = hit.y;
    normalX = hit.normalX;
    normalY = hit.normalY;
  }

  @Override
  public String toString() {
    return "QueryHit(body="
        + body
        + ", shape="
        + shape
        + ", fraction="
        + fraction
        + ", distance="
        + distance
        + ", point="
        + x
        + " "
        + y
        + ", normal="
        + normalX
        + " "
        + normalY
        + ")";
  }
}
