package carom.lab.measure;

import java.util.function.Consumer;

/**
 * How long to measure, and in which slices: the other entrants have their turns in between.
 *
 * @param warmUpSeconds of work before the run that counts
 * @param capSeconds after which the warm-up, the timed part, and likewise the untimed part end
 *     early
 * @param quick whether to time a quarter of the steps only
 * @param turns whose turn it is; this process has it
 */
public record Measurement(double warmUpSeconds, double capSeconds, boolean quick, Turns turns) {
  /** What a row that was cut short by {@link #capSeconds} says. */
  public static final String CUT = "cut short";

  /** Enough that a slow minute of the machine is everybody's, few enough that caches are warm. */
  private static final int SLICES = 12;

  /**
   * Times repeated work in slices, until the watch is full or {@link #capSeconds} are spent; at
   * least once.
   *
   * @param watch takes the times
   * @param before done before each piece of work, untimed
   * @param work what is timed
   */
  public void time(Stopwatch watch, Runnable before, Runnable work) {
    time(watch, before, work, slice -> {});
  }

  /**
   * Times repeated work in slices, and does something else after each.
   *
   * @param watch takes the times
   * @param before done before each piece of work, untimed
   * @param work what is timed
   * @param after done after each slice, and left out; gets the times of its pieces by the clock, ms
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
