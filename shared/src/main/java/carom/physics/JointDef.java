package carom.physics;

import carom.physics.dynamics.joint.JointStore;
import carom.physics.math.Limits;
import carom.physics.math.Trig;

/**
 * The definition of a joint. It is mutable and fluent; the static methods make one for each type of
 * joint.
 *
 * <p>Anchors and axes are given in world coordinates. {@link World#createJoint} fixes them to the
 * bodies in their poses at that moment; angles and translations count from there. Body A may be
 * null, except in gears, racks and pulleys; the world then takes its place. Except for pulleys, the
 * two bodies don't collide with each other unless {@link #collideConnected} says so.
 *
 * <pre>
 *   world.createJoint(JointDef.revolute(car, flap, 2, 1).limits(-0.5f, 0.5f).motor(1, 20))
 * </pre>
 *
 * @param <T> the user's type of {@link Body#user()}
 */
public final class JointDef<T> {
  private static final float MAX_LENGTH = 1e6f;

  /** Largest angle of a revolute joint, rad. A float resolves a thousandth of a radian there. */
  private static final float MAX_ANGLE = 1e4f;

  final JointType type;
  Body<T> bodyA;
  Body<T> bodyB;
  float ax;
  float ay;
  float bx;
  float by;
  float axisX = 1;
  float axisY;
  boolean collideConnected;
  boolean limited;
  boolean driven;
  boolean sprung;
  float ratio;
  float baseAx;
  float baseAy;
  float baseBx;
  float baseBy;
  float rest;
  boolean restGiven;
  float lower;
  float upper;
  float motorSpeed;
  float motorMax;
  float hertz;
  float damping;
  float angularHertz;
  float angularDamping;
  float maxForce;
  float maxTorque;
  float breakForce = Float.POSITIVE_INFINITY;
  float breakTorque = Float.POSITIVE_INFINITY;

  private JointDef(JointType type, Body<T> bodyA, Body<T> bodyB) {
    if (bodyB == null) {
      throw new IllegalArgumentException("bodyB=null; only bodyA may be null, for the world");
    }
    if (bodyA == bodyB) {
      throw new IllegalArgumentException("bodyA=bodyB=" + bodyB + "; a joint needs two bodies");
    }
    this.type = type;
    this.bodyA = bodyA;
    this.bodyB = bodyB;
  }

  /** Moves the definition to other bodies. */
  @SuppressWarnings("unchecked") // nothing but the bodies has to do with the user's type
  <U> JointDef<U> between(Body<U> a, Body<U> b) {
    JointDef<U> moved = (JointDef<U>) this;
    moved.bodyA = a;
    moved.bodyB = b;
    return moved;
  }

  private JointDef<T> anchors(float newAx, float newAy, float newBx, float newBy) {
    ax = Limits.coordinate("anchorAX", newAx);
    ay = Limits.coordinate("anchorAY", newAy);
    bx = Limits.coordinate("anchorBX", newBx);
    by = Limits.coordinate("anchorBY", newBy);
    return this;
  }

  private JointDef<T> axis(float x, float y) {
    float square = x * x + y * y;
    if (!(square >= 1e-12f && square <= 1e12f)) {
      throw new IllegalArgumentException(
          "axisX=" + x + " axisY=" + y + " is not a direction; give it a length near 1");
    }
    float length = (float) Math.sqrt(square);
    axisX = x / length;
    axisY = y / length;
    return this;
  }

