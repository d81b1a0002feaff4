package carom.client;

import carom.client.clock.RenderClock;
import carom.client.clock.TickClock;
import carom.client.events.EventBook;
import carom.client.events.EventListener;
import carom.client.events.Repeats;
import carom.client.prediction.Prediction;
import carom.game.Games;
import carom.net.codec.Quantizer;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.InputDatagram;
import carom.net.protocol.Limits;
import carom.net.protocol.ServerMessage;
import carom.net.snapshot.DecodeStatus;
import carom.net.snapshot.InputFeedback;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.event.EventInbox;
import carom.net.snapshot.event.EventRecord;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.FrameState;
import carom.net.transport.ClientTransport;
import carom.sim.Event;
import carom.sim.Input;
import carom.sim.Neighbourhood;
import carom.sim.Player;
import carom.sim.Role;
import carom.sim.Simulation;
import carom.sim.event.EventKind;
import carom.sim.level.Level;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.LongSupplier;

/**
 * A player's side of the game, without a window. Whoever owns it calls {@link #update} once per
 * frame with the present time and then reads {@link #view}; nothing here sleeps, waits or starts a
 * thread. One thread.
 *
 * <p>One update is one client frame: take in what arrived; steer the clock that runs ahead of the
 * server; for each tick due sample, send and predict; correct the prediction from the newest server
 * state. The picture is made when it is looked at.
 */
public final class GameClient implements AutoCloseable {
  private static final int RING = 256;

  /** Reports of wrong predictions come no closer than this. */
  private static final long DIVERGED_GAP_NS = 2_000_000_000L;

  private static final int RING_MASK = RING - 1;

  /** What is there when a player joins doesn't fade in, all at once would. */
  private static final long JOIN_GRACE_NS = 1_000_000_000L;

  /** The server is told what is shown at most this often. */
  private static final long LOOK_GAP_NS = 200_000_000L;

  /** How often the server is told that nothing has changed. */
  private static final int QUIET_PER_SECOND = 6;

  /** An input holds for so many times the pause, so that a lost datagram changes nothing. */
  private static final int HOLD_TIMES = 3;

  /** A server from which nothing is heard for so many pauses counts as silent. */
  private static final double SILENT_PAUSES = 1.5;

  /** More is asked for than is shown, so that nothing appears at the edge of the screen. */
  private static final float LOOK_MARGIN = 1.2f;

  private final ClientConfig config;
  private final LongSupplier stopwatch;
  private final InputSource source;
  private final NetStats stats = new NetStats();
  private final ClientView view = new ClientView(stats);
  private final Connection connection;
  private final Input input = new Input();
  private final InputDatagram datagram = new InputDatagram();
  private final byte[] buffer = new byte[InputDatagram.MAX_BYTES];
  private final long[] inputs = new long[RING];
  private final long[] sentNs = new long[RING];
  private final int[] sentTick = new int[RING];
  private final int[] sentSequence = new int[RING];
  private final boolean[] sentHold = new boolean[RING];
  private final OwnState own = new OwnState();
  private final Event event = new Event();
  private final Repeats repeats = new Repeats();
  private final EventListener hears =
      new EventListener() {
        @Override
        public void happened(Event e, boolean foreseen) {
          stats.events++;
          listener.happened(e, foreseen);
        }

        @Override
        public void retracted(Event e) {
          stats.eventsRetracted++;
          listener.retracted(e);
        }
      };

  private EventListener listener = EventListener.NONE;
  private EventBook events;
  private long nowNs;
  private long lastUpdateNs;
  private Simulation simulation;
  private Prediction prediction;
  private SnapshotDecoder decoder;
  private TickClock clock;
  private RenderClock renderClock;
  private Painter painter;
  private int snapshotTick;
  private final int[] seenTick = new int[RING];
  private int ownTick;
  private int equalTick;
  private long divergedNs;
  private long firstSnapshotNs;
  private ClientMessage.Look look;
  private ClientMessage.Look lookSent;
  private long lookSentNs;
  private int key;
  private int sequence;
  private int firstTick;
  private int ackedTick;

  /** Since which tick the input has been the same. */
  private int steadyTick;

  /** Last tick that an input datagram was sent at. */
  private int toldTick;

  /** Newest tick whose input the server knows to hold; before it there may be later ones. */
  private int heldTick;

  private boolean newsToAck;
  private int heardTick;
  private int feedbackSequence;

