package carom.server.threads;

import carom.server.metrics.Counter;
import carom.server.metrics.Counters;

/**
 * Paces the ticks of a room: which are due, how long they take, and how many a second the room can
 * keep. It counts what is late, and warns the operator. One thread; no allocation.
 *
 * <pre>
 *   due ◄── TickLoop ◄── pace ── TickLoad ◄── tickTook
 *              └── dropped ──► LoadWarnings ◄──┘
 * </pre>
 */
public final class TickPace {
  private final TickLoop loop;
  private final TickLoad load;
  private final LoadWarnings warnings;
  private final Counters counters;
  private boolean toldNarrow;

  /**
   * Creates the pace of a room whose clock doesn't run yet.
   *
   * @param rateHz ticks per second, at least 1
   * @param catchUpTicks the most ticks that are due at once, at least 1
   * @param warnings the room's
   */
  public TickPace(int rateHz, int catchUpTicks, LoadWarnings warnings, Counters counters) {
    loop = new TickLoop(rateHz, catchUpTicks);
    load = new TickLoad(rateHz);
    this.warnings = warnings;
    this.counters = counters;
  }

  /**
   * Returns the number of ticks to run now; call once per turn.
   *
   * @param paused stops the clock: no tick is due, and none is made good later; the load is 0
   * @param tick the last tick that ran
   * @param nowNs monotonic time
   */
  public int due(boolean paused, int tick, long nowNs) {
    if (paused) {
      loop.pause();
      load.rest(); // or a load that nothing measures any more keeps newcomers out
      tellViews(false, nowNs);
    }
    int due = paused ? 0 : loop.due(nowNs);
    counters.set(Counter.LOAD_PERCENT, load.percent());
    if (!paused && tick > 0) { // while a server with many rooms starts, nobody is there to notice
      warnings.ticksDropped(loop.droppedNow(), tick, nowNs);
    }
    counters.add(Counter.TICKS_LATE, Math.max(0, due - 1));
    return due;
  }

  /**
   * Notes how long a tick took, ns, which may change the pace and the views.
   *
   * @param late whether snapshots had to wait for the next tick
   * @param nowNs when the turn began
   */
  public void tickTook(long tookNs, boolean late, long nowNs) {
    counters.tickTook(tookNs);
    counters.add(Counter.TICKS_NARROW, load.viewsAreNarrow() ? 1 : 0);
    if (load.tickTook(tookNs, late)) {
      loop.pace(load.pacePercent(), nowNs + tookNs);
      warnings.paceChanged(load.pacePercent(), nowNs);
    }
    if (tookNs > loop.periodNs()) {
      counters.add(Counter.TICKS_OVERRUN, 1);
    }
    tellViews(true, nowNs);
    warnings.lasts(nowNs);
  }

  private void tellViews(boolean played, long nowNs) {
    if (toldNarrow != load.viewsAreNarrow()) {
      toldNarrow = load.viewsAreNarrow();
      warnings.viewsChanged(toldNarrow, played, nowNs);
    }
  }

  /** Returns the pace, percent of the tick rate, {@value TickLoad#SLOWEST_PERCENT}..100. */
  public int percent() {
    return load.pacePercent();
  }

  /** Returns whether players are told only of what they show; see {@link TickLoad}. */
  public boolean viewsAreNarrow() {
    return load.viewsAreNarrow();
  }

  /** Returns when the next tick is due; valid after the first call of {@link #due}. */
  public long nextDeadlineNs() {
    return loop.nextDeadlineNs();
  }
}
