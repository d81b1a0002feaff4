package carom.physics;

import carom.physics.dynamics.Checks;

/**
 * What a shape is made of. Two touching shapes mix: friction is {@code sqrt(f1 f2)}, restitution is
 * {@code max(r1, r2)}.
 *
 * @param density mass per area, kg/m^2, 0 to 1e9; only used by dynamic bodies
 * @param friction Coulomb coefficient, 0 (ice) to 100; 0.6 is wood on wood
 * @param restitution speed after a bounce by the speed before, 0 (clay) to 1 (no loss); up to 2 for
 *     bumpers that add energy
 */
public record Material(float density, float friction, float restitution) {
  /** Density 1, friction 0.6, restitution 0: a wooden toy. */
  public static final Material DEFAULT = new Material(1, 0.6f, 0);

  /**
   * Checks the ranges.
   *
   * @throws IllegalArgumentException naming the value that is not finite or out of range
   */
  public Material {
    Checks.range("density", density, 0, 1e9f);
    Checks.range("friction", friction, 0, 100);
    Checks.range("restitution", restitution, 0, 2);
  }

  /**
   * The same with another density.
   *
   * @param newDensity kg/m^2
   * @return a changed copy
   */
  public Material withDensity(float newDensity) {
    return new Material(newDensity, friction, restitution);
  }

  /**
   * The same with another friction.
   *
   * @param newFriction Coulomb coefficient
   * @return a changed copy
   */
  public Material withFriction(float newFriction) {
    return new Material(density, newFriction, restitution);
  }

  /**
   * The same with another restitution.
   *
   * @param newRestitution 0 to 2
   * @return a changed copy
   */
  public Material withRestitution(float newRestitution) {
    return new Material(density, friction, newRestitution);
  }
}
