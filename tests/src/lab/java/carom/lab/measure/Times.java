package carom.lab.measure;

import java.util.Arrays;

/**
 * What steps, or other repeated work, cost.
 *
 * @param steps how many were timed; 0 if nothing was measured
 * @param medianMs half of them took no longer, ms; CPU time of the thread that steps, or the time
 *     of the clock if several threads did
 * @param p99Ms 99 of 100 took no longer, ms
 * @param wallMs median by the clock, ms
 * @param allocatedBytes per step
 */
public record Times(
    int steps, double medianMs, double p99Ms, double wallMs, double allocatedBytes) {
  /** Nothing was measured. */
  public static final Times NONE = new Times(0, Double.NaN, Double.NaN, Double.NaN, Double.NaN);

  /**
   * Sums up.
   *
   * @param seconds of each step, at least one; gets sorted
   * @param wallSeconds of each step by the clock; gets sorted
   * @param steps how many of both count
   * @param allocated bytes by all of them
   */
  public static Times of(double[] seconds, double[] wallSeconds, int steps, double allocated) {
    Arrays.sort(seconds, 0, steps);
    Arrays.sort(wallSeconds, 0, steps);
    return new Times(
        steps,
        seconds[steps / 2] * 1e3,
        seconds[(int) Math.ceil(0.99 * steps) - 1] * 1e3,
        wallSeconds[steps / 2] * 1e3,
        allocated / steps);
  }
}
