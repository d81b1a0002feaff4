package carom.sim.level;

import carom.physics.Body;

/**
 * The path of a kinematic body: back and forth between two points, for ever. It is a pure function
 * of the tick, so server and client agree on it without a byte on the wire.
 *
 * @param x0 position at the start of a period, metres
 * @param y0 position at the start of a period, metres
 * @param x1 position in the middle of a period, metres
 * @param y1 position in the middle of a period, metres
 * @param periodSeconds time of a round trip, seconds, above 0
 * @param phase position in the period at tick 0, 0..1
 * @param eased true to slow down towards both ends (3 t^2 - 2 t^3), false for constant speed
 */
public record ScriptedMotion(
    float x0, float y0, float x1, float y1, float periodSeconds, float phase, boolean eased) {

  /** Returns the horizontal position at a tick, metres. */
  public float x(int tick, int tickRate) {
    return x0 + (x1 - x0) * progress(tick, tickRate);
  }

  /** Returns the vertical position at a tick, metres. */
  public float y(int tick, int tickRate) {
    return y0 + (y1 - y0) * progress(tick, tickRate);
  }

  /**
   * Moves a body along the path. It puts the body where the path was a tick ago, to the bit, and
   * sets the velocity that leads to the path's present point. A client that knows the tick computes
   * the same.
   */
  public void drive(Body<?> body, int tick, int tickRate) {
    float x = x(tick - 1, tickRate);
    float y = y(tick - 1, tickRate);
    if (body.x() != x || body.y() != y) {
      body.setPose(x, y, body.cos(), body.sin());
    }
    body.setVelocity((x(tick, tickRate) - x) * tickRate, (y(tick, tickRate) - y) * tickRate);
  }

  /** Returns 0 at the first point, 1 at the second, and the fraction of the way between. */
  private float progress(int tick, int tickRate) {
    int period = Math.max(2, Math.round(periodSeconds * tickRate));
    int offset = Math.round(phase * period);
    float turn = Math.floorMod(tick + offset, period) / (float) period;
    float t = turn < 0.5f ? 2 * turn : 2 - 2 * turn;
    return eased ? t * t * (3 - 2 * t) : t;
  }
}
