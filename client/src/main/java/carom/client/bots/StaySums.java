package carom.client.bots;

import carom.client.stats.NetStats;

/**
 * What a bot measured in all its stays: each client it has been counts from zero. Used by one
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

  /** Milliseconds times seconds, since a long stay tells more than a short one. */
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

  /** Mean of the stays' {@link NetStats#gapP99Ms}, by their length; NaN before the first. */
  double gapP99Ms() {
    return gapP99 / seconds;
  }

  /** Mean of the stays' {@link NetStats#rttP50Ms}, by their length; NaN before the first. */
  double rttP50Ms() {
    return rttP50 / seconds;
  }
}
