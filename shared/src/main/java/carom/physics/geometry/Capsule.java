package carom.physics.geometry;

/**
 * A capsule: all points within a radius of a line between two points. It slides over edges that
 * would catch a box, and rests on its flat side like a box.
 *
 * <p>The vertices are the two ends. Edge 0 is the side to the right of the way from vertex 0 to 1,
 * and edge 1 is the other.
 */
public final class Capsule extends Convex {
  private final float radius;

  /**
   * Creates a capsule between two points; all lengths in metres.
   *
   * @param x0 x of one end's centre
   * @param y0 y of one end's centre
   * @param x1 x of the other end's centre, at least {@link Shape#MIN_SIZE} away
   * @param y1 y of the other end's centre
   * @param radius {@link Shape#MIN_SIZE} to {@link Shape#MAX_SIZE}
   */
  public Capsule(float x0, float y0, float x1, float y1, float radius) {
    super(
        new float[] {checkCoordinate("capsule x0", x0), checkCoordinate("capsule x1", x1)},
        new float[] {checkCoordinate("capsule y0", y0), checkCoordinate("capsule y1", y1)},
        pairNormal(y1 - y0, x0 - x1),
        pairNormal(x0 - x1, y0 - y1),
        false);
    this.radius = checkSize("capsule radius", radius);
    checkSize("capsule length", length());
  }

  /**
   * Returns an upright capsule around the frame's origin, as tall as {@code height} with its caps.
   *
   * @param height more than {@code 2 radius} by {@link Shape#MIN_SIZE} or more; a circle has less
   * @param radius {@link Shape#MIN_SIZE} to {@link Shape#MAX_SIZE}
   */
  public static Capsule upright(float height, float radius) {
    checkSize("capsule radius", radius);
    if (!(height - 2 * radius >= MIN_SIZE && height <= MAX_SIZE)) {
      throw new IllegalArgumentException(
          "capsule height="
              + height
              + " must be in 2 radius + "
              + MIN_SIZE
              + "="
              + (2 * radius + MIN_SIZE)
              + ".."
              + MAX_SIZE
              + " m; a Circle is as high as 2 radius");
    }
    float half = 0.5f * height - radius;
    return new Capsule(0, -half, 0, half, radius);
  }

  @Override
  public float radius() {
    return radius;
  }

  /** Returns the distance between the centres of the two ends, metres. */
  public float length() {
    return (float) lengthOf(0);
  }

  @Override
  public float area() {
    return (float) (2.0 * radius * lengthOf(0) + Math.PI * radius * radius);
  }

  /**
   * Returns the mass of a rectangle and two half discs, each with its own centroid, by the parallel
   * axis theorem; see {@link Convex#roundedMass}.
   */
  @Override
  public MassData mass(float density) {
    return roundedMass(checkDensity(density));
  }

  @Override
  public Capsule moved(float dx, float dy) {
    return new Capsule(vx[0] + dx, vy[0] + dy, vx[1] + dx, vy[1] + dy, radius);
  }

  @Override
  public boolean containsPoint(float x, float y) {
    return isWithin(x, y, radius);
  }

  @Override
  public String toString() {
    return "Capsule("
        + vx[0]
        + " "
        + vy[0]
        + ", "
        + vx[1]
        + " "
        + vy[1]
        + ", radius="
        + radius
        + ")";
  }
}
