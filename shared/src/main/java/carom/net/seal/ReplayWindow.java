package carom.net.seal;

/**
 * The numbers of the datagrams that have come, so that none counts twice. It remembers the newest
 * {@value #SPAN} numbers; what is older counts as seen. Use it from one thread.
 */
final class ReplayWindow {
  /**
   * Age up to which a late datagram is accepted, datagrams: two seconds of 480 datagrams a second.
   */
  static final int SPAN = 1_024;

  private final long[] seen = new long[SPAN / Long.SIZE];
  private long end; // the number after the newest

  /**
   * Returns whether a number is new.
   *
   * @param number 0 or more
   */
  boolean isNew(long number) {
    return number >= end || (end - number <= SPAN && (word(number) & bit(number)) == 0);
  }

  /** Marks a number as seen, once its datagram is proven genuine. */
  void mark(long number) {
    if (number >= end) {
      // The places between the newest number and this one hold numbers that are too old now.
      for (long n = Math.max(end, number - SPAN + 1); n <= number; n++) {
        seen[index(n)] &= ~bit(n);
      }
      end = number + 1;
    } else if (end - number > SPAN) {
      return;
    }
    seen[index(number)] |= bit(number);
  }

  private long word(long number) {
    return seen[index(number)];
  }

  private static int index(long number) {
    return (int) (number % SPAN) / Long.SIZE;
  }

  private static long bit(long number) {
    return 1L << number;
  }
}
