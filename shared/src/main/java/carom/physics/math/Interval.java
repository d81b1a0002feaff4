package carom.physics.math;

/**
 * A closed interval on a line: the shadow of a shape on an axis, and with it the one-dimensional
 * case of collision. Two convex shapes overlap exactly when their shadows overlap on every axis
 * (separating axis theorem). Mutable and reused.
 */
public final class Interval {
  /** Lower end. */
  public float min;

  /** Upper end. */
  public float max;

  /** Makes the interval that holds only zero. */
  public Interval() {}

  /** Makes an interval from its ends, which are not checked. */
  public Interval(float min, float max) {
    set(min, max);
  }

  /** Sets both ends; {@code min <= max} is not checked. Returns this. */
  public Interval set(float min, float max) {
    this.min = min;
    this.max = max;
    return this;
  }

  /**
   * Becomes the projection of points on the axis through the origin with direction (axisX, axisY).
   * The result is in metres when the axis has length one, else scaled by its length. Returns this.
   *
   * @param xs x of the points
   * @param ys y of the points
   * @param count how many points count, at least 1
   */
  public Interval project(float[] xs, float[] ys, int count, float axisX, float axisY) {
    if (count < 1) {
      throw new IllegalArgumentException("count=" + count + " must be >= 1: nothing has no shadow");
    }
    float low = Float.POSITIVE_INFINITY;
    float high = Float.NEGATIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      float d = xs[i] * axisX + ys[i] * axisY;
      low = Math.min(low, d);
      high = Math.max(high, d);
    }
    return set(low, high);
  }

  /** Upper end less lower end. */
  public float length() {
    return max - min;
  }

  /** True when the intervals share at least one point; touching ends count. */
  public boolean overlaps(Interval other) {
    return min <= other.max && other.min <= max;
  }

  /**
   * Signed distance: the gap when positive, minus the smallest push that parts the intervals when
   * negative.
   */
  public float separation(Interval other) {
    return Math.max(other.min - max, min - other.max);
  }

  /**
   * Returns the smallest signed translation of this interval that moves it out of {@code other},
   * containment included.
   *
   * @return positive: up, negative: down, 0 when the intervals are separated or touch. Of two equal
   *     ways out, the one down is taken.
   */
  public float mtv(Interval other) {
    float down = max - other.min;
    float up = other.max - min;
    if (down <= 0 || up <= 0) {
      return 0;
    }
    return down <= up ? -down : up;
  }

  @Override
  public String toString() {
    return "[" + min + ", " + max + "]";
  }
}
