package carom.server.room;

import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.Limits;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.snapshot.frame.FrameRing;
import carom.net.transport.Broadcast;
import carom.net.transport.Link;
import carom.physics.Queries;
import carom.physics.threads.Workers;
import carom.replay.BlockSink;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.metrics.LogInterval;
import carom.server.recording.RecordingFile;
import carom.server.recording.RotatingRecording;
import carom.server.replication.FrameCapture;
import carom.server.replication.OwnCapture;
import carom.server.session.PartingLinks;
import carom.server.session.Seats;
import carom.server.session.Session;
import carom.sim.Entity;
import carom.sim.Game;
import carom.sim.GuardedGame;
import carom.sim.Player;
import carom.sim.Role;
import carom.sim.Simulation;
import carom.sim.level.Level;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One world, its players, one writer: a simulation at a fixed rate and the sessions that steer and
 * see it.
 *
 * <p>{@link #doWork} is one turn of the duty cycle: take what has arrived, and run the ticks that
 * are due. A tick is, in this order: arrivals from the lobby; what the inboxes hold (acks, inputs,
 * wishes); who leaves, is lost, or is too late to come back; one input per player; the simulation's
 * step; the frame state, once for all; each session's snapshot; roster and notices; counters.
 *
 * <p>Everything but {@link #admit}, {@link #number}, {@link #seed}, {@link #tick}, {@link #seats},
 * {@link #counters} and {@link #hasFailed} belongs to the thread that calls {@link #doWork}. A tick
 * in the steady state allocates next to nothing. A client can hurt only its own session, a game
 * only its own room; rooms share nothing that changes.
 */
public final class Room {
  /** The room closes in good order before tick numbers run out: 413 days at 60 Hz. */
  private static final int LAST_TICK = Integer.MAX_VALUE - (1 << 20);

  /** Lines about comings and goings: so many at once, and so many per second. */
  private static final float MAX_ANNOUNCEMENTS = 20;

  private static final float ANNOUNCEMENTS_PER_S = 2;

  /** A line to more than these counts as several. */
  private static final int FEW_SESSIONS = 64;

  private static final int MAX_QUESTIONS = 16;
  private static final long ANSWER_S = 2;
  private static final Logger LOG = LoggerFactory.getLogger(Room.class);
  private static final long NS_PER_MS = 1_000_000;
  private static final long PARTING_MS = 1_000;

  /** A crowd that comes at once must not cost those who play a tick: at most so many a tick. */
  private static final int MAX_ARRIVALS_PER_TICK = 8;

  /** And after such a part of a tick's time the rest waits for the next tick. */
  private static final int ARRIVALS_PART = 8;

  /** Nor must one that goes at once. */
  private static final int MAX_DEPARTURES_PER_TICK = 16;

  /** Of ticks that are made good in one burst, only so many of the last are worth a snapshot. */
  private static final int MAX_SENDS_PER_BURST = 2;

  private final ServerConfig config;
  private final int number;
  private final long seed;
  private final String label;
  private final LongSupplier clock;
  private final Counters counters = new Counters();
  private final Seats seats;
  private final GameFailures failures;
  private final Simulation simulation;
  private final RoomRecording recording;
  private final FrameCapture capture;
  private long droppedEvents;
  private final OwnCapture ownCapture;
  private final TickLoop loop;
  private final SendTurns turns;
  private final ArrayBlockingQueue<Admission> arrivals;
  private final ArrayBlockingQueue<FutureTask<String>> questions =
      new ArrayBlockingQueue<>(MAX_QUESTIONS);
  private final List<Session> sessions = new ArrayList<>();
  private final Session[] bySeat;
  private final IdentityHashMap<Session, RuntimeException> broken = new IdentityHashMap<>();
  private final PartingLinks partings = new PartingLinks(Limits.MAX_PLAYERS);
  private final Consumer<String> broadcastNotice = this::broadcast;
  private final RosterNews roster;
  private final BiConsumer<Session, Broadcast> sendTo = this::sendTo;
  private final AtomicInteger seatsAskedFor = new AtomicInteger();
  private int failedTicks;
  private int announcedTick;
  private float announcements = MAX_ANNOUNCEMENTS;
  private final LogInterval dropsWarning = new LogInterval();
  private final LogInterval lateWarning = new LogInterval();
  private long droppedUntold;
  private volatile int tick;
  private volatile boolean failed;
  private volatile boolean closed;

  /**
   * Builds the level and sets up the game.
   *
   * @param number 1 for the server's first room; log lines name it when there are several
   * @param gameRules an instance of this room's own
   * @param clock nanoseconds, to measure how long ticks take
   * @param seats this room's seats, shared with the lobby
   */
  public Room(
      ServerConfig config,
      int number,
      Game gameRules,
      Level level,
      LongSupplier clock,
      Seats seats) {
    this.config = config;
    this.number = number;
    this.seed = config.seed() + number - 1;
    this.label = config.rooms() == 1 ? "" : "room " + number + ": ";
    this.clock = clock;
    this.seats = seats;
    this.failures = new GameFailures(gameRules.name(), counters, label);
    GuardedGame game = new GuardedGame(gameRules, failures);
    this.simulation = new Simulation(game, level, seed, config.tickRateHz(), Role.AUTHORITY);
    this.recording = new RoomRecording(simulation, seed, label, counters);
    this.capture = new FrameCapture(simulation);
    this.ownCapture = new OwnCapture(simulation);
    this.loop = new TickLoop(config.tickRateHz(), config.catchUpTicks());
    this.turns = new SendTurns(config.tickRateHz(), config.snapshotRateHz());
    this.arrivals = new ArrayBlockingQueue<>(2 * seats.count());
    this.bySeat = new Session[seats.count()];
    this.roster = new RosterNews(seats.count(), config.rosterIntervalMs());
    capture.capture();
  }

  /**
   * Has other threads help with stepping the world, before the first turn.
   *
   * @param helpers null for nobody; may be shared with other rooms
   */
  public void helpedBy(Workers helpers) {
    simulation.world().workers(helpers);
  }

  /**
   * Records the game from now on, between two ticks. The last block tells why it ended when the
   * room closes.
   *
   * @param sink takes the blocks, on the room's thread; stays the caller's to close
   */
  public void record(BlockSink sink) {
    recording.begin(sink);
  }

  /**
   * Records the game into one file after the other, from now on; before the first {@link #doWork}.
   *
   * @param files stay the caller's to close
   * @throws IOException when the first file can't be created
   * @throws IllegalArgumentException when the game {@linkplain carom.sim.Game#keepsMore keeps more}
   *     than its state, so that only one file can begin
   */
  public void record(RotatingRecording files) throws IOException {
    recording.begin(files);
  }

  /**
   * Hands over a player whose level is loaded; from any thread.
   *
   * @return false when too many are on their way or the room is closed; the link and the claim stay
   *     the caller's
   */
  public boolean admit(Admission admission) {
    if (closed || !arrivals.offer(admission)) {
      return false;
    }
    // A room that closes in between has either told this player goodbye, or never will.
    return !closed || !arrivals.remove(admission);
  }

  /**
   * One turn: takes what has arrived and runs the ticks that are due, at most {@code catchUpTicks}.
   *
   * @param nowNs monotonic time
   * @return how much was done; 0 when the caller may wait until {@link #nextDeadlineNs}
   */
  public int doWork(long nowNs) {
    for (FutureTask<String> q; (q = questions.poll()) != null; ) {
      q.run();
    }
    if (closed) {
      return partings.doWork(nowNs);
    }
    int work = pollAll(nowNs) + partings.doWork(nowNs);
    int due = loop.due(nowNs);
    if (loop.droppedNow() > 0) {
      counters.add(Counter.TICKS_DROPPED, loop.droppedNow());
      droppedUntold += loop.droppedNow();
    }
    if (droppedUntold > 0 && dropsWarning.begins(nowNs)) {
      warnOfDroppedTicks();
    }
    counters.add(Counter.TICKS_LATE, Math.max(0, due - 1));
    for (int left = due; left > 0 && !closed; left--) {
      guardedTick(nowNs, left <= MAX_SENDS_PER_BURST);
    }
    return work + due;
  }

  /**
   * An exception that gets through every inner guard is a bug. Counted by ticks, not by turns: most
   * turns have no tick to do and succeed.
   */
  private void guardedTick(long nowNs, boolean sends) {
    try {
      tick(nowNs, sends);
      failedTicks = 0;
    } catch (RuntimeException | StackOverflowError e) {
      failedTicks++;
      if (failedTicks == 1) {
        LOG.error("{}tick {} failed; the room goes on", label, tick + 1, e);
      }
      if (failedTicks >= config.tickRateHz()) {
        fail(failedTicks + " ticks in a row failed");
      }
    }
    if (tick >= LAST_TICK) {
      fail("it has run for as long as its ticks can be numbered; start the server again");
    }
  }

  /** When the next tick is due; valid after the first {@link #doWork}. */
  public long nextDeadlineNs() {
    return loop.nextDeadlineNs();
  }

  private void tick(long nowNs, boolean sends) {
    long beginNs = clock.getAsLong();
    admitArrivals(beginNs, nowNs);
    serveWishes(nowNs);
    int next = simulation.tick() + 1;
    for (int i = sessions.size() - 1; i >= 0; i--) {
      sessions.get(i).consumeInput(next);
    }
    boolean stepped = step();
    if (stepped) {
      capture.capture();
      counters.add(Counter.EVENTS_LOST, simulation.droppedEvents() - droppedEvents);
      droppedEvents = simulation.droppedEvents();
      if (sends) {
        replicate(beginNs, nowNs);
      }
      simulation.drainNotices(broadcastNotice);
      roster.send(bySeat, nowNs, sendTo);
    }
    tick = simulation.tick();
    counters.add(Counter.TICKS, 1);
    recording.tickEnds();
    long tookNs = clock.getAsLong() - beginNs;
    counters.tickTook(tookNs);
    if (tookNs > loop.periodNs()) {
      counters.add(Counter.TICKS_OVERRUN, 1);
    }
    if (failures.endTick() >= config.tickRateHz()) {
      fail(
          "game "
              + simulation.game().name()
              + " failed in each of the last "
              + config.tickRateHz()
              + " ticks");
    }
  }

  private int pollAll(long nowNs) {
    int work = 0;
    for (int i = sessions.size() - 1; i >= 0; i--) {
      Session session = sessions.get(i);
      if (session.state() == SessionState.PLAYING) {
        try {
          work += session.poll(nowNs);
        } catch (RuntimeException e) {
          failSession(session, e, nowNs);
        }
      }
    }
    return work;
  }

  private void admitArrivals(long beginNs, long nowNs) {
    for (int i = 0; i < MAX_ARRIVALS_PER_TICK; i++) {
      if (i > 0 && clock.getAsLong() - beginNs > loop.periodNs() / ARRIVALS_PART) {
        break;
      }
      Admission a = arrivals.poll();
      if (a == null) {
        break;
      }
      seats.occupy(a.seat());
      try {
        admitOne(a, nowNs);
      } catch (RuntimeException e) {
        counters.add(Counter.SESSIONS_FAILED, 1);
        LOG.error("{}player {} could not be admitted", label, a.seat().id(), e);
        part(a.link(), "server error", nowNs);
        if (bySeat[a.seat().id()] == null) {
          seats.vacate(a.seat());
        }
      }
    }
  }

  private void admitOne(Admission a, long nowNs) {
    int id = a.seat().id();
    Session session = bySeat[id];
    boolean resumed = session != null;
    if (session == null) {
      Player player = simulation.join(id, a.seat().name());
      session = new Session(a.seat(), player, config, capture, ownCapture, counters);
      sessions.add(session);
      bySeat[id] = session;
    } else if (session.state() == SessionState.PLAYING) {
      // The client is back before we noticed that its old link is dead, or it plays twice.
      session.sayGoodbye(GoodbyeReason.RESUMED_ELSEWHERE, "");
      part(session.detach(nowNs), "resumed by another link", nowNs);
    }
    session.attach(a.link(), a.datagramKey(), simulation.tick());
    roster.changed();
    counters.add(Counter.JOINS, 1);
    if (resumed) {
      counters.add(Counter.RESUMES, 1);
    }
    LOG.info(
        "{}{}: {} as player {} from {}, {} of {} players",
        label,
        resumed ? "back" : "join",
        a.seat().name(),
        id,
        a.link().remote(),
        sessions.size(),
        seats.count());
    announce(session, a.seat().name() + (resumed ? " is back" : " joined"));
    updateGauges();
  }

  /**
   * Asks for a place for a newcomer, from any thread: whoever lost the connection first gives it up
   * in the next tick, unless just coming back.
   *
   * @return false when nobody has lost the connection
   */
  public boolean giveWay() {
    long waiting = counters.get(Counter.PLAYERS_IN_GRACE);
    if (waiting > seatsAskedFor.get()) {
      seatsAskedFor.incrementAndGet();
    }
    return waiting > 0;
  }

  /** The session that has waited longest for its player, when its place is asked for; or null. */
  private Session whoGivesWay() {
    Session first = null;
    for (int i = 0; i < sessions.size() && seatsAskedFor.get() > 0; i++) {
      Session session = sessions.get(i);
      if (session.state() == SessionState.GRACE
          && !seats.isClaimed(session.seat())
          && (first == null || session.graceEndNs() - first.graceEndNs() < 0)) {
        first = session;
      }
    }
    if (first == null) {
      seatsAskedFor.set(0);
    }
    return first;
  }

  private void serveWishes(long nowNs) {
    Session givesWay = whoGivesWay();
    int departures = 0;
    for (int i = sessions.size() - 1; i >= 0 && departures < MAX_DEPARTURES_PER_TICK; i--) {
      departures += departs(sessions.get(i), givesWay, nowNs) ? 1 : 0;
    }
  }

  /** Lets a session go whose time has come; whether it had. */
  private boolean departs(Session session, Session givesWay, long nowNs) {
    if (session.state() == SessionState.GRACE) {
      if (session == givesWay) {
        seatsAskedFor.decrementAndGet();
        remove(session, "gave way to a newcomer", " is gone", nowNs);
      } else if (session.graceIsOver(nowNs) && !seats.isClaimed(session.seat())) {
        remove(session, "did not come back", " is gone", nowNs);
      } else {
        return false;
      }
    } else if (session.wish() == Session.Wish.LEAVE) {
      counters.add(Counter.LEAVES, 1);
      session.sayGoodbye(GoodbyeReason.LEFT, "");
      remove(session, "left", " left", nowNs);
    } else if (session.wish() == Session.Wish.EXPEL) {
      counters.add(Counter.SESSIONS_EXPELLED, 1);
      session.sayGoodbye(GoodbyeReason.PROTOCOL_ERROR, "Received " + session.offence() + ".");
      remove(session, "expelled for " + session.offence(), " was removed", nowNs);
    } else if (session.linkLost()) {
      lose(session, "link lost: " + session.linkLostReason(), nowNs);
    } else if (session.isSilent()) {
      lose(session, "silent for " + config.silenceTimeoutMs() + " ms", nowNs);
    } else {
      return false;
    }
    return true;
  }

  /** The body stays for the grace period, or goes at once when there is none. */
  private void lose(Session session, String why, long nowNs) {
    counters.add(Counter.LINKS_LOST, 1);
    session.sayGoodbye(GoodbyeReason.TIMEOUT, "");
    if (config.graceMs() == 0) {
      remove(session, why, " is gone", nowNs);
      return;
    }
    LOG.info(
        "{}lost: {}, player {}, {}; the body waits {} s",
        label,
        session.seat().name(),
        session.seat().id(),
        why,
        config.graceMs() / 1_000);
    part(session.detach(nowNs), why, nowNs);
    announce(session, session.seat().name() + " lost the connection");
    updateGauges();
  }

  private void remove(Session session, String why, String notice, long nowNs) {
    sessions.remove(session);
    bySeat[session.seat().id()] = null;
    part(session.end(), why, nowNs);
    simulation.leave(session.player());
    seats.vacate(session.seat());
    roster.changed();
    LOG.info(
        "{}leave: {}, player {}, {}, {} of {} players",
        label,
        session.seat().name(),
        session.seat().id(),
        why,
        sessions.size(),
        seats.count());
    announce(session, session.seat().name() + notice);
    updateGauges();
  }

  /** An exception of ours while serving one session ends that session, and only that. */
  private void failSession(Session session, RuntimeException e, long nowNs) {
    counters.add(Counter.SESSIONS_FAILED, 1);
    LOG.error("{}session failed, {}; it is closed, the others go on", label, session, e);
    session.sayGoodbye(GoodbyeReason.SERVER_ERROR, "");
    remove(session, "server error", " was removed", nowNs);
  }

  private void part(Link link, String why, long nowNs) {
    if (link != null) {
      partings.add(link, why, nowNs + PARTING_MS * NS_PER_MS);
    }
  }

  /** Returns false when the step itself threw; the callbacks of the game can't. */
  private boolean step() {
    try {
      simulation.step();
      return true;
    } catch (RuntimeException | AssertionError | StackOverflowError e) {
      // The world is in the middle of a step now: nothing that follows would mean anything.
      LOG.error("{}the step of tick {} failed", label, simulation.tick() + 1, e);
      fail("its physics failed");
      return false;
    }
  }

  private void replicate(long beginNs, long nowNs) {
    int count = sessions.size();
    turns.begin(count, beginNs);
    for (int i = 0; i < count && simulation.game().relaysAhead(); i++) {
      if (sessions.get(i).state() == SessionState.PLAYING) {
        sessions.get(i).showWaiting(capture.frames().waiting());
      }
    }
    for (int i = 0; i < count; i++) {
      Session session = sessions.get(turns.index(i));
      try {
        if (session.state() == SessionState.GRACE) {
          session.listen();
        } else if (session.state() == SessionState.PLAYING
            && session.isSnapshotDue()
            && turns.take(i, clock.getAsLong())) {
          session.sendSnapshot(clock.getAsLong() - beginNs + nowNs);
        }
      } catch (RuntimeException e) {
        broken.put(session, e);
      }
    }
    if (!broken.isEmpty()) {
      broken.forEach((session, e) -> failSession(session, e, nowNs));
      broken.clear();
    }
    if (turns.late() > 0) {
      warnOfLateSnapshots(nowNs);
    }
  }

  /** At once, and of those that follow in a line every ten seconds: a log must last for weeks. */
  private void warnOfDroppedTicks() {
    LOG.warn(
        "{}can't keep up: {} ticks ({} ms) dropped up to tick {}; {}",
        label,
        droppedUntold,
        droppedUntold * 1_000 / config.tickRateHz(),
        tick,
        "if this repeats, lower --tick-rate or --max-players, or find a faster machine");
    droppedUntold = 0;
  }

  /** The first sign that the machine gets too slow; the ticks are still on time. */
  private void warnOfLateSnapshots(long nowNs) {
    counters.add(Counter.SNAPSHOTS_POSTPONED, turns.late());
    if (lateWarning.begins(nowNs)) {
      LOG.warn(
          "{}ticks take too long at tick {}: {} of {} snapshots wait for the next one; {}",
          label,
          simulation.tick(),
          turns.late(),
          sessions.size(),
          "if this repeats, lower --snapshot-rate, --budget or --max-players");
    }
  }

  private void broadcast(String text) {
    sendToAll(new ServerMessage.Notice(text), null);
  }

  /**
   * Who comes and goes; a few of them a second, since a crowd can come and go at once, and the
   * fewer the more they are told to.
   */
  private void announce(Session about, String text) {
    float refill = (tick - announcedTick) * ANNOUNCEMENTS_PER_S / config.tickRateHz();
    announcedTick = tick;
    announcements = Math.min(MAX_ANNOUNCEMENTS, announcements + refill);
    if (announcements < 1) {
      return; // the roster tells it anyway
    }
    announcements -= Math.max(1, sessions.size() / (float) FEW_SESSIONS);
    sendToAll(new ServerMessage.Notice(text), about);
  }

  private void sendToAll(ServerMessage message, Session except) {
    Broadcast broadcast = new Broadcast(message);
    for (int i = 0; i < sessions.size(); i++) {
      Session session = sessions.get(i);
      if (session != except && session.state() == SessionState.PLAYING) {
        sendTo(session, broadcast);
      }
    }
  }

  private void sendTo(Session session, Broadcast message) {
    try {
      session.send(message); // a link that refuses closes, and is found closed at its next poll
    } catch (RuntimeException e) {
      counters.add(Counter.SESSIONS_FAILED, 1);
      LOG.error("{}message {} could not be sent, {}", label, message, session, e);
    }
  }

  private void updateGauges() {
    int playing = 0;
    for (int i = 0; i < sessions.size(); i++) {
      if (sessions.get(i).state() == SessionState.PLAYING) {
        playing++;
      }
    }
    counters.set(Counter.PLAYERS, playing);
    counters.set(Counter.PLAYERS_IN_GRACE, sessions.size() - playing);
  }

  /**
   * Closes the room for an error that it can't go on after, and tells its players.
   *
   * @param why for the log
   */
  public void fail(String why) {
    LOG.error("{}closed at tick {}: {}", label.isEmpty() ? "room " : label, tick, why);
    failed = true;
    close(GoodbyeReason.SERVER_ERROR, "", clock.getAsLong());
  }

  /**
   * Tells everybody why the game ends and runs no further tick. The links stay open for a moment,
   * while {@link #doWork} is called, so that the goodbye arrives; {@link #closeLinks} ends that.
   */
  public void close(GoodbyeReason reason, String text, long nowNs) {
    if (closed) {
      return;
    }
    closed = true;
    recording.end(reason.name());
    for (Session session : sessions) {
      session.sayGoodbye(reason, text);
      part(session.end(), reason.name(), nowNs);
    }
    for (Admission a; (a = arrivals.poll()) != null; ) {
      a.link().send(new ServerMessage.Goodbye(reason, text));
      part(a.link(), reason.name(), nowNs);
    }
    sessions.clear();
    updateGauges();
  }

  /** Whether all links have said goodbye. */
  public boolean isDeserted() {
    return sessions.isEmpty() && partings.isEmpty();
  }

  /** Closes the links that linger after {@link #close}. */
  public void closeLinks() {
    partings.closeAll();
  }

  /**
   * Why a player was not sent an entity, or that it was: one line for an operator. From any thread
   * but the room's; waits for the room's next turn.
   *
   * @param playerId a seat's number
   * @param entityId an entity's number
   */
  public String why(int playerId, int entityId) {
    return ask(() -> explain(playerId, entityId));
  }

  /**
   * Removes a player, who is told so and may join again. From any thread but the room's; waits for
   * the room's next turn.
   *
   * @param playerId a seat's number
   * @param text for the player, may be empty
   * @return what was done, in one line for an operator
   */
  public String kick(int playerId, String text) {
    return ask(
        () -> {
          Session session = session(playerId);
          if (session == null) {
            return nobody(playerId);
          }
          session.sayGoodbye(GoodbyeReason.KICKED, text);
          remove(session, "kicked by the operator", " was removed", clock.getAsLong());
          return "removed player=" + playerId + " name=" + session.seat().name();
        });
  }

  /**
   * Begins to record the game for an operator. From any thread but the room's; waits for the room's
   * next turn.
   *
   * @param target a file that is not there yet, or a folder, which then gets a file with a name of
   *     its own
   * @return the file, or why there is none, in one line for an operator
   */
  public String record(Path target) {
    Path file =
        RecordingFile.fileFor(target, config.gameName(), config.rooms() == 1 ? 0 : number)
            .toAbsolutePath();
    return ask(() -> closed ? "room=" + number + " is closed" : recording.begin(file));
  }

  /**
   * Ends the recording, whoever began it, but not one that spectators watch. From any thread but
   * the room's; waits for the room's next turn, and at most 5 s more until the file is written.
   *
   * @return the file, or why it goes on, in one line for an operator, who is told if the disk takes
   *     longer
   */
  public String stopRecording() {
    String answer = ask(recording::stop);
    return recording.awaitEnd() ? answer : answer + "; the disk has not taken all of it yet";
  }

  /**
   * Waits until the recording that ended last is written, at most 5 s; when the room has closed.
   */
  public void awaitRecording() {
    recording.awaitEnd();
  }

  private String nobody(int playerId) {
    return "player=" + playerId + " doesn't play here; players are 0.." + (bySeat.length - 1);
  }

  private String ask(Callable<String> what) {
    FutureTask<String> question = new FutureTask<>(what);
    if (!questions.offer(question)) {
      return "too many questions at once; ask again";
    }
    try {
      return question.get(ANSWER_S, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return "interrupted";
    } catch (ExecutionException | TimeoutException e) {
      questions.remove(question);
      return "no answer from the room: " + e;
    }
  }

  private String explain(int playerId, int entityId) {
    Session session = session(playerId);
    if (session == null) {
      return nobody(playerId);
    }
    if (session.state() != SessionState.PLAYING) {
      return "player=" + playerId + " is away: nothing is sent to it";
    }
    if (entityId < 0 || entityId >= frames().capacity()) {
      return "entity=" + entityId + " is outside 0.." + (frames().capacity() - 1);
    }
    return "player="
        + playerId
        + " "
        + session.sender().encoder().explain(entityId)
        + " nearRowsWaiting="
        + session.waitingNearRows()
        + " paceBytesPerSecond="
        + session.sender().paceBytesPerSecond();
  }

  /** The room's number, from 1 on; from any thread. */
  public int number() {
    return number;
  }

  /** Start of this room's random numbers; from any thread. */
  public long seed() {
    return seed;
  }

  /** The last tick that was computed; from any thread. */
  public int tick() {
    return tick;
  }

  /** Whether the room closed itself because of an error, see {@link #fail}; from any thread. */
  public boolean hasFailed() {
    return failed;
  }

  /** The seats, shared with the lobby. */
  public Seats seats() {
    return seats;
  }

  /** What the room counts; from any thread. */
  public Counters counters() {
    return counters;
  }

  /** The world and its players, for reading. */
  public Simulation simulation() {
    return simulation;
  }

  /** The frame states of the last ticks, for reading. */
  public FrameRing frames() {
    return capture.frames();
  }

  /**
   * Questions about the world as a session's client shows it: casts, overlaps, nearest points; see
   * {@link Simulation#asSeenBy}. On the room's thread.
   *
   * @throws IllegalStateException when the game doesn't look back
   */
  public Queries<Entity> asSeenBy(Session session) {
    return simulation.asSeenBy(session.player());
  }

  /** The session on a seat, or null. */
  public Session session(int playerId) {
    return playerId >= 0 && playerId < bySeat.length ? bySeat[playerId] : null;
  }
}
