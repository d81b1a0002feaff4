package carom.sim.level;

/**
 * The path of a kinematic body: there and back between two points, for ever. A pure function of the
 * tick, so server and client agree on it without a byte on the wire.
 *
 * @param x0 position at the start of a period, metres
 * @param y0 position at the start of a period, metres
 * @param x1 position in the middle of a period, metres
 * @param y1 position in the middle of a period, metres
 * @param periodSeconds time there and back, seconds, above 0
 * @param phase where the body is at tick 0, as part of a period, 0..1
 * @param eased true: slows down towards both ends (3 t^2 - 2 t^3); false: constant speed
 */
public record ScriptedMotion(
    float x0, float y0, float x1, float y1, float periodSeconds, float phase, boolean eased) {

  /** Horizontal position at a tick, metres. */
  public float x(int tick, int tickRate) {
    return x0 + (x1 - x0) * progress(tick, tickRate);
  }

  /** Vertical position at a tick, metres. */
  public float y(int tick, int tickRate) {
    return y0 + (y1 - y0) * progress(tick, tickRate);
  }

  /** 0 at the first point, 1 at the second. */
  private float progress(int tick, int tickRate) {
    int period = Math.max(2, Math.round(periodSeconds * tickRate));
    int offset = Math.round(phase * period);
    float turn = Math.floorMod(tick + offset, period) / (float) period;
    float t = turn < 0.5f ? 2 * turn : 2 - 2 * turn;
    return eased ? t * t * (3 - 2 * t) : t;
  }
}
