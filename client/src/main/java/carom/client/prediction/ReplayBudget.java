package carom.client.prediction;

import java.util.function.LongSupplier;

/**
 * Limits how many ticks a reconciliation may resimulate, by count and by time. Learns from past
 * replays what a tick costs. One prediction's; allocates nothing.
 */
final class ReplayBudget {
  /** Exact updates are rare: their replay may take so many times as long as others. */
  static final int UPDATE_FACTOR = 3;

  private static final double SMOOTHING = 0.25;

  private final int maxTicks;
  private final long maxNs;
  private final LongSupplier stopwatch;

  /** Measured cost of a tick; 0 before the first replay, or when the stopwatch stands still. */
  private double nsPerTick;

  private long beganNs;
  private long limitNs;
  private long cuts;

  ReplayBudget(int maxTicks, long maxNs, LongSupplier stopwatch) {
    this.maxTicks = maxTicks;
    this.maxNs = maxNs;
    this.stopwatch = stopwatch;
  }

  /** Starts the stopwatch of one reconciliation, with the usual limit. */
  void begin() {
    beganNs = stopwatch.getAsLong();
    limitNs = maxNs;
  }

  /** Raises the limit of this reconciliation because it applies an update. */
  void extendForUpdate() {
    limitNs = UPDATE_FACTOR * maxNs;
  }

  /**
   * Stops the stopwatch.
   *
   * @param replayed ticks that were resimulated
   * @return time since {@link #begin}, nanoseconds
   */
  long end(int replayed) {
    long tookNs = stopwatch.getAsLong() - beganNs;
    if (replayed > 0) {
      double error = (double) tookNs / replayed - nsPerTick;
      nsPerTick += error * (nsPerTick == 0 ? 1 : SMOOTHING);
    }
    return tookNs;
  }

  /** Returns the most ticks that may be replayed at all. */
  int maxTicks() {
    return maxTicks;
  }

  /** Returns how many ticks the usual limit allows. */
  int usualTicks() {
    return ticksIn(maxNs);
  }

  /** Returns how many ticks the limit for updates allows. */
  int updateTicks() {
    return ticksIn(UPDATE_FACTOR * maxNs);
  }

  /** Returns how many ticks the limit of this reconciliation allows. */
  int ticks() {
    return ticksIn(limitNs);
  }

  private int ticksIn(long ns) {
    return nsPerTick <= 0 ? maxTicks : (int) Math.max(1, Math.min(maxTicks, ns / nsPerTick));
  }

  /** Returns whether the time of this reconciliation is used up. */
  boolean isSpent() {
    return stopwatch.getAsLong() - beganNs > limitNs;
  }

  /** Counts that ticks were left out. */
  void countCut() {
    cuts++;
  }

  /** Returns how often ticks were left out. */
  long cuts() {
    return cuts;
  }
}
