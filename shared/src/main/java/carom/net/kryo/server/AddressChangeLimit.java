package carom.net.kryo.server;

import carom.net.admission.TokenBucket;
import java.net.InetSocketAddress;

/**
 * Limit on the datagrams of one link that come from an address which isn't its own. Such a datagram
 * is opened, because a home router may have changed the client's address while it plays. A forged
 * one costs several times as much as a genuine one, because the JCE refuses it by an exception.
 *
 * <p>The limit is the link's own, so that forgeries for other links don't delay a client that has
 * moved. It is one limit for the client's present host, where most clients move to another port,
 * and one for all other hosts. So a flood from elsewhere doesn't delay most moves. Of an address
 * that has just forged a datagram, the link hears nothing for a second, so that a few forgers don't
 * use up either limit. All links together have a limit for the sake of the processor.
 *
 * <p>Nothing here allocates, and it remembers {@value #FORGERS} addresses at most. Use it from one
 * thread.
 */
final class AddressChangeLimit {
  /** Largest number of datagrams per second that are opened for one link, of each kind of host. */
  public static final int PER_SECOND = 20;

  /**
   * Largest number of datagrams per second from hosts other than their links' that are opened for
   * all links together.
   */
  public static final int TOTAL_PER_SECOND = 2_000;

  /** Number of addresses whose forgeries a link remembers. */
  static final int FORGERS = 8;

  private static final long FORGER_NANOS = 1_000_000_000L;

  private final TokenBucket total;
  private final TokenBucket sameHost = new TokenBucket(PER_SECOND, PER_SECOND);
  private final TokenBucket otherHosts = new TokenBucket(PER_SECOND, PER_SECOND);
  private final InetSocketAddress[] forgers = new InetSocketAddress[FORGERS];
  private final long[] forgedAt = new long[FORGERS];
  private int next;

  /**
   * Creates the limit of a link that has received nothing.
   *
   * @param total the limit that all links share, from {@link #total}
   */
  public AddressChangeLimit(TokenBucket total) {
    this.total = total;
  }

  /** Returns a limit for many links to share. */
  public static TokenBucket total() {
    return new TokenBucket(TOTAL_PER_SECOND, TOTAL_PER_SECOND / 4);
  }

  /**
   * Takes one datagram. Returns false when it must not be opened.
   *
   * @param from where it comes from, resolved
   * @param present the link's present address, resolved, or null if it has none
   * @param now a time of {@link System#nanoTime}
   */
  public boolean take(InetSocketAddress from, InetSocketAddress present, long now) {
    for (int i = 0; i < FORGERS; i++) {
      if (forgers[i] != null && now - forgedAt[i] < FORGER_NANOS && forgers[i].equals(from)) {
        return false;
      }
    }
    if (present != null && from.getAddress().equals(present.getAddress())) {
      return sameHost.take(now);
    }
    return otherHosts.take(now) && total.take(now);
  }

  /** Notes that a datagram from an address was opened, and was forged. */
  public void forged(InetSocketAddress from, long now) {
    forgers[next] = from;
    forgedAt[next] = now;
    next = (next + 1) % FORGERS;
  }
}
