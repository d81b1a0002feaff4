package carom.physics.broadphase;

/**
 * A moving box that computes when it meets boxes at rest. The projection on each axis gives an
 * interval of time (the slab method; Kay and Kajiya 1986).
 *
 * <p>A larger box at rest is never met later than a smaller one inside it, rounding included,
 * because every operation is monotone. So a cast through a tree that skips a node misses nothing.
 */
public final class MovingBox {
  private static final double NEVER = Double.POSITIVE_INFINITY;

  private double minX;
  private double minY;
  private double maxX;
  private double maxY;
  private double perX;
  private double perY;

  /** Makes a box; call {@link #set} before use. */
  public MovingBox() {}

  /**
   * Sets the start and the way of the box.
   *
   * @param left left edge, m, finite
   * @param bottom lower edge, m
   * @param right right edge, m
   * @param top upper edge, m
   * @param dx way along x, m
   * @param dy way along y, m
   */
  public void set(float left, float bottom, float right, float top, float dx, float dy) {
    minX = left;
    minY = bottom;
    maxX = right;
    maxY = top;
    perX = dx == 0 ? NEVER : 1 / (double) dx;
    perY = dy == 0 ? NEVER : 1 / (double) dy;
  }

  /**
   * Returns when the moving box first touches a box at rest.
   *
   * @param left left edge of the box at rest, m
   * @param bottom lower edge, m
   * @param right right edge, m
   * @param top upper edge, m
   * @return the fraction of the way: 0 at the start, above 1 beyond the end, infinite if never
   */
  public double enter(float left, float bottom, float right, float top) {
    double enter = 0;
    double leave = NEVER;
    if (perX == NEVER) {
      if (left > maxX || right < minX) {
        return NEVER;
      }
    } else {
      double s = (left - maxX) * perX;
      double t = (right - minX) * perX;
      enter = Math.max(enter, Math.min(s, t));
      leave = Math.max(s, t);
    }
    if (perY == NEVER) {
      if (bottom > maxY || top < minY) {
        return NEVER;
      }
    } else {
      double s = (bottom - maxY) * perY;
      double t = (top - minY) * perY;
      enter = Math.max(enter, Math.min(s, t));
      leave = Math.min(leave, Math.max(s, t));
    }
    return enter <= leave ? enter : NEVER;
  }

  /** Returns when the moving box first touches a box of an array. */
  double enter(AabbArray boxes, int i) {
    return enter(boxes.minX(i), boxes.minY(i), boxes.maxX(i), boxes.maxY(i));
  }
}
