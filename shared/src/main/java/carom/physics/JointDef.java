package carom.physics;

import carom.physics.dynamics.joint.JointStore;
import carom.physics.math.Limits;
import carom.physics.math.Trig;

/**
 * What a joint is made from; mutable, fluent. Begin with one of the factories.
 *
 * <p>Anchors and axes are given in world coordinates and are fixed to the bodies where these are
 * when {@link World#createJoint} is called; angles and translations count from there. Body A may be
 * null: then the world takes its place. Unless {@link #collideConnected} says otherwise, the two
 * bodies don't collide with each other.
 *
 * <pre>
 *   world.createJoint(JointDef.revolute(car, flap, 2, 1).limits(-0.5f, 0.5f).motor(1, 20))
 * </pre>
 *
 * @param <T> the user's type of {@link Body#user()}
 */
public final class JointDef<T> {
  private static final float MAX_LENGTH = 1e6f;

  /** Largest angle of a hinge, rad; a float still tells a thousandth of a radian there. */
  private static final float MAX_ANGLE = 1e4f;

  final JointType type;
  final Body<T> bodyA;
  final Body<T> bodyB;
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
   * A hinge. {@link #limits}, {@link #motor} and {@link #spring} act on the angle of B relative to
   * A, 0 as it is now. It goes from -pi to pi and from there to -pi again, unless {@link #limits}
   * or {@link #rest} ask for more: then full turns are counted.
   *
   * @param bodyA a body, or null for the world
   * @param bodyB the other one
   * @param x the hinge, m, world
   * @param y the hinge, m, world
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> revolute(Body<T> bodyA, Body<T> bodyB, float x, float y) {
    return new JointDef<>(JointType.REVOLUTE, bodyA, bodyB).anchors(x, y, x, y);
  }

  /**
   * A rod that keeps two points at their distance. With {@link #spring} it becomes a spring, with
   * {@link #limits} a range; both together are a spring with stops.
   *
   * @param bodyA a body, or null for the world
   * @param bodyB the other one
   * @param ax point of A, m, world
   * @param ay point of A, m, world
   * @param bx point of B, m, world
   * @param by point of B, m, world
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> distance(
      Body<T> bodyA, Body<T> bodyB, float ax, float ay, float bx, float by) {
    return new JointDef<>(JointType.DISTANCE, bodyA, bodyB).anchors(ax, ay, bx, by);
  }

  /**
   * A rope: two points may come closer than its length, not further.
   *
   * @param bodyA a body, or null for the world
   * @param bodyB the other one
   * @param ax point of A, m, world
   * @param ay point of A, m, world
   * @param bx point of B, m, world
   * @param by point of B, m, world
   * @param length m
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> rope(
      Body<T> bodyA, Body<T> bodyB, float ax, float ay, float bx, float by, float length) {
    return distance(bodyA, bodyB, ax, ay, bx, by).limits(0, length);
  }

  /**
   * A slider. {@link #limits}, {@link #motor} and {@link #spring} act on the translation of B along
   * the axis, 0 as it is now.
   *
   * @param bodyA a body, or null for the world; the axis turns with it
   * @param bodyB the one that slides
   * @param x a point on the axis, m, world
   * @param y a point on the axis, m, world
   * @param axisX direction, world; any length
   * @param axisY direction, world
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> prismatic(
      Body<T> bodyA, Body<T> bodyB, float x, float y, float axisX, float axisY) {
    return new JointDef<>(JointType.PRISMATIC, bodyA, bodyB).anchors(x, y, x, y).axis(axisX, axisY);
  }

  /**
   * Glue. {@link #spring} makes the point soft, {@link #angularSpring} the angle.
   *
   * @param bodyA a body, or null for the world
   * @param bodyB the other one
   * @param x where they are glued, m, world
   * @param y where they are glued, m, world
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> weld(Body<T> bodyA, Body<T> bodyB, float x, float y) {
    return new JointDef<>(JointType.WELD, bodyA, bodyB).anchors(x, y, x, y);
  }

  /**
   * A wheel with suspension: B slides along an axis of A and turns freely. {@link #spring} and
   * {@link #limits} act on the translation, 0 as it is now; {@link #motor} on the rotation.
   *
   * @param bodyA the car, or null for the world; the axis turns with it
   * @param bodyB the wheel
   * @param x the wheel's axle, m, world
   * @param y the wheel's axle, m, world
   * @param axisX direction of the suspension, world; any length
   * @param axisY direction of the suspension, world
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> wheel(
      Body<T> bodyA, Body<T> bodyB, float x, float y, float axisX, float axisY) {
    return new JointDef<>(JointType.WHEEL, bodyA, bodyB).anchors(x, y, x, y).axis(axisX, axisY);
  }

  /**
   * Draws B to a pose relative to A, now its own, with limited force; see {@link Joint#setTarget}.
   * The springs that do it have 10 hertz and are critically damped unless {@link #spring} and
   * {@link #angularSpring} say otherwise.
   *
   * @param bodyA a body, or null for the world
   * @param bodyB the one that is drawn
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
   * Draws a point of a body to a point of the world, at first the same, with limited force; see
   * {@link Joint#setTarget}. The spring that does it has 5 hertz and is critically damped unless
   * {@link #spring} says otherwise.
   *
   * @param body what is dragged
   * @param x where it is held, m, world
   * @param y where it is held, m, world
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
   * Two gears: from now on B turns {@code ratio} times what A turns. Two wheels that mesh have the
   * ratio -radiusA / radiusB, a belt between them the positive one. Each needs a hinge of its own
   * that holds it. Full turns are counted, so nothing drifts. {@link Joint#torque} is that on B; A
   * feels -ratio times that.
   *
   * @param bodyA the one that counts
   * @param bodyB the other one
   * @param ratio within 1e4, not 0
   * @param <T> the user's type
   * @return a definition
   */
  public static <T> JointDef<T> gear(Body<T> bodyA, Body<T> bodyB, float ratio) {
    return coupled(JointType.GEAR, bodyA, bodyB, ratio);
  }

  /**
   * Rack and pinion: from now on B moves {@code ratio} metres along an axis per radian that A
   * turns. A wheel of radius r that runs on top of a rack moves it by r along x, one that runs
   * below it by -r. A needs a hinge and B a slider that hold them.
   *
   * @param bodyA the pinion
   * @param bodyB the rack; the axis turns with it
   * @param axisX direction, world; any length
   * @param axisY direction, world
   * @param ratio m/rad, within 1e4, not 0
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
   * A pulley: a rope from A up to a point of the world, over to another one, and down to B. The sum
   * {@code lengthA + ratio lengthB} stays as it is now; with a ratio of n, B hangs in n strands.
   * Without limits it is a rod that also pushes; {@code limits(0, length)} makes it a rope, which
   * only pulls, {@link #spring} makes it elastic. {@link Joint#forceX} is the force on B, A's rope
   * pulls with 1 / ratio of it. The bodies collide unless {@link #collideConnected} says otherwise.
   *
   * @param bodyA a body
   * @param bodyB the other one
   * @param ax where the rope holds A, m, world
   * @param ay where the rope holds A, m, world
   * @param bx where the rope holds B, m, world
   * @param by where the rope holds B, m, world
   * @param groundAx where A's rope goes, m, world
   * @param groundAy where A's rope goes, m, world
   * @param groundBx where B's rope goes, m, world
   * @param groundBy where B's rope goes, m, world
   * @param ratio more than 0, within 1e4
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
   * Limits the coordinate: the angle of a revolute joint (rad, within 1e4; beyond pi full turns are
   * counted), the distance of a distance joint, the translation of a prismatic or wheel joint, the
   * length of a pulley (m).
   *
   * @param newLower lower limit
   * @param newUpper upper limit, not below the lower one
   * @return this
   */
  public JointDef<T> limits(float newLower, float newUpper) {
    refuseUnless(hasLimits(type), "limits");
    lower = Limits.range("lower", newLower, least(type), most(type));
    upper = Limits.range("upper", newUpper, lower, most(type));
    limited = true;
    return this;
  }

  /**
   * Drives the speed of the coordinate: the angle of a revolute joint, the translation of a
   * prismatic joint, the rotation of a wheel.
   *
   * @param speed m/s or rad/s
   * @param max the most it gives for that, N or N m
   * @return this
   */
  public JointDef<T> motor(float speed, float max) {
    refuseUnless(hasMotor(type), "motor");
    motorSpeed = Limits.velocity("speed", speed);
    motorMax = Limits.range("max", max, 0, Limits.MAX_FORCE);
    driven = true;
    return this;
  }

  /**
   * Puts a spring on the coordinate, or on the point of a weld, motor or mouse joint. Its stiffness
   * is {@code m (2 pi hertz)^2} with the mass m that the joint feels, so that it swings with that
   * frequency whatever the bodies weigh.
   *
   * @param newHertz 1/s, 0 to 1000; beyond a twelfth of the substep rate it is damped additionally
   * @param dampingRatio 0 swings for ever, 1 just doesn't overshoot
   * @return this
   */
  public JointDef<T> spring(float newHertz, float dampingRatio) {
    refuseUnless(canSpring(type), "spring");
    hertz = Limits.range("hertz", newHertz, 0, Limits.MAX_HERTZ);
    damping = Limits.range("dampingRatio", dampingRatio, 0, Limits.MAX_DAMPING_RATIO);
    sprung = hasCoordinateSpring(type);
    return this;
  }

  /**
   * Puts a spring on the angle of a weld or motor joint.
   *
   * @param newHertz 1/s, 0 to 1000; 0 makes a weld rigid
   * @param dampingRatio 0 swings for ever, 1 just doesn't overshoot
   * @return this
   */
  public JointDef<T> angularSpring(float newHertz, float dampingRatio) {
    refuseUnless(type == JointType.WELD || type == JointType.MOTOR, "angularSpring");
    angularHertz = Limits.range("hertz", newHertz, 0, Limits.MAX_HERTZ);
    angularDamping = Limits.range("dampingRatio", dampingRatio, 0, Limits.MAX_DAMPING_RATIO);
    return this;
  }

  /**
   * Sets where the spring is at ease, and the length of a rod; default: as it is now.
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
   * Sets what the joint bears; beyond, it breaks: it is destroyed at the end of the step, and the
   * {@link JointListener} hears it.
   *
   * @param force N, 0 or more; infinite by default
   * @param torque N m, 0 or more; infinite by default
   * @return this
   */
  public JointDef<T> breaksAt(float force, float torque) {
    breakForce = Limits.range("force", force, 0, Float.POSITIVE_INFINITY);
    breakTorque = Limits.range("torque", torque, 0, Float.POSITIVE_INFINITY);
    return this;
  }

  /**
   * Sets whether the two bodies collide with each other; default false.
   *
   * @param collide true if they do
   * @return this
   */
  public JointDef<T> collideConnected(boolean collide) {
    collideConnected = collide;
    return this;
  }

  /** As {@link JointStore} keeps them. */
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
      case REVOLUTE -> windsBeyond(lower) || windsBeyond(upper) || windsBeyond(rest);
      default -> false;
    };
  }

  /** Whether a hinge must count turns to get to an angle. */
  static boolean windsBeyond(float angle) {
    return Math.abs(angle) > Trig.PI;
  }

  /** Largest coordinate that can be asked for. */
  static float most(JointType type) {
    return type == JointType.REVOLUTE ? MAX_ANGLE : MAX_LENGTH;
  }

  /** Smallest coordinate that can be asked for. */
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
      case REVOLUTE, PRISMATIC, WHEEL -> true;
      case DISTANCE, WELD, MOTOR, MOUSE, GEAR, RACK, PULLEY -> false;
    };
  }

  static boolean canSpring(JointType type) {
    return type != JointType.GEAR && type != JointType.RACK;
  }

  /** Whether the spring is one of several things on the coordinate that can be missing. */
  static boolean hasCoordinateSpring(JointType type) {
    return hasLimits(type);
  }

  private void refuseUnless(boolean possible, String what) {
    if (!possible) {
      throw new IllegalStateException(what + " is not possible for type=" + type);
    }
  }
}
