package carom.server.metrics;

/**
 * Limits the log about something that may happen in each tick, because a log must last for weeks.
 * It allows one line every ten seconds at first, and fewer while it lasts, at last one a minute.
 * One thread.
 */
public final class LogInterval {
  /** Shortest time between two lines, ns. After a silence of this length it holds again. */
  static final long LENGTH_NS = 10_000_000_000L;

  /** Time between two lines about what goes on and on, ns. */
  static final long MAX_LENGTH_NS = 60_000_000_000L;

  private boolean begun;
  private long beginNs;
  private long lastNs;
  private long lengthNs;

  /**
   * Returns whether the caller may write a line now. If so, an interval begins in which further
   * calls return false.
   *
   * @param nowNs monotonic time
   */
  public boolean tryBegin(long nowNs) {
    boolean lasts = begun && nowNs - lastNs < LENGTH_NS;
    lastNs = nowNs;
    if (lasts && nowNs - beginNs < lengthNs) {
      return false;
    }
    lengthNs = lasts ? Math.min(MAX_LENGTH_NS, 2 * lengthNs) : LENGTH_NS;
    begun = true;
    beginNs = nowNs;
    return true;
  }
}
