package carom.physics.math;

/**
 * An immutable point or vector, for building shapes and reading results. Hot loops use plain floats
 * instead.
 *
 * @param x component to the right
 * @param y component upwards
 */
public record Vec2(float x, float y) {
  /** The origin. */
  public static final Vec2 ZERO = new Vec2(0, 0);

  /** Returns the sum of this vector and {@code v}. */
  public Vec2 plus(Vec2 v) {
    Limits.notNull("v", v);
    return new Vec2(x + v.x, y + v.y);
  }

  /** Returns this vector minus {@code v}, which leads from {@code v} to this point. */
  public Vec2 minus(Vec2 v) {
    Limits.notNull("v", v);
    return new Vec2(x - v.x, y - v.y);
  }

  /** Returns this vector scaled by {@code factor}. A negative factor reverses it. */
  public Vec2 times(float factor) {
    return new Vec2(x * factor, y * factor);
  }

  /** Returns this vector turned counter-clockwise by a quarter turn. */
  public Vec2 perpendicular() {
    return new Vec2(-y, x);
  }

  /**
   * Returns the scalar product. It is positive if the directions differ by less than a quarter
   * turn.
   */
  public float dot(Vec2 v) {
    Limits.notNull("v", v);
    return x * v.x + y * v.y;
  }

  /**
   * Returns the z component of the cross product. It is positive if {@code v} lies
   * counter-clockwise of this vector.
   */
  public float cross(Vec2 v) {
    Limits.notNull("v", v);
    return x * v.y - y * v.x;
  }

  /** Returns the length. It is correct for every finite vector whose length is a finite float. */
  public float length() {
    return (float) Math.sqrt((double) x * x + (double) y * y);
  }

  /**
   * Returns the vector of length one in the direction of this one.
   *
   * @return {@link #ZERO} when this vector is zero
   */
  public Vec2 normalized() {
    double length = Math.sqrt((double) x * x + (double) y * y);
    return length > 0 ? new Vec2((float) (x / length), (float) (y / length)) : ZERO;
  }
}
