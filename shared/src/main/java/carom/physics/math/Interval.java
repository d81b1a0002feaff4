package carom.physics.math;

/**
 * A closed interval on a line, such as the projection of a shape on an axis. It is the
 * one-dimensional case of collision: two convex shapes overlap exactly if their projections overlap
 * on every axis (separating axis theorem). It is mutable and reused.
 */
public final class Interval {
  /** Lower end. */
  public float min;

  /** Upper end. */
  public float max;

  /** Creates the interval that holds only zero. */
  public Interval() {}

  /** Creates an interval from its ends, which are not checked. */
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
   * Sets this interval to the projection of points on the axis through the origin with the
   * direction (axisX, axisY). The result is in metres if the axis has length one; otherwise it is
   * scaled by that length. Returns this.
   *
   * @param xs x of the points
   * @param ys y of the points
   * @param count number of points, at least 1
   */
  public Interval project(float[] xs, float[] ys, int count, float axisX, float axisY) {
    if (count < 1) {
      throw new IllegalArgumentException(
          "count=" + count + " must be >= 1: a projection needs a point");
    }
    Limits.stretch("xs", Limits.notNull("xs", xs).length, 0, count);
    Limits.stretch("ys", Limits.notNull("ys", ys).length, 0, count);
    float low = Float.POSITIVE_INFINITY;
    float high = Float.NEGATIVE_INFINITY;
    for (int i = 0; i < count; i++) {
      float d = xs[i] * axisX + ys[i] * axisY;
      low = Math.min(low, d);
      high = Math.max(high, d);
    }
    return set(low, high);
  }

  /** Returns the upper end minus the lower end. */
  public float length() {
    return max - min;
  }

  /** Returns whether a number is in the interval; its ends are. */
  public boolean contains(float value) {
    return min <= value && value <= max;
  }

  /** Returns whether another interval is a part of this one; equal ends count. */
  public boolean contains(Interval other) {
    Limits.notNull("other", other);
    return min <= other.min && other.max <= max;
  }

  /** Returns the smallest interval that contains both, as a new one. */
  public Interval union(Interval other) {
    Limits.notNull("other", other);
    return new Interval(Math.min(min, other.min), Math.max(max, other.max));
  }

  /**
   * Returns what both intervals share, as a new one.
   *
   * @return null if they share nothing
   */
  public Interval intersection(Interval other) {
    Limits.notNull("other", other);
    float low = Math.max(min, other.min);
    float high = Math.min(max, other.max);
    return low <= high ? new Interval(low, high) : null;
  }

  /** Returns true if the intervals share at least one point; touching ends count. */
  public boolean overlaps(Interval other) {
    Limits.notNull("other", other);
    return min <= other.max && other.min <= max;
  }

  /**
   * Returns the signed distance to another interval. It is the gap if positive, and minus the
   * smallest translation that separates the intervals if negative.
   */
  public float separation(Interval other) {
    Limits.notNull("other", other);
    return Math.max(other.min - max, min - other.max);
  }

  /**
   * Returns the smallest signed translation of this interval that moves it out of {@code other},
   * containment included.
   *
   * @return positive for up, negative for down, 0 if the intervals are separated or touch. Of two
   *     equal ways out, it is the one down.
   */
  public float mtv(Interval other) {
    Limits.notNull("other", other);
    float down = max - other.min;
    float up = other.max - min;
    if (down <= 0 || up <= 0) {
      return 0;
    }
    return down <= up ? -down : up;
  }

  /** Returns whether another interval has the same ends now; both are mutable. */
  @Override
  public boolean equals(Object other) {
    return other instanceof Interval i
        && Float.compare(min, i.min) == 0
        && Float.compare(max, i.max) == 0;
  }

  @Override
  public int hashCode() {
    return 31 * Float.hashCode(min) + Float.hashCode(max);
  }

  @Override
  public String toString() {
    return "[" + min + ", " + max + "]";
  }
}
