package carom.physics;

import carom.physics.math.Limits;

/**
 * What a shape is made of. Two touching shapes mix: friction is {@code sqrt(f1 f2)}, restitution is
 * {@code max(r1, r2)}, rolling resistance is {@code max(c1, c2)}, tangent speeds act both.
 *
 * @param density mass per area, kg/m^2, 0 to 1e9; only used by dynamic bodies
 * @param friction Coulomb coefficient, 0 (ice) to 100; 0.6 is wood on wood
 * @param restitution speed after a bounce by the speed before, 0 (clay) to 1 (no loss); up to 2 for
 *     bumpers that add energy
 * @param rollingResistance torque against rolling, by load and the larger radius of the two shapes,
 *     0 to 10; a disc stays on slopes up to {@code tan(angle) = c}, and on the flat loses {@code
 *     2/3 c g} of its speed per second. Nothing for shapes without a radius
 * @param tangentSpeed speed of the surface along itself, m/s, -1e5 to 1e5: a conveyor belt.
 *     Positive runs clockwise around the shape, so that its upper side runs to the right
 * @param tag a number with a meaning of the user's own, such as a sound; the engine ignores it
 */
public record Material(
    float density,
    float friction,
    float restitution,
    float rollingResistance,
    float tangentSpeed,
    int tag) {
  /** Density 1, friction 0.6, restitution 0: a wooden toy. */
  public static final Material DEFAULT = new Material(1, 0.6f, 0);

  /**
   * Checks the ranges.
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
   * A material that rolls freely and whose surface is at rest, with tag 0.
   *
   * @param density kg/m^2
   * @param friction Coulomb coefficient
   * @param restitution 0 to 2
   */
  public Material(float density, float friction, float restitution) {
    this(density, friction, restitution, 0, 0, 0);
  }

  /**
   * The same with another density.
   *
   * @param newDensity kg/m^2
   * @return a changed copy
   */
  public Material withDensity(float newDensity) {
    return new Material(newDensity, friction, restitution, rollingResistance, tangentSpeed, tag);
  }

  /**
   * The same with another friction.
   *
   * @param newFriction Coulomb coefficient
   * @return a changed copy
   */
  public Material withFriction(float newFriction) {
    return new Material(density, newFriction, restitution, rollingResistance, tangentSpeed, tag);
  }

  /**
   * The same with another restitution.
   *
   * @param newRestitution 0 to 2
   * @return a changed copy
   */
  public Material withRestitution(float newRestitution) {
    return new Material(density, friction, newRestitution, rollingResistance, tangentSpeed, tag);
  }

  /**
   * The same with another rolling resistance.
   *
   * @param newRollingResistance 0 to 10
   * @return a changed copy
   */
  public Material withRollingResistance(float newRollingResistance) {
    return new Material(density, friction, restitution, newRollingResistance, tangentSpeed, tag);
  }

  /**
   * The same with another speed of the surface.
   *
   * @param newTangentSpeed m/s, positive runs clockwise around the shape
   * @return a changed copy
   */
  public Material withTangentSpeed(float newTangentSpeed) {
    return new Material(density, friction, restitution, rollingResistance, newTangentSpeed, tag);
  }

  /**
   * The same with another tag.
   *
   * @param newTag the user's own number
   * @return a changed copy
   */
  public Material withTag(int newTag) {
    return new Material(density, friction, restitution, rollingResistance, tangentSpeed, newTag);
  }
}
