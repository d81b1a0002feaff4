package carom.client;

import carom.client.clock.RenderClock;
import carom.client.clock.TickClock;
import org.HdrHistogram.IntCountsHistogram;

/**
 * How the connection does, in numbers for a net graph, a status line or a test. Written by one
 * {@link GameClient}; read on its thread.
 *
 * <p>Unless it says otherwise a value describes the last few seconds.
 */
public final class NetStats {
  private static final int LOSS_WINDOW = 256;
  private static final int SETTLED = 16;
  private static final long SECOND = 1_000_000_000L;

  final Series rtt = new Series();
  final Series snapshotBytes = new Series();
  final Series gap = new Series();
  final Series margin = new Series();
  final Series correction = new Series();
  final Series replay = new Series();

  private final float[] scratch = new float[Series.CAPACITY];
  private final IntCountsHistogram gapsUs = new IntCountsHistogram(60_000_000L, 2);
  private final IntCountsHistogram rttUs = new IntCountsHistogram(60_000_000L, 2);

  private boolean sequenced;
  private int settled;
  private final boolean[] received = new boolean[LOSS_WINDOW];
  private int window;

  private long playingSinceNs;
  private long playedNs;
  private boolean playing;
  private long lastSnapshotNs;
  private long snapshots;
  private long bytesIn;
  private long bytesOut;
  private long playingBytesIn;
  private long playingBytesOut;
  private long rateSinceNs;
  private long rateBytesIn;
  private long rateBytesOut;
  private long rateSnapshots;
  private double kbitIn;
  private double kbitOut;
  private double snapshotRate;

  private long compared;
  private long exact;
  private long awakeBodies;
  private int nearBodies;
  private long disagreements;
  private long exactBodies;
  private long rollbacks;
  private long rollbackTicks;
  private int longestRollback;
  private long cutShort;
  private long syncErrors;
  private long corrections;
  private double correctionMetres;
  private double largestCorrection;
  private double interpolationDelayMs;
  private double jitterMs;
  private double targetMargin;
  private double clockSpeed = 1;
  long events;
  long eventsRetracted;
  long eventsMissed;
  int malformed;
  int reconnects;

  NetStats() {}

  // ---- written by the client

  void bytesIn(int bytes) {
    bytesIn += bytes;
    if (playing) {
      playingBytesIn += bytes;
    }
  }

  void bytesOut(int bytes) {
    bytesOut += bytes;
    if (playing) {
      playingBytesOut += bytes;
    }
  }

  void playing(boolean now, long nowNs) {
    if (now && !playing) {
      playingSinceNs = nowNs;
      lastSnapshotNs = 0;
      sequenced = false;
      window = 0;
    } else if (!now && playing) {
      playedNs += nowNs - playingSinceNs;
    }
    playing = now;
  }

  void datagram(int bytes) {
    snapshotBytes.add(bytes);
  }

  /**
   * Takes in the acks as they are sent: what is {@link #SETTLED} behind is lost or never will be.
   */
  void acks(int sequence, long bits) {
    if (!sequenced) {
      sequenced = true;
      settled = sequence - 1;
      return;
    }
    int ahead = (short) (sequence - SETTLED - settled);
    for (int i = 0; i < ahead; i++) {
      settled++;
      int age = (short) (sequence - settled) - 1;
      received[window & (LOSS_WINDOW - 1)] = age < 64 && (bits >>> age & 1) != 0;
      window++;
    }
  }

  /** A snapshot of a new tick arrived. */
  void snapshot(long nowNs) {
    snapshots++;
    if (lastSnapshotNs != 0) {
      long gapNs = Math.max(0, nowNs - lastSnapshotNs);
      gap.add(gapNs / 1e6f);
      gapsUs.recordValue(Math.min(60_000_000L, gapNs / 1_000));
    }
    lastSnapshotNs = nowNs;
  }

  void roundTrip(double ms) {
    rtt.add((float) ms);
    rttUs.recordValue((long) Math.max(0, Math.min(60_000_000.0, ms * 1_000)));
  }

  void compared(boolean same, int awake, int right) {
    compared++;
    nearBodies = awake;
    if (same) {
      exact++;
    }
    awakeBodies += awake;
    exactBodies += right;
  }

