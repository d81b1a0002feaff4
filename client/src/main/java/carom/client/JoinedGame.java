package carom.client;

import carom.client.clock.RenderClock;
import carom.client.clock.TickClock;
import carom.client.field.OwnWords;
import carom.client.field.RemoteFields;
import carom.client.link.Connection;
import carom.client.prediction.Prediction;
import carom.client.stats.NetStatsRecorder;
import carom.client.view.ViewComposer;
import carom.client.view.ViewWriter;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.table.JointWords;
import carom.net.snapshot.table.TableInbox;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.entity.JointTable;
import carom.sim.level.Level;
import java.util.List;
import java.util.function.LongSupplier;

/**
 * One stay in a game, from joining until the link is lost. A client that comes back starts a new
 * one. Data flows one way:
 *
 * <pre>
 * datagram ──► SnapshotInbox ──┬─► RenderClock, TickClock (steered by arrivals and feedback)
 *              (decoder)       ├─► EventReceiver ──► EventListener
 *                              └─► own state ──► Prediction.reconcile ──► DivergenceReporter
 *
 * TickClock ──► InputSource ──► InputSender ──► datagram
 *                    └────────► Prediction.step
 *
 * decoder, Prediction ──► ViewComposer ──► ClientView
 * </pre>
 *
 * <p>One thread; allocates nothing per tick.
 */
final class JoinedGame {
  /** Time after the first snapshot in which entities don't fade in, because all are new. */
  private static final long JOIN_GRACE_NS = 1_000_000_000L;

  private final ViewWriter view;
  private final NetStatsRecorder stats;
  private final InputSource source;
  private final RemoteFields fields;
  private final SnapshotDecoder decoder;
  private final SnapshotInbox inbox;
  private final EventReceiver events;
  private final PacedTime time = new PacedTime();
  private final TickClock clock;
  private final RenderClock renderClock;
  private final InputSender sender;
  private final SimulationHost simulation;
  private final PredictionFailure failure;

  // Null where nothing is predicted, or no longer.
  private Prediction prediction;
  private DivergenceReporter divergence;

  private ViewComposer composer;
  private final PoolFollower pools;
  private final Input input = new Input();
  private final int tickRate;
  private final int playerId;
  private final Level level;
  private final ServerMessage.Welcome welcome;

  /** False as long as the view shows the stay before, of which this one is the continuation. */
  private boolean isShown;

  private boolean listsPlayers;
  private long firstSnapshotNs;
  private long lastAdvanceNs;

  /**
   * Joins a game.
   *
   * @param simulation of role PREDICTION, fresh
   * @param failure hears when its game fails
   * @param stopwatch measures replays
   * @param repeats outlives this stay
   * @param listener receives each event once
   * @param goesOn whether the view shows the same match, which then stays until the first snapshot
   */
  JoinedGame(
      ClientConfig config,
      ServerMessage.Welcome welcome,
      Level level,
      SimulationHost simulation,
      PredictionFailure failure,
      InputSource source,
      LongSupplier stopwatch,
      Connection connection,
      NetStatsRecorder stats,
      ViewWriter view,
      RepeatedEventFilter repeats,
      EventListener listener,
      boolean goesOn) {
    this.view = view;
    this.stats = stats;
    this.simulation = simulation;
    this.failure = failure;
    stats.viewsNarrow(false);
    playerId = welcome.playerId();
    this.level = level;
    this.welcome = welcome;
    this.source = source;
    tickRate = welcome.tickRate();
    fields = new RemoteFields(simulation.schema(), () -> view.view().tick());
    decoder =
        new SnapshotDecoder(
            ProtocolLimits.MAX_ENTITIES,
            welcome.epoch(),
            welcome.tick(),
            welcome.tickRate(),
            OwnWords.count(simulation.schema()),
            fields.inbox());
    placeJoints(level, fields.inbox());
    decoder.gravity(level.gravityX(), level.gravityY());
    decoder.level(
        FrameState.of(ProtocolLimits.MAX_ENTITIES, frame -> level.forEachBody(frame::put)));
    inbox = new SnapshotInbox(decoder, stats);
    clock = new TickClock(tickRate);
    renderClock = new RenderClock(tickRate);
    renderClock.leastDelay(config.get(ClientConfig.MIN_INTERPOLATION_MS) / 1_000.0);
    prediction =
        config.get(ClientConfig.PREDICTION) == PredictionMode.NONE
            ? null
            : new Prediction(
                simulation,
                welcome.playerId(),
                config.get(ClientConfig.NAME),
                config.get(ClientConfig.MAX_ROLLBACK_TICKS),
                config.get(ClientConfig.MAX_REPLAY_MS) * 1_000_000L,
                stopwatch,
                config.get(ClientConfig.SYNC_TEST));
    events =
        new EventReceiver(simulation, welcome.playerId(), prediction, repeats, stats, listener);
    repeats.beginLink(welcome.room(), welcome.match(), welcome.incarnation(), welcome.courseTick());
    sender =
        new InputSender(config, welcome.epoch(), tickRate, decoder, prediction, stats, connection);
    divergence = prediction == null ? null : new DivergenceReporter(prediction, connection);
    pools = new PoolFollower(simulation.pools(), fields.inbox(), connection);
    if (!goesOn) {
      beginView();
      view.roster(List.of());
    }
    composer = new ViewComposer(view.view(), decoder, simulation, prediction, tickRate);
  }

