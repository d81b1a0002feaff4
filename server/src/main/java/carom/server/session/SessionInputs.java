package carom.server.session;

import carom.net.codec.Sequence;
import carom.net.protocol.InputDatagram;
import carom.net.snapshot.InputFeedback;
import carom.net.snapshot.frame.WaitingInputs;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.replication.SessionReplication;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;

/**
 * The way of one player's inputs from datagrams to ticks, and the feedback on it that snapshots
 * carry. The room's thread; no allocation.
 *
 * <pre>
 *   receive ──► InputBuffer ──► consume ──► Player
 *      │            └─────────► showWaiting ──► clients of players near
 *      ├──► feedback ──► snapshot
 *      └──► acknowledgements, confirmed inputs ──► SessionReplication
 * </pre>
 */
final class SessionInputs {
  private static final long NS_PER_MS = 1_000_000;
  private static final long NEUTRAL = new Input().pack();
  private static final int MAX_HOLD_MS = 255;
  private static final int MIN_MARGIN = -32;
  private static final int MAX_MARGIN = 31;

  private final Counters counters;
  private final InputBuffer buffer;
  private final InputDatagram datagram = new InputDatagram();
  private final InputFeedback feedback = new InputFeedback();

  /** Time at which the datagram arrived that the feedback is about. */
  private long arrivalNs;

  private int viewDelay;
  private long lastInput;
  private int idleTicks;
  private long missingCounted;
  private long lateCounted;
  private long earlyCounted;

  /** Creates the inputs of a session that none has arrived for. */
  SessionInputs(ServerConfig config, Counters counters) {
    this.counters = counters;
    int holdTicks = Input.holdTicks(config.get(ServerConfig.TICK_RATE));
    buffer = new InputBuffer(config.get(ServerConfig.INPUT_WINDOW_TICKS), holdTicks);
  }

  /**
   * Begins with a link.
   *
   * @param tick the room's last tick: inputs for later ones are welcome
   */
  void begin(int tick) {
    buffer.reset(tick);
    viewDelay = 0;
    feedback.present = false;
    idleTicks = 0;
  }

  /**
   * Takes a datagram.
   *
   * @param epoch that of the link
   * @param receivedNs when it arrived
   * @param replication is told what the client has and predicts
   * @return false if it is none of this link
   */
  boolean receive(
      byte[] bytes, int length, int epoch, long receivedNs, SessionReplication replication) {
    if (!datagram.decode(bytes, 0, length) || datagram.epoch != epoch) {
      return false;
    }
    if (!feedback.present || Sequence.isNewer(datagram.sequence, feedback.sequence)) {
      feedback.present = true;
      feedback.sequence = datagram.sequence;
      arrivalNs = receivedNs;
      if (datagram.count > 0) {
        viewDelay = datagram.viewDelay;
      }
      replication.receivePrediction(datagram);
    }
    if (datagram.hasAck) {
      replication.receiveAck(datagram.ackSequence, datagram.ackBits);
    }
    for (int i = datagram.count - 1; i >= 0; i--) { // oldest first
      int tick = datagram.newestTick - i;
      if (buffer.offer(tick, datagram.inputs[i]) == InputBuffer.Arrival.CONFIRMED) {
        replication.confirmInput(tick);
      }
    }
    if (datagram.count > 0) {
      buffer.hold(datagram.newestTick, datagram.inputs[0], datagram.holdTicks);
    }
    return true;
  }

  /** Sets a player's input for a tick, which must be the one after the last consumed. */
  void consume(int tick, HostPlayer player) {
    long input = buffer.consume(tick);
    idleTicks++;
    if (!buffer.lastWasMissing() && input != lastInput) {
      lastInput = input;
      idleTicks = 0;
    }
    player.viewDelay(player.isSpectator() ? 0 : viewDelay);
    player.input().unpack(player.isSpectator() ? NEUTRAL : input);
    feedback.margin = Math.max(MIN_MARGIN, Math.min(MAX_MARGIN, buffer.arrivalMarginTicks()));
    count();
  }

  /** Sets the input of a thin client's player, for which the newest counts, whenever it came. */
  void consumeNewest(long input, HostPlayer player) {
    idleTicks++;
    if (input != lastInput) {
      lastInput = input;
      idleTicks = 0;
    }
    player.viewDelay(0);
    player.input().unpack(player.isSpectator() ? NEUTRAL : input);
    counters.add(Counter.INPUTS_DUE, 1);
  }

  private void count() {
    counters.add(Counter.INPUTS_DUE, 1);
    if (buffer.missing() != missingCounted) {
      counters.add(Counter.INPUTS_MISSING, buffer.missing() - missingCounted);
      missingCounted = buffer.missing();
    }
    if (buffer.tooLate() != lateCounted) {
      counters.add(Counter.INPUTS_LATE, buffer.tooLate() - lateCounted);
      lateCounted = buffer.tooLate();
    }
    if (buffer.tooEarly() != earlyCounted) {
      counters.add(Counter.INPUTS_EARLY, buffer.tooEarly() - earlyCounted);
      earlyCounted = buffer.tooEarly();
    }
  }

  /** Adds the inputs of a player that wait for the next ticks. */
  void showWaiting(int playerId, WaitingInputs to) {
    int tick = buffer.lastConsumedTick() + 1;
    while (buffer.isWaiting(tick) && to.add(playerId, buffer.waiting(tick))) {
      tick++;
    }
  }

  /** Returns whether the input of the last tick had arrived before it. */
  boolean wasInTime() {
    return !buffer.lastWasMissing() && !buffer.lastWasHeld();
  }

  /** Returns whether the newest input came after its tick. */
  boolean areLate() {
    return feedback.margin < 0;
  }

  /**
   * Returns the feedback for a snapshot.
   *
   * @param timeNs when it is sent
   * @return valid until the next call of this object
   */
  InputFeedback feedback(long timeNs) {
    long holdMs = (timeNs - arrivalNs) / NS_PER_MS;
    feedback.holdMs = (int) Math.max(0, Math.min(MAX_HOLD_MS, holdMs));
    return feedback;
  }

  /** Returns how many ticks were consumed since the input last changed. */
  int idleTicks() {
    return idleTicks;
  }

  /** Returns the inputs between arrival and use. */
  InputBuffer buffer() {
    return buffer;
  }
}
