package carom.physics.effects;

import carom.physics.Integrator;
import carom.physics.WorldDef;

/**
 * Time at which to measure a force that depends on a body's position.
 *
 * <p>A force holds for a whole step of n substeps h = dt / n, in which symplectic Euler moves a
 * body by {@code v dt + a dt^2 (n + 1) / (2 n)}. Measured at the start, the force of a spring would
 * add energy: in each step, the area of phase space grows by {@code 1 + (1 - c) o^2 dt^2}, with c =
 * (n + 1) / (2 n) and o the angular frequency. Measured at {@code x + t v dt}, the factor is {@code
 * 1 + (1 - c - t) o^2 dt^2}. It is exactly 1 for t = (n - 1) / (2 n); the oscillation is then that
 * of symplectic Euler with the step dt, whose frequency is {@code 2 asin(o dt / 2) / dt}. Explicit
 * Euler moves a body by {@code v dt + a dt^2 (n - 1) / (2 n)}, so its t is {@code (n + 1) / (2 n)}.
 */
final class Lookahead {
  private Lookahead() {}

  /** Returns how far ahead to measure a force, s. */
  static float seconds(WorldDef def, float dt) {
    int more = def.integrator() == Integrator.EXPLICIT_EULER ? 1 : -1;
    return dt * (def.substeps() + more) / (2f * def.substeps());
  }
}
