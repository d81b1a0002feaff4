package carom.physics.collision;

/**
 * A minimum translation vector: the shortest move of shape A, in world axes, that takes it out of
 * shape B. Reused.
 */
public final class Mtv {
  /** Component along the world's x axis, metres. */
  public float x;

  /** Component along the world's y axis, metres. */
  public float y;

  /** Makes a zero vector. */
  public Mtv() {}

  /** Sets both components and returns this. */
  public Mtv set(float x, float y) {
    this.x = x;
    this.y = y;
    return this;
  }

  /** Returns how deep the shapes overlap, metres. */
  public float length() {
    return (float) Math.sqrt((double) x * x + (double) y * y);
  }

  @Override
  public String toString() {
    return "Mtv(" + x + ", " + y + ")";
  }
}
