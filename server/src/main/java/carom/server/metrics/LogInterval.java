package carom.server.metrics;

/**
 * Limits the log to one line every ten seconds about something that may happen in each tick,
 * because a log must last for weeks. One thread.
 */
public final class LogInterval {
  /** Shortest time between two lines, ns. */
  static final long LENGTH_NS = 10_000_000_000L;

  private boolean begun;
  private long beginNs;

  /**
   * Returns whether the caller may write a line now. If so, an interval begins in which further
   * calls return false.
   *
   * @param nowNs monotonic time
   */
  public boolean tryBegin(long nowNs) {
    if (begun && nowNs - beginNs < LENGTH_NS) {
      return false;
    }
    begun = true;
    beginNs = nowNs;
    return true;
  }
}
