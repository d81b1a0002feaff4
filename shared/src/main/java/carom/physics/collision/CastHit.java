package carom.physics.collision;

import carom.physics.math.Limits;

/** The point, normal and fraction at which a cast met a shape. Mutable and reused. */
public final class CastHit {
  /** Fraction of the way at the first touch, from 0 to the cast's largest fraction. */
  public float fraction;

  /**
   * X of the unit normal of the surface that was hit, pointing out of it and against the motion; 0
   * when the cast began inside.
   */
  public float normalX;

  /** Y of the unit normal, see {@link #normalX}. */
  public float normalY;

  /** World x of the point of touch, metres. */
  public float x;

  /** World y of the point of touch, metres. */
  public float y;

  /** Makes a result with all zeros. */
  public CastHit() {}

  /**
   * Returns whether the cast began inside (or, for a shape, touching). Then fraction and normal are
   * 0.
   */
  public boolean isInside() {
    return normalX == 0 && normalY == 0;
  }

  /** Copies {@code hit} and returns this. */
  public CastHit set(CastHit hit) {
    Limits.notNull("hit", hit);
    return set(hit.fraction, hit.normalX, hit.normalY, hit.x, hit.y);
  }

  CastHit set(double fraction, double normalX, double normalY, double x, double y) {
    this.fraction = (float) fraction;
    this.normalX = (float) normalX + 0f;
    this.normalY = (float) normalY + 0f;
    this.x = (float) x;
    this.y = (float) y;
    return this;
  }

  @Override
  public String toString() {
    return "CastHit(fraction="
        + fraction
        + ", normal="
        + normalX
        + " "
        + normalY
        + ", point="
        + x
        + " "
        + y
        + ")";
  }
}
