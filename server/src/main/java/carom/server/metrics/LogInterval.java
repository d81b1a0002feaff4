package carom.server.metrics;

/**
 * At most one line every ten seconds about something that may happen in each tick: a log must last
 * for weeks. One thread.
 */
public final class LogInterval {
  /** Between two lines, ns. */
  static final long LENGTH_NS = 10_000_000_000L;

  private boolean begun;
  private long beginNs;

  /**
   * Whether a line may be written now; then the next one has to wait.
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
