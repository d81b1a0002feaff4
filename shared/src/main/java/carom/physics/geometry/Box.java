package carom.physics.geometry;

import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * A rectangle whose sides are parallel to the axes of its body's frame. It turns with the body.
 * While neither of two boxes is rotated, their collision is that of two axis-aligned boxes and
 * costs a few comparisons.
 *
 * <p>Vertices: 0 lower left, 1 lower right, 2 upper right, 3 upper left. Edges: 0 lower, 1 right, 2
 * upper, 3 left.
 */
public final class Box extends Convex {
  private static final float[] NORMAL_X = {0, 1, 0, -1};
  private static final float[] NORMAL_Y = {-1, 0, 1, 0};

  private final float halfWidth;
  private final float halfHeight;
  private final float centerX;
  private final float centerY;

  /**
   * Creates a rectangle around the frame's origin by its whole sizes, as level files tell them.
   *
   * @param width horizontal size, twice {@link Shape#MIN_SIZE} to {@link Shape#MAX_SIZE}, metres
   * @param height vertical size, same range
   */
  public static Box of(float width, float height) {
    return new Box(width / 2, height / 2);
  }

  /**
   * Creates a rectangle of 2 halfWidth x 2 halfHeight metres around the frame's origin. {@link #of}
   * takes whole sizes.
   */
  public Box(float halfWidth, float halfHeight) {
    this(halfWidth, halfHeight, 0, 0);
  }

  /**
   * Creates a rectangle around (centerX, centerY).
   *
   * @param halfWidth half of the horizontal size, {@link Shape#MIN_SIZE} to {@link Shape#MAX_SIZE}
   *     metres
   * @param halfHeight half of the vertical size, same range
   * @param centerX metres, at most {@link Shape#MAX_SIZE} in magnitude
   * @param centerY metres, at most {@link Shape#MAX_SIZE} in magnitude
   */
  public Box(float halfWidth, float halfHeight, float centerX, float centerY) {
    super(
        new float[] {
          centerX - halfWidth, centerX + halfWidth, centerX + halfWidth, centerX - halfWidth
        },
        new float[] {
          centerY - halfHeight, centerY - halfHeight, centerY + halfHeight, centerY + halfHeight
        },
        NORMAL_X,
        NORMAL_Y);
    this.halfWidth = checkSize("box halfWidth", halfWidth);
    this.halfHeight = checkSize("box halfHeight", halfHeight);
    this.centerX = checkCoordinate("box centerX", centerX);
    this.centerY = checkCoordinate("box centerY", centerY);
    checkEdges("box");
  }

  /** Returns half of the horizontal size, metres. */
  public float halfWidth() {
    return halfWidth;
  }

  /** Returns half of the vertical size, metres. */
  public float halfHeight() {
    return halfHeight;
  }

  /** Returns the x of the centre, metres. */
  public float centerX() {
    return centerX;
  }

  /** Returns the y of the centre, metres. */
  public float centerY() {
    return centerY;
  }

  @Override
  public float radius() {
    return 0;
  }

  @Override
  public void aabb(Transform t, Aabb out) {
    Limits.notNull("t", t);
    Limits.notNull("out", out);
    float x = t.worldX(centerX, centerY);
    float y = t.worldY(centerX, centerY);
    float cos = Math.abs(t.cos);
    float sin = Math.abs(t.sin);
    float hw = cos * halfWidth + sin * halfHeight;
    float hh = sin * halfWidth + cos * halfHeight;
    out.set(x - hw, y - hh, x + hw, y + hh);
  }

  @Override
  public float area() {
    return (float) (4.0 * halfWidth * halfHeight);
  }

  /**
   * Returns mass and inertia. The inertia of a w x h rectangle about its centre is m (w&sup2; +
   * h&sup2;) / 12 (any table of moments of inertia).
   */
  @Override
  public MassData mass(float density) {
    double mass = 4.0 * halfWidth * halfHeight * checkDensity(density);
    double squares = (double) halfWidth * halfWidth + (double) halfHeight * halfHeight;
    return new MassData((float) mass, centerX, centerY, (float) (mass * squares / 3));
  }

  @Override
  public Box moved(float dx, float dy) {
    return new Box(halfWidth, halfHeight, centerX + dx, centerY + dy);
  }

  @Override
  public boolean isSame(Convex other) {
    return super.isSame(other)
        && other instanceof Box box
        && halfWidth == box.halfWidth
        && halfHeight == box.halfHeight
        && Float.compare(centerX, box.centerX) == 0
        && Float.compare(centerY, box.centerY) == 0;
  }

  @Override
  public boolean containsPoint(float x, float y) {
    return vx[0] <= x && x <= vx[2] && vy[0] <= y && y <= vy[2];
  }

  @Override
  public String toString() {
    return "Box(halfWidth="
        + halfWidth
        + ", halfHeight="
        + halfHeight
        + ", center="
        + centerX
        + ", "
        + centerY
        + ")";
  }
}
