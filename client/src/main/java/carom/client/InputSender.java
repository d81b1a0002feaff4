package carom.client;

import carom.client.clock.TickClock;
import carom.client.link.Connection;
import carom.client.prediction.Prediction;
import carom.client.stats.NetStatsRecorder;
import carom.net.protocol.InputDatagram;
import carom.net.protocol.ProtocolLimits;
import carom.net.snapshot.InputFeedback;
import carom.net.snapshot.SnapshotDecoder;
import carom.sim.entity.HostPlayer;
import java.util.Arrays;

/**
 * Sends the player's inputs, and the acknowledgements of snapshots with them, no more often than
 * they tell something new. Learns from the server's feedback which inputs have arrived. One stay's;
 * one thread; allocates nothing per tick.
 *
 * <p>An input that doesn't change is sent as "holds for the next ticks". Once the server knows
 * that, a few datagrams per second suffice.
 */
final class InputSender {
  private static final int RING = 256;
  private static final int MASK = RING - 1;

  /** Datagrams per second while the input holds and there is nothing to acknowledge. */
  private static final int QUIET_PER_SECOND = 4;

  /** Quiet intervals for which an input holds, so that a lost datagram changes nothing. */
  private static final int HOLD_INTERVALS = 3;

  /** Quiet intervals without a snapshot after which the server counts as silent. */
  private static final double SILENT_INTERVALS = 1.5;

  private final int tickRate;
  private final int ticksPerDatagram;
  private int near;
  private final int epoch;
  private final SnapshotDecoder decoder;
  private Prediction prediction;
  private final NetStatsRecorder stats;
  private final Connection connection;
  private final InputHistory inputs = new InputHistory();
  private final InputDatagram datagram = new InputDatagram();
  private final byte[] buffer = new byte[InputDatagram.MAX_BYTES];

  // The last datagrams, by sequence number.
  private final long[] sentNs = new long[RING];
  private final int[] sentTick = new int[RING];
  private final int[] sentSequence = new int[RING];
  private final int[] sentHold = new int[RING];
  private int sequence;

  private int lastSentTick;
  private int lastHeardTick;
  private int feedbackSequence = -1;
  private boolean hasNewAck;

  /** Newest tick whose input the server has. */
  private int ackedTick;

  /** Newest tick whose input the server knows to hold; later ones may be known, too. */
  private int heldTick = -1;

  /**
   * Creates a sender for one stay.
   *
   * @param config how many ticks a datagram has, and what is predicted
   * @param epoch as in {@code Welcome}
   * @param prediction or null
   */
  InputSender(
      ClientConfig config,
      int epoch,
      int tickRate,
      SnapshotDecoder decoder,
      Prediction prediction,
      NetStatsRecorder stats,
      Connection connection) {
    this.epoch = epoch;
    this.tickRate = tickRate;
    this.decoder = decoder;
    this.prediction = prediction;
    this.stats = stats;
    this.connection = connection;
    ticksPerDatagram = config.get(ClientConfig.TICKS_PER_INPUT_DATAGRAM);
    near =
        prediction == null ? InputDatagram.NEAR_NONE : config.get(ClientConfig.PREDICTION).near();
    Arrays.fill(sentSequence, -1);
  }

  /**
   * Adds the input of a tick; {@link #sendIfDue} sends it.
   *
   * @param lastTick the tick before, or before a jump of the clock
   */
  void add(int tick, long packed, int lastTick) {
    if (inputs.firstTick() < 0) {
      ackedTick = tick - 1;
    }
    inputs.add(tick, packed, lastTick);
  }

  /**
   * Sends a datagram if there is something to tell.
   *
   * @param tick newest tick with an input
   * @param ticksBehind how far the interpolated picture is behind that tick
   */
  void sendIfDue(int tick, double ticksBehind, long nowNs) {
    if (tick % ticksPerDatagram == 0 && isWorthSending(tick)) {
      send(tick, ticksBehind, nowNs);
    }
  }

  /**
   * Returns whether there is something to tell. New inputs, new acknowledgements and mispredictions
   * are sent at once. A silent server gets a datagram in each tick, because losses come in bursts
   * and a rare datagram would be cut off for long. So does one that receives inputs too late.
   */
  private boolean isWorthSending(int tick) {
    boolean known = heldTick >= inputs.steadyTick();
    boolean silent = tick - lastHeardTick > SILENT_INTERVALS * quietTicks();
    boolean late = stats.stats().inputMargin() < 0;
    return !known
        || hasNewAck
        || disagrees()
        || silent
        || late
        || tick - lastSentTick >= quietTicks();
  }

