package carom.server.threads;

import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.metrics.LogInterval;
import java.util.Arrays;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Counts what a room can't do in time, and warns the operator at once, and then as often as {@link
 * LogInterval} allows.
 */
public final class LoadWarnings {
  private static final Logger LOG = LoggerFactory.getLogger(LoadWarnings.class);

  /** Fewest late ticks in a second that are worth a warning, at any tick rate. */
  private static final int LEAST_LATE_TICKS = 3;

  private static final long SECOND_NS = 1_000_000_000L;

  private final String label;
  private final Counters counters;
  private final int tickRateHz;
  private final LogInterval dropped = new LogInterval();
  private final LogInterval stoodStill = new LogInterval();
  private final LogInterval postponed = new LogInterval();
  private final LogInterval narrowed = new LogInterval();
  private final LogInterval slowed = new LogInterval();

  /** Times of the last ticks in which snapshots waited: a ring, the oldest at {@link #oldest}. */
  private final long[] postponedAt;

  private int oldest;
  private int pacePercent = 100;
  private boolean narrow;

  /** Dropped ticks that no line has told of. */
  private long untold;

  /**
   * Creates an object that has warned of nothing.
   *
   * @param label begins each log line
   */
  public LoadWarnings(String label, Counters counters, int tickRateHz) {
    this.label = label;
    this.counters = counters;
    this.tickRateHz = tickRateHz;
    counters.set(Counter.PACE_PERCENT, 100);
    postponedAt = new long[Math.max(LEAST_LATE_TICKS, tickRateHz / 10)];
    Arrays.fill(postponedAt, Long.MIN_VALUE / 2);
  }

  /**
   * Notes how many ticks were dropped; call once per turn.
   *
   * @param ticks dropped in this turn, perhaps 0
   * @param tick the last tick that ran
   */
  public void ticksDropped(int ticks, int tick, long nowNs) {
    counters.add(Counter.TICKS_DROPPED, ticks);
    if (ticks >= tickRateHz && stoodStill.tryBegin(nowNs)) {
      LOG.warn(
          "{}stood still: {} dropped up to tick {}; {}",
          label,
          ticksWithTime(ticks),
          tick,
          "the process was stopped, the machine suspended, or one tick took that long");
    } else {
      untold += ticks;
    }
    if (untold > 0 && dropped.tryBegin(nowNs)) {
      LOG.warn(
          "{}can't keep up: {} dropped up to tick {}; {}",
          label,
          ticksWithTime(untold),
          tick,
          "if this repeats, lower --tick-rate or --max-players, or find a faster machine");
      untold = 0;
    }
  }

  private String ticksWithTime(long ticks) {
    return ticks + (ticks == 1 ? " tick (" : " ticks (") + ticks * 1_000 / tickRateHz + " ms)";
  }

  /**
   * Notes that time has slowed down, or goes faster again.
   *
   * @param newPacePercent the present pace, percent of the tick rate
   */
  public void paceChanged(int newPacePercent, long nowNs) {
    counters.set(Counter.PACE_PERCENT, newPacePercent);
    pacePercent = newPacePercent;
    lasts(nowNs);
  }

  /** Repeats the warnings about what lasts, now and then; call once per tick. */
  public void lasts(long nowNs) {
    if (pacePercent < 100 && slowed.tryBegin(nowNs)) {
      LOG.warn(
          "{}ticks take longer than their time: time passes at {} percent for all players; {}",
          label,
          pacePercent,
          "if this lasts, lower max-players or max-load (the command set does that at once) or"
              + " --tick-rate, or find a faster machine");
    }
    if (narrow && narrowed.tryBegin(nowNs)) {
      LOG.warn(
          "{}ticks take too long: players are told only of what they show; {}",
          label,
          "if this lasts, lower snapshot-rate, budget or max-players (the command set does that at"
              + " once), or find a faster machine");
    }
  }

  /**
   * Notes that views have become narrow, or wide again.
   *
   * @param nowNarrow whether players are told only of what they show
   * @param played whether there are players who notice
   */
  public void viewsChanged(boolean nowNarrow, boolean played, long nowNs) {
    narrow = nowNarrow;
    if (!narrow && played) {
      LOG.info("{}players are told again of what they don't show", label);
    }
    lasts(nowNs);
  }

  /**
   * Notes that snapshots wait for the next tick: the first sign that the machine gets too slow,
   * while ticks are still on time. A warning comes when that happens in a tenth of the ticks of a
   * second: single late ticks, as when code is compiled at the first join, are only counted.
   *
   * @param snapshots how many wait
   * @param sessions of how many sessions
   */
  public void snapshotsPostponed(int snapshots, int sessions, int tick, long nowNs) {
    counters.add(Counter.SNAPSHOTS_POSTPONED, snapshots);
    postponedAt[oldest] = nowNs;
    oldest = (oldest + 1) % postponedAt.length;
    if (nowNs - postponedAt[oldest] < SECOND_NS && postponed.tryBegin(nowNs)) {
      LOG.warn(
          "{}ticks take too long: in {} of the last second snapshots waited, at tick {} {} of {};"
              + " {}",
          label,
          postponedAt.length,
          tick,
          snapshots,
          sessions,
          "if this repeats, lower --snapshot-rate, --budget or --max-players");
    }
  }
}
