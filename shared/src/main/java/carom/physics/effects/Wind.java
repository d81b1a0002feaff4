package carom.physics.effects;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.geometry.Convex;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;
import java.util.List;

/**
 * A wind that acts on the edges of shapes, with drag and lift: it turns sails into it, carries
 * kites and lets a falling card flutter. ({@link AreaEffect#wind} is simpler: it takes bodies
 * along, whatever their form.) Call {@link #apply} before every {@code World.step}.
 *
 * <p>An edge that faces the wind feels the air's velocity u relative to its own. With the air's
 * density d, the edge's length l and the part s of it that the wind sees, {@code s = -u.n / |u|}
 * for the outward normal n,
 *
 * <pre>
 *   drag = 1/2 d cd l s |u|^2   along u
 *   lift = 1/2 d cl l s c |u|^2 across u, to the side to which the edge deflects;  c^2 + s^2 = 1
 * </pre>
 *
 * <p>With equal coefficients that is the force of air that bounces off a flat plate. As in Box2D
 * 3.2 (b2Shape_ApplyWind), a force acts on each edge, from the velocity of the edge itself. Each
 * half of an edge is felt at a point of its own, so rotation is damped, too. Rounded corners, and
 * circles, have the drag of a disc. Edges in the lee feel nothing, nor do half edges at which
 * another part of the same body begins: it doesn't matter into which parts a body is cut. All other
 * edges feel the wind as if nothing were in front of them.
 *
 * <p>The forces on a body are limited together, so that none reverses the velocity of an edge
 * against the air in a step, so light bodies stay stable in any wind. It has no influence on
 * sleeping bodies: after a change, or for a new wind, call {@link #wake} once. It is not
 * thread-safe. A steady call allocates nothing.
 */
public final class Wind implements Effect {
  /** Distance of Gauss' two points from the middle of an edge, in its lengths: 1 / sqrt(12). */
  private static final float GAUSS = 0.28867513f;

  /** Distance before an edge at which it feels the wind, m, unless the body's own part is there. */
  private static final float BEFORE = 1e-3f;

  private final Aabb area = new Aabb();
  private final float x;
  private final float y;
  private float airDensity = 1.2f;
  private float drag = 1;
  private float lift = 1;
  private int categories = -1;
  private final Nearby nearby = new Nearby();
  private final Transform identity = new Transform(0, 0, 0);

  // The body at present, and what acts on it so far.
  private float forceX;
  private float forceY;
  private float torque;

  /** Rate at which the forces so far draw what they act on to the air, 1/s. */
  private float stiffness;

  private float inverseMass;
  private float inverseInertia;

  /**
   * Creates a wind with a drag and a lift of 1, of air of 1.2 kg/m^2.
   *
   * @param area the area, m; copied. Half an edge feels the wind if its point is inside
   * @param vx velocity of the air along x, m/s, within 1e5
   * @param vy velocity of the air along y, m/s, within 1e5
   */
  public Wind(Aabb area, float vx, float vy) {
    Areas.check(area);
    this.area.set(area);
    x = Limits.velocity("vx", vx);
    y = Limits.velocity("vy", vy);
  }

  /**
   * Sets the density of the air; default 1.2.
   *
   * @param density kg/m^2, 0..1e4, in the same unit as that of materials
   * @return this
   */
  public Wind airDensity(float density) {
    airDensity = Limits.range("airDensity", density, 0, 1e4f);
    return this;
  }

  /**
   * Sets the drag coefficient; default 1.
   *
   * @param coefficient 0..1000
   * @return this
   */
  public Wind drag(float coefficient) {
    drag = Limits.range("drag", coefficient, 0, 1000);
    return this;
  }

  /**
   * Sets the lift coefficient; default 1.
   *
   * @param coefficient 0..1000; 0 for no lift
   * @return this
   */
  public Wind lift(float coefficient) {
    lift = Limits.range("lift", coefficient, 0, 1000);
    return this;
  }

  /**
   * Sets which bodies the wind acts on; default all.
   *
   * @param bits category bits; the wind acts on a body if a solid shape's category has one of them
   * @return this
   */
  public Wind categories(int bits) {
    categories = bits;
    return this;
  }

  /**
   * Applies the wind to the bodies in the area, for the next step.
   *
   * @param world the world
   * @param dtSeconds length of the next step, s
   */
  public void apply(World<?> world, float dtSeconds) {
    Limits.timeStep(dtSeconds);
    nearby.find(world, area);
    for (int i = 0; i < nearby.count(); i++) {
      act(world, nearby.get(i), identity, 1, dtSeconds);
    }
    nearby.clear();
  }

