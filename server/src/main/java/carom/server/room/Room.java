package carom.server.room;

import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.Limits;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.snapshot.frame.FrameRing;
import carom.net.transport.Broadcast;
import carom.physics.Queries;
import carom.physics.threads.Workers;
import carom.replay.BlockSink;
import carom.server.checkpoint.RoomCheckpoints;
import carom.server.checkpoint.SlotDisk;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.MatchInfo;
import carom.server.match.MatchLibrary;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.metrics.StageTimes;
import carom.server.metrics.TurnStage;
import carom.server.picture.RoomPictures;
import carom.server.recording.RecordingFiles;
import carom.server.recording.RotatingRecording;
import carom.server.room.match.Match;
import carom.server.room.match.MatchLoader;
import carom.server.room.match.RoomContext;
import carom.server.room.recording.RoomRecording;
import carom.server.schedule.LoadWarnings;
import carom.server.schedule.TickLoad;
import carom.server.schedule.TickLoop;
import carom.server.session.Admission;
import carom.server.session.PartingLinks;
import carom.server.session.RosterNews;
import carom.server.session.SeatRequests;
import carom.server.session.Seats;
import carom.server.session.Session;
import carom.sim.MatchClock;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A room: one match after the other at a fixed rate, and the sessions that steer and see them. All
 * matches but the first begin because the game or an operator wants another level or game; players
 * and links stay.
 *
 * <p>{@link #doWork} is one turn of the duty cycle: it takes what has arrived and runs the ticks
 * that are due. A tick, in order:
 *
 * <pre>
 *   Arrivals            players from the lobby get a session
 *   Departures          sessions end, or begin their grace period
 *   RoomMoves           players see the other rooms, and go there
 *   Session             one input per player
 *   Simulation.step
 *   FrameCapture        the frame state, quantised once for all sessions
 *   SnapshotRound       each session's snapshot
 *   Post                messages of the game, which Session collected before the step
 *   Announcer           notices of the game
 *   RosterNews          players and scores that changed
 *   Counters, RoomRecording
 *   MatchChange         another match, if one is wanted and loaded
 * </pre>
 *
 * <p>Only {@link #admit}, {@link #seatRequests}, {@link #operator}, {@link #number}, {@link #name},
 * {@link #match}, {@link #tick}, {@link #age}, {@link #seats}, {@link #counters}, {@link #stages},
 * {@link #pictures}, {@link #isPaused} and {@link #hasFailed} may be called from any thread; the
 * rest belongs to the thread that calls {@link #doWork}. A tick in the steady state allocates next
 * to nothing. A client can hurt only its own session, and a game only its own room: rooms share
 * nothing that changes.
 *
 * <p><b>Length.</b> Just above 500 lines: what a room does in a turn is told in one place, and each
 * part of it is a class of its own.
 */
public final class Room {
  /** The room closes in good order before tick numbers run out: 413 days at 60 Hz. */
  private static final int LAST_TICK = Integer.MAX_VALUE - (1 << 20);

  private static final Logger LOG = LoggerFactory.getLogger(Room.class);

  /** Of several ticks that are made good in one turn, only so many of the last send snapshots. */
  private static final int MAX_SENDS_PER_BURST = 2;

  private final RoomContext context;
  private final int number;
  private final RoomConfig settings;
  private final LongSupplier clock;
  private final Counters counters;
  private final StageTimes stages;
  private final RoomPictures pictures = new RoomPictures();
  private final RoomRecording recording;
  private final TickLoop loop;
  private final TickLoad load;
  private final PartingLinks partings = new PartingLinks(Limits.MAX_PLAYERS);
  private final RoomSessions sessions;
  private final RosterNews roster;
  private final Post post;
  private final Departures departures;
  private final MatchChange changes;
  private final Arrivals arrivals;
  private final RoomMoves moves;
  private final LoadWarnings warnings;
  private final SnapshotRound snapshots;
  private final OperatorCommands operator;

  /** Null if the room isn't kept. */
  private volatile RoomCheckpoints checkpoints;

  private final Consumer<String> sendNotice;
  private final BiConsumer<Session, Broadcast> sendTo;
  private int failedTicks;
  private volatile int tick;
  private volatile String phase;
  private volatile boolean failed;
  private volatile boolean closed;
  private volatile boolean paused;

  /**
   * Builds the level and sets up the game of the first match.
   *
   * @param config settings of the server
   * @param number 1 for the server's first room
   * @param alone whether the server has no other room, so that log lines needn't name this one
   * @param settings the room's own
   * @param library finds games and levels
   * @param loads runs what builds further matches, on a thread that no tick waits for
   * @param clock nanoseconds, to measure how long ticks take
   * @param seats this room's seats, shared with the lobby
   * @param directory the server's rooms
   * @param counters those of a room whose place this one takes, or new ones
   * @throws IllegalArgumentException when the first match can't be played; the message says why
   */
  public Room(
      ServerConfig config,
      int number,
      boolean alone,
      RoomConfig settings,
      MatchLibrary library,
      Executor loads,
      LongSupplier clock,
      Seats seats,
      RoomDirectory directory,
      Counters counters) {
    this.number = number;
    this.counters = counters;
    this.settings = settings;
    this.clock = clock;
    stages = new StageTimes(clock);
    String label = alone ? "" : "room " + settings.name() + ": ";
    MatchLoader loader = new MatchLoader(config, settings, library, label, counters);
    context = new RoomContext(config, label, counters, seats, firstMatch(loader));
    recording = new RoomRecording(context);
    loop = new TickLoop(config.tickRateHz(), config.catchUpTicks());
    load = new TickLoad(config.tickRateHz());
    sessions = new RoomSessions(seats.count(), label, counters);
    Announcer announcer = new Announcer(sessions, config.tickRateHz());
    roster = new RosterNews(seats.count(), config.rosterIntervalMs());
    departures = new Departures(context, sessions, roster, announcer, partings);
    changes =
        new MatchChange(context, loader, loads, settings, sessions, recording, roster, announcer);
    arrivals = new Arrivals(context, clock, sessions, departures, roster, announcer, changes);
    moves = new RoomMoves(context, this, directory, sessions, departures);
    warnings = new LoadWarnings(label, counters, config.tickRateHz());
    snapshots = new SnapshotRound(context, clock, sessions, departures, warnings);
    operator =
        new OperatorCommands(
            context, number, sessions, departures, recording, changes, clock, () -> closed);
    post = new Post(context, sessions, directory);
    sendNotice = announcer::notice;
    sendTo = sessions::sendTo;
    context.match().capture().capture();
    phase = presentPhase();
  }

  private static Match firstMatch(MatchLoader loader) {
    try {
      return loader.first();
    } catch (MatchLoader.Unplayable e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /**
   * Lets other threads help with stepping the world; call before the first turn.
   *
   * @param helpers null for none; may be shared with other rooms
   */
  public void helpedBy(Workers helpers) {
    context.helpedBy(helpers);
  }

  /**
   * Records the present match from now on, between two ticks. The last block tells why it ended
   * when the match ends or the room closes.
   *
   * @param sink takes the blocks, on the room's thread; stays the caller's to close
   */
  public void record(BlockSink sink) {
    recording.begin(sink);
  }

  /**
   * Records each match into a file of its own, from now on.
   *
   * @param files stay the caller's to close
   * @throws IOException when the first file can't be created
   */
  public void record(RecordingFiles files) throws IOException {
    recording.begin(files);
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
   * Keeps the room on the disk from now on. If an earlier run has left a checkpoint, the room first
   * goes on from where that run ended, with its players in their grace period. Before the first
   * {@link #doWork}, and before the room is recorded.
   *
   * @param disk stays the caller's to close, after this room
   * @param folder for this room alone; created if it isn't there
   * @param seconds time between checkpoints, s
   * @throws IOException if the folder can't be used
   */
  public void checkpoint(SlotDisk disk, Path folder, int seconds) throws IOException {
    RoomCheckpoints.Setting kept =
        new RoomCheckpoints.Setting(
            context.config(),
            settings,
            number,
            context.label(),
            counters,
            seats(),
            sessions.bySeat());
    checkpoints = new RoomCheckpoints(kept, disk, folder, seconds);
    changes.keep(checkpoints, clock.getAsLong());
    tick = context.simulation().tick();
    phase = presentPhase();
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
    return !closed || !arrivals.withdraw(admission);
  }

  /**
   * Does one turn: takes what has arrived and runs the ticks that are due, at most {@code
   * catchUpTicks}.
   *
   * @param nowNs monotonic time
   * @return the amount of work done; 0 when the caller may wait until {@link #nextDeadlineNs}
   */
  public int doWork(long nowNs) {
    operator.serve();
    if (closed) {
      return partings.doWork(nowNs);
    }
    int work = pollAll(nowNs) + partings.doWork(nowNs);
    paused = isIdle();
    if (paused) {
      loop.pause();
    }
    int due = paused ? 0 : loop.due(nowNs);
    counters.set(Counter.LOAD_PERCENT, load.percent());
    warnings.ticksDropped(loop.droppedNow(), tick, nowNs);
    counters.add(Counter.TICKS_LATE, Math.max(0, due - 1));
    for (int left = due; left > 0 && !closed; left--) {
      guardedTick(nowNs, left <= MAX_SENDS_PER_BURST);
    }
    if ((due > 0 || paused) && pictures.isWanted()) {
      stages.begin();
      pictures.take(context.match().info(), context.simulation(), sessions.bySeat());
      stages.end(TurnStage.PICTURE);
    }
    return work + due;
  }

  private boolean isIdle() {
    return context.config().pausesIdleRooms()
        && context.age() > 0
        && sessions.count() == 0
        && arrivals.isEmpty()
        && !recording.isOn();
  }

  /**
   * Steps the room and guards it. An exception that gets through every inner guard is a bug.
   * Counted by ticks, not by turns: most turns have no tick to do and succeed.
   */
  private void guardedTick(long nowNs, boolean sends) {
    try {
      tick(nowNs, sends);
      failedTicks = 0;
    } catch (RuntimeException | StackOverflowError e) {
      failedTicks++;
      if (failedTicks == 1) {
        LOG.error("{}tick {} failed; the room goes on", context.label(), tick + 1, e);
      }
      if (failedTicks >= context.config().tickRateHz()) {
        fail(failedTicks + " ticks in a row failed");
      }
    }
    if (tick >= LAST_TICK) {
      fail("it has run for as long as its ticks can be numbered; start the server again");
    }
  }

  /** Returns when the next tick is due; valid after the first {@link #doWork}. */
  public long nextDeadlineNs() {
    return loop.nextDeadlineNs();
  }

  private void tick(long nowNs, boolean sends) {
    long beginNs = clock.getAsLong();
    stages.begin();
    arrivals.admit(beginNs, nowNs);
    departures.serve(nowNs);
    moves.serve(nowNs);
    Match match = context.match();
    Simulation simulation = match.simulation();
    int next = simulation.tick() + 1;
    for (int i = sessions.count() - 1; i >= 0; i--) {
      sessions.get(i).consumeInput(next);
      sessions.get(i).tellPace(load.pacePercent());
    }
    post.collect();
    stages.end(TurnStage.INPUTS);
    boolean stepped = step();
    stages.end(TurnStage.STEP);
    if (stepped) {
      match.capture().capture();
      stages.end(TurnStage.CAPTURE);
      counters.add(Counter.EVENTS_LOST, match.takeDroppedEvents());
      if (sends) {
        snapshots.run(beginNs, nowNs);
        stages.end(TurnStage.SNAPSHOTS);
      }
      post.send();
      simulation.outbox().drainNotices(sendNotice);
      match.failures().tell(simulation.findings());
      roster.send(sessions.bySeat(), nowNs, sendTo);
    }
    counters.add(Counter.TICKS, 1);
    context.passTick();
    recording.tickEnds();
    if (stepped) {
      changes.tickEnds(nowNs);
      if (checkpoints != null) {
        checkpoints.tickEnds(nowNs);
      }
    }
    tick = context.simulation().tick();
    phase = presentPhase();
    stages.end(TurnStage.REST);
    long tookNs = clock.getAsLong() - beginNs;
    counters.tickTook(tookNs);
    if (load.tickTook(tookNs)) {
      loop.pace(load.pacePercent(), nowNs + tookNs);
      warnings.paceChanged(load.pacePercent(), nowNs);
    }
    if (tookNs > loop.periodNs()) {
      counters.add(Counter.TICKS_OVERRUN, 1);
    }
    int rate = context.config().tickRateHz();
    if (match.failures().endTick() >= rate && !closed) {
      String game = simulation.game().name();
      fail("game " + game + " failed in each of the last " + rate + " ticks");
    }
  }

  /** Returns the phase of the match for people, empty if the game has no clock. */
  private String presentPhase() {
    Simulation simulation = context.simulation();
    return simulation.game().clock() == null ? "" : MatchClock.phase(simulation).text();
  }

  private int pollAll(long nowNs) {
    int work = 0;
    for (int i = sessions.count() - 1; i >= 0; i--) {
      Session session = sessions.get(i);
      if (session.state() == SessionState.PLAYING || session.state() == SessionState.LOADING) {
        try {
          work += session.poll(nowNs);
        } catch (RuntimeException e) {
          departures.fail(session, e, nowNs);
        }
      }
    }
    return work;
  }

  /** Returns the requests of newcomers for seats; any thread may ask. */
  public SeatRequests seatRequests() {
    return departures.requests();
  }

  /** Returns false when the step itself threw; the callbacks of the game can't. */
  private boolean step() {
    Simulation simulation = context.simulation();
    try {
      simulation.step();
      return true;
    } catch (RuntimeException | AssertionError | StackOverflowError e) {
      // The world is in the middle of a step now: nothing that follows would mean anything.
      LOG.error("{}the step of tick {} failed", context.label(), simulation.tick() + 1, e);
      fail("its physics failed");
      return false;
    }
  }

  /**
   * Closes the room for an error that it can't go on after, and tells its players.
   *
   * @param why for the log
   */
  public void fail(String why) {
    String name = context.label().isEmpty() ? "room " : context.label();
    LOG.error("{}closed at tick {}: {}", name, tick, why);
    failed = true;
    close(GoodbyeReason.SERVER_ERROR, "", clock.getAsLong());
  }

  /**
   * Tells all players why the game ends and runs no further tick. The links stay open for a moment,
   * while {@link #doWork} is called, so that the goodbye arrives; {@link #closeLinks} ends that.
   */
  public void close(GoodbyeReason reason, String text, long nowNs) {
    if (closed) {
      return;
    }
    closed = true;
    recording.end(reason.name());
    if (checkpoints != null) {
      checkpoints.end(!failed, nowNs);
    }
    departures.endAll(reason, text, nowNs);
    arrivals.refuseAll(reason, text, nowNs);
  }

  /**
   * Gives the room up because its thread doesn't come back from the game: closes all links, and
   * makes it keep nothing more. From any thread. The room's own ends when it comes back.
   *
   * @param why for logs
   */
  public void abandon(String why) {
    closed = true;
    if (checkpoints != null) {
      checkpoints.abandon(why);
    }
    arrivals.closeLinks(why);
    sessions.closeLinks(why);
  }

  /** Returns whether all links have said goodbye. */
  public boolean isDeserted() {
    return sessions.count() == 0 && partings.isEmpty();
  }

  /** Closes the links that linger after {@link #close}. */
  public void closeLinks() {
    partings.closeAll();
  }

  /** Returns what an operator may ask of the room; from any thread but the room's. */
  public OperatorCommands operator() {
    return operator;
  }

  /**
   * Waits until the recording that ended last is written, at most 5 s; when the room has closed.
   */
  public void awaitRecording() {
    recording.awaitEnd();
  }

  /** Returns the room's number, from 1 on; from any thread. */
  public int number() {
    return number;
  }

  /** Returns the name by which players find the room; from any thread. */
  public String name() {
    return settings.name();
  }

  /** Returns the room's settings; from any thread. */
  public RoomConfig settings() {
    return settings;
  }

  /** Returns what clients must know to play the present match; from any thread. */
  public MatchInfo match() {
    return context.match().info();
  }

  /** Returns what a list of rooms says about this one; from any thread. */
  ServerMessage.RoomEntry entry() {
    MatchInfo match = match();
    return new ServerMessage.RoomEntry(
        name(),
        match.game(),
        match.level().level().name(),
        phase,
        seats().takenCount(),
        seats().count(),
        (int) counters.get(Counter.SPECTATORS),
        settings.metadata());
  }

  /** Returns the number of ticks that the room has run, of all matches; from any thread. */
  public int age() {
    return context.age();
  }

  /** Returns the last tick of the present match that was computed; from any thread. */
  public int tick() {
    return tick;
  }

  /**
   * Returns whether the room closed itself because of an error, see {@link #fail}; from any thread.
   */
  public boolean hasFailed() {
    return failed;
  }

  /**
   * Returns whether the room doesn't tick because nobody needs it, see {@link
   * ServerConfig#pausesIdleRooms}; from any thread.
   */
  public boolean isPaused() {
    return paused;
  }

  /** Returns the seats, shared with the lobby. */
  public Seats seats() {
    return context.seats();
  }

  /** Returns what the room counts; from any thread. */
  public Counters counters() {
    return counters;
  }

  /** Returns the number of ticks per second; from any thread. */
  public int tickRateHz() {
    return context.config().tickRateHz();
  }

  /** Returns how long the stages of its turns took; from any thread. */
  public StageTimes stages() {
    return stages;
  }

  /** Returns the pictures of the room for people who watch it; from any thread. */
  public RoomPictures pictures() {
    return pictures;
  }

  /** Returns the world and the players of the present match, for reading. */
  public Simulation simulation() {
    return context.simulation();
  }

  /** Returns the frame states of the last ticks, for reading. */
  public FrameRing frames() {
    return context.match().capture().frames();
  }

  /**
   * Questions about the world as a session's client shows it: casts, overlaps, nearest points; see
   * {@link Simulation#asSeenBy}. On the room's thread.
   *
   * @throws IllegalStateException when the game doesn't look back
   */
  public Queries<Entity> asSeenBy(Session session) {
    return simulation().asSeenBy(session.player());
  }

  /** Returns the session on a seat, or null. */
  public Session session(int playerId) {
    return sessions.onSeat(playerId);
  }
}
