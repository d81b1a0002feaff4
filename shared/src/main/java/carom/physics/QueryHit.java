package carom.physics;

import carom.physics.collision.CastHit;

/**
 * The hit of a query. It is mutable and reused: the caller creates one, or a visitor receives one.
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

  /** Makes an empty hit. */
  public QueryHit() {}

  /**
   * Returns the body that was hit.
   *
   * @return the body, null if nothing was found yet
   */
  public Body<T> body() {
    return body;
  }

  /**
   * Returns which of the body's shapes was hit.
   *
   * @return number of the shape, see {@link Body#shape}
   */
  public int shape() {
    return shape;
  }

  /**
   * Returns the fraction of the way at which a cast hit.
   *
   * @return 0..1, 0 at the start, 1 at the end; 0 for other queries
   */
  public float fraction() {
    return fraction;
  }

  /**
   * Returns the distance to the hit.
   *
   * @return m; for casts the length of the way to the hit, for the nearest point its distance
   */
  public float distance() {
    return distance;
  }

  /**
   * Returns the x coordinate of the point that was hit.
   *
   * @return m, world
   */
  public float x() {
    return x;
  }

  /**
   * Returns the y coordinate of the point that was hit.
   *
   * @return m, world
   */
  public float y() {
    return y;
  }

  /**
   * Returns the x component of the unit normal out of the surface that was hit.
   *
   * @return -1..1; both components are 0 if the query began inside
   */
  public float normalX() {
    return normalX;
  }

  /**
   * Returns the y component of the unit normal out of the surface that was hit.
   *
   * @return -1..1; both components are 0 if the query began inside
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