  /**
   * Makes the definition of a revolute joint (a hinge), which holds the bodies together at a point.
   * {@link #limits}, {@link #motor} and {@link #spring} act on the angle of B relative to A, which
   * is 0 when the joint is created. The angle wraps from pi to -pi, unless {@link #limits} or
   * {@link #rest} ask for more than half a turn: then full turns are counted.
   *
   * @param bodyA the first body, or null for the world
   * @param bodyB the second body
   * @param x x of the point, m, world
   * @param y y of the point, m, world
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> revolute(Body<T> bodyA, Body<T> bodyB, float x, float y) {
    return new JointDef<>(JointType.REVOLUTE, bodyA, bodyB).anchors(x, y, x, y);
  }

  /**
   * Makes the definition of a distance joint, a rod that keeps two points at their distance. With
   * {@link #spring} it becomes a spring, with {@link #limits} it allows a range, and with {@link
   * #motor} it pushes and pulls along the line of its points; all together are a driven spring with
   * stops.
   *
   * @param bodyA the first body, or null for the world
   * @param bodyB the second body
   * @param ax x of the point of A, m, world
   * @param ay y of the point of A, m, world
   * @param bx x of the point of B, m, world
   * @param by y of the point of B, m, world
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> distance(
      Body<T> bodyA, Body<T> bodyB, float ax, float ay, float bx, float by) {
    return new JointDef<>(JointType.DISTANCE, bodyA, bodyB).anchors(ax, ay, bx, by);
  }

  /**
   * Makes the definition of a rope: a distance joint whose points may be closer than its length,
   * but not farther apart.
   *
   * @param bodyA the first body, or null for the world
   * @param bodyB the second body
   * @param ax x of the point of A, m, world
   * @param ay y of the point of A, m, world
   * @param bx x of the point of B, m, world
   * @param by y of the point of B, m, world
   * @param length length of the rope, m, 0..1e6
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> rope(
      Body<T> bodyA, Body<T> bodyB, float ax, float ay, float bx, float by, float length) {
    return distance(bodyA, bodyB, ax, ay, bx, by).limits(0, length);
  }

  /**
   * Makes the definition of a prismatic joint (a slider). {@link #limits}, {@link #motor} and
   * {@link #spring} act on the translation of B along the axis, which is 0 when the joint is
   * created.
   *
   * @param bodyA the first body, or null for the world; the axis turns with it
   * @param bodyB the body that slides
   * @param x x of a point on the axis, m, world
   * @param y y of a point on the axis, m, world
   * @param axisX x of the direction, world; its length is 1e-6..1e6
   * @param axisY y of the direction, world
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> prismatic(
      Body<T> bodyA, Body<T> bodyB, float x, float y, float axisX, float axisY) {
    return new JointDef<>(JointType.PRISMATIC, bodyA, bodyB).anchors(x, y, x, y).axis(axisX, axisY);
  }

  /**
   * Makes the definition of a weld, which glues two bodies together. {@link #spring} makes the
   * point soft, {@link #angularSpring} the angle.
   *
   * @param bodyA the first body, or null for the world
   * @param bodyB the second body
   * @param x x of the point of the weld, m, world
   * @param y y of the point of the weld, m, world
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> weld(Body<T> bodyA, Body<T> bodyB, float x, float y) {
    return new JointDef<>(JointType.WELD, bodyA, bodyB).anchors(x, y, x, y);
  }

  /**
   * Makes the definition of a wheel with suspension: B slides along an axis of A and turns freely.
   * {@link #spring} and {@link #limits} act on the translation, which is 0 when the joint is
   * created; {@link #motor} acts on the rotation.
   *
   * @param bodyA the car, or null for the world; the axis turns with it
   * @param bodyB the wheel
   * @param x x of the wheel's axle, m, world
   * @param y y of the wheel's axle, m, world
   * @param axisX x of the suspension's direction, world; its length is 1e-6..1e6
   * @param axisY y of the suspension's direction, world
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> wheel(
      Body<T> bodyA, Body<T> bodyB, float x, float y, float axisX, float axisY) {
    return new JointDef<>(JointType.WHEEL, bodyA, bodyB).anchors(x, y, x, y).axis(axisX, axisY);
  }

  /**
   * Makes the definition of a groove: a point of B stays on a line between two points of A, and B
   * turns freely. It is a {@link #wheel} without suspension, whose {@link #limits} are the groove's
   * ends and whose coordinate is 0 where B is when the joint is created.
   *
   * @param bodyA the body with the groove, or null for the world; the groove turns with it
   * @param bodyB the body that slides
   * @param fromX x of one end of the groove, m, world
   * @param fromY y of one end of the groove, m, world
   * @param toX x of the other end, at least 1 mm away
   * @param toY y of the other end
   * @param x x of the point of B, m, world; a point beside the groove is drawn into it
   * @param y y of the point of B, m, world
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> groove(
      Body<T> bodyA,
      Body<T> bodyB,
      float fromX,
      float fromY,
      float toX,
      float toY,
      float x,
      float y) {
    float wayX = Limits.coordinate("toX", toX) - Limits.coordinate("fromX", fromX);
    float wayY = Limits.coordinate("toY", toY) - Limits.coordinate("fromY", fromY);
    float length = (float) Math.sqrt((double) wayX * wayX + (double) wayY * wayY);
    if (!(length >= 1e-3f)) {
      throw new IllegalArgumentException(
          "length=" + length + " of a groove is below 0.001; move its ends apart");
    }
    float ux = wayX / length;
    float uy = wayY / length;
    float along = Math.max(0, Math.min((x - fromX) * ux + (y - fromY) * uy, length));
    return wheel(bodyA, bodyB, x, y, ux, uy)
        .anchors(fromX + ux * along, fromY + uy * along, x, y)
        .limits(-along, length - along);
  }

  /**
   * Makes the definition of a ratchet: a {@link #revolute} joint that turns in one direction only.
   * It may turn back to the last tooth that it has passed. It counts full turns, can have a {@link
   * #motor} and a {@link #spring}, and has no {@link #limits}.
   *
   * @param bodyA the first body, or null for the world
   * @param bodyB the second body
   * @param x x of the point, m, world
   * @param y y of the point, m, world
   * @param tooth angle between teeth, rad, its size 0.001..100; positive if B turns freely
   *     counter-clockwise, negative if clockwise
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> ratchet(
      Body<T> bodyA, Body<T> bodyB, float x, float y, float tooth) {
    if (!(Math.abs(tooth) >= 0.001f && Math.abs(tooth) <= 100)) {
      throw new IllegalArgumentException("tooth=" + tooth + " rad; its size must be 0.001..100");
    }
    JointDef<T> d = revolute(bodyA, bodyB, x, y);
    d.ratio = tooth;
    return d;
  }

  /**
   * Makes the definition of a friction joint, which resists all motion of B relative to A, as drag
   * on a table seen from above does. It pulls B to no place.
   *
   * @param bodyA the body against which friction acts on B, or null for the world
   * @param bodyB the body that is slowed down
   * @param x x of the point of B at which the force acts, m, world
   * @param y y of that point, m, world
   * @param maxForce greatest force, N; of a body that rests on a table {@code mu m g}
   * @param maxTorque greatest torque, N m
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> friction(
      Body<T> bodyA, Body<T> bodyB, float x, float y, float maxForce, float maxTorque) {
    JointDef<T> d = new JointDef<>(JointType.MOTOR, bodyA, bodyB);
    d.maxForce = Limits.range("maxForce", maxForce, 0, Limits.MAX_FORCE);
    d.maxTorque = Limits.range("maxTorque", maxTorque, 0, Limits.MAX_FORCE);
    d.driven = true;
    return d.anchors(x, y, x, y).collideConnected(true);
  }

  /**
   * Makes the definition of a motor joint, which draws B to a pose relative to A with limited
   * force. The pose is at first the one B has when the joint is created; see {@link
   * Joint#setTarget}. The springs of the joint have 10 hertz and are critically damped unless
   * {@link #spring} and {@link #angularSpring} say otherwise.
   *
   * @param bodyA the first body, or null for the world
   * @param bodyB the body that is drawn
   * @param maxForce N, at the centre of mass of B
   * @param maxTorque N m
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> motor(
      Body<T> bodyA, Body<T> bodyB, float maxForce, float maxTorque) {
    JointDef<T> d = new JointDef<>(JointType.MOTOR, bodyA, bodyB);
    d.maxForce = Limits.range("maxForce", maxForce, 0, Limits.MAX_FORCE);
    d.maxTorque = Limits.range("maxTorque", maxTorque, 0, Limits.MAX_FORCE);
    float x = bodyB.centerX();
    float y = bodyB.centerY();
    return d.anchors(x, y, x, y).spring(10, 1).angularSpring(10, 1);
  }

  /**
   * Makes the definition of a mouse joint, which draws a point of a body to a target with limited
   * force. The target is at first that point itself; see {@link Joint#setTarget}. The spring of the
   * joint has 5 hertz and is critically damped unless {@link #spring} says otherwise.
   *
   * @param body the body that is dragged
   * @param x x of the point, m, world
   * @param y y of the point, m, world
   * @param maxForce N
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> mouse(Body<T> body, float x, float y, float maxForce) {
    JointDef<T> d = new JointDef<>(JointType.MOUSE, null, body);
    d.maxForce = Limits.range("maxForce", maxForce, 0, Limits.MAX_FORCE);
    return d.anchors(x, y, x, y).spring(5, 1).collideConnected(true);
  }

  /**
   * Makes the definition of a gear joint: B turns {@code ratio} times as far as A. Two wheels that
   * mesh have the ratio -radiusA / radiusB; a belt between them has the positive one. Each body
   * needs a revolute joint of its own that holds it. Full turns are counted, so nothing drifts.
   * {@link Joint#torque} is the torque on B; A feels -ratio times that.
   *
   * @param bodyA the first body, whose rotation is the reference
   * @param bodyB the second body
   * @param ratio turns of B per turn of A, its size 1e-4..1e4
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> gear(Body<T> bodyA, Body<T> bodyB, float ratio) {
    return coupled(JointType.GEAR, bodyA, bodyB, ratio);
  }

  /**
   * Makes the definition of a rack and pinion: B moves {@code ratio} metres along an axis per
   * radian that A turns. A wheel of radius r on top of a rack moves it by r along x; one below it
   * moves it by -r. A needs a revolute joint and B a prismatic joint that hold them.
   *
   * @param bodyA the pinion
   * @param bodyB the rack; the axis turns with it
   * @param axisX x of the direction, world; its length is 1e-6..1e6
   * @param axisY y of the direction, world
   * @param ratio m/rad, its size 1e-4..1e4
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> rack(
      Body<T> bodyA, Body<T> bodyB, float axisX, float axisY, float ratio) {
    JointDef<T> d = coupled(JointType.RACK, bodyA, bodyB, ratio);
    return d.anchors(bodyA.centerX(), bodyA.centerY(), bodyB.centerX(), bodyB.centerY())
        .axis(axisX, axisY);
  }

  /**
   * Makes the definition of a pulley: a rope from A up to a point of the world, over to another
   * one, and down to B. The sum {@code lengthA + ratio lengthB} stays as it is when the joint is
   * created; with a ratio of n, B hangs in n strands. Without limits the pulley also pushes, like a
   * rod. {@code limits(0, length)} makes it a rope, which only pulls, and {@link #spring} makes it
   * elastic. {@link Joint#forceX} is the force on B; A's rope pulls with 1 / ratio of it. The
   * bodies collide unless {@link #collideConnected} says otherwise.
   *
   * @param bodyA the first body
   * @param bodyB the second body
   * @param ax x of the point where the rope holds A, m, world
   * @param ay y of the point where the rope holds A, m, world
   * @param bx x of the point where the rope holds B, m, world
   * @param by y of the point where the rope holds B, m, world
   * @param groundAx x of the world point that the rope runs to from A, m
   * @param groundAy y of the world point that the rope runs to from A, m
   * @param groundBx x of the world point that the rope runs to from B, m
   * @param groundBy y of the world point that the rope runs to from B, m
   * @param ratio 1e-4..1e4
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> pulley(
      Body<T> bodyA,
      Body<T> bodyB,
      float ax,
      float ay,
      float bx,
      float by,
      float groundAx,
      float groundAy,
      float groundBx,
      float groundBy,
      float ratio) {
    Limits.range("ratio", ratio, 0, Limits.MAX_RATIO);
    JointDef<T> d = coupled(JointType.PULLEY, bodyA, bodyB, ratio).anchors(ax, ay, bx, by);
    d.baseAx = Limits.coordinate("groundAX", groundAx);
    d.baseAy = Limits.coordinate("groundAY", groundAy);
    d.baseBx = Limits.coordinate("groundBX", groundBx);
    d.baseBy = Limits.coordinate("groundBY", groundBy);
    return d.collideConnected(true);
  }

  private static <T> JointDef<T> coupled(
      JointType type, Body<T> bodyA, Body<T> bodyB, float ratio) {
    if (bodyA == null) {
      throw new IllegalArgumentException("bodyA=null; a joint of type=" + type + " needs two");
    }
    Limits.range("ratio", ratio, -Limits.MAX_RATIO, Limits.MAX_RATIO);
    if (Math.abs(ratio) < 1 / Limits.MAX_RATIO) {
      throw new IllegalArgumentException(
          "ratio=" + ratio + " couples nothing, its size must be at least " + 1 / Limits.MAX_RATIO);
    }
    JointDef<T> d = new JointDef<>(type, bodyA, bodyB);
    d.ratio = ratio;
    return d;
  }

  /**
   * Limits the coordinate of the joint. That is the angle of a revolute joint (rad, within 1e4;
   * beyond pi full turns are counted), the distance of a distance joint, the translation of a
   * prismatic or wheel joint, or the length of a pulley (m).
   *
   * @param newLower lower limit
   * @param newUpper upper limit, not below the lower one
   * @return this
   */
  public JointDef<T> limits(float newLower, float newUpper) {
    refuseUnless(hasLimits(type), "limits");
    if (type == JointType.REVOLUTE && ratio != 0) {
      throw new IllegalStateException("limits are not possible for a ratchet; use a revolute");
    }
    Limits.range("lower", newLower, least(type), most(type));
    Limits.range("upper", newUpper, newLower, most(type));
    lower = newLower;
    upper = newUpper;
    limited = true;
    return this;
  }