  /** Tells the server from now on that nothing is predicted. */
  void stopPredicting() {
    prediction = null;
    near = InputDatagram.NEAR_NONE;
  }

  private boolean disagrees() {
    return prediction != null && prediction.agreement().disagreedTick() >= 0;
  }

  private int quietTicks() {
    return Math.max(1, tickRate / QUIET_PER_SECOND);
  }

  private void send(int tick, double ticksBehind, long nowNs) {
    datagram.epoch = epoch;
    datagram.sequence = sequence;
    datagram.hasAck = decoder.hasAck();
    datagram.ackSequence = decoder.hasAck() ? decoder.ackSequence() : 0;
    datagram.ackBits = decoder.hasAck() ? decoder.ackBits() : 0;
    datagram.near = near;
    datagram.disagrees = disagrees();
    datagram.disagreedTick =
        datagram.disagrees ? prediction.agreement().disagreedTick() & 0xffff : 0;
    datagram.newestTick = tick;
    datagram.viewDelay = viewDelay(ticksBehind);
    boolean holds = ackedTick >= inputs.steadyTick();
    datagram.holdTicks =
        holds ? Math.min(InputDatagram.MAX_HOLD_TICKS, HOLD_INTERVALS * quietTicks()) : 0;
    int available = tick - inputs.firstTick() + 1;
    int pending = Math.min(tick - ackedTick, available);
    int least = Math.min(ticksPerDatagram, available);
    datagram.count = Math.max(least, Math.min(ProtocolLimits.MAX_INPUTS, pending));
    for (int i = 0; i < datagram.count; i++) {
      datagram.inputs[i] = inputs.at(tick - i);
    }
    int length = datagram.encode(buffer, 0);
    int slot = sequence & MASK;
    sentNs[slot] = nowNs;
    sentTick[slot] = tick;
    sentSequence[slot] = sequence;
    sentHold[slot] = datagram.holdTicks;
    lastSentTick = tick;
    hasNewAck = false;
    sequence = (sequence + 1) & 0xffff;
    connection.sendDatagram(buffer, length);
  }

  /** Converts a delay into the units of the protocol, sixteenths of a tick. */
  private static int viewDelay(double ticks) {
    long steps = Math.round(ticks * HostPlayer.VIEW_STEPS);
    return (int) Math.max(0, Math.min(InputDatagram.MAX_VIEW_DELAY, steps));
  }

  /**
   * Notes that a snapshot arrived.
   *
   * @param tick the client's present tick
   * @param hasNews whether it has content to acknowledge
   */
  void heard(int tick, boolean hasNews) {
    lastHeardTick = tick;
    hasNewAck |= hasNews;
  }

  /**
   * Takes in what the server says about the inputs it received.
   *
   * @param serverTick tick of the snapshot
   * @param arrivedNs when it arrived
   * @param clock is steered by the input margin
   */
  void receive(InputFeedback feedback, int serverTick, long arrivedNs, TickClock clock) {
    int slot = feedback.sequence & MASK;
    if (sentSequence[slot] != feedback.sequence) {
      return;
    }
    boolean newer = feedbackSequence < 0 || (short) (feedback.sequence - feedbackSequence) > 0;
    if (newer) {
      feedbackSequence = feedback.sequence;
      ackedTick = Math.max(ackedTick, sentTick[slot]);
      heldTick = sentHold[slot] > 0 ? Math.max(heldTick, sentTick[slot]) : heldTick;
      if (feedback.holdMs < 255) {
        stats.roundTrip(Math.max(0, (arrivedNs - sentNs[slot]) / 1e6 - feedback.holdMs));
      }
    }
    if (prediction != null && sentTick[slot] < serverTick) {
      prediction.missed(serverTick, sentTick[slot], sentHold[slot]);
    }
    boolean clamped = feedback.margin <= -32 || feedback.margin >= 31;
    int margin = clamped ? sentTick[slot] - serverTick : feedback.margin;
    stats.inputMargin(margin);
    clock.report(sentTick[slot] - margin, margin); // the tick consumed when the input arrived
  }
}
