package carom.physics;

import carom.physics.math.Limits;
import carom.physics.settings.MixingRule;

/**
 * The surface and density of a shape. The materials of two touching shapes are mixed. Friction and
 * restitution are mixed by a {@link MixingRule}: friction is {@code sqrt(f1 f2)} and restitution
 * {@code max(r1, r2)} unless the world or a material says otherwise. Rolling resistance is {@code
 * max(c1, c2)}, and both tangent speeds act. A {@link CollisionListener} may set other values for a
 * contact.
 *
 * @param density mass per area, kg/m^2, 0..1e9; only used by dynamic bodies
 * @param friction Coulomb coefficient, 0..100; 0 is ice, 0.6 is wood on wood
 * @param restitution ratio of the speed after a bounce to the speed before, 0..2; 0 is clay, 1
 *     loses nothing, more suits bumpers that add energy
 * @param rollingResistance torque against rolling, divided by the load and the larger radius of the
 *     two shapes, 0..10; a disc stays on slopes up to {@code tan(angle) = c}, and on the flat loses
 *     {@code 2/3 c g} of its speed per second. It has no effect on shapes without a radius
 * @param tangentSpeed speed of the surface along itself, m/s, -1e5..1e5, as of a conveyor belt. A
 *     positive speed runs clockwise around the shape, so its upper side runs to the right
 * @param tag a number for the using program, such as a sound; the engine ignores it
 * @param frictionMixing how friction is mixed with that of another shape; null (the default) for
 *     the world's rule
 * @param restitutionMixing how restitution is mixed with that of another shape; null (the default)
 *     for the world's rule
 */
public record Material(
    float density,
    float friction,
    float restitution,
    float rollingResistance,
    float tangentSpeed,
    int tag,
    MixingRule frictionMixing,
    MixingRule restitutionMixing) {
  /** The default material, like a wooden toy: density 1, friction 0.6, restitution 0. */
  public static final Material DEFAULT = new Material(1, 0.6f, 0);

  /**
   * Makes a material and checks the ranges.
   *
   * @throws IllegalArgumentException naming the value that is not finite or out of range
   */
  public Material {
    Limits.range("density", density, 0, 1e9f);
    Limits.range("friction", friction, 0, 100);
    Limits.range("restitution", restitution, 0, 2);
    Limits.range("rollingResistance", rollingResistance, 0, 10);
    Limits.velocity("tangentSpeed", tangentSpeed);
  }

  /**
   * Makes a material that is mixed by the world's rules.
   *
   * @param density kg/m^2
   * @param friction Coulomb coefficient
   * @param restitution 0 to 2
   * @param rollingResistance 0 to 10
   * @param tangentSpeed m/s, positive runs clockwise around the shape
   * @param tag number for the using program
   */
  public Material(
      float density,
      float friction,
      float restitution,
      float rollingResistance,
      float tangentSpeed,
      int tag) {
    this(density, friction, restitution, rollingResistance, tangentSpeed, tag, null, null);
  }

  /**
   * Makes a material with no rolling resistance, no tangent speed and tag 0.
   *
   * @param density kg/m^2
   * @param friction Coulomb coefficient
   * @param restitution 0 to 2
   */
  public Material(float density, float friction, float restitution) {
    this(density, friction, restitution, 0, 0, 0);
  }

  /**
   * Returns a copy with another density.
   *
   * @param newDensity kg/m^2
   * @return a changed copy
   */
  public Material withDensity(float newDensity) {
    return new Material(
        newDensity,
        friction,
        restitution,
        rollingResistance,
        tangentSpeed,
        tag,
        frictionMixing,
        restitutionMixing);
  }

  /**
   * Returns a copy with another friction.
   *
   * @param newFriction Coulomb coefficient
   * @return a changed copy
   */
  public Material withFriction(float newFriction) {
    return new Material(
        density,
        newFriction,
        restitution,
        rollingResistance,
        tangentSpeed,
        tag,
        frictionMixing,
        restitutionMixing);
  }

  /**
   * Returns a copy with another restitution.
   *
   * @param newRestitution 0 to 2
   * @return a changed copy
   */
  public Material withRestitution(float newRestitution) {
    return new Material(
        density,
        friction,
        newRestitution,
        rollingResistance,
        tangentSpeed,
        tag,
        frictionMixing,
        restitutionMixing);
  }

  /**
   * Returns a copy with another rolling resistance.
   *
   * @param newRollingResistance 0 to 10
   * @return a changed copy
   */
  public Material withRollingResistance(float newRollingResistance) {
    return new Material(
        density,
        friction,
        restitution,
        newRollingResistance,
        tangentSpeed,
        tag,
        frictionMixing,
        restitutionMixing);
  }

  /**
   * Returns a copy with another tangent speed.
   *
   * @param newTangentSpeed m/s, positive runs clockwise around the shape
   * @return a changed copy
   */
  public Material withTangentSpeed(float newTangentSpeed) {
    return new Material(
        density,
        friction,
        restitution,
        rollingResistance,
        newTangentSpeed,
        tag,
        frictionMixing,
        restitutionMixing);
  }

  /**
   * Returns a copy with another tag.
   *
   * @param newTag number for the using program
   * @return a changed copy
   */
  public Material withTag(int newTag) {
    return new Material(
        density,
        friction,
        restitution,
        rollingResistance,
        tangentSpeed,
        newTag,
        frictionMixing,
        restitutionMixing);
  }

  /**
   * Returns a copy whose friction is mixed by a rule of its own.
   *
   * @param rule goes before the world's; null for the world's
   * @return a changed copy
   */
  public Material withFrictionMixing(MixingRule rule) {
    return new Material(
        density,
        friction,
        restitution,
        rollingResistance,
        tangentSpeed,
        tag,
        rule,
        restitutionMixing);
  }

  /**
   * Returns a copy whose restitution is mixed by a rule of its own.
   *
   * @param rule goes before the world's; null for the world's
   * @return a changed copy
   */
  public Material withRestitutionMixing(MixingRule rule) {
    return new Material(
        density, friction, restitution, rollingResistance, tangentSpeed, tag, frictionMixing, rule);
  }
}
