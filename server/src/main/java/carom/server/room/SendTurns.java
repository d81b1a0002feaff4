package carom.server.room;

/**
 * Whose snapshots leave in which tick. When there are fewer snapshots than ticks, no tick sends
 * more than its share, so that all sessions don't burden the same tick: at 60 ticks and 30
 * snapshots a second, half of the sessions are served in each. And when a tick has used up five
 * eighths of its time, the rest waits for the next one: a machine that is too slow sends fewer
 * snapshots, but its ticks stay on time. A quarter of the share is served whatever the time.
 *
 * <p>Who had to wait is first in the next tick. One thread; no allocation.
 */
final class SendTurns {
  private static final int TIME_PARTS = 8;
  private static final int TIME_PARTS_TO_SEND_IN = 5;
  private static final int LEAST_PARTS = 4;

  private final int tickRateHz;
  private final int snapshotRateHz;
  private final long timeNs;
  private int count;
  private int first;
  private int next;
  private int served;
  private int share;
  private boolean hasWaiting;
  private long beginNs;
  private int late;

  /**
   * @param snapshotRateHz of each session; more than one a tick counts as one
   */
  SendTurns(int tickRateHz, int snapshotRateHz) {
    this.tickRateHz = tickRateHz;
    this.snapshotRateHz = Math.min(snapshotRateHz, tickRateHz);
    timeNs = 1_000_000_000L / tickRateHz * TIME_PARTS_TO_SEND_IN / TIME_PARTS;
  }

  /**
   * A tick's sending begins.
   *
   * @param sessions how many there are
   * @param tickBeganNs when the tick began, by the clock of {@link #take}
   */
  void begin(int sessions, long tickBeganNs) {
    count = sessions;
    first = sessions == 0 ? 0 : next % sessions;
    next = first;
    share = (sessions * snapshotRateHz + tickRateHz - 1) / tickRateHz;
    served = 0;
    hasWaiting = false;
    late = 0;
    beginNs = tickBeganNs;
  }

  /** The session whose turn it is as number {@code i}, 0 to the number of sessions - 1. */
  int index(int i) {
    int index = first + i;
    return index < count ? index : index - count;
  }

  /**
   * Whether the session whose turn it is as number {@code i} may send; else it waits. Call in order
   * and only for those who want to.
   */
  boolean take(int i, long nowNs) {
    boolean inTime = nowNs - beginNs < timeNs || served < (share + LEAST_PARTS - 1) / LEAST_PARTS;
    if (inTime && served < share) {
      served++;
      return true;
    }
    if (!hasWaiting) {
      hasWaiting = true;
      next = index(i);
    }
    late += inTime ? 0 : 1;
    return false;
  }

  /** How many sessions wait because the tick took too long. */
  int late() {
    return late;
  }
}