  /**
   * Creates a client that connects at the first {@link #update}.
   *
   * @param config where to and how
   * @param transport opens links; stays the caller's, close it after this client
   * @param input plays
   */
  public GameClient(ClientConfig config, ClientTransport transport, InputSource input) {
    this(config, transport, input, System::nanoTime);
  }

  /**
   * Creates a client whose prediction measures its time otherwise.
   *
   * @param config where to and how
   * @param transport opens links; stays the caller's, close it after this client
   * @param input plays
   * @param stopwatch nanoseconds, to bound how long a replay takes; a constant lifts that bound,
   *     for tests in virtual time that must not depend on the machine
   */
  public GameClient(
      ClientConfig config, ClientTransport transport, InputSource input, LongSupplier stopwatch) {
    this.stopwatch = stopwatch;
    this.config = config;
    this.source = input;
    connection = new Connection(config, transport, new Ears(), stats);
    view.painter(this::paint);
  }

  /**
   * Does everything that is due: takes in what arrived, runs the ticks that are due, sends inputs,
   * corrects predictions, and invites the {@link #view} to show this moment.
   *
   * @param nowNs the present, nanoseconds of any clock that never goes back
   */
  public void update(long nowNs) {
    float seconds = lastUpdateNs == 0 ? 0 : Math.max(0, (nowNs - lastUpdateNs) * 1e-9f);
    lastUpdateNs = nowNs;
    this.nowNs = nowNs;
    connection.update(nowNs);
    stats.roll(nowNs);
    if (events != null && renderClock.started()) {
      events.advance(renderClock.tick());
    }
    if (decoder != null && clock.started()) {
      renderClock.loss(stats.lossPercent() / 100);
      clock.loss(stats.lossPercent() / 100);
      renderClock.advance(nowNs);
      clock.advance(nowNs);
      if (connection.playing()) {
        while (clock.due() > 0) {
          runTick(clock.next());
        }
        correct();
        sendLook();
      }
      if (prediction != null) {
        prediction.advance(seconds);
      }
      stats.clocks(clock, renderClock, view.tickRate);
    }
    describe();
  }

  private void runTick(int tick) {
    input.clear();
    source.sample(view, tick, input);
    view.input.set(input);
    long packed = input.pack();
    if (firstTick < 0) {
      firstTick = tick;
      ackedTick = tick - 1;
    }
    if (packed != inputs[(tick - 1) & RING_MASK] || firstTick == tick) {
      steadyTick = tick;
    }
    inputs[tick & RING_MASK] = packed;
    for (int missed = Math.max(view.tick + 1, tick - RING + 1); missed < tick; missed++) {
      inputs[missed & RING_MASK] = packed; // the clock jumped over it
      firstTick = Math.min(firstTick, missed);
    }
    view.tick = tick;
    if (tick % config.ticksPerInputDatagram() == 0 && isWorthTelling(tick)) {
      send(tick);
    }
    if (prediction != null) {
      prediction.step(tick, packed);
    }
  }

  /**
   * Whether there is anything to say. A server that knows that the newest input holds is told so
   * again a few times a second, and acks of what is new at once. A silent server is told in each
   * tick: where losses come in bursts, whoever says little is cut off for long. So is one that
   * hears us too late, as the clock learns from each answer.
   */
  private boolean isWorthTelling(int tick) {
    boolean known = heldTick >= steadyTick;
    boolean mends = prediction != null && prediction.disagreedTick() >= 0;
    boolean silent = tick - heardTick > SILENT_PAUSES * quietTicks();
    boolean late = stats.inputMargin() < 0;
    return !known || newsToAck || mends || silent || late || tick - toldTick >= quietTicks();
  }

  private int quietTicks() {
    return Math.max(1, view.tickRate / QUIET_PER_SECOND);
  }

