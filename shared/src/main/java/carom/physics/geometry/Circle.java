package carom.physics.geometry;

import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/** A disc. */
public final class Circle extends Convex {
  private static final float[] NO_NORMAL = {0};

  private final float radius;

  /**
   * Creates a disc around the frame's origin. The radius is {@link Shape#MIN_SIZE} to {@link
   * Shape#MAX_SIZE} metres.
   */
  public Circle(float radius) {
    this(radius, 0, 0);
  }

  /**
   * Creates a disc around (centerX, centerY), in metres. The radius is {@link Shape#MIN_SIZE} to
   * {@link Shape#MAX_SIZE}.
   */
  public Circle(float radius, float centerX, float centerY) {
    super(
        new float[] {checkCoordinate("circle centerX", centerX)},
        new float[] {checkCoordinate("circle centerY", centerY)},
        NO_NORMAL,
        NO_NORMAL);
    this.radius = checkSize("circle radius", radius);
  }

  @Override
  public float radius() {
    return radius;
  }

  /** Returns the x of the centre, metres. */
  public float centerX() {
    return vx[0];
  }

  /** Returns the y of the centre, metres. */
  public float centerY() {
    return vy[0];
  }

  @Override
  public void aabb(Transform t, Aabb out) {
    Limits.notNull("t", t);
    Limits.notNull("out", out);
    float x = t.worldX(vx[0], vy[0]);
    float y = t.worldY(vx[0], vy[0]);
    out.set(x - radius, y - radius, x + radius, y + radius);
  }

  @Override
  public float area() {
    return (float) (Math.PI * radius * radius);
  }

  /**
   * Returns mass and inertia. The inertia of a disc about its centre is m r&sup2; / 2 (any table of
   * moments of inertia).
   */
  @Override
  public MassData mass(float density) {
    double mass = Math.PI * radius * radius * checkDensity(density);
    return new MassData((float) mass, centerX(), centerY(), (float) (0.5 * mass * radius * radius));
  }

  @Override
  public Circle moved(float dx, float dy) {
    return new Circle(radius, centerX() + dx, centerY() + dy);
  }

  @Override
  public boolean containsPoint(float x, float y) {
    double dx = (double) x - centerX();
    double dy = (double) y - centerY();
    return dx * dx + dy * dy <= (double) radius * radius;
  }

  @Override
  public String toString() {
    return "Circle(radius=" + radius + ", center=" + centerX() + ", " + centerY() + ")";
  }
}
