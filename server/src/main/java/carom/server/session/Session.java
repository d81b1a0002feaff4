package carom.server.session;

import carom.net.codec.Sequence;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.InputDatagram;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.snapshot.InputFeedback;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.WaitingInputs;
import carom.net.transport.Broadcast;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.physics.BodyContactVisitor;
import carom.physics.BodyType;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.metrics.LogInterval;
import carom.server.replication.FrameCapture;
import carom.server.replication.NearSet;
import carom.server.replication.OwnCapture;
import carom.server.replication.SnapshotSender;
import carom.sim.Entity;
import carom.sim.Player;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One player in a room: the state of the session, its link while there is one, its input buffer and
 * its snapshots. Lives from Ready until the player leaves or the grace period ends; a resumed
 * session keeps this object and gets a new link.
 *
 * <p>What a client sends can change this object only: a wrong message asks the room to expel the
 * session, a wrong datagram is counted and forgotten, because anybody can forge a datagram.
 *
 * <p>Owned by the room's thread. Polling and sending in the steady state allocate nothing.
 */
public final class Session implements LinkHandler {
  /** Most messages and datagrams taken from one link per poll; the rest waits for the next. */
  public static final int MAX_POLL = 64;

  private static final Logger LOG = LoggerFactory.getLogger(Session.class);
  private static final long NS_PER_MS = 1_000_000;
  private static final int MAX_HOLD_MS = 255;
  private static final int MIN_MARGIN = -32;
  private static final int MAX_MARGIN = 31;

  /** What the client asked for, for the room to do at the next tick. */
  public enum Wish {
    /** Nothing special. */
    STAY,
    /** The player goes. */
    LEAVE,
    /** The client broke the protocol. */
    EXPEL
  }

  private final Seats.Seat seat;
  private final Player player;
  private final ServerConfig config;
  private final Counters counters;
  private final FrameCapture frames;
  private final OwnCapture capture;
  private int near;
  private int disagreedTick = -1;
  private final InputBuffer inputs;
  private final InputDatagram datagram = new InputDatagram();
  private final InputFeedback feedback = new InputFeedback();
  private final OwnState own = new OwnState();
  private SessionState state = SessionState.LOADING;
  private Link link;
  private int datagramKey;
  private int viewDelay;
  private int consumedTick;

  // Of a client that predicts; null until it says that it does.
  private NearSet nearSet;
  private PredictionAudit audit;
  private NearAudit nearAudit;

  private boolean touched;
  private final BodyContactVisitor<Entity> touch =
      (other, normalX, normalY, impulse) -> touched |= other.type() != BodyType.STATIC;
  private final LogInterval divergenceLines = new LogInterval();
  private SnapshotSender sender;
  private long nowNs;
  private int silentTicks;
  private long sequenceArrivalNs;
  private long graceEndNs;
  private boolean linkLost;
  private String linkLostReason = "";
  private Wish wish = Wish.STAY;
  private String offence = "";
  private boolean knowsRoster;
  private long missingSeen;
  private long lateSeen;
  private long earlySeen;

  /**
   * Creates a session without a link, in {@link SessionState#LOADING}; {@link #attach} makes it
   * play.
   *
   * @param player the player in the room's simulation
   * @param frames the room's frames
   * @param capture reads the player's own section
   */
  public Session(
      Seats.Seat seat,
      Player player,
      ServerConfig config,
      FrameCapture frames,
      OwnCapture capture,
      Counters counters) {
    this.seat = seat;
    this.player = player;
    this.config = config;
    this.frames = frames;
    this.capture = capture;
    this.counters = counters;
    this.inputs = new InputBuffer(config.inputWindowTicks(), config.inputHoldTicks());
  }

