package carom.physics.dynamics.continuous;

import carom.physics.collision.Sweep;

/**
 * The motion of a fast body in a step: one stretch if nothing stopped it, else one up to the impact
 * and another one from there, along with what it hit.
 */
final class Flight {
  /** The body's slot. */
  int body;

  /** The motion as the solver left it. */
  final Sweep whole = new Sweep();

  /** The motion up to the impact. */
  final Sweep first = new Sweep();

  /** The motion after the impact. */
  final Sweep second = new Sweep();

  /** The time of the impact as a part of the step; 1 if there is none. */
  float split;

  /** Returns the motion until the body was stopped: all of it, if nothing did. */
  Sweep beginning() {
    return split < 1 ? first : whole;
  }
}