  void rolledBack(int ticks, int replayed, long tookNs) {
    if (replayed == 0) {
      return;
    }
    rollbacks++;
    rollbackTicks += ticks;
    longestRollback = Math.max(longestRollback, ticks);
    replay.add(tookNs / 1e6f);
  }

  void disagreements(long count) {
    disagreements = count;
  }

  void syncErrors(long count) {
    syncErrors = count;
  }

  void cutShort(long count) {
    cutShort = count;
  }

  void corrected(double metres) {
    corrections++;
    correctionMetres += metres;
    largestCorrection = Math.max(largestCorrection, metres);
  }

  void clocks(TickClock clock, RenderClock renderClock, int tickRate) {
    targetMargin = clock.targetMargin();
    clockSpeed = clock.speed();
    jitterMs = renderClock.jitterMs();
    interpolationDelayMs = renderClock.delayTicks() * 1_000 / tickRate;
  }

  void roll(long nowNs) {
    if (rateSinceNs == 0) {
      rateSinceNs = nowNs;
    }
    long elapsed = nowNs - rateSinceNs;
    if (elapsed >= SECOND) {
      double seconds = elapsed / 1e9;
      kbitIn = (bytesIn - rateBytesIn) * 8 / 1_000.0 / seconds;
      kbitOut = (bytesOut - rateBytesOut) * 8 / 1_000.0 / seconds;
      snapshotRate = (snapshots - rateSnapshots) / seconds;
      rateSinceNs = nowNs;
      rateBytesIn = bytesIn;
      rateBytesOut = bytesOut;
      rateSnapshots = snapshots;
    }
  }

  // ---- read by everybody

  /** Median round trip, milliseconds; what the server held an input back is not counted. */
  public double rttMs() {
    return rtt.percentile(0.5, scratch);
  }

  /** Median round trip since the client was created, milliseconds. */
  public double rttP50Ms() {
    return rttUs.getTotalCount() == 0 ? 0 : rttUs.getValueAtPercentile(50) / 1_000.0;
  }

  /** Lateness of snapshots that 95 % stay below, milliseconds. */
  public double jitterMs() {
    return jitterMs;
  }

  /** Snapshot datagrams lost, percent of the last {@value #LOSS_WINDOW}. */
  public double lossPercent() {
    int considered = Math.min(window, LOSS_WINDOW);
    if (considered == 0) {
      return 0;
    }
    int lost = 0;
    for (int i = 0; i < considered; i++) {
      if (!received[i]) {
        lost++;
      }
    }
    return 100.0 * lost / considered;
  }

  /** Mean size of a snapshot datagram, bytes. */
  public double snapshotBytes() {
    return snapshotBytes.mean();
  }

  /** Snapshots (ticks, not datagrams) received in the last second. */
  public double snapshotsPerSecond() {
    return snapshotRate;
  }

  /** Snapshots received since the client was created. */
  public long snapshots() {
    return snapshots;
  }

  /** Seconds in which the client was playing. */
  public double playedSeconds(long nowNs) {
    return (playedNs + (playing ? nowNs - playingSinceNs : 0)) / 1e9;
  }

  /** Payload received while playing, bytes: datagrams and reliable messages. */
  public long playingBytesIn() {
    return playingBytesIn;
  }

  /** Payload sent while playing, bytes: datagrams and reliable messages. */
  public long playingBytesOut() {
    return playingBytesOut;
  }

  /** Time between snapshots that 99 % stay below, milliseconds, since the client was created. */
  public double gapP99Ms() {
    return gapsUs.getTotalCount() == 0 ? 0 : gapsUs.getValueAtPercentile(99) / 1_000.0;
  }

  /** Inputs that waited at the server when it consumed one, in ticks; negative = too late. */
  public double inputMargin() {
    return margin.newest();
  }

  /** Input margin the clock aims at, in ticks. */
  public double targetMargin() {
    return targetMargin;
  }

  /** Speed of the client's clock; 1 = the server's. */
  public double clockSpeed() {
    return clockSpeed;
  }

  /** How far in the past others are drawn, milliseconds. */
  public double interpolationDelayMs() {
    return interpolationDelayMs;
  }

