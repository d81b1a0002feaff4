package carom.server.query;

import carom.net.admission.AddressGroup;
import java.net.InetSocketAddress;
import java.util.Arrays;

/**
 * Limits how many queries are looked at in a second: of one socket, of one host (an IPv4 address or
 * an IPv6 /64 network) and of all. What is beyond a smaller limit doesn't count for a larger one,
 * so that a flood from somewhere uses up nothing of others. Nothing is kept about single hosts:
 * senders share {@value #SLOTS} counters by a hash that changes with each run. One thread.
 */
final class QueryBudgets {
  /** Most queries of one socket in a second. A client that shows a server sends about six. */
  static final int MOST_OF_SOCKET = 20;

  /** Most queries of one host in a second. */
  static final int MOST_OF_HOST = 200;

  /** Most queries of all in a second. */
  static final int MOST_OF_ALL = 2_000;

  private static final int SLOTS = 4_096;
  private static final long SECOND_NS = 1_000_000_000L;

  private final int salt;
  private final int[] ofSocket = new int[SLOTS];
  private final int[] ofHost = new int[SLOTS];
  private int ofAll;
  private long beginNs;
  private boolean begun;

  /**
   * Creates budgets of which nothing is used up.
   *
   * @param salt a secret of this run
   */
  QueryBudgets(int salt) {
    this.salt = salt;
  }

  /** Counts a query, and returns whether it is within the limits. */
  boolean allow(InetSocketAddress from, long nowNs) {
    if (!begun || nowNs - beginNs >= SECOND_NS) {
      begun = true;
      beginNs = nowNs;
      ofAll = 0;
      Arrays.fill(ofSocket, 0);
      Arrays.fill(ofHost, 0);
    }
    String host = AddressGroup.of(from.getAddress()).host();
    return ++ofSocket[slot(31 * host.hashCode() + from.getPort())] <= MOST_OF_SOCKET
        && ++ofHost[slot(host.hashCode())] <= MOST_OF_HOST
        && ++ofAll <= MOST_OF_ALL;
  }

  /** Returns a counter's place, which can't be chosen without the salt. */
  private int slot(int key) {
    int mixed = (key ^ salt) * 0x9e3779b1;
    mixed = (mixed ^ (mixed >>> 15)) * 0x85ebca6b;
    return (mixed ^ (mixed >>> 13)) & (SLOTS - 1);
  }
}
