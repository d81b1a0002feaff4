package carom.physics.broadphase.index;

/**
 * A box on its way, and when it meets boxes at rest. The shadows on both axes give each an interval
 * of time (slabs; Kay and Kajiya 1986).
 *
 * <p>A larger box at rest is never met later than a smaller one inside it, rounding included: every
 * operation is monotone. So nodes of trees hide nothing.
 */
public final class MovingBox {
  private static final double NEVER = Double.POSITIVE_INFINITY;

  private double minX;
  private double minY;
  private double maxX;
  private double maxY;
  private double perX;
  private double perY;

  /** Makes a box that must be set. */
  public MovingBox() {}

  /**
   * Sets the box at its start and its way.
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
   * When the boxes first touch.
   *
   * @param left left edge of the box at rest, m
   * @param bottom lower edge, m
   * @param right right edge, m
   * @param top upper edge, m
   * @return the part of the way, 0 at the start, perhaps beyond its end; infinite if never
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

  /** The same for one of many boxes. */
  double enter(AabbArray boxes, int i) {
    return enter(boxes.minX(i), boxes.minY(i), boxes.maxX(i), boxes.maxY(i));
  }
}