  /**
   * Gives the session a link and lets it play; allowed while loading and in grace.
   *
   * @param newLink its inbox belongs to this session from now on
   * @param key first 32 bits of each input datagram of this link
   * @param tick the room's last tick: inputs for later ones are welcome
   */
  public void attach(Link newLink, int key, int tick) {
    state = state.become(SessionState.PLAYING);
    link = newLink;
    datagramKey = key;
    SnapshotSender before = sender;
    sender = new SnapshotSender(frames, player, key, config, counters);
    if (before != null) {
      sender.takeOver(before);
    }
    nearSet = null;
    if (audit != null) {
      audit.clear();
      nearAudit.clear();
    }
    near = InputDatagram.NEAR_NONE;
    disagreedTick = -1;
    inputs.reset(tick);
    viewDelay = 0;
    feedback.present = false;
    feedback.consumedTick = tick;
    silentTicks = 0;
    linkLost = false;
    linkLostReason = "";
    wish = Wish.STAY;
    knowsRoster = false;
  }

  /**
   * Takes the link away and begins the grace period; the player's input turns neutral.
   *
   * @return the link, now the caller's
   */
  public Link detach(long timeNs) {
    state = state.become(SessionState.GRACE);
    graceEndNs = timeNs + config.graceMs() * NS_PER_MS;
    Link old = link;
    link = null;
    player.input().clear();
    return old;
  }

  /**
   * Notes what the player would hear of while it is away, for its return; once per tick in grace.
   */
  public void listen() {
    sender.listen();
  }

  /** Ends the session; returns its link, or null when it had none. */
  public Link end() {
    state = state.become(SessionState.CLOSED);
    Link old = link;
    link = null;
    sender = null;
    return old;
  }

  /** Takes what has arrived, at most {@link #MAX_POLL} messages and datagrams. */
  public int poll(long timeNs) {
    nowNs = timeNs;
    int work = link.poll(this, MAX_POLL);
    if (work == 0 && !linkLost && link.state() == Link.State.CLOSED) {
      closed(link, link.closeReason()); // while it changed hands, the lobby was told
    }
    return work;
  }

  @Override
  public void message(Link from, Object message) {
    if (from != link) {
      return;
    }
    silentTicks = 0;
    if (message instanceof ClientMessage.Leave) {
      wish = Wish.LEAVE;
    } else if (message instanceof ClientMessage.Look look) {
      sender.look(look.x(), look.y(), look.halfWidth(), look.halfHeight());
    } else if (message instanceof ClientMessage.Diverged report) {
      judge(report);
    } else if (message instanceof ClientMessage.DivergedNear report) {
      judgeNear(report);
    } else if (!(message instanceof ClientMessage.Ready) && wish == Wish.STAY) {
      wish = Wish.EXPEL;
      offence =
          message == null
              ? "an undecodable message"
              : message.getClass().getSimpleName() + " while playing";
    }
  }

  private void judge(ClientMessage.Diverged report) {
    counters.add(Counter.DIVERGENCES_REPORTED, 1);
    if (audit == null || audit.judge(report) != PredictionAudit.Verdict.UNEXPLAINED) {
      return;
    }
    if (unexplained()) {
      LOG.warn(
          "diverged: {} predicted tick {} otherwise, though equal at tick {} and alone since:{}",
          this,
          report.tick(),
          report.equalTick(),
          audit.describe(report));
    }
  }

  private void judgeNear(ClientMessage.DivergedNear report) {
    counters.add(Counter.DIVERGENCES_REPORTED, 1);
    if (audit == null
        || nearAudit.judge(report) != PredictionAudit.Verdict.UNEXPLAINED
        || !audit.isCertain(report.equalTick(), report.tick())) {
      return;
    }
    if (unexplained()) {
      LOG.warn(
          "diverged: {} predicted tick {} of what is near otherwise, though equal at tick {}:{}",
          this,
          report.tick(),
          report.equalTick(),
          nearAudit.describe(report));
    }
  }

  /** Counts a divergence; whether it may be logged, too. */
  private boolean unexplained() {
    counters.add(Counter.DIVERGENCES_UNEXPLAINED, 1);
    return divergenceLines.begins(nowNs);
  }

  /** What touched the body in the last step, see {@link PredictionAudit}. */
  private boolean isTouched() {
    touched = false;
    if (player.body() != null) {
      player.body().body().forEachContact(touch);
    }
    return touched;
  }

