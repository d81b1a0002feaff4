package carom.client.stats;

import org.HdrHistogram.IntCountsHistogram;

/**
 * Records what a link carries: bytes, snapshots, round trips and losses. Written by one client; one
 * thread.
 */
final class TrafficRecorder {
  private static final long SECOND_NS = 1_000_000_000L;
  private static final long MAX_US = 60_000_000L;

  final RecentValues roundTrips = new RecentValues();
  final RecentValues snapshotBytes = new RecentValues();
  final RecentValues gaps = new RecentValues();
  final IntCountsHistogram gapsUs = new IntCountsHistogram(MAX_US, 2);
  final IntCountsHistogram roundTripsUs = new IntCountsHistogram(MAX_US, 2);
  final LossWindow loss = new LossWindow();

  private boolean playing;
  private long playingSinceNs;
  private long playedNs;
  private long lastSnapshotNs;
  long snapshots;
  long bytesIn;
  long bytesOut;
  long playingBytesIn;
  long playingBytesOut;
  int malformed;
  int reconnects;
  int sessionsLost;
  int redirects;
  int ticksLost;
  boolean overTcp;

  private long rateSinceNs;
  private long rateBytesIn;
  private long rateBytesOut;
  private long rateSnapshots;
  double kbitInPerSecond;
  double kbitOutPerSecond;
  double snapshotsPerSecond;

  /** Adds bytes that the link carried. */
  void bytes(int in, int out) {
    bytesIn += in;
    bytesOut += out;
    if (playing) {
      playingBytesIn += in;
      playingBytesOut += out;
    }
  }

  /** Notes that playing begins or ends. */
  void playing(boolean now, long nowNs) {
    if (now && !playing) {
      playingSinceNs = nowNs;
      lastSnapshotNs = 0;
      loss.reset();
    } else if (!now && playing) {
      playedNs += nowNs - playingSinceNs;
    }
    playing = now;
  }

  /** Returns the time in which the client was playing, seconds. */
  double playedSeconds(long nowNs) {
    return (playedNs + (playing ? nowNs - playingSinceNs : 0)) / 1e9;
  }

  /** Notes the first datagram of a snapshot. */
  void snapshot(long arrivedNs) {
    snapshots++;
    if (lastSnapshotNs != 0) {
      long gapNs = Math.max(0, arrivedNs - lastSnapshotNs);
      gaps.add(gapNs / 1e6f);
      gapsUs.recordValue(Math.min(MAX_US, gapNs / 1_000));
    }
    lastSnapshotNs = arrivedNs;
  }

  /** Notes a round trip, milliseconds. */
  void roundTrip(double ms) {
    roundTrips.add((float) ms);
    roundTripsUs.recordValue((long) Math.max(0, Math.min(MAX_US, ms * 1_000)));
  }

  /** Computes the rates once per second. */
  void roll(long nowNs) {
    if (rateSinceNs == 0) {
      rateSinceNs = nowNs;
    }
    long elapsed = nowNs - rateSinceNs;
    if (elapsed >= SECOND_NS) {
      double seconds = elapsed / 1e9;
      kbitInPerSecond = (bytesIn - rateBytesIn) * 8 / 1_000.0 / seconds;
      kbitOutPerSecond = (bytesOut - rateBytesOut) * 8 / 1_000.0 / seconds;
      snapshotsPerSecond = (snapshots - rateSnapshots) / seconds;
      rateSinceNs = nowNs;
      rateBytesIn = bytesIn;
      rateBytesOut = bytesOut;
      rateSnapshots = snapshots;
    }
  }
}
