package carom.net.kryo.server;

/**
 * Tells a flood from a burst: a link floods when it sends more than ten times its budget in each of
 * {@value #SECONDS} seconds in a row. Use it from one thread.
 */
final class FloodMeter {
  /** Multiple of its budget from which what a link sends counts as a flood. */
  public static final int FACTOR = 10;

  /** Least length of a flood, full seconds in a row. */
  static final int SECONDS = 2;

  private static final long SECOND_NANOS = 1_000_000_000L;

  private final long limit;
  private boolean begun;
  private long second;
  private long count;
  private int excessive;

  /**
   * Creates a meter that has counted nothing.
   *
   * @param perSecond the budget, datagrams per second
   */
  public FloodMeter(int perSecond) {
    limit = (long) FACTOR * perSecond;
  }

  /** Counts a datagram at a time of {@link System#nanoTime}. Returns whether the link floods. */
  public boolean count(long now) {
    if (!begun) {
      begun = true;
      second = now;
    }
    long passed = (now - second) / SECOND_NANOS;
    if (passed > 0) {
      excessive = passed == 1 && count > limit ? excessive + 1 : 0;
      second += passed * SECOND_NANOS;
      count = 0;
    }
    count++;
    return excessive + (count > limit ? 1 : 0) >= SECONDS;
  }
}