  @Override
  public void datagram(Link from, byte[] bytes, int length) {
    if (from != link) {
      return;
    }
    counters.add(Counter.BYTES_IN, length);
    if (!datagram.decode(bytes, 0, length) || datagram.key != datagramKey) {
      counters.add(Counter.DATAGRAMS_REFUSED, 1);
      return;
    }
    counters.add(Counter.DATAGRAMS_IN, 1);
    silentTicks = 0;
    if (!feedback.present || Sequence.isNewer(datagram.sequence, feedback.sequence)) {
      feedback.present = true;
      feedback.sequence = datagram.sequence;
      sequenceArrivalNs = nowNs - from.waitedNs();
      if (datagram.count > 0) {
        viewDelay = datagram.viewDelay;
      }
      near = datagram.near;
      if (datagram.disagrees) {
        disagreedTick = Sequence.expand(datagram.disagreedTick, frames.frames().newest().tick());
      }
    }
    if (datagram.hasAck) {
      sender.receiveAck(datagram.ackSequence, datagram.ackBits);
    }
    for (int i = datagram.count - 1; i >= 0; i--) { // oldest first
      int tick = datagram.newestTick - i;
      if (inputs.offer(tick, datagram.inputs[i]) == InputBuffer.Verdict.CONFIRMED
          && audit != null) {
        audit.confirmInput(tick);
      }
    }
    if (datagram.count > 0) {
      inputs.hold(datagram.newestTick, datagram.inputs[0], datagram.holdTicks);
    }
  }

  @Override
  public void closed(Link from, String reason) {
    if (from == link) {
      linkLost = true;
      linkLostReason = reason;
    }
  }

  /** Sets the player's input for a tick, which must be the one after the last consumed. */
  public void consumeInput(int tick) {
    if (state != SessionState.PLAYING) {
      player.input().clear();
      player.viewDelay(0);
      return;
    }
    consumedTick = tick;
    silentTicks++;
    player.viewDelay(viewDelay);
    player.input().unpack(inputs.consume(tick));
    if (!inputs.lastWasMissing()) {
      feedback.consumedTick = tick;
    }
    feedback.margin = Math.max(MIN_MARGIN, Math.min(MAX_MARGIN, inputs.arrivalMarginTicks()));
    countInputs();
  }

  /** Shows which inputs of the next ticks are here already, for the clients of those near. */
  public void showWaiting(WaitingInputs to) {
    int tick = inputs.lastConsumedTick() + 1;
    while (inputs.isWaiting(tick) && to.add(player.id(), inputs.waiting(tick))) {
      tick++;
    }
  }

  private void countInputs() {
    counters.add(Counter.INPUTS_DUE, 1);
    if (inputs.missing() != missingSeen) {
      counters.add(Counter.INPUTS_MISSING, inputs.missing() - missingSeen);
      missingSeen = inputs.missing();
    }
    if (inputs.tooLate() != lateSeen) {
      counters.add(Counter.INPUTS_LATE, inputs.tooLate() - lateSeen);
      lateSeen = inputs.tooLate();
    }
    if (inputs.tooEarly() != earlySeen) {
      counters.add(Counter.INPUTS_EARLY, inputs.tooEarly() - earlySeen);
      earlySeen = inputs.tooEarly();
    }
  }

  /**
   * Takes note of the tick for the player, and says whether it is time for a snapshot; call once
   * per tick while playing.
   */
  public boolean isSnapshotDue() {
    sender.tick();
    capture.capture(player, own);
    if (near != InputDatagram.NEAR_NONE && nearSet == null) {
      nearSet = capture.nearSet(sender::mayKnow);
      audit = audit == null ? new PredictionAudit() : audit;
      nearAudit = nearAudit == null ? new NearAudit() : nearAudit;
    }
    if (audit != null) {
      boolean certain = !inputs.lastWasMissing() && !inputs.lastWasHeld();
      boolean ruled = player.ruledTick() >= consumedTick;
      audit.keep(consumedTick, own, !certain, isTouched(), ruled);
    }
    if (nearSet == null) {
      own.near().clear();
      own.relayed().clear();
    } else if (near == InputDatagram.NEAR_NONE) {
      nearSet.captureNothing(own);
    } else {
      nearSet.acknowledge(sender.encoder());
      long updates = nearSet.updates();
      long disagreements = nearSet.disagreements();
      boolean all = near == InputDatagram.NEAR_ALL;
      nearSet.capture(player, all, disagreedTick, sender.nearBits(), own);
      counters.add(Counter.NEAR_UPDATES, nearSet.updates() - updates);
      counters.add(Counter.NEAR_DISAGREEMENTS, nearSet.disagreements() - disagreements);
      if (own.near().present()) {
        nearAudit.keep(consumedTick, nearSet.surprising());
      }
    }
    return sender.isDue(own, feedback.margin < 0);
  }

