package carom.physics.effects;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;

/**
 * A point that draws bodies in, pushes them away, or swirls them round. Call {@link #apply} before
 * every {@code World.step}.
 *
 * <p>Gives every dynamic body whose centre of mass is within range the same acceleration at the
 * same distance d, whatever its mass:
 *
 * <ul>
 *   <li>{@link Falloff#CONSTANT}: {@code strength} everywhere;
 *   <li>{@link Falloff#LINEAR}: {@code strength * (1 - d / range)}, nothing at the range;
 *   <li>{@link Falloff#INVERSE_SQUARE}: {@code strength * (minimum / d)^2}, like gravity.
 * </ul>
 *
 * <p>Within the minimum radius the acceleration falls to nothing at the point itself, linearly with
 * d, so that it has no jump there. The distance is taken where the body will be in the middle of
 * its substeps, so that orbits keep their energy.
 *
 * <p>Sleeping bodies are left alone; who changes or adds an attractor calls {@link #wake} once. Not
 * thread-safe; a steady call allocates nothing.
 */
public final class Attractor {
  /** How the acceleration changes with the distance. */
  public enum Falloff {
    /** Not at all. */
    CONSTANT,
    /** Linearly, to nothing at the range. */
    LINEAR,
    /** With the square of the distance. */
    INVERSE_SQUARE
  }

  private final float x;
  private final float y;
  private final float range;
  private final Aabb area = new Aabb();
  private float strength = 10;
  private float swirl;
  private float minimum;
  private Falloff falloff = Falloff.CONSTANT;
  private int categories = -1;
  private final Nearby nearby = new Nearby();

  /**
   * An attractor of 10 m/s^2 within its range.
   *
   * @param x where it is, m
   * @param y where it is, m
   * @param range how far it reaches, 1e-3 to 1e6 m
   */
  public Attractor(float x, float y, float range) {
    this.x = Limits.coordinate("x", x);
    this.y = Limits.coordinate("y", y);
    this.range = Limits.range("range", range, 1e-3f, 1e6f);
    area.set(x - range, y - range, x + range, y + range);
    Areas.check(area);
    minimum = 0.01f * range;
  }

  /**
   * Sets the acceleration towards the point; default 10.
   *
   * @param acceleration m/s^2, within 1e5; negative repels
   * @return this
   */
  public Attractor strength(float acceleration) {
    strength = Limits.range("strength", acceleration, -1e5f, 1e5f);
    return this;
  }

  /**
   * Sets the acceleration around the point; default 0. A vortex needs some strength, too, or it
   * throws everything out.
   *
   * @param acceleration m/s^2, counter-clockwise, within 1e5
   * @return this
   */
  public Attractor swirl(float acceleration) {
    swirl = Limits.range("swirl", acceleration, -1e5f, 1e5f);
    return this;
  }

  /**
   * Sets how it changes with the distance; default not at all.
   *
   * @param how the law
   * @param minimumRadius where the law ends towards the point, and, for the inverse square, where
   *     the strength is reached; above 0, at most the range, m; default a hundredth of the range
   * @return this
   */
  public Attractor falloff(Falloff how, float minimumRadius) {
    falloff = how;
    minimum = Limits.range("minimumRadius", minimumRadius, 1e-4f, range);
    return this;
  }

  /**
   * Sets which bodies feel it; default all.
   *
   * @param bits a body feels it if a solid shape's category has one of them
   * @return this
   */
  public Attractor categories(int bits) {
    categories = bits;
    return this;
  }

  /**
   * Pulls at what is within range, for the next step.
   *
   * @param world the world
   * @param dtSeconds length of the next step, s
   */
  public void apply(World<?> world, float dtSeconds) {
    Limits.timeStep(dtSeconds);
    float ahead = Lookahead.seconds(world.def(), dtSeconds);
    nearby.find(world, area);
    for (int i = 0; i < nearby.count(); i++) {
      Body<?> body = nearby.get(i);
      if (body.awake() && Nearby.isOf(body, categories)) {
        pull(body, ahead);
      }
    }
    nearby.clear();
  }

  /**
   * Wakes what sleeps within range: after an attractor came, went or changed.
   *
   * @param world the world
   */
  public void wake(World<?> world) {
    Areas.wake(nearby, world, area);
  }

  private void pull(Body<?> body, float ahead) {
    double dx = (double) x - body.centerX() - (double) body.velocityX() * ahead;
    double dy = (double) y - body.centerY() - (double) body.velocityY() * ahead;
    double d = Math.sqrt(dx * dx + dy * dy);
    if (!(d <= range)) {
      return;
    }
    double at = Math.max(d, minimum);
    double factor =
        switch (falloff) {
          case CONSTANT -> 1;
          case LINEAR -> 1 - at / range;
          case INVERSE_SQUARE -> minimum * (double) minimum / (at * at);
        };
    double k = body.mass() * factor / at;
    body.applyAmbientForce(
        (float) (k * (strength * dx + swirl * dy)), (float) (k * (strength * dy - swirl * dx)), 0);
  }
}
