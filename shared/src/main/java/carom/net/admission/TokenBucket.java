package carom.net.admission;

/**
 * Token bucket in one number, with a limit on the events per second and on the events at once. Use
 * it from one thread.
 */
public final class TokenBucket {
  private final long intervalNanos;
  private final long burstNanos;
  private long paidUntil;
  private boolean used;

  /**
   * Creates a full bucket.
   *
   * @param perSecond events per second on average, at least 1
   * @param burst events at once, at least 1
   */
  public TokenBucket(int perSecond, int burst) {
    intervalNanos = Math.max(1, 1_000_000_000L / perSecond);
    burstNanos = intervalNanos * burst;
  }

  /**
   * Takes one event at a time of {@link System#nanoTime}. Returns false when the bucket is empty.
   */
  public boolean take(long now) {
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
