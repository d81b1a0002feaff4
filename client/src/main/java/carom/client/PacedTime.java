package carom.client;

/**
 * Time as the server's ticks pass it. A server that is too slow for its tick rate slows time down
 * for all and tells its clients; their clocks then run at the same pace. Continuous and never
 * backwards. Not thread-safe.
 */
final class PacedTime {
  private boolean begun;
  private long sinceNs;
  private long pacedNs;
  private double pace = 1;

  /** Creates a time at full pace, which is the time that it is given. */
  public PacedTime() {}

  /**
   * Changes the pace.
   *
   * @param percent of the full pace, 1..100
   * @param nowNs the present
   */
  public void pace(int percent, long nowNs) {
    pacedNs = at(nowNs);
    sinceNs = nowNs;
    begun = true;
    pace = percent / 100.0;
  }

  /** Returns the present pace, 0.01..1. */
  public double pace() {
    return pace;
  }

  /** Returns the paced time of a moment, ns. A moment before the last change counts as it. */
  public long at(long ns) {
    if (!begun) {
      return ns;
    }
    return pacedNs + (long) (Math.max(0, ns - sinceNs) * pace);
  }
}
