package carom.client.stats;

/**
 * Figures about a connection and its predictions, for a net graph, a status line or a test. Read it
 * on the client's thread.
 *
 * <p>A figure describes the last few seconds unless its comment says otherwise.
 */
public final class NetStats {
  private final TrafficRecorder traffic;
  private final PredictionRecorder prediction;
  private final NetStatsRecorder recorder;
  private final float[] scratch = new float[RecentValues.CAPACITY];

  NetStats(NetStatsRecorder recorder) {
    this.recorder = recorder;
    traffic = recorder.traffic;
    prediction = recorder.prediction;
  }

  // ---- the link

  /** Returns the median round trip, milliseconds, without the time the server held inputs back. */
  public double rttMs() {
    return traffic.roundTrips.percentile(0.5, scratch);
  }

  /** Returns the median round trip since the client was created, milliseconds. */
  public double rttP50Ms() {
    return traffic.roundTripsUs.getTotalCount() == 0
        ? 0
        : traffic.roundTripsUs.getValueAtPercentile(50) / 1_000.0;
  }

  /** Returns the lateness that 95 % of the snapshots stay below, milliseconds. */
  public double jitterMs() {
    return recorder.jitterMs;
  }

  /** Returns the lost snapshot datagrams, percent of the last 256. */
  public double lossPercent() {
    return traffic.loss.percent();
  }

  /** Returns the mean size of a snapshot datagram, bytes. */
  public double snapshotBytes() {
    return traffic.snapshotBytes.mean();
  }

  /** Returns how many snapshots (ticks, not datagrams) arrived in the last second. */
  public double snapshotsPerSecond() {
    return traffic.snapshotsPerSecond;
  }

  /** Returns how many snapshots arrived since the client was created. */
  public long snapshots() {
    return traffic.snapshots;
  }

  /** Returns the time in which the client was playing, seconds. */
  public double playedSeconds(long nowNs) {
    return traffic.playedSeconds(nowNs);
  }

  /** Returns the payload received while playing, bytes: datagrams and reliable messages. */
  public long playingBytesIn() {
    return traffic.playingBytesIn;
  }

  /** Returns the payload sent while playing, bytes: datagrams and reliable messages. */
  public long playingBytesOut() {
    return traffic.playingBytesOut;
  }

  /** Returns the time between snapshots that 99 % stay below since the start, milliseconds. */
  public double gapP99Ms() {
    return traffic.gapsUs.getTotalCount() == 0
        ? 0
        : traffic.gapsUs.getValueAtPercentile(99) / 1_000.0;
  }

  /** Returns the payload received in the last second, kbit/s. */
  public double kbitInPerSecond() {
    return traffic.kbitInPerSecond;
  }

  /** Returns the payload sent in the last second, kbit/s. */
  public double kbitOutPerSecond() {
    return traffic.kbitOutPerSecond;
  }

  /** Returns the payload received since the client was created, bytes. */
  public long bytesIn() {
    return traffic.bytesIn;
  }

  /** Returns how many datagrams could not be decoded since the client was created. */
  public int malformed() {
    return traffic.malformed;
  }

  /** Returns how often the link was lost and came back since the client was created. */
  public int reconnects() {
    return traffic.reconnects;
  }

  /** Returns how often a lost link came back without the session, so that the player began anew. */
  public int sessionsLost() {
    return traffic.sessionsLost;
  }

  /** Returns how often a server has sent the client to another one. */
  public int redirects() {
    return traffic.redirects;
  }

  /** Returns how many ticks that the client has seen never happened, as a server was lost. */
  public int ticksLost() {
    return traffic.ticksLost;
  }

  /** Returns whether datagrams go over TCP now, because UDP is blocked. */
  public boolean isOverTcp() {
    return traffic.overTcp;
  }

  // ---- the clocks

  /** Returns the inputs that waited when the server consumed one, ticks; negative = too late. */
  public double inputMargin() {
    return recorder.margins.newest();
  }

  /** Returns the input margin that the clock aims at, ticks. */
  public double targetMargin() {
    return recorder.targetMargin;
  }

  /** Returns the speed of the client's clock; 1 = the server's. */
  public double clockSpeed() {
    return recorder.clockSpeed;
  }

  /** Returns whether the server is too busy to tell of more than what is shown. */
  public boolean viewsNarrow() {
    return recorder.viewsNarrow;
  }