  private void send(int tick) {
    datagram.key = key;
    datagram.sequence = sequence;
    datagram.hasAck = decoder.hasAck();
    datagram.ackSequence = decoder.hasAck() ? decoder.ackSequence() : 0;
    datagram.ackBits = decoder.hasAck() ? decoder.ackBits() : 0;
    datagram.near = prediction == null ? InputDatagram.NEAR_NONE : config.prediction().near();
    datagram.disagrees = prediction != null && prediction.disagreedTick() >= 0;
    datagram.disagreedTick = datagram.disagrees ? prediction.disagreedTick() & 0xffff : 0;
    datagram.newestTick = tick;
    datagram.viewDelay = viewDelay(tick);
    boolean holds = ackedTick >= steadyTick;
    datagram.holdTicks =
        holds ? Math.min(InputDatagram.MAX_HOLD_TICKS, HOLD_TIMES * quietTicks()) : 0;
    int pending = Math.min(tick - ackedTick, tick - firstTick + 1);
    int least = Math.min(config.ticksPerInputDatagram(), tick - firstTick + 1);
    datagram.count = Math.max(least, Math.min(Limits.MAX_INPUTS, pending));
    for (int i = 0; i < datagram.count; i++) {
      datagram.inputs[i] = inputs[(tick - i) & RING_MASK];
    }
    int length = datagram.encode(buffer, 0);
    int slot = sequence & RING_MASK;
    sentNs[slot] = nowNs;
    sentTick[slot] = tick;
    sentSequence[slot] = sequence;
    sentHold[slot] = holds;
    toldTick = tick;
    newsToAck = false;
    sequence = (sequence + 1) & 0xffff;
    connection.sendDatagram(buffer, length);
  }

  private void sendLook() {
    boolean due = lookSentNs == 0 || nowNs - lookSentNs >= LOOK_GAP_NS;
    if (look != null && due && (lookSentNs == 0 || !look.equals(lookSent))) {
      connection.send(look);
      lookSent = look;
      lookSentNs = nowNs;
    }
  }

  /** How far the picture of the others is behind the tick an input is for, in sixteenths. */
  private int viewDelay(int tick) {
    double ticks = renderClock.started() ? tick - renderClock.tick() : 0;
    long steps = Math.round(ticks * Player.VIEW_STEPS);
    return (int) Math.max(0, Math.min(InputDatagram.MAX_VIEW_DELAY, steps));
  }

  private void correct() {
    if (prediction == null || ownTick < 0) {
      return;
    }
    int compare = ownTick;
    ownTick = -1;
    boolean alone = prediction.alone();
    prediction.reconcile(own, compare, decoder);
    prove(compare, alone && prediction.alone());
    proveNear(compare);
    if (prediction.compared()) {
      stats.compared(prediction.exact(), prediction.awakeBodies(), prediction.exactBodies());
    }
    stats.rolledBack(prediction.rolledBack(), prediction.replayed(), prediction.replayNs());
    stats.cutShort(prediction.cutShort());
    stats.disagreements(prediction.disagreements());
    stats.syncErrors(prediction.syncErrors());
    if (prediction.corrected()) {
      stats.corrected(prediction.correctionMetres());
    }
    stats.correction.add(prediction.correctionMetres());
  }

  /**
   * Alone among statics, a prediction must be right in every bit. The server is told of one that
   * wasn't, and knows better whether there was an ordinary reason.
   */
  private void prove(int tick, boolean alone) {
    if (!prediction.compared() || !alone) {
      equalTick = -1;
    } else if (prediction.exact()) {
      equalTick = tick;
    } else if (equalTick >= 0) {
      if (mayReport()) {
        OwnState wrong = prediction.predicted();
        List<Integer> bits = new ArrayList<>();
        for (int i = 0; i < ClientMessage.Diverged.BITS; i++) {
          bits.add(wrong.bits(i));
        }
        connection.send(
            new ClientMessage.Diverged(tick, equalTick, wrong.slot(), wrong.generation(), bits));
      }
      equalTick = -1;
    }
  }

  /**
   * From equal hashes and true inputs, what is near must be right in every bit, too. Which of the
   * bodies differs only the server can see: it is told all there is room for.
   */
  private void proveNear(int tick) {
    if (!prediction.diverged() || prediction.divergedState().count() < 2 || !mayReport()) {
      return;
    }
    Neighbourhood state = prediction.divergedState();
    List<Integer> bodies = new ArrayList<>();
    for (int i = 0; i < Math.min(state.count(), ClientMessage.DivergedNear.MAX_BODIES); i++) {
      for (int j = 0; j < ClientMessage.DivergedNear.BODY_INTS; j++) {
        bodies.add(state.entities()[i * Neighbourhood.ENTITY_INTS + j]);
      }
    }
    connection.send(new ClientMessage.DivergedNear(tick, prediction.equalTick(), bodies));
  }

