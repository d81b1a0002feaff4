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
    if (isEmpty(now)) {
      return false;
    }
    charge(now);
    return true;
  }

  /** Counts an event that happened, even if the bucket is empty: then it takes longer to refill. */
  public void charge(long now) {
    paidUntil = now + owedNanos(now) + intervalNanos;
    used = true;
  }

  /** Returns whether no further event may happen now. */
  public boolean isEmpty(long now) {
    return owedNanos(now) + intervalNanos > burstNanos;
  }

  /** Returns whether as many events may happen now as in a new bucket. */
  public boolean isFull(long now) {
    return owedNanos(now) == 0;
  }

  private long owedNanos(long now) {
    return used ? Math.max(0, paidUntil - now) : 0;
  }
}
