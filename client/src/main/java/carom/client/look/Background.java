package carom.client.look;

import carom.physics.math.Limits;

/**
 * A picture behind the level, repeated without end, that moves less than the level does. The first
 * one declared is the furthest. Each method changes it and returns it, and throws {@link
 * IllegalArgumentException} for a value outside its range.
 */
public final class Background {
  private final String file;
  private float height = 10;
  private float parallax;
  private float bottom = Float.NaN;
  private float driftX;
  private float driftY;
  private float alpha = 1;

  Background(String file) {
    this.file = Limits.notNull("file", file);
  }

  /** Sets the height of one picture, 0.1..10,000 metres; 10 without it. */
  public Background height(float metres) {
    height = Range.check("a background's height", metres, 0.1f, 10_000);
    return this;
  }

  /**
   * Sets how much it moves with the level, -10..10: 0, as without it, is the sky, 1 the level
   * itself, and more is before it.
   */
  public Background parallax(float share) {
    parallax = Range.check("a background's parallax", share, -10, 10);
    return this;
  }

  /** Repeats it to the sides only, with its lower edge at a height of the level, ±32,768 m. */
  public Background standsAt(float y) {
    bottom = Range.check("a background's lower edge", y, -32_768, 32_768);
    return this;
  }

  /** Lets it drift by itself to the right and upwards, -100..100 m/s. */
  public Background drifts(float x, float y) {
    Range.check("a background's drift", x, -100, 100);
    driftY = Range.check("a background's drift", y, -100, 100);
    driftX = x;
    return this;
  }

  /** Sets how opaque it is, 0..1. */
  public Background alpha(float share) {
    alpha = Range.check("a background's alpha", share, 0, 1);
    return this;
  }

  /** Returns the name of the picture's file. */
  public String file() {
    return file;
  }

  /** Returns the height of one picture, metres. */
  public float height() {
    return height;
  }

  /** Returns how much it moves with the level. */
  public float parallax() {
    return parallax;
  }

  /** Returns its lower edge, metres; NaN if it is repeated upwards, too. */
  public float bottom() {
    return bottom;
  }

  /** Returns how far it drifts to the right, m/s. */
  public float driftX() {
    return driftX;
  }

  /** Returns how far it drifts upwards, m/s. */
  public float driftY() {
    return driftY;
  }

  /** Returns how opaque it is, 0..1. */
  public float alpha() {
    return alpha;
  }
}