  /** Predictions of the own body that were corrected, per minute of play. */
  public double correctionsPerMinute(long nowNs) {
    double seconds = playedSeconds(nowNs);
    return seconds <= 0 ? 0 : corrections * 60 / seconds;
  }

  /** Predictions of the own body that were corrected, since the client was created. */
  public long corrections() {
    return corrections;
  }

  /** Mean distance by which the own body was corrected, metres. */
  public double correctionMeanMetres() {
    return corrections == 0 ? 0 : correctionMetres / corrections;
  }

  /** Largest distance by which the own body was corrected, metres. */
  public double correctionMaxMetres() {
    return largestCorrection;
  }

  /** Share of compared predictions of the own body that were right in every bit, 0..1. */
  public double exactRate() {
    return compared == 0 ? 1 : (double) exact / compared;
  }

  /** Predictions of the own body compared with the server's state. */
  public long compared() {
    return compared;
  }

  /** Share of the bodies near and awake whose prediction was right in every bit, 0..1. */
  public double perfectRate() {
    return awakeBodies == 0 ? 1 : (double) exactBodies / awakeBodies;
  }

  /** Bodies near and awake whose prediction was compared with the server's state. */
  public long awakeBodies() {
    return awakeBodies;
  }

  /** Bodies near and awake at the last comparison, the own one included. */
  public int nearBodies() {
    return nearBodies;
  }

  /** Times since joining that what is near turned out otherwise than predicted. */
  public long disagreements() {
    return disagreements;
  }

  /** Those of {@link #awakeBodies} that were right in every bit. */
  public long exactBodies() {
    return exactBodies;
  }

  /** Times the prediction went back and came again, since the client was created. */
  public long rollbacks() {
    return rollbacks;
  }

  /** Mean length of a rollback, ticks. */
  public double rollbackMeanTicks() {
    return rollbacks == 0 ? 0 : (double) rollbackTicks / rollbacks;
  }

  /** Longest rollback, ticks. */
  public int rollbackMaxTicks() {
    return longestRollback;
  }

  /** Replays that were too long or took too long, so that ticks were left out. */
  public long replaysCutShort() {
    return cutShort;
  }

  /** Events fired, since the client was created: hits, goals, jumps. */
  public long events() {
    return events;
  }

  /** Events that were foreseen, fired, and taken back, since the client was created. */
  public long eventsRetracted() {
    return eventsRetracted;
  }

  /** Events of this visit that were lost because too many waited at the server. */
  public long eventsMissed() {
    return eventsMissed;
  }

  /** Ticks in which the synctest found another hash; 0 unless the simulation has a fault. */
  public long syncErrors() {
    return syncErrors;
  }

  /** Time that replays took, milliseconds, the newest of them. */
  public double replayP95Ms() {
    return replay.percentile(0.95, scratch);
  }

  /** Times that replays took, milliseconds. */
  public Series replaySeries() {
    return replay;
  }

  /** Payload received, kbit/s in the last second. */
  public double kbitInPerSecond() {
    return kbitIn;
  }

  /** Payload sent, kbit/s in the last second. */
  public double kbitOutPerSecond() {
    return kbitOut;
  }

  /** Payload bytes received since the client was created. */
  public long bytesIn() {
    return bytesIn;
  }

  /** Payload bytes sent since the client was created. */
  public long bytesOut() {
    return bytesOut;
  }

  /** Datagrams that could not be decoded. */
  public int malformed() {
    return malformed;
  }

  /** Times the link was lost and came back. */
  public int reconnects() {
    return reconnects;
  }

  /** Round trips, milliseconds. */
  public Series rttSeries() {
    return rtt;
  }

  /** Sizes of snapshot datagrams, bytes. */
  public Series snapshotBytesSeries() {
    return snapshotBytes;
  }

  /** Times between snapshots, milliseconds. */
  public Series gapSeries() {
    return gap;
  }

  /** Input margins, ticks. */
  public Series marginSeries() {
    return margin;
  }

  /** Distances by which the own body was corrected, metres, one value per snapshot; 0 = exact. */
  public Series correctionSeries() {
    return correction;
  }
}
