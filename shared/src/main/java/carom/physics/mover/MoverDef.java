package carom.physics.mover;

import carom.physics.QueryFilter;
import carom.physics.math.Limits;
import carom.physics.math.Trig;

/**
 * The settings of a {@link Mover}. Setters check their argument and return this. A mover copies
 * what it needs.
 *
 * @param <T> the world's user type
 */
public final class MoverDef<T> {
  final float height;
  final float radius;
  float skin = 0.005f;
  float maxSlopeCos = Trig.cos(0.87266463f);
  float stepHeight = 0.3f;
  float snapDistance = 0.3f;
  float pushForce;
  float weight;
  float upX;
  float upY = 1;
  QueryFilter<T> filter;
  QueryFilter<T> oneWay;

  /**
   * Makes the settings of an upright capsule.
   *
   * @param height height with both caps, m, at least twice the radius
   * @param radius radius of the caps, m, 0.01..1000
   */
  public MoverDef(float height, float radius) {
    this.radius = Limits.range("radius", radius, 0.01f, 1000);
    this.height = Limits.range("height", height, 2 * radius, 1e5f);
  }

  /**
   * Sets the gap that the mover keeps between itself and what it touches. It takes up the rounding
   * of coordinates, so it should be larger than they are apart where the mover goes.
   *
   * @param metres the gap, m, 0.0001..0.1; 0.005 by default
   */
  public MoverDef<T> skin(float metres) {
    skin = Limits.range("skin", metres, 1e-4f, 0.1f);
    return this;
  }

  /**
   * Sets the greatest slope that the mover walks and stands on. It slides down steeper ones.
   *
   * @param radians the angle against level ground, rad, 0..1.5; 50 degrees by default
   */
  public MoverDef<T> maxSlope(float radians) {
    maxSlopeCos = Trig.cos(Limits.range("maxSlope", radians, 0, 1.5f));
    return this;
  }

  /**
   * Sets the height of the highest step that the mover walks up.
   *
   * @param metres the height, m, 0..1e4; 0 for none; 0.3 by default
   */
  public MoverDef<T> stepHeight(float metres) {
    stepHeight = Limits.range("stepHeight", metres, 0, 1e4f);
    return this;
  }

  /**
   * Sets how far down the mover follows ground that falls away while it walks. It leaves ground
   * that is farther down, and is in the air.
   *
   * @param metres the distance, m, 0..1e4; 0.3 by default
   */
  public MoverDef<T> snapDistance(float metres) {
    snapDistance = Limits.range("snapDistance", metres, 0, 1e4f);
    return this;
  }

  /**
   * Sets the greatest force by which the mover pushes dynamic bodies that are in its way. In a move
   * of {@code dt} seconds all its pushes together have at most the impulse {@code force * dt}.
   *
   * @param newtons the force, N, not negative; 0 (the default) to push nothing
   */
  public MoverDef<T> pushForce(float newtons) {
    pushForce = Limits.range("pushForce", newtons, 0, Limits.MAX_FORCE);
    return this;
  }

  /**
   * Sets the force by which the mover weighs on a dynamic body that it stands on.
   *
   * @param newtons the force, N, not negative; 0 by default
   */
  public MoverDef<T> weight(float newtons) {
    weight = Limits.range("weight", newtons, 0, Limits.MAX_FORCE);
    return this;
  }

  /**
   * Sets which way is up. The capsule stands along it.
   *
   * @param x x component of a direction of any length; 0 by default
   * @param y y component; 1 by default
   */
  public MoverDef<T> up(float x, float y) {
    Limits.coordinate("upX", x);
    Limits.coordinate("upY", y);
    double length = Math.sqrt((double) x * x + (double) y * y);
    if (!(length > 1e-6)) {
      throw new IllegalArgumentException("up=" + x + " " + y + " has no direction; make it longer");
    }
    upX = (float) (x / length);
    upY = (float) (y / length);
    return this;
  }

  /**
   * Sets which shapes are in the mover's way.
   *
   * @param shapes the shapes; null (the default) for all but sensors
   */
  public MoverDef<T> filter(QueryFilter<T> shapes) {
    filter = shapes;
    return this;
  }

  /**
   * Sets which shapes are one-way: they carry a mover that was above them, and let it through
   * otherwise. Above means above the uppermost face of each convex part.
   *
   * @param shapes the shapes, asked after {@link #filter}; null (the default) for none
   */
  public MoverDef<T> oneWay(QueryFilter<T> shapes) {
    oneWay = shapes;
    return this;
  }
}
