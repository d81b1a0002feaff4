package carom.server.replication;

import carom.net.codec.Sequence;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.InputDatagram;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.snapshot.InputFeedback;
import carom.net.snapshot.exact.OwnState;
import carom.net.transport.Link;
import carom.physics.BodyContactVisitor;
import carom.physics.BodyType;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.prediction.OwnCapture;
import carom.server.prediction.PredictedSet;
import carom.server.prediction.PredictionAudit;
import carom.server.prediction.PredictionAudit.Finding;
import carom.server.thin.ThinLink;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import java.util.Arrays;
import java.util.function.LongConsumer;
import java.util.function.Predicate;
import java.util.function.Supplier;

/**
 * Replicates the world to the client of one session: its snapshots, its predicted set while it asks
 * for one, and the audit of its predictions.
 *
 * <p>In each tick, {@link #prepareSnapshot} captures what the client should know; then, if it
 * {@link #isSnapshotDue} and the tick has time left, {@link #sendSnapshot} sends it.
 *
 * <p>The room's thread. The steady state allocates nothing.
 */
public final class SessionReplication {
  /** Ticks before tick 0, longer than any wait. */
  private static final int NEVER_TICKS = 1 << 20;

  private final HostPlayer player;
  private final Supplier<ServerConfig> config;
  private final FrameCapture frames;
  private final OwnCapture capture;
  private final Counters counters;
  private final OwnState own;

  /** Null before the first link of an own client, and after the end. */
  private SnapshotSender sender;

  /** Null unless the client is a thin one. */
  private ThinSender thin;

  /** Null until the client says that it predicts. */
  private PredictedSet predictedSet;

  /** Null until a client of the session says that it predicts. */
  private PredictionAudit audit;

  /**
   * The set that the client wants to predict: one of {@link InputDatagram}'s {@code NEAR}
   * constants.
   */
  private int wanted = InputDatagram.NEAR_NONE;

  /** The newest tick at which the client says that it had another state, or -1. */
  private int disagreedTick = -1;

  /** The state of the pools that the client is loading; null before the first request. */
  private byte[] poolState;

  private int poolStateTick = -NEVER_TICKS;

  /** Offset up to which pieces of the state were sent. */
  private int poolSent;

  /** Ticks with a predicted set, and how often the client had another state in them. */
  private long predictedTicks;

  private long mispredictions;
  private int preparedTick;
  private boolean touched;
  private final Predicate<HostEntity> mayKnow = this::mayKnow;
  private final BodyContactVisitor<HostEntity> touchVisitor =
      (other, normalX, normalY, impulse) -> touched |= other.type() != BodyType.STATIC;

  /**
   * Creates the replication to a client without a link.
   *
   * @param player the player in the room's simulation
   * @param frames the room's frames
   * @param capture reads the player's own section
   */
  public SessionReplication(
      HostPlayer player,
      Supplier<ServerConfig> config,
      FrameCapture frames,
      OwnCapture capture,
      Counters counters) {
    this.player = player;
    this.config = config;
    this.frames = frames;
    this.capture = capture;
    own = new OwnState(capture.words());
    this.counters = counters;
  }

  private boolean mayKnow(HostEntity e) {
    return sender.mayKnow(e);
  }

  /**
   * Begins with a client that knows nothing but the level, and of former links only what the player
   * has heard of.
   *
   * @param epoch that of the session's Welcome
   * @param link to the client; null for none yet
   */
  public void begin(int epoch, Link link) {
    if (link instanceof ThinLink thinLink) {
      sender = null;
      predictedSet = null;
      thin = new ThinSender(frames, player, thinLink, epoch, config, counters);
      return;
    }
    thin = null;
    SnapshotSender before = sender;
    sender = new SnapshotSender(frames, player, epoch, config, counters);
    if (before != null) {
      sender.takeOver(before);
    }
    predictedSet = null;
    poolState = null;
    poolStateTick = -NEVER_TICKS;
    if (audit != null) {
      audit.clear();
    }
    wanted = InputDatagram.NEAR_NONE;
    disagreedTick = -1;
  }

  /**
   * Sends a piece of the state of the pools, each once, and at most a state in a second.
   *
   * @return false if there is no such piece
   */
  public boolean answer(ClientMessage.PoolRequest request, Link link) {
    int offset = request.offset();
    int tick = frames.index().simulation().tick();
    if (offset == 0 && tick - poolStateTick >= config.get().get(ServerConfig.TICK_RATE)) {
      poolState = frames.pools().state();
      poolStateTick = tick;
      poolSent = 0;
    }
    if (poolState == null || offset >= poolState.length) {
      return false;
    }
    if (offset < poolSent) {
      return true; // once is enough, so that a client can't make the server send without end
    }
    poolSent = offset + 1;
    int end = Math.min(poolState.length, offset + ProtocolLimits.MAX_LEVEL_CHUNK_BYTES);
    byte[] piece = Arrays.copyOfRange(poolState, offset, end);
    link.send(new ServerMessage.PoolChunk(poolState.length, offset, piece));
    return true;
  }

  /** Ends the replication; the session is over. */
  public void end() {
    sender = null;
    thin = null;
  }

  /** Notes the events that the player would hear of; once per tick without a link. */
  public void listen() {
    if (sender != null) { // a match that began after the link was lost has told it nothing yet
      sender.listen();
    }
  }

  /**
   * Passes on the numbers of the events, of those that the frames keep, that the player may not
   * have heard of.
   */
  public void forEachUnacknowledged(LongConsumer reader) {
    if (sender != null) {
      sender.forEachUnacknowledged(reader);
    }
  }

  /** Offers an event that the frames keep, and that the player may not have heard of. */
  public void offer(long number) {
    sender.offer(number);
  }

