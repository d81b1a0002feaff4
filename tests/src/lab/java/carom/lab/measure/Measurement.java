package carom.lab.measure;

import java.util.function.Consumer;

/**
 * The length of a measurement and its slices, between which the other entrants have their turns.
 *
 * @param warmUpSeconds length of the work before the run that counts, s
 * @param capSeconds time after which the warm-up, the timed part and the untimed part each end
 *     early, s
 * @param quick whether to time only a quarter of the steps
 * @param turns hands over the turn, which this process has
 */
public record Measurement(double warmUpSeconds, double capSeconds, boolean quick, Turns turns) {
  /** The fault of a row that {@link #capSeconds} cut short. */
  public static final String CUT = "cut short";

  /**
   * Number of slices: enough that a slow minute of the machine affects all entrants, few enough
   * that caches stay warm.
   */
  private static final int SLICES = 12;

  /**
   * Times repeated work in slices until the watch is full or {@link #capSeconds} are spent, at
   * least once.
   *
   * @param watch takes the times
   * @param before runs before each piece of work, untimed
   * @param work the timed work
   */
  public void time(Stopwatch watch, Runnable before, Runnable work) {
    time(watch, before, work, slice -> {});
  }

  /**
   * Times repeated work in slices and does other work after each slice.
   *
   * @param watch takes the times
   * @param before runs before each piece of work, untimed
   * @param work the timed work
   * @param after runs after each slice, untimed; gets the clock times of the slice's pieces, ms
   */
  public void time(Stopwatch watch, Runnable before, Runnable work, Consumer<double[]> after) {
    int slice = Math.max(1, (watch.most() + SLICES - 1) / SLICES);
    do {
      turns.pass();
      int begin = watch.count();
      do {
        before.run();
        watch.begin();
        work.run();
        watch.end();
      } while (!watch.isFull() && watch.count() < begin + slice && watch.spent() < capSeconds);
      watch.leaveOut(() -> after.accept(watch.wallMs(begin)));
    } while (!watch.isFull() && watch.spent() < capSeconds);
  }
}
