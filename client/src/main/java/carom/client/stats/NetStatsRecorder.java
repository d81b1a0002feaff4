package carom.client.stats;

import carom.client.clock.RenderClock;
import carom.client.clock.TickClock;
import carom.client.prediction.Prediction;

/** Records what {@link NetStats} shows. Written by one client; one thread. */
public final class NetStatsRecorder {
  final TrafficRecorder traffic = new TrafficRecorder();
  final PredictionRecorder prediction = new PredictionRecorder();
  final RecentValues margins = new RecentValues();

  double interpolationDelayMs;
  double jitterMs;
  double targetMargin;
  double clockSpeed = 1;
  boolean viewsNarrow;
  long eventsRetracted;
  long eventsMissed;

  private final NetStats stats = new NetStats(this);

  /** Creates a recorder in which nothing has happened. */
  public NetStatsRecorder() {}

  /** Returns the figures to read; the same object for ever. */
  public NetStats stats() {
    return stats;
  }

  /** Adds payload bytes that the link carried. */
  public void bytes(int in, int out) {
    traffic.bytes(in, out);
  }

  /** Notes that playing begins or ends. */
  public void playing(boolean now, long nowNs) {
    traffic.playing(now, nowNs);
  }

  /** Notes that a lost link came back. */
  public void reconnected() {
    traffic.reconnects++;
  }

  /** Notes that a lost link came back without the session: the player has begun anew. */
  public void sessionLost() {
    traffic.sessionsLost++;
  }

  /** Notes that the server has sent the client to another one. */
  public void redirected() {
    traffic.redirects++;
  }

  /** Notes that ticks which the client has seen never happened, as a server was lost. */
  public void ticksLost(int ticks) {
    traffic.ticksLost += ticks;
  }

  /** Notes whether datagrams go over TCP now, because UDP is blocked. */
  public void overTcp(boolean now) {
    traffic.overTcp = now;
  }

  /** Notes a snapshot datagram and the acknowledgement that it makes. */
  public void datagram(int bytes, int ackSequence, long ackBits) {
    traffic.snapshotBytes.add(bytes);
    traffic.loss.acks(ackSequence, ackBits);
  }

  /** Notes a datagram that could not be decoded. */
  public void malformed() {
    traffic.malformed++;
  }

  /** Notes the first datagram of a snapshot. */
  public void snapshot(long arrivedNs) {
    traffic.snapshot(arrivedNs);
  }

  /** Notes a round trip, milliseconds. */
  public void roundTrip(double ms) {
    traffic.roundTrip(ms);
  }

  /** Notes how many ticks of inputs waited at the server. */
  public void inputMargin(int ticks) {
    margins.add(ticks);
  }

  /** Adds the result of a reconciliation. */
  public void reconciled(Prediction predicted) {
    prediction.reconciled(predicted);
  }

  /** Notes where the clocks stand. */
  public void clocks(TickClock clock, RenderClock renderClock, double tickRate, double pace) {
    targetMargin = clock.targetMargin();
    clockSpeed = clock.speed() * pace;
    jitterMs = renderClock.jitterMs();
    interpolationDelayMs = renderClock.delayTicks() * 1_000 / (tickRate * pace);
  }

  /** Sets whether the server is too busy to tell of more than what is shown. */
  public void viewsNarrow(boolean narrow) {
    viewsNarrow = narrow;
  }

  /** Notes an event that was retracted. */
  public void eventRetracted() {
    eventsRetracted++;
  }

  /** Sets how many events of this visit were lost. */
  public void eventsMissed(long count) {
    eventsMissed = count;
  }

  /** Lets time pass for rates per second; once per update. */
  public void roll(long nowNs) {
    traffic.roll(nowNs);
  }
}
