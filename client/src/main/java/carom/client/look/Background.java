package carom.client.look;

/**
 * A picture behind the level, repeated without end, that moves less than the level does. The first
 * one declared is the furthest. Each method changes it and returns it.
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
    this.file = file;
  }

  /** Sets the height of one picture, metres; 10 without it. */
  public Background height(float metres) {
    if (!(metres > 0)) {
      throw new IllegalArgumentException("a background's height=" + metres);
    }
    height = metres;
    return this;
  }

  /** Sets how much it moves with the level: 0, as without it, is the sky, 1 the level itself. */
  public Background parallax(float share) {
    parallax = share;
    return this;
  }

  /** Repeats it to the sides only, with its lower edge at a height of the level, metres. */
  public Background standsAt(float y) {
    bottom = y;
    return this;
  }

  /** Lets it drift by itself, m/s. */
  public Background drifts(float x, float y) {
    driftX = x;
    driftY = y;
    return this;
  }

  /** Sets how opaque it is, 0..1. */
  public Background alpha(float share) {
    alpha = Math.max(0, Math.min(1, share));
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