  /** Tells the view what stays the same for as long as the game lasts. */
  private void beginView() {
    isShown = true;
    view.fields(fields);
    view.tick(welcome.tick());
    view.room(welcome.room(), welcome.match());
    view.game(
        welcome.game(),
        level,
        welcome.playerId(),
        tickRate,
        prediction == null ? null : simulation);
    view.pools(simulation.pools());
    view.geometry(simulation.world().queries());
  }

  /** Places the joints of the level, which the server doesn't tell until they change. */
  private static void placeJoints(Level level, TableInbox tables) {
    int[] words = new int[JointWords.WORDS];
    JointTable.forEachOfLevel(
        level,
        (index, endA, endB, definition) -> {
          JointWords.put(words, endA, endB, JointTable.LEVEL, index, definition, 0);
          tables.place(JointWords.TABLE, index, 0, words, 0);
        });
  }

  // ---- datagrams

  /**
   * Takes in a datagram.
   *
   * @param arrivedNs when it arrived
   * @param nowNs time of the present update
   * @param roundTripNs a message's round trip, as far as it is known
   */
  void receive(byte[] bytes, int length, long arrivedNs, long nowNs, long roundTripNs) {
    if (!inbox.decode(bytes, length, arrivedNs)) {
      return;
    }
    int tick = decoder.tick();
    if (decoder.hasOwn() && prediction != null) {
      prediction.receive(decoder.own(), tick);
    }
    events.receive(decoder.events());
    pools.receive();
    sender.heard(view.view().tick(), decoder.hasNews());
    if (inbox.isNewest()) {
      steerClocks(tick, arrivedNs, nowNs, roundTripNs);
    }
    if (decoder.feedback().present) {
      sender.receive(decoder.feedback(), tick, arrivedNs, clock);
    }
    if (inbox.keepOwn() && prediction == null) {
      for (int i = 0; i < inbox.own().words(); i++) {
        fields.own(playerId, i, inbox.own().word(i));
      }
    }
  }

  private void steerClocks(int tick, long arrivedNs, long nowNs, long roundTripNs) {
    renderClock.snapshot(tick, time.at(arrivedNs), decoder.touchedCount() == 0);
    if (!isShown) {
      beginView();
    }
    if (!clock.started()) {
      clock.start(time.at(nowNs), tick, (long) (roundTripNs * time.pace()));
      view.tick(clock.tick());
      firstSnapshotNs = nowNs;
    }
    clock.heard(tick, time.at(nowNs));
  }

  /** Lets the clocks run at another pace, and notes whether views are narrow. */
  void pace(ServerMessage.Pace pace, long nowNs) {
    time.pace(pace.percent(), nowNs);
    stats.viewsNarrow(pace.viewsNarrow());
  }

  /** Takes in who plays: first all, then what changes. */
  void roster(ServerMessage.Roster roster) {
    if (!listsPlayers) {
      listsPlayers = true;
      view.roster(List.of()); // those of the stay before
    }
    view.roster(roster);
  }

  /** Takes in a piece of the state of the level's pools. */
  void pools(ServerMessage.PoolChunk chunk) {
    pools.add(chunk);
  }

  // ---- time

  /**
   * Lets time pass: moves the clocks, runs the ticks that are due, and reconciles.
   *
   * @param seconds since the last call
   * @param playing whether the link is up; without it only the picture goes on
   */
  void advance(long nowNs, float seconds, boolean playing) {
    lastAdvanceNs = nowNs;
    if (renderClock.started()) {
      events.advance(renderClock.tick());
    }
    if (!clock.started()) {
      return;
    }
    double loss = stats.stats().lossPercent() / 100;
    renderClock.loss(loss);
    clock.loss(loss);
    renderClock.advance(time.at(nowNs));
    clock.advance(time.at(nowNs));
    if (playing) {
      while (clock.due() > 0) {
        runTick(clock.next(), nowNs);
      }
      reconcile(nowNs);
    }
    if (prediction != null) {
      prediction.advance(seconds);
      stopPredictingIfFailed(); // the sync test steps
    }
    stats.clocks(clock, renderClock, tickRate, time.pace());
  }

