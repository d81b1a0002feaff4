package carom.physics.effects;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * A fluid that lifts bodies, brakes them, and carries them along. Call {@link #apply} before every
 * {@code World.step}:
 *
 * <pre>
 *   Buoyancy lake = new Buoyancy(new Aabb(-10, -5, 10, 0), 1000).drag(1).flow(0.5f, 0);
 *   lake.apply(world, dt);
 *   world.step(dt);
 * </pre>
 *
 * <p>The fluid fills an area below a surface. By Archimedes' principle, a body loses the weight of
 * the fluid it displaces, {@code density * area * gravity}, at the centroid of the submerged area.
 * That area is exact for polygons and discs; capsules and rounded polygons are approximated by
 * many-cornered polygons with the shape's area. Overlapping parts of a body each displace in full.
 *
 * <p><b>Drag</b> depends on the submerged area's velocity relative to the flow: force {@code drag *
 * density * area * (flow - v)} at the centroid, torque {@code angularDrag * density * J * -w}, with
 * J the second moment of the submerged area about its centroid. Both are applied implicitly over
 * the step and never overshoot.
 *
 * <p>Without drag, a floating body bobs for ever and neither gains nor loses energy, because the
 * force is measured where the body will be in the middle of its substeps. An angular frequency
 * above 2 / dt is too fast for this, such as that of a 1 cm slab of a thousandth of the fluid's
 * density at 60 steps per second. Make such a body heavier or use drag.
 *
 * <p>The fluid has no influence on sleeping bodies, which need no force while at rest in it. After
 * a change, call {@link #wake} once. Settings are not part of any saved state. It is not
 * thread-safe. A steady call allocates nothing.
 */
public final class Buoyancy implements Effect {
  private final Aabb area = new Aabb();
  private final float density;
  private float surfaceX;
  private float surfaceY;
  private float normalX;
  private float normalY = 1;
  private boolean surfaceGiven;
  private float drag = 1;
  private float angularDrag = 1;
  private float flowX;
  private float flowY;
  private int categories = -1;
  private final Nearby nearby = new Nearby();
  private final Submerged submerged = new Submerged();
  private final Aabb box = new Aabb();

  /**
   * Creates a fluid that fills an area, whose upper edge is the surface.
   *
   * @param area the area, m; not empty, copied
   * @param density density of the fluid, kg/m^2, not negative, at most 1e6
   */
  public Buoyancy(Aabb area, float density) {
    Areas.check(area);
    this.area.set(area);
    this.density = Limits.range("density", density, 0, 1e6f);
  }

  /**
   * Sets a surface other than the area's upper edge.
   *
   * @param x x of a point on the surface, m
   * @param y y of a point on the surface, m
   * @param upX x of the direction out of the fluid; any length but 0
   * @param upY y of the direction out of the fluid
   * @return this
   */
  public Buoyancy surface(float x, float y, float upX, float upY) {
    Limits.coordinate("x", x);
    Limits.coordinate("y", y);
    Limits.coordinate("upX", upX);
    Limits.coordinate("upY", upY);
    double length = Math.sqrt((double) upX * upX + (double) upY * upY);
    if (!(length > 1e-6)) {
      throw new IllegalArgumentException(
          "up=" + upX + " " + upY + " has no length; (0, 1) is a level surface");
    }
    surfaceX = x;
    surfaceY = y;
    normalX = (float) (upX / length);
    normalY = (float) (upY / length);
    surfaceGiven = true;
    return this;
  }

  /**
   * Sets how quickly the fluid carries bodies along; default 1.
   *
   * @param perSecond rate at which a submerged body of the fluid's density approaches the velocity
   *     of the flow; 1/s, 0 to 1e4
   * @return this
   */
  public Buoyancy drag(float perSecond) {
    drag = Limits.range("drag", perSecond, 0, 1e4f);
    return this;
  }

  /**
   * Sets how quickly the fluid stops the rotation of bodies; default 1.
   *
   * @param perSecond rate, 1/s, 0 to 1e4
   * @return this
   */
  public Buoyancy angularDrag(float perSecond) {
    angularDrag = Limits.range("angularDrag", perSecond, 0, 1e4f);
    return this;
  }

  /**
   * Sets the velocity of the fluid; default 0. It acts through drag.
   *
   * @param vx velocity along x, m/s
   * @param vy velocity along y, m/s
   * @return this
   */
  public Buoyancy flow(float vx, float vy) {
    Limits.velocity("flowX", vx);
    Limits.velocity("flowY", vy);
    flowX = vx;
    flowY = vy;
    return this;
  }

  /**
   * Sets which shapes the fluid acts on; default all that are not sensors.
   *
   * @param bits category bits; the fluid acts on a shape if its filter's category has one of them
   * @return this
   */
  public Buoyancy categories(int bits) {
    categories = bits;
    return this;
  }

  /**
   * Lifts, brakes and carries the bodies in the fluid, for the next step.
   *
   * @param world the world
   * @param dtSeconds length of the next step, s
   */
  public void apply(World<?> world, float dtSeconds) {
    Limits.timeStep(dtSeconds);
    nearby.find(world, area);
    act(world, area, dtSeconds);
  }

  /**
   * Acts on a body in the next step. The frame moves the fluid, but doesn't turn it: area and
   * surface stay upright. The strength is a factor on the fluid's density.
   */
  @Override
  public void act(World<?> world, Body<?> body, Transform frame, float strength, float dtSeconds) {
    Areas.check(world, body, frame, strength, dtSeconds);
    if (Nearby.isActedOn(body)) {
      reach(frame, box);
      float ahead = Lookahead.seconds(world.def(), dtSeconds);
      lift(world, body, box, frame.x, frame.y, strength * density, ahead, dtSeconds);
    }
  }

  @Override
  public void reach(Transform frame, Aabb out) {
    Limits.notNull("frame", frame);
    Limits.notNull("out", out);
    out.set(area.minX + frame.x, area.minY + frame.y, area.maxX + frame.x, area.maxY + frame.y);
  }

  /**
   * Applies the fluid to the bodies that were in a sensor in the last step. The sensor's box bounds
   * the fluid, wherever the sensor has moved. The box's upper edge is the surface unless one was
   * set.
   *
   * @param world the world
   * @param sensor a body with sensors
   * @param dtSeconds length of the next step, s
   * @param <T> the world's user type
   */
  public <T> void apply(World<T> world, Body<T> sensor, float dtSeconds) {
    Limits.timeStep(dtSeconds);
    Limits.notNull("world", world);
    Limits.notNull("sensor", sensor).aabb(box);
    nearby.findInside(sensor);
    act(world, box, dtSeconds);
  }

  private void act(World<?> world, Aabb bounds, float dt) {
    float ahead = Lookahead.seconds(world.def(), dt);
    for (int i = 0; i < nearby.count(); i++) {
      Body<?> body = nearby.get(i);
      if (body.awake()) {
        lift(world, body, bounds, 0, 0, density, ahead, dt);
      }
    }
    nearby.clear();
  }

  /**
   * Wakes the bodies that sleep in the fluid. Call it after density, surface or flow changed.
   *
   * @param world the world
   */
  public void wake(World<?> world) {
    Areas.wake(nearby, world, area);
  }

  /**
   * Acts on a body.
   *
   * @param movedX how far a given surface has moved with the fluid, m
   * @param movedY how far a given surface has moved with the fluid, m
   * @param thickness density of the fluid, kg/m^2
   */
  private void lift(
      World<?> world,
      Body<?> body,
      Aabb bounds,
      float movedX,
      float movedY,
      float thickness,
      float ahead,
      float dt) {
    measure(body, bounds, movedX, movedY, ahead);
    double mass = thickness * submerged.area;
    if (!(mass > 0)) {
      return;
    }
    double rx = submerged.centroidX;
    double ry = submerged.centroidY;
    double inverseInertia = body.inertia() > 0 ? 1.0 / body.inertia() : 0;
    double arm = (rx * rx + ry * ry) * inverseInertia;
    double rate = drag * mass;
    double pull = rate / (1 + dt * rate * (1.0 / body.mass() + arm));
    double w = body.angularVelocity();
    double fx = -mass * world.gravityX() + pull * (flowX - (body.velocityX() - w * ry));
    double fy = -mass * world.gravityY() + pull * (flowY - (body.velocityY() + w * rx));
    double turn = angularDrag * thickness * submerged.second;
    double brake = turn / (1 + dt * turn * inverseInertia);
    Areas.push(body, fx, fy, rx * fy - ry * fx - brake * w);
  }

  private void measure(Body<?> body, Aabb bounds, float movedX, float movedY, float ahead) {
    double cos = body.cos();
    double sin = body.sin();
    double turn = body.angularVelocity() * ahead;
    double c = cos - turn * sin;
    double s = sin + turn * cos;
    double length = Math.sqrt(c * c + s * s);
    c /= length;
    s /= length;
    double ox = (double) body.x() - body.centerX();
    double oy = (double) body.y() - body.centerY();
    double localX = cos * ox + sin * oy;
    double localY = cos * oy - sin * ox;
    submerged.begin(
        body.centerX() + (double) body.velocityX() * ahead,
        body.centerY() + (double) body.velocityY() * ahead,
        c * localX - s * localY,
        s * localX + c * localY,
        c,
        s,
        bounds,
        surfaceGiven ? surfaceX + movedX : bounds.maxX,
        surfaceGiven ? surfaceY + movedY : bounds.maxY,
        normalX,
        normalY);
    for (int i = 0; i < body.shapeCount(); i++) {
      if (!body.sensor(i) && (body.filter(i).category() & categories) != 0) {
        Shape shape = body.shape(i);
        for (int k = 0; k < shape.parts().size(); k++) {
          submerged.add(shape.parts().get(k));
        }
      }
    }
    submerged.end();
  }
}
