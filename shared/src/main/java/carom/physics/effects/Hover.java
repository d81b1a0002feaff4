package carom.physics.effects;

import carom.physics.Body;
import carom.physics.QueryFilter;
import carom.physics.QueryHit;
import carom.physics.World;
import carom.physics.math.Limits;

/**
 * Keeps a body at a height above what is below it, like a hovercraft. Apply it before each step:
 *
 * <pre>
 *   Hover hover = new Hover(1.5f).hertz(1).dampingRatio(0.5f);
 *   hover.apply(world, body, dt);
 *   world.step(dt);
 * </pre>
 *
 * <p>A ray from the centre of mass along gravity finds the ground, up to twice the height away.
 * Below the height, the lift carries the body's weight and accelerates it by {@code w^2 (height -
 * distance) - 2 z w v}, as a {@link Spring} does; it never pulls down. Above the height it falls
 * off to nothing where the ray ends, so a body that comes from above gains no energy.
 *
 * <p>A hover is not thread-safe. A repeated call allocates nothing.
 *
 * @param <T> the world's user type
 */
public final class Hover<T> {
  private static final float TWO_PI = 6.2831855f;

  private final float height;
  private final QueryHit<T> hit = new QueryHit<>();
  private final QueryFilter<T> ground = this::isGround;
  private Body<T> lifted;
  private float omega = TWO_PI;
  private float ratio = 0.5f;

  /**
   * Creates a lift of 1 Hz and a damping ratio of 0.5.
   *
   * @param height height of the centre of mass above the ground, 1e-2 to 1e4 m
   */
  public Hover(float height) {
    this.height = Limits.range("height", height, 1e-2f, 1e4f);
  }

  /**
   * Sets the frequency with which a body bobs; default 1.
   *
   * @param hertz oscillations per second, 0 to 1000; cut to what steps can follow
   * @return this
   */
  public Hover<T> hertz(float hertz) {
    omega = TWO_PI * Limits.range("hertz", hertz, 0, Limits.MAX_HERTZ);
    return this;
  }

  /**
   * Sets the damping; default 0.5.
   *
   * @param dampingRatio 0 bobs for ever, 1 settles without bobbing; up to 100
   * @return this
   */
  public Hover<T> dampingRatio(float dampingRatio) {
    ratio = Limits.range("dampingRatio", dampingRatio, 0, Limits.MAX_DAMPING_RATIO);
    return this;
  }

  /**
   * Lifts a body if it is dynamic and awake, and ground is in reach.
   *
   * @param world the body's world
   * @param body the body
   * @param dtSeconds length of the step, s
   * @return whether the body was lifted
   */
  public boolean apply(World<T> world, Body<T> body, float dtSeconds) {
    Limits.notNull("world", world);
    Limits.notNull("body", body);
    Limits.timeStep(dtSeconds);
    float gx = world.gravityX();
    float gy = world.gravityY();
    float g = (float) Math.sqrt(gx * gx + gy * gy);
    if (!(g > 0) || !Nearby.isActedOn(body)) {
      return false;
    }
    float downX = gx / g;
    float downY = gy / g;
    float reach = 2 * height;
    lifted = body;
    boolean found =
        world
            .queries()
            .rayClosest(body.centerX(), body.centerY(), reach * downX, reach * downY, ground, hit);
    lifted = null;
    if (!found) {
      return false;
    }
    float w = Math.min(omega, 1 / dtSeconds);
    float c = 2 * ratio * w;
    float falls = body.velocityX() * downX + body.velocityY() * downY;
    float distance = hit.distance() - falls * Lookahead.seconds(world.def(), dtSeconds);
    float near = Math.max(0, Math.min(1, 2 - distance / height));
    float lift = near * g * body.gravityScale() + w * w * Math.max(0, height - distance);
    lift = Math.max(0, lift + near * c * falls / (1 + c * dtSeconds));
    Areas.push(body, -lift * downX * body.mass(), -lift * downY * body.mass(), 0);
    return lift > 0;
  }

  private boolean isGround(Body<T> body, int shape) {
    return body != lifted && !body.sensor(shape);
  }
}