  /**
   * Adds a motor that drives the angle of a revolute joint, the distance of a distance joint, the
   * translation of a prismatic joint, or the rotation of a wheel. A distance joint with a motor is
   * no rod any more: without a spring or limits, the motor alone acts.
   *
   * @param speed target speed, m/s or rad/s
   * @param max largest force or torque of the motor, N or N m
   * @return this
   */
  public JointDef<T> motor(float speed, float max) {
    refuseUnless(hasMotor(type), "motor");
    Limits.velocity("speed", speed);
    Limits.range("max", max, 0, Limits.MAX_FORCE);
    motorSpeed = speed;
    motorMax = max;
    driven = true;
    return this;
  }

  /**
   * Puts a spring on the coordinate, or on the point of a weld, motor or mouse joint. Its stiffness
   * is {@code m (2 pi hertz)^2} with the effective mass m of the joint, so it swings with that
   * frequency whatever the masses of the bodies. Where that mass depends on the direction (a point,
   * a length, a wheel beside its centre), m is the mean of all directions.
   *
   * @param newHertz frequency, 1/s, 0..1000; beyond a twelfth of the substep rate the spring is
   *     damped additionally, and beyond a quarter it is as stiff as there
   * @param dampingRatio 0..100; 0 swings for ever, 1 just doesn't overshoot
   * @return this
   */
  public JointDef<T> spring(float newHertz, float dampingRatio) {
    refuseUnless(canSpring(type), "spring");
    Limits.range("hertz", newHertz, 0, Limits.MAX_HERTZ);
    Limits.range("dampingRatio", dampingRatio, 0, Limits.MAX_DAMPING_RATIO);
    hertz = newHertz;
    damping = dampingRatio;
    sprung = hasCoordinateSpring(type);
    return this;
  }

