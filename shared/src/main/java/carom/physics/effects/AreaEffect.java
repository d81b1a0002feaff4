package carom.physics.effects;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;

/**
 * A place where something pulls at bodies: a force, an acceleration, a wind, a drag. Call {@link
 * #apply} before every {@code World.step}; several effects add up.
 *
 * <p>Acts at the centre of mass of every dynamic body whose centre is in the area, borders
 * included. (For belts there is {@code Material.tangentSpeed}.)
 *
 * <p>Sleeping bodies are left alone: what came to rest in an effect stays at rest in it. Who
 * changes or adds an effect calls {@link #wake} once. Immutable but for scratch memory; not
 * thread-safe; a steady call allocates nothing.
 */
public final class AreaEffect {
  private enum Kind {
    FORCE,
    ACCELERATION,
    FLOW
  }

  private final Kind kind;
  private final Aabb area = new Aabb();
  private final float x;
  private final float y;
  private final float rate;
  private final float angularRate;
  private int categories = -1;
  private final Nearby nearby = new Nearby();

  private AreaEffect(Kind kind, Aabb area, float x, float y, float rate, float angularRate) {
    Areas.check(area);
    this.kind = kind;
    this.area.set(area);
    this.x = x;
    this.y = y;
    this.rate = rate;
    this.angularRate = angularRate;
  }

  /**
   * The same force for every body: the light ones fly.
   *
   * @param area m, copied
   * @param fx N
   * @param fy N
   * @return the effect
   */
  public static AreaEffect force(Aabb area, float fx, float fy) {
    return new AreaEffect(Kind.FORCE, area, Limits.force("fx", fx), Limits.force("fy", fy), 0, 0);
  }

  /**
   * The same acceleration for every body: a gravity of its own, on top of the world's.
   *
   * @param area m, copied
   * @param ax m/s^2, within 1e5
   * @param ay m/s^2
   * @return the effect
   */
  public static AreaEffect acceleration(Aabb area, float ax, float ay) {
    return new AreaEffect(
        Kind.ACCELERATION,
        area,
        Limits.range("ax", ax, -1e5f, 1e5f),
        Limits.range("ay", ay, -1e5f, 1e5f),
        0,
        0);
  }

  /**
   * Wind, or a current: the difference to a velocity shrinks by {@code 1 / (1 + rate dt)} in every
   * step, whatever the mass, and never overshoots.
   *
   * @param area m, copied
   * @param vx velocity of the air, m/s
   * @param vy velocity of the air, m/s
   * @param rate 1/s, 0 to 1e4
   * @return the effect
   */
  public static AreaEffect wind(Aabb area, float vx, float vy, float rate) {
    return new AreaEffect(
        Kind.FLOW,
        area,
        Limits.velocity("vx", vx),
        Limits.velocity("vy", vy),
        Limits.range("rate", rate, 0, 1e4f),
        0);
  }

  /**
   * Mud: velocities shrink by {@code 1 / (1 + rate dt)} in every step.
   *
   * @param area m, copied
   * @param rate for the velocity, 1/s, 0 to 1e4
   * @param angularRate for the angular velocity, 1/s, 0 to 1e4
   * @return the effect
   */
  public static AreaEffect drag(Aabb area, float rate, float angularRate) {
    return new AreaEffect(
        Kind.FLOW,
        area,
        0,
        0,
        Limits.range("rate", rate, 0, 1e4f),
        Limits.range("angularRate", angularRate, 0, 1e4f));
  }

  /**
   * Sets which bodies feel it; default all.
   *
   * @param bits a body feels it if a solid shape's category has one of them
   * @return this
   */
  public AreaEffect categories(int bits) {
    categories = bits;
    return this;
  }

  /**
   * Pulls at what is in the area, for the next step.
   *
   * @param world the world
   * @param dtSeconds length of the next step, s
   */
  public void apply(World<?> world, float dtSeconds) {
    Limits.timeStep(dtSeconds);
    nearby.find(world, area);
    for (int i = 0; i < nearby.count(); i++) {
      Body<?> body = nearby.get(i);
      if (body.awake()
          && area.contains(body.centerX(), body.centerY())
          && Nearby.isOf(body, categories)) {
        act(body, dtSeconds);
      }
    }
    nearby.clear();
  }

  /**
   * The same for all that was in a sensor in the last step, with any part of it, wherever the area
   * is.
   *
   * @param sensor a body with sensors
   * @param dtSeconds length of the next step, s
   */
  public void apply(Body<?> sensor, float dtSeconds) {
    Limits.timeStep(dtSeconds);
    nearby.findInside(sensor);
    for (int i = 0; i < nearby.count(); i++) {
      Body<?> body = nearby.get(i);
      if (body.awake() && Nearby.isOf(body, categories)) {
        act(body, dtSeconds);
      }
    }
    nearby.clear();
  }

  /**
   * Wakes what sleeps in the area: after an effect came, went or changed.
   *
   * @param world the world
   */
  public void wake(World<?> world) {
    Areas.wake(nearby, world, area);
  }

  private void act(Body<?> body, float dt) {
    if (kind == Kind.FORCE) {
      body.applyAmbientForce(x, y, 0);
    } else if (kind == Kind.ACCELERATION) {
      body.applyAmbientForce(body.mass() * x, body.mass() * y, 0);
    } else {
      float pull = body.mass() * rate / (1 + rate * dt);
      float brake = body.inertia() * angularRate / (1 + angularRate * dt);
      body.applyAmbientForce(
          pull * (x - body.velocityX()),
          pull * (y - body.velocityY()),
          -brake * body.angularVelocity());
    }
  }
}