  /** Returns whether time has begun to pass: the first snapshot is here. */
  boolean hasStarted() {
    return clock.started();
  }

  private void runTick(int tick, long nowNs) {
    input.clear();
    source.sample(view.view(), tick, input);
    view.input(input);
    long packed = input.pack();
    sender.add(tick, packed, view.view().tick());
    view.tick(tick);
    sender.sendIfDue(tick, renderClock.started() ? tick - renderClock.tick() : 0, nowNs);
    int seen = renderClock.started() ? (int) renderClock.tick() : 0;
    boolean known = pools.advance(tick, seen, nowNs);
    if (prediction != null) {
      if (!known) {
        divergence.guessed(tick);
      }
      try {
        prediction.step(tick, packed);
      } catch (RuntimeException | Error e) { // the engine's, over what the game did
        failure.failed("the step", simulation, e);
      }
      stopPredictingIfFailed();
    }
  }

  /** Lets the stay go on without prediction if the game has failed in it. */
  private void stopPredictingIfFailed() {
    if (!failure.hasFailed()) {
      return;
    }
    prediction = null;
    divergence = null;
    sender.stopPredicting();
    events.stopPredicting();
    fields.ownBody(-1, 0, null);
    view.withoutPrediction();
    composer = new ViewComposer(view.view(), decoder, simulation, null, tickRate);
    firstSnapshotNs = lastAdvanceNs; // what is here doesn't fade in again
  }

  private void reconcile(long nowNs) {
    if (prediction == null) {
      return;
    }
    int tick = inbox.takeOwnTick();
    if (tick < 0) {
      return;
    }
    boolean wasAlone = prediction.isAlone();
    try {
      prediction.reconcile(inbox.own(), tick, decoder);
    } catch (RuntimeException | Error e) {
      failure.failed("the step", simulation, e);
    }
    stopPredictingIfFailed();
    if (prediction != null) {
      divergence.check(tick, wasAlone, nowNs);
      stats.reconciled(prediction);
    }
  }

  // ---- the picture

  /** Updates the view, except its entities, which are composed on demand. */
  void describe(boolean playing) {
    if (prediction != null) {
      describeOwnFields();
    }
    if (playing && isShown) {
      view.renderTick(renderClock.tick());
      view.invalidate();
    }
  }

  private void describeOwnFields() {
    HostPlayer player = prediction.player();
    fields.own(playerId, player.fieldValues());
    HostEntity body = player.entity();
    if (body == null) {
      fields.ownBody(-1, 0, null);
    } else {
      fields.ownBody(body.id(), body.generation(), body.fieldValues());
    }
  }

  /** Composes the entities of the present moment. */
  void compose(long nowNs) {
    if (renderClock.started()) {
      boolean joining = nowNs - firstSnapshotNs < JOIN_GRACE_NS;
      composer.compose(nowNs, renderClock.tick(), clock.fraction(), joining, inbox.own());
    }
  }

  /** Ends the stay: fires the events that wait. The picture stays. */
  void close() {
    events.close();
  }

  /** Returns whether another link goes on with the match of this stay, in the same seat. */
  boolean goesOn(ServerMessage.Welcome next, Level nextLevel) {
    return isSameMatch(next) && next.playerId() == playerId && nextLevel == level;
  }

  private boolean isSameMatch(ServerMessage.Welcome next) {
    return next.room().equals(welcome.room()) && next.match() == welcome.match();
  }

  /** Returns which run of the server the stay belongs to. */
  int incarnation() {
    return welcome.incarnation();
  }

  /**
   * Returns how many ticks that this client has seen never happened, because the room goes on from
   * an earlier state.
   *
   * @param next of the link after this one
   */
  int ticksLost(ServerMessage.Welcome next) {
    boolean another = isSameMatch(next) && next.incarnation() != welcome.incarnation();
    return another ? Math.max(0, decoder.newestTick() - next.courseTick()) : 0;
  }

  /** Returns what has arrived, exactly as the server sent it. Read-only. */
  SnapshotDecoder decoder() {
    return decoder;
  }

  /** Returns what is left to fade of corrections of the own body, metres. */
  double visualErrorMetres() {
    return prediction == null ? 0 : prediction.visualErrorMetres();
  }
}