  private boolean mayReport() {
    if (divergedNs != 0 && nowNs - divergedNs < DIVERGED_GAP_NS) {
      return false;
    }
    divergedNs = nowNs;
    return true;
  }

  private final class Ears implements Connection.Listener {
    @Override
    public String joined(ServerMessage.Welcome welcome, Level level) {
      try {
        simulation =
            new Simulation(
                Games.create(welcome.game()),
                level,
                welcome.seed(),
                welcome.tickRate(),
                Role.PREDICTION);
      } catch (IllegalArgumentException | IllegalStateException e) {
        return "This client can't play " + welcome.game() + ": " + e.getMessage();
      }
      start(welcome, level);
      return null;
    }

    @Override
    public void datagram(byte[] bytes, int length, long arrivedNs) {
      take(bytes, length, arrivedNs);
    }

    @Override
    public void roster(ServerMessage.Roster roster) {
      view.roster(roster);
    }

    @Override
    public void notice(String text) {
      view.notice(text, nowNs);
    }

    @Override
    public void stopped() {
      events.close();
      view.freeze();
    }
  }

  private void start(ServerMessage.Welcome welcome, Level level) {
    view.roster(List.of());
    int rate = welcome.tickRate();
    key = welcome.datagramKey();
    decoder = new SnapshotDecoder(Limits.MAX_ENTITIES, key, welcome.tick(), rate);
    decoder.gravity(level.gravityX(), level.gravityY());
    decoder.level(FrameState.of(Limits.MAX_ENTITIES, frame -> level.forEachBody(frame::put)));
    lookSentNs = 0;
    clock = new TickClock(rate);
    renderClock = new RenderClock(rate);
    prediction =
        config.prediction() == PredictionMode.NONE
            ? null
            : new Prediction(
                simulation,
                welcome.playerId(),
                config.name(),
                config.maxRollbackTicks(),
                config.maxReplayMs() * 1_000_000L,
                stopwatch,
                config.syncTest());
    events = new EventBook(welcome.playerId(), prediction != null, rate, hears);
    simulation.journal(events);
    repeats.linkBegins(welcome.tick());
    snapshotTick = -1;
    Arrays.fill(seenTick, -1);
    ownTick = -1;
    equalTick = -1;
    divergedNs = 0;
    firstSnapshotNs = 0;
    firstTick = -1;
    steadyTick = 0;
    heldTick = -1;
    newsToAck = false;
    feedbackSequence = -1;
    sequence = 0;
    own.clearBody();
    Arrays.fill(sentSequence, -1);
    view.level = level;
    view.game = welcome.game();
    view.playerId = welcome.playerId();
    view.tickRate = rate;
    view.tick = welcome.tick();
    view.predictedWorld = prediction == null ? null : simulation;
    painter = new Painter(view, decoder, simulation, prediction, rate);
  }

  private void take(byte[] bytes, int length, long arrivedNs) {
    DecodeStatus status = decoder.decode(bytes, 0, length);
    if (status != DecodeStatus.OK) {
      if (status == DecodeStatus.DAMAGED) {
        stats.malformed++;
      }
      return;
    }
    hearEvents();
    stats.datagram(length);
    newsToAck |= decoder.hasNews();
    heardTick = view.tick;
    stats.acks(decoder.ackSequence(), decoder.ackBits());
    int tick = decoder.tick();
    if (seenTick[tick & RING_MASK] != tick) {
      seenTick[tick & RING_MASK] = tick;
      stats.snapshot(arrivedNs);
    }
    if (tick > snapshotTick) {
      snapshotTick = tick;
      renderClock.snapshot(tick, arrivedNs, decoder.touchedCount() == 0);
      if (!clock.started()) {
        clock.start(nowNs, tick, connection.roundTripNs());
        view.tick = clock.tick();
        firstSnapshotNs = nowNs;
      }
      clock.heard(tick, nowNs);
    }
    if (decoder.feedback().present) {
      feedback(decoder.feedback(), tick, arrivedNs);
    }
    if (decoder.hasOwn() && prediction != null) {
      prediction.hear(decoder.own().near(), tick);
    }
    if (decoder.hasOwn() && tick > ownTick) {
      own.set(decoder.own());
      ownTick = tick;
      if (prediction == null) {
        for (int i = 0; i < OwnState.MEMORY; i++) {
          view.memory[i] = own.memory(i);
        }
      }
    }
  }

