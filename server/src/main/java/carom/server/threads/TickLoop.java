package carom.server.threads;

import java.util.Locale;

/**
 * Says how many ticks are due, at a fixed rate, for a clock that is handed in.
 *
 * <p>Deadlines are computed from the start and the count, never from the previous deadline, so that
 * rounding can't make the rate drift: tick {@code n} is due at {@code start + n / rate}. After a
 * pause the missing ticks are made good in one burst, but never more than {@code catchUpTicks}; the
 * rest is dropped: the simulation then simply is that much younger than the wall clock, and clients
 * follow by their clock sync. Without the bound, a server that is too slow for its rate would fall
 * behind without end.
 *
 * <p>One thread; no allocation.
 */
final class TickLoop {
  private static final long NS_PER_S = 1_000_000_000L;

  private static final long HUNDRED_S = 100 * NS_PER_S;

  private final int rateHz;
  private long ticksIn100s;
  private final int catchUpTicks;
  private final long periodNs;
  private boolean started;
  private long startNs;
  private long scheduled; // ticks handed out or dropped since startNs
  private long lateTicks;
  private long droppedTicks;
  private int droppedNow;

  /**
   * Creates a loop whose clock doesn't run yet.
   *
   * @param rateHz ticks per second, at least 1
   * @param catchUpTicks the most ticks that one call of {@link #due} hands out, at least 1
   */
  public TickLoop(int rateHz, int catchUpTicks) {
    if (rateHz < 1 || catchUpTicks < 1) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "rateHz=%d and catchUpTicks=%d must be at least 1",
              rateHz,
              catchUpTicks));
    }
    this.rateHz = rateHz;
    ticksIn100s = 100L * rateHz;
    this.catchUpTicks = catchUpTicks;
    this.periodNs = NS_PER_S / rateHz;
  }

  /**
   * Returns the number of ticks to run now, 0..catchUpTicks. The first call starts the clock and
   * hands out nothing; the first tick is due one period later.
   *
   * @param nowNs monotonic time in nanoseconds; a value before the previous one hands out nothing
   */
  public int due(long nowNs) {
    droppedNow = 0;
    if (!started) {
      started = true;
      startNs = nowNs;
      return 0;
    }
    long elapsedNs = nowNs - startNs;
    if (elapsedNs < 0) {
      return 0;
    }
    // In two steps: elapsedNs * ticksIn100s would overflow after some months of uptime.
    long reached =
        elapsedNs / HUNDRED_S * ticksIn100s
            + (elapsedNs % HUNDRED_S * ticksIn100s) / HUNDRED_S
            - scheduled;
    if (reached <= 0) {
      return 0;
    }
    if (reached > catchUpTicks) {
      droppedNow = (int) Math.min(Integer.MAX_VALUE, reached - catchUpTicks);
      droppedTicks += reached - catchUpTicks;
    }
    scheduled += reached;
    int run = (int) Math.min(reached, catchUpTicks);
    lateTicks += run - 1;
    return run;
  }

  /**
   * Lets time pass more slowly, or faster again: fewer ticks a second, none of which is made good.
   *
   * @param percent of the rate, 1..100
   * @param nowNs the present
   */
  public void pace(int percent, long nowNs) {
    ticksIn100s = (long) percent * rateHz;
    startNs = nowNs;
    scheduled = 0;
  }

  /** Stops the clock. The next call of {@link #due} starts it anew, as the first one did. */
  public void pause() {
    started = false;
    scheduled = 0;
    droppedNow = 0;
  }

  /** Returns when the next tick is due, in the time of {@link #due}; valid after its first call. */
  public long nextDeadlineNs() {
    long next = scheduled + 1;
    // Rounded up, so that a wait until this moment is never a nanosecond short.
    return startNs
        + next / ticksIn100s * HUNDRED_S
        + (next % ticksIn100s * HUNDRED_S + ticksIn100s - 1) / ticksIn100s;
  }

  /** Returns the nominal length of a tick, ns, rounded down. */
  public long periodNs() {
    return periodNs;
  }

  /** Returns the number of ticks since the start that ran at least one period late. */
  public long lateTicks() {
    return lateTicks;
  }

  /** Returns the number of ticks that never ran because the loop was too far behind. */
  public long droppedTicks() {
    return droppedTicks;
  }

  /** Returns the number of ticks that the latest call of {@link #due} dropped. */
  public int droppedNow() {
    return droppedNow;
  }
}
