package carom.net.kryo;

/**
 * A token bucket in one number: so many events per second on average, so many at once. One thread.
 */
final class RateBudget {
  private final long intervalNanos;
  private final long burstNanos;
  private long paidUntil;
  private boolean used;

  /**
   * A full bucket.
   *
   * @param perSecond events per second, at least 1
   * @param burst events at once, at least 1
   */
  RateBudget(int perSecond, int burst) {
    intervalNanos = Math.max(1, 1_000_000_000L / perSecond);
    burstNanos = intervalNanos * burst;
  }

  /**
   * Takes one event at a time of {@code System.nanoTime}'s kind; false when the budget is spent.
   */
  boolean take(long now) {
    if (!used || now - paidUntil > 0) {
      used = true;
      paidUntil = now;
    }
    if (paidUntil + intervalNanos - now > burstNanos) {
      return false;
    }
    paidUntil += intervalNanos;
    return true;
  }
}