  /** Sends a snapshot of the newest frame, when it {@linkplain #isSnapshotDue is due}. */
  public void sendSnapshot(long timeNs) {
    long holdMs = (timeNs - sequenceArrivalNs) / NS_PER_MS;
    feedback.holdMs = (int) Math.max(0, Math.min(MAX_HOLD_MS, holdMs));
    sender.send(link, feedback, own);
    if (own.near().present()) {
      nearAudit.keepState(consumedTick, nearSet.state());
    }
    if (nearSet != null) {
      nearSet.sent();
    }
  }

  /**
   * Sends a message when there is a link.
   *
   * @return false when there is none or it doesn't take the message
   */
  public boolean send(ServerMessage message) {
    return link != null && link.send(message);
  }

  /** As {@link #send(ServerMessage)}, a message for many sessions. */
  public boolean send(Broadcast message) {
    return link != null && link.send(message);
  }

  /** Sends the last message if the link still takes one; the session ends either way. */
  public void sayGoodbye(GoodbyeReason reason, String text) {
    try {
      send(new ServerMessage.Goodbye(reason, text));
    } catch (RuntimeException e) {
      LOG.debug("no goodbye for {}", this, e);
    }
  }

  /** Whether this link was told who plays; then it needs only what changes. */
  public boolean knowsRoster() {
    return knowsRoster;
  }

  /** This link was told who plays. */
  public void toldRoster() {
    knowsRoster = true;
  }

  /** The place in the room: id, name, secret. */
  public Seats.Seat seat() {
    return seat;
  }

  /** The player in the room's simulation. */
  public Player player() {
    return player;
  }

  /** The present state: playing, in grace or closed. */
  public SessionState state() {
    return state;
  }

  /** What the client asked for since it was attached. */
  public Wish wish() {
    return wish;
  }

  /** What the client did when {@link #wish} is {@link Wish#EXPEL}. */
  public String offence() {
    return offence;
  }

  /** When the grace period is over; meaningful in {@link SessionState#GRACE}. */
  public long graceEndNs() {
    return graceEndNs;
  }

  /** Whether the link has closed. */
  public boolean linkLost() {
    return linkLost;
  }

  /** Why the link has closed. */
  public String linkLostReason() {
    return linkLostReason;
  }

  /**
   * Whether nothing was heard for longer than the configured silence, counted in ticks of the room:
   * while the server itself stood still nobody could be heard, and those ticks were dropped.
   */
  public boolean isSilent() {
    return silentTicks * 1_000L > (long) config.silenceTimeoutMs() * config.tickRateHz();
  }

  /** Whether the grace period is over; meaningful in grace. */
  public boolean graceIsOver(long timeNs) {
    return timeNs - graceEndNs >= 0;
  }

  /** The peer for log lines. */
  public String remote() {
    return link == null ? "no link" : link.remote();
  }

  /**
   * The session's snapshots, for inspection: in grace those of the link that was lost, null before
   * the first link and after the end.
   */
  public SnapshotSender sender() {
    return sender;
  }

  /** Rows of exact state of what is near that wait to be sent, for inspection. */
  public int waitingNearRows() {
    return nearSet == null ? 0 : nearSet.waitingRows();
  }

  /** The input buffer, for inspection. */
  public InputBuffer inputs() {
    return inputs;
  }

  @Override
  public String toString() {
    return "player=" + seat.id() + " name=\"" + seat.name() + "\" state=" + state;
  }
}