  private void hearEvents() {
    EventInbox inbox = decoder.events();
    for (EventRecord r; (r = inbox.poll()) != null; ) {
      if (!repeats.isNew(r.tick, inbox.missed())) {
        continue;
      }
      EventKind kind = simulation.eventKinds().get(r.kind);
      if (kind == null) {
        stats.malformed++;
        continue;
      }
      events.told(
          event.set(
              kind,
              r.tick,
              r.player,
              r.first,
              r.second,
              Quantizer.positionOf(r.x),
              Quantizer.positionOf(r.y),
              r.strengthOf(),
              r.data));
    }
    events.complete(inbox.completeTick());
    stats.eventsMissed = inbox.missed();
  }

  private void feedback(InputFeedback feedback, int tick, long arrivedNs) {
    int slot = feedback.sequence & RING_MASK;
    if (sentSequence[slot] != feedback.sequence) {
      return;
    }
    if (feedback.sequence != feedbackSequence) {
      boolean newer = feedbackSequence < 0 || (short) (feedback.sequence - feedbackSequence) > 0;
      if (newer) {
        feedbackSequence = feedback.sequence;
        ackedTick = Math.max(ackedTick, sentTick[slot]);
        heldTick = sentHold[slot] ? Math.max(heldTick, sentTick[slot]) : heldTick;
        if (feedback.holdMs < 255) {
          stats.roundTrip(Math.max(0, (arrivedNs - sentNs[slot]) / 1e6 - feedback.holdMs));
        }
      }
    }
    boolean clamped = feedback.margin <= -32 || feedback.margin >= 31;
    int margin = clamped ? sentTick[slot] - tick : feedback.margin;
    stats.margin.add(margin);
    clock.report(sentTick[slot] - margin, margin); // the tick that was consumed when it had come
  }

  private void describe() {
    view.phase = connection.phase();
    view.message = connection.message();
    view.progress = connection.levelProgress();
    if (prediction != null) {
      for (int i = 0; i < OwnState.MEMORY; i++) {
        view.memory[i] = prediction.memory(i);
      }
    }
    if (connection.playing()) {
      view.renderTick = renderClock.tick();
      view.invite();
    }
  }

  /** Fills in the visible entities; called when somebody looks. */
  private void paint() {
    view.clear();
    if (painter != null && renderClock.started()) {
      boolean joining = nowNs - firstSnapshotNs < JOIN_GRACE_NS;
      painter.paint(nowNs, renderClock.tick(), clock.fraction(), joining, own);
    }
  }

  /**
   * Sets who hears what happens in the game: hits, goals, jumps, each once; during {@link #update}
   * and {@link #close}.
   */
  public void events(EventListener newListener) {
    listener = newListener;
  }

  /** What the player sees; the same object for ever. */
  public ClientView view() {
    return view;
  }

  /**
   * Says what is shown, so that the server tells about that: it bounds the size, and follows the
   * own body by itself. Never called: as much as the server allows.
   *
   * @param x middle of the picture while there is no own body, metres
   * @param y middle of the picture while there is no own body, metres
   * @param width of the picture, metres
   * @param height of the picture, metres
   */
  public void look(float x, float y, float width, float height) {
    boolean follows = view.own() != null;
    look =
        new ClientMessage.Look(
            follows ? 0 : x, follows ? 0 : y, width / 2 * LOOK_MARGIN, height / 2 * LOOK_MARGIN);
  }

  /**
   * What has arrived, exactly as the server sent it; null before joining. For reading only: tests
   * and tools compare it with the server's truth.
   */
  public SnapshotDecoder decoder() {
    return decoder;
  }

  /** Offset of the own body's picture that is left of corrections, metres. */
  public double visualErrorMetres() {
    return prediction == null ? 0 : prediction.visualErrorMetres();
  }

  /**
   * Whether a new client might get in where this one {@linkplain ConnectionPhase#ENDED ended}: the
   * server was full, busy or out of reach, and not at odds with this client.
   */
  public boolean mayTryAgain() {
    return connection.mayPass();
  }

  /** Numbers about the connection. */
  public NetStats stats() {
    return stats;
  }

  /** Leaves the game: tells the server, closes the link. Does nothing the second time. */
  @Override
  public void close() {
    connection.leave();
    if (events != null) {
      events.close();
    }
    describe();
  }
}
