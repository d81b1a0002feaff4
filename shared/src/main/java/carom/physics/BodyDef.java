package carom.physics;

import carom.physics.geometry.MassData;
import carom.physics.geometry.Shape;
import carom.physics.math.Limits;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * What a body is made from; mutable, fluent, reusable. The world copies what it needs.
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
  boolean fixedRotation;
  boolean bullet;
  boolean sleepAllowed = true;
  boolean awake = true;
  MassData mass;
  final List<ShapeDef> shapes = new ArrayList<>();

  /** A static body at the origin, without shapes. */
  public BodyDef() {
    this(BodyType.STATIC);
  }

  /**
   * A body at the origin, without shapes.
   *
   * @param type what may move it
   */
  public BodyDef(BodyType type) {
    this.type = type;
  }

  /**
   * Sets the type; default static.
   *
   * @param newType what may move it
   * @return this
   */
  public BodyDef type(BodyType newType) {
    type = newType;
    return this;
  }

  /**
   * What kind of body this makes.
   *
   * @return static unless set
   */
  public BodyType type() {
    return type;
  }

  /**
   * The shapes so far.
   *
   * @return in the order they were added, unmodifiable, live
   */
  public List<ShapeDef> shapes() {
    return Collections.unmodifiableList(shapes);
  }

  /**
   * Sets where the body's origin is; default (0, 0).
   *
   * @param newX m, within 1e7 of the world's origin
   * @param newY m
   * @return this
   */
  public BodyDef position(float newX, float newY) {
    x = Limits.coordinate("x", newX);
    y = Limits.coordinate("y", newY);
    return this;
  }

  /**
   * Sets the rotation about the body's origin; default 0.
   *
   * @param angleRad rad, counter-clockwise
   * @return this
   */
  public BodyDef angle(float angleRad) {
    angle = Limits.range("angle", angleRad, -1e5f, 1e5f);
    return this;
  }

  /**
   * Sets the velocity of the centre of mass; default (0, 0).
   *
   * @param newVx m/s, within 1e5
   * @param newVy m/s
   * @return this
   */
  public BodyDef velocity(float newVx, float newVy) {
    vx = Limits.velocity("velocityX", newVx);
    vy = Limits.velocity("velocityY", newVy);
    return this;
  }

  /**
   * Sets the angular velocity; default 0.
   *
   * @param radPerSecond rad/s, counter-clockwise, within 1e5
   * @return this
   */
  public BodyDef angularVelocity(float radPerSecond) {
    angularVelocity = Limits.velocity("angularVelocity", radPerSecond);
    return this;
  }

  /**
   * Sets what a dynamic body weighs, instead of what its shapes and densities say.
   *
   * @param kilograms 1e-9 to 1e15
   * @param inertia moment of inertia about the centre of mass, kg m^2, 1e-20 to 1e20; 0 for a body
   *     that no force turns
   * @param centerX centre of mass in the body frame, m
   * @param centerY centre of mass in the body frame, m
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
    Limits.coordinate("centerX", centerX);
    Limits.coordinate("centerY", centerY);
    return new MassData(kilograms, centerX, centerY, inertia);
  }

  /**
   * Sets whether no force turns the body; default false.
   *
   * @param fixed true for players that stay upright
   * @return this
   */
  public BodyDef fixedRotation(boolean fixed) {
    fixedRotation = fixed;
    return this;
  }

  /**
   * Sets whether the body is a bullet; default false. Every dynamic body that is fast for its size
   * is stopped at static and kinematic bodies; a bullet at dynamic ones and other bullets, too,
   * which costs more. For shots and small fast balls, not for everything.
   *
   * @param isBullet true for what must hit all that is in its way
   * @return this
   */
  public BodyDef bullet(boolean isBullet) {
    bullet = isBullet;
    return this;
  }

  /**
   * Sets the rate at which velocity decays; default 0.
   *
   * @param perSecond 1/s, 0 to 1e4; v falls to v / (1 + h c) in a substep h
   * @return this
   */
  public BodyDef linearDamping(float perSecond) {
    linearDamping = Limits.range("linearDamping", perSecond, 0, Limits.MAX_DAMPING);
    return this;
  }

  /**
   * Sets the rate at which angular velocity decays; default 0.
   *
   * @param perSecond 1/s, 0 to 1e4
   * @return this
   */
  public BodyDef angularDamping(float perSecond) {
    angularDamping = Limits.range("angularDamping", perSecond, 0, Limits.MAX_DAMPING);
    return this;
  }

  /**
   * Sets the factor on the world's gravity; default 1.
   *
   * @param factor 0 floats, negative rises; within 1e3
   * @return this
   */
  public BodyDef gravityScale(float factor) {
    gravityScale =
        Limits.range("gravityScale", factor, -Limits.MAX_GRAVITY_SCALE, Limits.MAX_GRAVITY_SCALE);
    return this;
  }

  /**
   * Sets whether the body may fall asleep; default true. One that may not keeps awake all it rests
   * on or leans against.
   *
   * @param allowed false for what must react in every tick
   * @return this
   */
  public BodyDef sleepAllowed(boolean allowed) {
    sleepAllowed = allowed;
    return this;
  }

  /**
   * Sets whether the body starts awake; default true. One that starts asleep is at rest, costs
   * nothing and has no contacts until something awake touches it: for large levels, whose static
   * bodies should be made first. It starts awake in spite of this if it may not sleep.
   *
   * @param startAwake false to start asleep
   * @return this
   */
  public BodyDef awake(boolean startAwake) {
    awake = startAwake;
    return this;
  }

  /**
   * Adds a shape; several make a compound body.
   *
   * @param shape in the body frame
   * @param material what it is made of
   * @return this
   */
  public BodyDef shape(Shape shape, Material material) {
    return shape(new ShapeDef(shape, material));
  }

  /**
   * Adds a shape that meets only some others.
   *
   * @param shape in the body frame
   * @param material what it is made of
   * @param filter whom it meets
   * @return this
   */
  public BodyDef shape(Shape shape, Material material, Filter filter) {
    return shape(new ShapeDef(shape, material, filter, false));
  }

  /**
   * Adds a shape, for instance a sensor.
   *
   * @param shapeDef the shape and what belongs to it
   * @return this
   */
  public BodyDef shape(ShapeDef shapeDef) {
    shapes.add(shapeDef);
    return this;
  }

  /**
   * Adds a shape of {@link Material#DEFAULT}.
   *
   * @param shape in the body frame
   * @return this
   */
  public BodyDef shape(Shape shape) {
    return shape(shape, Material.DEFAULT);
  }
}