  /** Returns how far in the past interpolated entities are drawn, milliseconds. */
  public double interpolationDelayMs() {
    return recorder.interpolationDelayMs;
  }

  // ---- the prediction

  /** Returns how often the own body was corrected per minute of play. */
  public double correctionsPerMinute(long nowNs) {
    double seconds = playedSeconds(nowNs);
    return seconds <= 0 ? 0 : prediction.correctionCount * 60 / seconds;
  }

  /** Returns how often the own body was corrected since the client was created. */
  public long corrections() {
    return prediction.correctionCount;
  }

  /**
   * Returns how often the own body was shifted in the present by more than a millimetre: because it
   * had been predicted wrong, or because the game's rules did something to it.
   */
  public long shifts() {
    return prediction.shifts;
  }

  /** Returns how often inputs came that differ from those that were predicted in their place. */
  public long otherInputs() {
    return prediction.otherInputs;
  }

  /** Returns how often word came of what the game's rules did in ticks that were predicted. */
  public long rulings() {
    return prediction.rulings;
  }

  /** Returns the mean distance of all corrections of the own body, metres. */
  public double correctionMeanMetres() {
    return prediction.correctionCount == 0
        ? 0
        : prediction.correctionMetres / prediction.correctionCount;
  }

  /** Returns the largest distance of all corrections of the own body, metres. */
  public double correctionMaxMetres() {
    return prediction.largestCorrection;
  }

  /** Returns the share of compared predictions of the own body that were exact, 0..1. */
  public double exactRate() {
    return prediction.compared == 0 ? 1 : (double) prediction.exact / prediction.compared;
  }

  /** Returns how many predictions of the own body were compared with the server's state. */
  public long compared() {
    return prediction.compared;
  }

  /** Returns the share of {@link #awakeBodies} whose prediction was exact, 0..1. */
  public double perfectRate() {
    return prediction.awakeBodies == 0
        ? 1
        : (double) prediction.exactBodies / prediction.awakeBodies;
  }

  /** Returns how many predictions of awake bodies were compared with the server's state. */
  public long awakeBodies() {
    return prediction.awakeBodies;
  }

  /** Returns how many of {@link #awakeBodies} were right in every bit. */
  public long exactBodies() {
    return prediction.exactBodies;
  }

  /**
   * Returns how many predictions of awake bodies were otherwise than the server's state because of
   * what the game's rules did, and right with what the server told of that. They don't count in
   * {@link #awakeBodies}.
   */
  public long toldBodies() {
    return prediction.toldBodies;
  }

  /** Returns the awake bodies of the predicted set at the last comparison, own one included. */
  public int nearBodies() {
    return prediction.nearBodies;
  }

  /** Returns how often the predicted set differed from the server's since joining. */
  public long disagreements() {
    return prediction.disagreements;
  }

  /** Returns how many rollbacks there were since the client was created. */
  public long rollbacks() {
    return prediction.rollbacks;
  }

  /** Returns the mean length of all rollbacks, ticks. */
  public double rollbackMeanTicks() {
    return prediction.rollbacks == 0 ? 0 : (double) prediction.rollbackTicks / prediction.rollbacks;
  }

  /** Returns how many replays left out ticks because they were too long or took too long. */
  public long replaysCutShort() {
    return prediction.replaysCutShort;
  }

  /** Returns the time of a replay that 95 % stay below, milliseconds. */
  public double replayP95Ms() {
    return prediction.replays.percentile(0.95, scratch);
  }

  /** Returns how many sync tests failed; 0 unless the simulation has a fault. */
  public long syncErrors() {
    return prediction.syncErrors;
  }

  // ---- events

  /** Returns how many predicted events were retracted since the client was created. */
  public long eventsRetracted() {
    return recorder.eventsRetracted;
  }

  /** Returns how many events of this visit were lost because the server's queue was full. */
  public long eventsMissed() {
    return recorder.eventsMissed;
  }

  // ---- graphs

  /** Returns recent sizes of snapshot datagrams, bytes. */
  public RecentValues snapshotBytesSeries() {
    return traffic.snapshotBytes;
  }

  /** Returns recent times between snapshots, milliseconds. */
  public RecentValues gapSeries() {
    return traffic.gaps;
  }

  /** Returns recent input margins, ticks. */
  public RecentValues marginSeries() {
    return recorder.margins;
  }

  /** Returns recent corrections of the own body, metres, one per snapshot; 0 = exact. */
  public RecentValues correctionSeries() {
    return prediction.corrections;
  }
}