  @Override
  public void act(World<?> world, Body<?> body, Transform frame, float strength, float dtSeconds) {
    Areas.check(world, body, frame, strength, dtSeconds);
    if (!Nearby.isActedOn(body) || !Nearby.isOf(body, categories)) {
      return;
    }
    forceX = 0;
    forceY = 0;
    torque = 0;
    inverseMass = 1 / body.mass();
    inverseInertia = body.inertia() > 0 ? 1 / body.inertia() : 0;
    stiffness = 0;
    float factor = 0.5f * airDensity * strength;
    for (int i = 0; i < body.shapeCount(); i++) {
      if (!body.sensor(i)) {
        List<Convex> parts = body.shape(i).parts();
        for (int k = 0; k < parts.size(); k++) {
          actOnEdges(body, parts.get(k), frame, factor);
          actOnRounding(body, parts.get(k), frame, factor);
        }
      }
    }
    // No edge may be faster than the air after the step, whatever acts on the others.
    float share = 1 / (1 + dtSeconds * stiffness);
    Areas.push(body, share * forceX, share * forceY, share * torque);
  }

  private void actOnEdges(Body<?> body, Convex part, Transform frame, float factor) {
    int n = part.vertexCount();
    for (int e = 0; n > 1 && e < n; e++) {
      int next = e + 1 == n ? 0 : e + 1;
      float ex = part.vertexX(next) - part.vertexX(e);
      float ey = part.vertexY(next) - part.vertexY(e);
      float nx = body.cos() * part.normalX(e) - body.sin() * part.normalY(e);
      float ny = body.sin() * part.normalX(e) + body.cos() * part.normalY(e);
      float rim = part.radius();
      float middleX = 0.5f * (part.vertexX(e) + part.vertexX(next)) + rim * part.normalX(e);
      float middleY = 0.5f * (part.vertexY(e) + part.vertexY(next)) + rim * part.normalY(e);
      float half = 0.5f * (float) Math.sqrt(ex * ex + ey * ey);
      float beforeX = middleX + BEFORE * part.normalX(e);
      float beforeY = middleY + BEFORE * part.normalY(e);
      for (int which = -1; which <= 1; which += 2) {
        float side = which * GAUSS;
        if (!isWithin(body, part, beforeX + side * ex, beforeY + side * ey)) {
          act(body, middleX + side * ex, middleY + side * ey, nx, ny, half, frame, factor);
        }
      }
    }
  }

  /** Returns whether a point, in the body's frame, is in another part of the body than one. */
  @SuppressWarnings("ReferenceEquality") // equal parts may lie side by side
  private static boolean isWithin(Body<?> body, Convex but, float x, float y) {
    for (int i = 0; i < body.shapeCount(); i++) {
      List<Convex> parts = body.sensor(i) ? List.of() : body.shape(i).parts();
      for (int k = 0; k < parts.size(); k++) {
        if (parts.get(k) != but && parts.get(k).containsPoint(x, y)) {
          return true;
        }
      }
    }
    return false;
  }

  private void actOnRounding(Body<?> body, Convex part, Transform frame, float factor) {
    if (part.radius() > 0) {
      int n = part.vertexCount();
      float middleX = 0;
      float middleY = 0;
      for (int i = 0; i < n; i++) {
        middleX += part.vertexX(i) / n;
        middleY += part.vertexY(i) / n;
      }
      act(body, middleX, middleY, 0, 0, 2 * part.radius(), frame, factor);
    }
  }

  /**
   * Adds the force on an edge, or on what is round.
   *
   * @param localX its middle, in the body's frame
   * @param localY its middle, in the body's frame
   * @param nx its normal, world axes; zero for what is round and faces any wind
   * @param ny its normal
   * @param length m
   */
  private void act(
      Body<?> body,
      float localX,
      float localY,
      float nx,
      float ny,
      float length,
      Transform frame,
      float factor) {
    float placeX = body.x() + (body.cos() * localX - body.sin() * localY);
    float placeY = body.y() + (body.sin() * localX + body.cos() * localY);
    if (!area.contains(frame.localX(placeX, placeY), frame.localY(placeX, placeY))) {
      return;
    }
    float leverX = placeX - body.centerX();
    float leverY = placeY - body.centerY();
    float ux = frame.rotateX(x, y) - (body.velocityX() - body.angularVelocity() * leverY);
    float uy = frame.rotateY(x, y) - (body.velocityY() + body.angularVelocity() * leverX);
    float speed = (float) Math.sqrt(ux * ux + uy * uy);
    boolean round = nx == 0 && ny == 0;
    float facing = round ? speed : -(ux * nx + uy * ny);
    if (!(facing > 0)) {
      return;
    }
    float seen = factor * length * facing;
    float lifting = round ? 0 : lift;
    float inverse = inverseMass + (leverX * leverX + leverY * leverY) * inverseInertia;
    stiffness += seen * (drag + lifting) * inverse;
    float s = facing / speed;
    float fx = seen * (drag * ux - lifting * (speed * nx + s * ux));
    float fy = seen * (drag * uy - lifting * (speed * ny + s * uy));
    forceX += fx;
    forceY += fy;
    torque += leverX * fy - leverY * fx;
  }

  @Override
  public void reach(Transform frame, Aabb out) {
    Areas.reach(area, frame, out);
  }

  /**
   * Wakes the bodies that sleep in the area. Call it after a wind was added, removed or changed.
   *
   * @param world the world
   */
  public void wake(World<?> world) {
    Areas.wake(nearby, world, area);
  }
}
