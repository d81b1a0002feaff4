package carom.physics.effects;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * A point that attracts bodies, repels them, or swirls them round. Call {@link #apply} before every
 * {@code World.step}.
 *
 * <p>It gives every dynamic body whose centre of mass is within range the same acceleration at the
 * same distance d, independent of its mass:
 *
 * <ul>
 *   <li>{@link Falloff#CONSTANT}: {@code strength} everywhere;
 *   <li>{@link Falloff#LINEAR}: {@code strength * (1 - d / range)}, nothing at the range;
 *   <li>{@link Falloff#INVERSE_SQUARE}: {@code strength * (minimum / d)^2}, like gravity.
 * </ul>
 *
 * <p>Within the minimum radius, the acceleration falls linearly with d to nothing at the point
 * itself, so that it has no jump there. The distance is measured where the body will be in the
 * middle of its substeps, so that orbits keep their energy.
 *
 * <p>It has no influence on sleeping bodies. After a change, or for a new attractor, call {@link
 * #wake} once. It is not thread-safe. A steady call allocates nothing.
 */
public final class Attractor implements Effect {
  /** Law by which the acceleration depends on the distance. */
  public enum Falloff {
    /** The acceleration is the same at every distance. */
    CONSTANT,
    /** The acceleration falls linearly to nothing at the range. */
    LINEAR,
    /** The acceleration falls with the square of the distance. */
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
   * Creates an attractor of 10 m/s^2 within its range.
   *
   * @param x x of the point, m
   * @param y y of the point, m
   * @param range range, 1e-3 to 1e6 m
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
   * Sets the acceleration around the point; default 0. A vortex also needs some strength, otherwise
   * it throws everything out.
   *
   * @param acceleration m/s^2, counter-clockwise, within 1e5
   * @return this
   */
  public Attractor swirl(float acceleration) {
    swirl = Limits.range("swirl", acceleration, -1e5f, 1e5f);
    return this;
  }

  /**
   * Sets how the acceleration depends on the distance; default {@link Falloff#CONSTANT}.
   *
   * @param how the law
   * @param minimumRadius distance below which the acceleration falls to nothing and, for the
   *     inverse square, at which it equals the strength; 1e-4 m to the range; default a hundredth
   *     of the range
   * @return this
   */
  public Attractor falloff(Falloff how, float minimumRadius) {
    Limits.notNull("how", how);
    minimum = Limits.range("minimumRadius", minimumRadius, 1e-4f, range);
    falloff = how;
    return this;
  }

  /**
   * Sets which bodies the attractor acts on; default all.
   *
   * @param bits category bits; the attractor acts on a body if a solid shape's category has one of
   *     them
   * @return this
   */
  public Attractor categories(int bits) {
    categories = bits;
    return this;
  }

  /**
   * Applies the acceleration to the bodies within range, for the next step.
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
        pull(body, x, y, 1, ahead);
      }
    }
    nearby.clear();
  }

  @Override
  public void act(World<?> world, Body<?> body, Transform frame, float strength, float dtSeconds) {
    Areas.check(world, body, frame, strength, dtSeconds);
    if (Nearby.isActedOn(body) && Nearby.isOf(body, categories)) {
      float ahead = Lookahead.seconds(world.def(), dtSeconds);
      pull(body, frame.worldX(x, y), frame.worldY(x, y), strength, ahead);
    }
  }

  @Override
  public void reach(Transform frame, Aabb out) {
    float atX = Limits.notNull("frame", frame).worldX(x, y);
    float atY = frame.worldY(x, y);
    Limits.notNull("out", out).set(atX - range, atY - range, atX + range, atY + range);
  }

  /**
   * Wakes the bodies that sleep within range. Call it after an attractor was added, removed or
   * changed.
   *
   * @param world the world
   */
  public void wake(World<?> world) {
    Areas.wake(nearby, world, area);
  }

  private void pull(Body<?> body, float atX, float atY, float factorOfAll, float ahead) {
    double dx = (double) atX - body.centerX() - (double) body.velocityX() * ahead;
    double dy = (double) atY - body.centerY() - (double) body.velocityY() * ahead;
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
    double k = factorOfAll * (body.mass() * factor / at);
    Areas.push(body, k * (strength * dx + swirl * dy), k * (strength * dy - swirl * dx), 0);
  }
}
