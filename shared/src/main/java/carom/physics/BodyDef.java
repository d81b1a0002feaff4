package carom.physics;

import carom.physics.dynamics.body.BodyMaker;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.geometry.MassData;
import carom.physics.geometry.Shape;
import carom.physics.math.Limits;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * The definition of a body. It is mutable, fluent and reusable; {@link World#createBody} copies
 * what it needs.
 *
 * <pre>
 *   new BodyDef(BodyType.DYNAMIC).position(0, 5).shape(new Circle(0.5f), Material.DEFAULT)
 * </pre>
 */
public final class BodyDef {
  BodyType type;
  float x;
  float y;
  float angle;
  float vx;
  float vy;
  float angularVelocity;
  float linearDamping;
  float angularDamping;
  float gravityScale = 1;
  MotionLocks locks = MotionLocks.NONE;
  boolean bullet;
  boolean sleepAllowed = true;
  float sleepSpeed = BodyStore.WORLDS;
  boolean awake = true;
  MassData mass;
  final List<ShapeDef> shapes = new ArrayList<>();

  /** Makes the definition of a static body at the world's origin, without shapes. */
  public BodyDef() {
    this(BodyType.STATIC);
  }

  /**
   * Makes the definition of a body at the world's origin, without shapes.
   *
   * @param type static, kinematic or dynamic
   */
  public BodyDef(BodyType type) {
    this.type = Limits.notNull("type", type);
  }

  /**
   * Sets the body's type. The default is static.
   *
   * @param newType static, kinematic or dynamic
   * @return this
   */
  public BodyDef type(BodyType newType) {
    type = Limits.notNull("newType", newType);
    return this;
  }

  /**
   * Returns the body's type.
   *
   * @return static unless set
   */
  public BodyType type() {
    return type;
  }

  /**
   * Returns the shapes that were added so far.
   *
   * @return an unmodifiable live list, in the order in which the shapes were added
   */
  public List<ShapeDef> shapes() {
    return Collections.unmodifiableList(shapes);
  }

  /**
   * Sets the position of the body's origin. The default is (0, 0).
   *
   * @param newX m, world, within 32,768
   * @param newY m, world, within 32,768
   * @return this
   */
  public BodyDef position(float newX, float newY) {
    Limits.position("x", newX);
    Limits.position("y", newY);
    x = newX;
    y = newY;
    return this;
  }

  /**
   * Sets the rotation about the body's origin. The default is 0.
   *
   * @param angleRad rad, counter-clockwise, within 1e5
   * @return this
   */
  public BodyDef angle(float angleRad) {
    angle = Limits.range("angle", angleRad, -1e5f, 1e5f);
    return this;
  }

  /**
   * Sets the velocity of the centre of mass. The default is (0, 0).
   *
   * @param newVx x component, m/s, within 1e5
   * @param newVy y component, m/s, within 1e5
   * @return this
   */
  public BodyDef velocity(float newVx, float newVy) {
    Limits.velocity("velocityX", newVx);
    Limits.velocity("velocityY", newVy);
    vx = newVx;
    vy = newVy;
    return this;
  }

  /**
   * Sets the angular velocity. The default is 0.
   *
   * @param radPerSecond rad/s, counter-clockwise, within 1e5
   * @return this
   */
  public BodyDef angularVelocity(float radPerSecond) {
    angularVelocity = Limits.velocity("angularVelocity", radPerSecond);
    return this;
  }

  /**
   * Sets the mass that the body has while it is dynamic. By default it is computed from shapes and
   * densities.
   *
   * @param kilograms mass, kg, 1e-9..1e15
   * @param inertia moment of inertia about the centre of mass, kg m^2, 1e-20..1e20; 0 for a body
   *     that no force turns
   * @param centerX x of the centre of mass in the body frame, m
   * @param centerY y of the centre of mass in the body frame, m
   * @return this
   */
  public BodyDef mass(float kilograms, float inertia, float centerX, float centerY) {
    mass = checkedMass(kilograms, inertia, centerX, centerY);
    return this;
  }

  static MassData checkedMass(float kilograms, float inertia, float centerX, float centerY) {
    Limits.range("mass", kilograms, 1e-9f, 1e15f);
    if (inertia != 0) {
      Limits.range("inertia", inertia, 1e-20f, 1e20f);
    }
    BodyMaker.checkCenter(centerX, centerY);
    return new MassData(kilograms, centerX, centerY, inertia);
  }

  /**
   * Sets whether the rotation is fixed, so that no force turns the body. The default is false. It
   * is the short form of the third of the {@link #motionLocks}.
   *
   * @param fixed true for players that stay upright, for instance
   * @return this
   */
  public BodyDef fixedRotation(boolean fixed) {
    locks = locks.withAngularZ(fixed);
    return this;
  }

  /**
   * Sets the axes along which no force, contact or joint moves the body. By default there are none.
   *
   * @param motionLocks the locks, the rotation's included
   * @return this
   */
  public BodyDef motionLocks(MotionLocks motionLocks) {
    locks = Limits.notNull("motionLocks", motionLocks);
    return this;
  }

  /**
   * Sets whether the body is a bullet. The default is false. Continuous collision stops every
   * dynamic body that is fast for its size at static and kinematic bodies. It stops a bullet at
   * dynamic bodies and other bullets, too, which costs more. Use it for shots and small fast balls,
   * not for everything.
   *
   * @param isBullet true for a body that must not pass through any other
   * @return this
   */
  public BodyDef bullet(boolean isBullet) {
    bullet = isBullet;
    return this;
  }

  /**
   * Sets the rate at which velocity decays. The default is 0.
   *
   * @param perSecond 1/s, 0..1e4; v falls to v / (1 + h c) in a substep h
   * @return this
   */
  public BodyDef linearDamping(float perSecond) {
    linearDamping = Limits.range("linearDamping", perSecond, 0, Limits.MAX_DAMPING);
    return this;
  }

  /**
   * Sets the rate at which angular velocity decays. The default is 0.
   *
   * @param perSecond 1/s, 0..1e4
   * @return this
   */
  public BodyDef angularDamping(float perSecond) {
    angularDamping = Limits.range("angularDamping", perSecond, 0, Limits.MAX_DAMPING);
    return this;
  }

  /**
   * Sets the factor on the world's gravity. The default is 1.
   *
   * @param factor -1e3..1e3; with 0 the body floats, with a negative factor it rises
   * @return this
   */
  public BodyDef gravityScale(float factor) {
    gravityScale =
        Limits.range("gravityScale", factor, -Limits.MAX_GRAVITY_SCALE, Limits.MAX_GRAVITY_SCALE);
    return this;
  }

  /**
   * Sets whether the body may fall asleep. The default is true. A body that may not sleep keeps
   * awake all that it touches.
   *
   * @param allowed false for a body that must react in every tick
   * @return this
   */
  public BodyDef sleepAllowed(boolean allowed) {
    sleepAllowed = allowed;
    return this;
  }

  /**
   * Sets the speed below which the body is at rest, instead of {@link WorldDef#sleepSpeed}. No
   * point of the body may be faster. An island sleeps when all its bodies are at rest, each by its
   * own speed. Kinematic bodies are at rest at 0 only.
   *
   * @param speed m/s, 0..1000; 0 lets the body sleep only when it is perfectly still
   * @return this
   */
  public BodyDef sleepSpeed(float speed) {
    sleepSpeed = Limits.range("sleepSpeed", speed, 0, Limits.MAX_SLEEP_SPEED);
    return this;
  }

  /**
   * Sets whether the body starts awake. The default is true. A body that starts asleep is at rest,
   * costs nothing and has no contacts until something awake touches it. Use it for large levels,
   * and create their static and kinematic bodies first, which wake what sleeps where they appear. A
   * body that may not sleep starts awake in any case.
   *
   * @param startAwake false to start asleep
   * @return this
   */
  public BodyDef awake(boolean startAwake) {
    awake = startAwake;
    return this;
  }

  /**
   * Adds a shape of a material. Several shapes make a compound body.
   *
   * @param shape the shape, in the body frame
   * @param material its material
   * @return this
   */
  public BodyDef shape(Shape shape, Material material) {
    return shape(new ShapeDef(shape, material));
  }

  /**
   * Adds a shape with a filter, which collides only with some other shapes.
   *
   * @param shape the shape, in the body frame
   * @param material its material
   * @param filter its filter, which says what it collides with
   * @return this
   */
  public BodyDef shape(Shape shape, Material material, Filter filter) {
    return shape(new ShapeDef(shape, material, filter, false));
  }

  /**
   * Adds a shape by its definition, for instance a sensor.
   *
   * @param shapeDef the shape with its material and filter
   * @return this
   */
  public BodyDef shape(ShapeDef shapeDef) {
    shapes.add(Limits.notNull("shapeDef", shapeDef));
    return this;
  }

  /**
   * Adds a shape of {@link Material#DEFAULT}.
   *
   * @param shape the shape, in the body frame
   * @return this
   */
  public BodyDef shape(Shape shape) {
    return shape(shape, Material.DEFAULT);
  }
}
