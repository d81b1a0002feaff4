package carom.lab.measure;

/**
 * The gain of several threads, and the most that they could gain on this machine at this time.
 * Processors may be threads of one core, or be shared with other programs.
 *
 * @param speedUp speed of several threads that step one world, as a multiple of one thread's, by
 *     the clock
 * @param ceiling throughput of several threads that each step their own world, as a multiple of one
 *     thread's
 * @param share the part of the ceiling that is reached
 */
public record Scaling(double speedUp, double ceiling, double share) {
  /** The value of a gain that was not measured. */
  public static final Scaling NONE = new Scaling(Double.NaN, Double.NaN, Double.NaN);

  /** Returns whether the gain was measured. */
  public boolean isMeasured() {
    return !Double.isNaN(share);
  }
}
