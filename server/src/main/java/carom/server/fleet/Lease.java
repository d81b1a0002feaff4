package carom.server.fleet;

import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;

/**
 * The lease of a server in its fleet's directory, as the server itself sees it. It holds from the
 * moment when its last renewal was <em>asked for</em>, less a margin: so it ends here before it can
 * end there, whatever the answer's way took. By a monotonic clock, which goes on while the process
 * is stopped. Any thread asks; the fleet's thread changes it.
 */
final class Lease implements BooleanSupplier {
  /** Time for which the directory keeps the lease without a renewal, ms. */
  static final int TTL_MS = 2_000;

  /** Part of that time in which the server doesn't count on it, ms. */
  static final int MARGIN_MS = 400;

  private static final long NS_PER_MS = 1_000_000;

  private final LongSupplier clock;
  private final boolean keeps;
  private volatile long number;
  private volatile long untilNs;

  /**
   * Creates a lease that hasn't begun.
   *
   * @param clock monotonic nanoseconds
   * @param keeps whether the lease holds until the directory says that it is over, and not only for
   *     its time: the operator prefers rooms that go on while the directory is away
   */
  Lease(LongSupplier clock, boolean keeps) {
    this.clock = clock;
    this.keeps = keeps;
  }

  /** Notes that the directory has begun or renewed the lease, as was asked for at a time. */
  void renewed(long lease, long askedNs) {
    untilNs = askedNs + (TTL_MS - MARGIN_MS) * NS_PER_MS;
    number = lease;
  }

  /** Notes that the lease is over. */
  void ended() {
    number = 0;
  }

  /** Returns the number of the lease, 0 for none. */
  long number() {
    return number;
  }

  /** Returns how long the lease still holds, 0 if it doesn't, ns. */
  long leftNs() {
    return number == 0 ? 0 : Math.max(0, untilNs - clock.getAsLong());
  }

  /** Returns whether the lease holds now. */
  @Override
  public boolean getAsBoolean() {
    return number != 0 && (keeps || clock.getAsLong() - untilNs < 0);
  }
}
