package carom.physics.effects;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * A force, an acceleration, a wind or a drag that acts on bodies in an area. Call {@link #apply}
 * before every {@code World.step}; several effects add up.
 *
 * <p>It acts at the centre of mass of every dynamic body whose centre is in the area, borders
 * included. (For belts there is {@code Material.tangentSpeed}.)
 *
 * <p>It has no influence on sleeping bodies: a body that came to rest in an effect stays at rest in
 * it. After a change, or for a new effect, call {@link #wake} once. It is immutable except for
 * scratch memory, and not thread-safe. A steady call allocates nothing.
 */
public final class AreaEffect implements Effect {
  private enum Kind {
    FORCE,
    ACCELERATION,
    GRAVITY,
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
   * Returns an effect with the same force on every body, so that light bodies accelerate more.
   *
   * @param area the area, m; copied
   * @param fx force along x, N
   * @param fy force along y, N
   * @return the effect
   */
  public static AreaEffect force(Aabb area, float fx, float fy) {
    return new AreaEffect(Kind.FORCE, area, Limits.force("fx", fx), Limits.force("fy", fy), 0, 0);
  }

  /**
   * Returns an effect with the same acceleration for every body, as a local gravity on top of the
   * world's.
   *
   * @param area the area, m; copied
   * @param ax acceleration along x, m/s^2, within 1e5
   * @param ay acceleration along y, m/s^2, within 1e5
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
   * Returns an effect that adds to the world's gravity, as far as a body's gravity scale lets it.
   * Its direction is in world axes, also in a frame that turns.
   *
   * @param area the area, m; copied
   * @param ax acceleration along x, m/s^2, within 1e5
   * @param ay acceleration along y, m/s^2, within 1e5
   * @return the effect
   */
  public static AreaEffect gravity(Aabb area, float ax, float ay) {
    return new AreaEffect(
        Kind.GRAVITY,
        area,
        Limits.range("ax", ax, -1e5f, 1e5f),
        Limits.range("ay", ay, -1e5f, 1e5f),
        0,
        0);
  }

  /**
   * Returns a wind or a current. In every step, the difference between a body's velocity and the
   * flow's shrinks by {@code 1 / (1 + rate dt)}, whatever the mass, and never overshoots.
   *
   * @param area the area, m; copied
   * @param vx velocity of the flow along x, m/s
   * @param vy velocity of the flow along y, m/s
   * @param rate strength of the coupling, 1/s, 0 to 1e4
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
   * Returns a drag, like that of mud. Velocities shrink by {@code 1 / (1 + rate dt)} in every step.
   *
   * @param area the area, m; copied
   * @param rate rate for the velocity, 1/s, 0 to 1e4
   * @param angularRate rate for the angular velocity, 1/s, 0 to 1e4
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
   * Sets which bodies the effect acts on; default all.
   *
   * @param bits category bits; the effect acts on a body if a solid shape's category has one of
   *     them
   * @return this
   */
  public AreaEffect categories(int bits) {
    categories = bits;
    return this;
  }

  /**
   * Applies the effect to the bodies in the area, for the next step.
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
        act(body, x, y, 1, dtSeconds);
      }
    }
    nearby.clear();
  }

  @Override
  public void act(World<?> world, Body<?> body, Transform frame, float strength, float dtSeconds) {
    Areas.check(world, body, frame, strength, dtSeconds);
    float localX = frame.localX(body.centerX(), body.centerY());
    float localY = frame.localY(body.centerX(), body.centerY());
    if (Nearby.isActedOn(body) && area.contains(localX, localY) && Nearby.isOf(body, categories)) {
      boolean turns = kind != Kind.GRAVITY;
      float wx = turns ? frame.rotateX(x, y) : x;
      float wy = turns ? frame.rotateY(x, y) : y;
      act(body, wx, wy, strength, dtSeconds);
    }
  }

  @Override
  public void reach(Transform frame, Aabb out) {
    Areas.reach(area, frame, out);
  }

  /**
   * Applies the effect to all bodies that any part of a sensor overlapped in the last step,
   * wherever the area is.
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
        act(body, x, y, 1, dtSeconds);
      }
    }
    nearby.clear();
  }

  /**
   * Wakes the bodies that sleep in the area. Call it after an effect was added, removed or changed.
   *
   * @param world the world
   */
  public void wake(World<?> world) {
    Areas.wake(nearby, world, area);
  }

  /**
   * Acts on a body.
   *
   * @param wx the vector of the effect, world axes
   * @param wy the vector of the effect, world axes
   */
  private void act(Body<?> body, float wx, float wy, float strength, float dt) {
    switch (kind) {
      case FORCE -> Areas.push(body, strength * wx, strength * wy, 0);
      case ACCELERATION -> accelerate(body, strength * body.mass(), wx, wy);
      case GRAVITY -> accelerate(body, strength * body.gravityScale() * body.mass(), wx, wy);
      case FLOW -> {
        float pull = body.mass() * (strength * rate) / (1 + strength * rate * dt);
        float brake = body.inertia() * (strength * angularRate) / (1 + strength * angularRate * dt);
        Areas.push(
            body,
            pull * (wx - body.velocityX()),
            pull * (wy - body.velocityY()),
            -brake * body.angularVelocity());
      }
    }
  }

  private static void accelerate(Body<?> body, float factor, float ax, float ay) {
    Areas.push(body, factor * ax, factor * ay, 0);
  }
}
