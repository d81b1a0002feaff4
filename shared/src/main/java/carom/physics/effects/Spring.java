package carom.physics.effects;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * A spring from a point to every body in its range. Apply it before each step:
 *
 * <pre>
 *   Spring spring = new Spring(0, 5, 10).hertz(1).dampingRatio(0.2f);
 *   spring.apply(world, dt);
 *   world.step(dt);
 * </pre>
 *
 * <p>Each body is accelerated by {@code -w^2 d - 2 z w v}, with w = 2 pi hertz, z the damping
 * ratio, d the way from the point to its centre of mass and v its velocity. It never gains energy:
 * the frequency is cut to what steps can follow, w = 1 / dt, and damping is implicit. A joint with
 * a spring ({@code JointDef.spring}) is the way to tie two bodies.
 *
 * <p>A spring is not thread-safe. A repeated call allocates nothing.
 */
public final class Spring implements Effect {
  private static final float TWO_PI = 6.2831855f;

  private final float x;
  private final float y;
  private final float range;
  private final Aabb area = new Aabb();
  private final Nearby nearby = new Nearby();
  private float omega = TWO_PI;
  private float ratio;
  private int categories = -1;

  /**
   * Creates an undamped spring of 1 Hz.
   *
   * @param x x of the point, m
   * @param y y of the point, m
   * @param range distance up to which bodies are pulled, 1e-3 to 1e6 m
   */
  public Spring(float x, float y, float range) {
    this.x = Limits.coordinate("x", x);
    this.y = Limits.coordinate("y", y);
    this.range = Limits.range("range", range, 1e-3f, 1e6f);
    reach(new Transform(0, 0, 0), area);
    Areas.check(area);
  }

  /**
   * Sets the frequency; default 1.
   *
   * @param hertz oscillations per second, 0 to 1000
   * @return this
   */
  public Spring hertz(float hertz) {
    omega = TWO_PI * Limits.range("hertz", hertz, 0, Limits.MAX_HERTZ);
    return this;
  }

  /**
   * Sets the damping; default 0.
   *
   * @param dampingRatio 0 oscillates for ever, 1 stops without oscillating; up to 100
   * @return this
   */
  public Spring dampingRatio(float dampingRatio) {
    ratio = Limits.range("dampingRatio", dampingRatio, 0, Limits.MAX_DAMPING_RATIO);
    return this;
  }

  /**
   * Sets which bodies are pulled; default all.
   *
   * @param bits category bits; a body is pulled if one of its solid shapes has one of them
   * @return this
   */
  public Spring categories(int bits) {
    categories = bits;
    return this;
  }

  /**
   * Pulls the awake bodies in range. Call it before each step.
   *
   * @param world the world
   * @param dtSeconds length of the step, s
   */
  public void apply(World<?> world, float dtSeconds) {
    Limits.timeStep(dtSeconds);
    nearby.find(world, area);
    for (int i = 0; i < nearby.count(); i++) {
      Body<?> body = nearby.get(i);
      if (body.awake() && Nearby.isOf(body, categories)) {
        pull(world, body, x, y, 1, dtSeconds);
      }
    }
    nearby.clear();
  }

  @Override
  public void act(World<?> world, Body<?> body, Transform frame, float strength, float dtSeconds) {
    Areas.check(world, body, frame, strength, dtSeconds);
    if (Nearby.isActedOn(body) && Nearby.isOf(body, categories)) {
      pull(world, body, frame.worldX(x, y), frame.worldY(x, y), strength, dtSeconds);
    }
  }

  @Override
  public void reach(Transform frame, Aabb out) {
    float atX = Limits.notNull("frame", frame).worldX(x, y);
    float atY = frame.worldY(x, y);
    Limits.notNull("out", out).set(atX - range, atY - range, atX + range, atY + range);
  }

  private void pull(World<?> world, Body<?> body, float atX, float atY, float strength, float dt) {
    float ahead = Lookahead.seconds(world.def(), dt);
    double dx = (double) body.centerX() + (double) body.velocityX() * ahead - atX;
    double dy = (double) body.centerY() + (double) body.velocityY() * ahead - atY;
    if (dx * dx + dy * dy <= (double) range * range) {
      double w = Math.min(omega, 1 / dt);
      double c = 2 * ratio * w;
      double m = strength * body.mass() / (1 + c * dt);
      double fx = -m * (w * w * dx + c * body.velocityX());
      Areas.push(body, fx, -m * (w * w * dy + c * body.velocityY()), 0);
    }
  }
}
