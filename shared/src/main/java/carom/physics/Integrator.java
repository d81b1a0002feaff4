package carom.physics;

/**
 * An integrator advances velocity v and position x by a substep h under the acceleration a.
 *
 * <p>Contacts and joints work with both integrators, but are made for the first.
 */
public enum Integrator {
  /**
   * {@code v' = v + h a, x' = x + h v'}: the position uses the new velocity. The energy of an
   * oscillator of angular frequency w swings about its true value for ever, as long as {@code h w <
   * 2}.
   */
  SYMPLECTIC_EULER,

  /**
   * {@code x' = x + h v, v' = v + h a}: the position uses the old velocity. An oscillator gains
   * energy by the factor {@code 1 + h^2 w^2} per substep. For teaching and tests; resting bodies
   * float {@code h^2 g} above the ground.
   */
  EXPLICIT_EULER
}
