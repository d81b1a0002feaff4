package carom.server.room;

import carom.server.metrics.TurnStage;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.function.LongSupplier;

/**
 * The times that the stages of a room's turns have taken since the start. The room's thread writes
 * without a lock or an allocation, and any other thread may read.
 */
public final class StageTimes {
  private final LongSupplier clock;
  private final AtomicLongArray totals = new AtomicLongArray(TurnStage.values().length);
  private long beginNs;

  /**
   * Creates times at zero.
   *
   * @param clock monotonic nanoseconds
   */
  public StageTimes(LongSupplier clock) {
    this.clock = clock;
  }

  /** Begins the first stage of a turn. The room's thread only. */
  public void begin() {
    beginNs = clock.getAsLong();
  }

  /** Ends a stage, and begins the next. The room's thread only. */
  public void end(TurnStage stage) {
    long nowNs = clock.getAsLong();
    int index = stage.ordinal();
    totals.setRelease(index, totals.getPlain(index) + nowNs - beginNs);
    beginNs = nowNs;
  }

  /** Returns the time that a stage has taken since the start, ns. Any thread. */
  public long totalNs(TurnStage stage) {
    return totals.getAcquire(stage.ordinal());
  }
}