  /**
   * Puts a spring on the angle of a weld or motor joint.
   *
   * @param newHertz frequency, 1/s, 0..1000; 0 makes a weld rigid
   * @param dampingRatio 0..100; 0 swings for ever, 1 just doesn't overshoot
   * @return this
   */
  public JointDef<T> angularSpring(float newHertz, float dampingRatio) {
    refuseUnless(type == JointType.WELD || type == JointType.MOTOR, "angularSpring");
    Limits.range("hertz", newHertz, 0, Limits.MAX_HERTZ);
    Limits.range("dampingRatio", dampingRatio, 0, Limits.MAX_DAMPING_RATIO);
    angularHertz = newHertz;
    angularDamping = dampingRatio;
    return this;
  }

  /**
   * Sets the rest value of the coordinate: where the spring exerts no force, or the length of a
   * rod. The default is the value that the coordinate has when the joint is created.
   *
   * @param coordinate m or rad, see {@link JointType}
   * @return this
   */
  public JointDef<T> rest(float coordinate) {
    refuseUnless(hasLimits(type), "rest");
    rest = Limits.range("rest", coordinate, least(type), most(type));
    restGiven = true;
    return this;
  }

  /**
   * Sets the force and the torque above which the joint breaks. A joint that breaks is destroyed at
   * the end of the step, and the {@link JointListener} is called.
   *
   * @param force N, 0 or more; infinite by default
   * @param torque N m, 0 or more; infinite by default
   * @return this
   */
  public JointDef<T> breaksAt(float force, float torque) {
    Limits.range("force", force, 0, Float.POSITIVE_INFINITY);
    Limits.range("torque", torque, 0, Float.POSITIVE_INFINITY);
    breakForce = force;
    breakTorque = torque;
    return this;
  }

