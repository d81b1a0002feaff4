package carom.client.bots;

import carom.client.stats.NetStats;

/**
 * Sums of the figures of all stays of a bot, because each client counts from zero. Used by one
 * thread at a time.
 */
final class StaySums {
  double seconds;
  long snapshots;
  long bytesIn;
  long bytesOut;
  long awakeBodies;
  long exactBodies;
  long corrections;
  int malformed;

  /** Sum of milliseconds times the seconds of the stay: a long stay weighs more. */
  private double gapP99;

  private double rttP50;

  /**
   * Adds what a client measured up to now. Takes about 0.1 ms if it played.
   *
   * @param nowNs as in the client's updates
   */
  void add(NetStats stats, long nowNs) {
    snapshots += stats.snapshots();
    bytesIn += stats.playingBytesIn();
    bytesOut += stats.playingBytesOut();
    awakeBodies += stats.awakeBodies();
    exactBodies += stats.exactBodies();
    corrections += stats.corrections();
    malformed += stats.malformed();
    double played = stats.playedSeconds(nowNs);
    if (played > 0) {
      seconds += played;
      gapP99 += stats.gapP99Ms() * played;
      rttP50 += stats.rttP50Ms() * played;
    }
  }

  /** Adds earlier stays of the same bot. */
  void add(StaySums earlier) {
    seconds += earlier.seconds;
    snapshots += earlier.snapshots;
    bytesIn += earlier.bytesIn;
    bytesOut += earlier.bytesOut;
    awakeBodies += earlier.awakeBodies;
    exactBodies += earlier.exactBodies;
    corrections += earlier.corrections;
    malformed += earlier.malformed;
    gapP99 += earlier.gapP99;
    rttP50 += earlier.rttP50;
  }

  /**
   * Returns the mean of {@link NetStats#gapP99Ms}, weighted by length; NaN before the first stay.
   */
  double gapP99Ms() {
    return gapP99 / seconds;
  }

  /**
   * Returns the mean of {@link NetStats#rttP50Ms}, weighted by length; NaN before the first stay.
   */
  double rttP50Ms() {
    return rttP50 / seconds;
  }
}
