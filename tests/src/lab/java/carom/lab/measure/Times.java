package carom.lab.measure;

import java.util.Arrays;

/**
 * The cost of a step, or of other repeated work.
 *
 * @param steps number of steps timed; 0 if nothing was measured
 * @param medianMs median time, ms; CPU time of the stepping thread, or clock time if several
 *     threads stepped
 * @param p99Ms 99th percentile of that time, ms
 * @param wallMs median clock time, ms
 * @param allocatedBytes bytes allocated per step
 */
public record Times(
    int steps, double medianMs, double p99Ms, double wallMs, double allocatedBytes) {
  /** The value of times that were not measured. */
  public static final Times NONE = new Times(0, Double.NaN, Double.NaN, Double.NaN, Double.NaN);

  /**
   * Returns the percentiles of measured times.
   *
   * @param seconds time of each step, at least one; sorted by this method
   * @param wallSeconds clock time of each step; sorted by this method
   * @param steps number of steps in both arrays
   * @param allocated bytes that all steps together allocated
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