  /**
   * Sets whether the two bodies collide with each other. The default is false, except for pulley
   * and mouse joints.
   *
   * @param collide true if they do
   * @return this
   */
  public JointDef<T> collideConnected(boolean collide) {
    collideConnected = collide;
    return this;
  }

  /** Returns the flags of {@link JointStore} for this definition. */
  byte flags() {
    return (byte)
        ((collideConnected ? JointStore.COLLIDE : 0)
            | (limited ? JointStore.LIMITED : 0)
            | (driven ? JointStore.DRIVEN : 0)
            | (sprung ? JointStore.SPRUNG : 0)
            | (winds() ? JointStore.WINDS : 0));
  }

  private boolean winds() {
    return switch (type) {
      case GEAR, RACK -> true;
      case REVOLUTE -> ratio != 0 || windsAt(lower) || windsAt(upper) || windsBeyond(rest);
      default -> false;
    };
  }

  /** Returns whether a revolute joint must count full turns to reach an angle, rad. */
  /**
   * Returns whether turns are counted for a limit. That is so long before the angle of half a turn,
   * where a body that is pushed against its limit would come round to the other one.
   */
  static boolean windsAt(float limit) {
    return Math.abs(limit) > Trig.PI / 2;
  }

  static boolean windsBeyond(float angle) {
    return Math.abs(angle) > Trig.PI;
  }

