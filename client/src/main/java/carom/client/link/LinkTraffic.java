package carom.client.link;

import carom.client.stats.NetStatsRecorder;
import carom.net.transport.Link;

/**
 * Adds what a link has carried since it was last counted to the figures of the net graph, and how
 * its datagrams travel.
 */
final class LinkTraffic {
  private final NetStatsRecorder stats;
  private long countedIn;
  private long countedOut;

  LinkTraffic(NetStatsRecorder stats) {
    this.stats = stats;
  }

  /** Begins with a new link, of which nothing is counted yet. */
  void begin() {
    countedIn = 0;
    countedOut = 0;
  }

  /** Counts the bytes since the last call, or since {@link #begin}. */
  void count(Link link) {
    var counters = link.counters();
    long in = counters.datagramBytesIn.get() + counters.messageBytesIn.get();
    long out = counters.datagramBytesOut.get() + counters.messageBytesOut.get();
    stats.bytes((int) (in - countedIn), (int) (out - countedOut));
    countedIn = in;
    countedOut = out;
    stats.overTcp(link.isOverTcp());
  }
}