  /** Takes over what the client says it shows. */
  public void look(ClientMessage.Look look) {
    if (thin != null) {
      thin.look(look.x(), look.y(), look.halfWidth(), look.halfHeight(), look.follows());
    } else {
      sender.look(look.x(), look.y(), look.halfWidth(), look.halfHeight(), look.follows());
    }
  }

  /** Takes a client's acks as they are. */
  public void receiveAck(int ackSequence, long ackBits) {
    sender.receiveAck(ackSequence, ackBits);
  }

  /** Takes over what the client's newest input datagram says about its prediction. */
  public void receivePrediction(InputDatagram datagram) {
    wanted = datagram.near;
    if (datagram.disagrees) {
      int tick = Sequence.expand(datagram.disagreedTick, frames.frames().newest().tick());
      mispredictions += tick > disagreedTick ? 1 : 0;
      disagreedTick = tick;
    }
  }

  /** Notes that an input came after its tick but was the one that was used. */
  public void confirmInput(int tick) {
    if (audit != null) {
      audit.confirmInput(tick);
    }
  }

  /** Judges the client's report of a misprediction. */
  public Finding judge(ClientMessage.Diverged report) {
    return audit == null ? Finding.UNKNOWN : audit.judge(report);
  }

  /** Describes what differs in a report that was judged {@link Finding#UNEXPLAINED}. */
  public String describe(ClientMessage.Diverged report) {
    return audit.describe(report);
  }

  /**
   * Captures what the client should know after the simulation's last step, and decides whether a
   * snapshot of it {@linkplain #isSnapshotDue is due}; call once per tick with a link.
   *
   * @param tick the tick of the input that was consumed last
   * @param inputInTime whether the client's own input was there for it
   * @param inputsLate whether the client's inputs come too late at present
   */
  public void prepareSnapshot(int tick, boolean inputInTime, boolean inputsLate) {
    if (thin != null) {
      thin.prepare();
      return;
    }
    preparedTick = tick;
    sender.tick();
    capture.capture(player, mayKnow, own);
    if (wanted != InputDatagram.NEAR_NONE && predictedSet == null) {
      predictedSet = capture.predictedSet(player, sender.encoder(), mayKnow);
      audit = audit == null ? new PredictionAudit(own.words()) : audit;
    }
    if (audit != null) {
      lookForTouch();
      audit.keep(tick, own, !inputInTime, touched, capture.interferedTick(player) >= tick);
    }
    capturePredictedSet();
    sender.prepare(own, inputsLate);
  }

  /**
   * Finds out whether anything that is not static touched or reached the body in the last step, or
   * may have been read by its input.
   */
  private void lookForTouch() {
    touched =
        capture.isInArea(player) || (predictedSet != null && predictedSet.looksAtOthers(player));
    if (player.entity() != null) {
      player.entity().body().forEachContact(touchVisitor);
    }
  }

  private void capturePredictedSet() {
    if (predictedSet == null) {
      own.near().clear();
      own.relayed().clear();
    } else if (wanted == InputDatagram.NEAR_NONE) {
      predictedSet.captureNothing(own);
    } else {
      long updates = predictedSet.updates();
      long disagreements = predictedSet.disagreements();
      boolean all = wanted == InputDatagram.NEAR_ALL;
      predictedSet.capture(player, all, disagreedTick, sender.nearBits(), own);
      counters.add(Counter.NEAR_UPDATES, predictedSet.updates() - updates);
      counters.add(Counter.NEAR_DISAGREEMENTS, predictedSet.disagreements() - disagreements);
      if (own.near().present()) {
        predictedTicks++;
        boolean hidden = predictedSet.hasHiddenCause();
        audit.keepSet(preparedTick, predictedSet.hasOutsideCause(), hidden);
      }
    }
  }

  /** Returns whether the snapshot prepared last should be sent. */
  public boolean isSnapshotDue() {
    return thin != null ? thin.isDue() : sender.isDue();
  }

  /** Sends the snapshot prepared last. */
  public void sendSnapshot(Link link, InputFeedback feedback) {
    if (thin != null) {
      thin.send();
      return;
    }
    sender.send(link, feedback, own);
    if (own.near().present()) {
      audit.keepSetState(preparedTick, predictedSet.state());
    }
    if (predictedSet != null) {
      predictedSet.sent();
    }
  }

  /** Returns the round trip to the client and back, ms; 0 while it isn't known. */
  public int roundTripMs() {
    return thin != null ? thin.figures().roundTripMs() : sender == null ? 0 : sender.roundTripMs();
  }

  /** Returns what the line and the client's predictions have done since the link began. */
  public LinkFigures figures() {
    if (thin != null) {
      return thin.figures();
    }
    return sender == null
        ? LinkFigures.NONE
        : new LinkFigures(
            sender.roundTripMs(),
            sender.bytesSent(),
            sender.encoder().ledger().settledDatagrams(),
            sender.encoder().ledger().ackedDatagrams(),
            predictedTicks,
            mispredictions);
  }

  /** Returns the priority that an entity has collected since it was sent; 0 without a link. */
  public float collectedPriority(int entityId) {
    return sender == null ? 0 : sender.encoder().report().collectedPriority(entityId);
  }

  /** Returns whether the client looks at the place of an entity and may know it. */
  public boolean sees(int entityId) {
    return thin != null ? thin.sees(entityId) : sender.sees(entityId);
  }

  /**
   * Explains to an operator why an entity was not sent, or that it was; null for a thin client,
   * which is told of all that it sees.
   */
  public SentReport explain(int entityId) {
    if (sender == null) {
      return null;
    }
    return new SentReport(
        sender.encoder().report().explain(entityId),
        predictedSet == null ? 0 : predictedSet.waitingRows(),
        sender.paceBytesPerSecond());
  }
}