  /** Returns the largest coordinate that limits and rest may have, m or rad. */
  static float most(JointType type) {
    return type == JointType.REVOLUTE ? MAX_ANGLE : MAX_LENGTH;
  }

  /** Returns the smallest coordinate that limits and rest may have, m or rad. */
  static float least(JointType type) {
    return type == JointType.DISTANCE || type == JointType.PULLEY ? 0 : -most(type);
  }

  static boolean hasLimits(JointType type) {
    return switch (type) {
      case REVOLUTE, DISTANCE, PRISMATIC, WHEEL, PULLEY -> true;
      case WELD, MOTOR, MOUSE, GEAR, RACK -> false;
    };
  }

  static boolean hasMotor(JointType type) {
    return switch (type) {
      case REVOLUTE, DISTANCE, PRISMATIC, WHEEL -> true;
      case WELD, MOTOR, MOUSE, GEAR, RACK, PULLEY -> false;
    };
  }

  static boolean canSpring(JointType type) {
    return type != JointType.GEAR && type != JointType.RACK;
  }

  /** Returns whether the spring is optional and acts on the coordinate, beside limits. */
  static boolean hasCoordinateSpring(JointType type) {
    return hasLimits(type);
  }

  private void refuseUnless(boolean possible, String what) {
    if (!possible) {
      throw new IllegalStateException(what + " is not possible for type=" + type);
    }
  }
}
