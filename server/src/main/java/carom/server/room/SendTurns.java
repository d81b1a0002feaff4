package carom.server.room;

/**
 * Shares the snapshots of all sessions out among the ticks. With fewer snapshots than ticks, no
 * tick sends more than its share: at 60 ticks and 30 snapshots a second, each tick serves half of
 * the sessions.
 *
 * <p>When a tick has used up {@value #TIME_PARTS_TO_SEND_IN} of {@value #TIME_PARTS} parts of its
 * time, the rest waits for the next one. So a machine that is too slow sends fewer snapshots, but
 * its ticks stay on time. A quarter of the share is served even when time is short.
 *
 * <p>The first session that had to wait is the first in the next tick. One thread; no allocation.
 */
final class SendTurns {
  private static final int TIME_PARTS = 8;
  private static final int TIME_PARTS_TO_SEND_IN = 5;
  private static final int LEAST_PARTS = 4;

  private final int tickRateHz;
  private int snapshotRateHz;
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
   * Creates the turns of a room.
   *
   * @param snapshotRateHz snapshots per second and session; more than one per tick count as one
   */
  public SendTurns(int tickRateHz, int snapshotRateHz) {
    this.tickRateHz = tickRateHz;
    rate(snapshotRateHz);
    timeNs = 1_000_000_000L / tickRateHz * TIME_PARTS_TO_SEND_IN / TIME_PARTS;
  }

  /** Sets the number of snapshots per second and session, for the ticks that follow. */
  public void rate(int newSnapshotRateHz) {
    snapshotRateHz = Math.min(newSnapshotRateHz, tickRateHz);
  }

  /**
   * Begins the sending of a tick.
   *
   * @param sessions how many there are
   * @param tickBeganNs when the tick began, by the clock of {@link #take}
   */
  public void begin(int sessions, long tickBeganNs) {
    count = sessions;
    first = sessions == 0 ? 0 : next % sessions;
    next = first;
    share = (sessions * snapshotRateHz + tickRateHz - 1) / tickRateHz;
    served = 0;
    hasWaiting = false;
    late = 0;
    beginNs = tickBeganNs;
  }

  /** Returns the session that has turn {@code i}, 0..number of sessions - 1. */
  public int index(int i) {
    int index = first + i;
    return index < count ? index : index - count;
  }

  /**
   * Takes turn {@code i} for its session, which may send if this returns true and has to wait if
   * not. Call in order of turns, and only for sessions that have something to send.
   */
  public boolean take(int i, long nowNs) {
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

  /** Returns how many sessions wait because the tick took too long. */
  public int late() {
    return late;
  }
}
