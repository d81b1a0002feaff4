package carom.server.room;

import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.snapshot.frame.FrameRing;
import carom.net.transport.Link;
import carom.physics.Queries;
import carom.physics.threads.Workers;
import carom.replay.BlockSink;
import carom.server.account.BestLists;
import carom.server.checkpoint.RoomCheckpoints;
import carom.server.checkpoint.SlotDisk;
import carom.server.checkpoint.SlotLink;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.MatchInfo;
import carom.server.match.MatchLibrary;
import carom.server.match.RoomContext;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.metrics.TurnStage;
import carom.server.recording.RecordingFiles;
import carom.server.recording.RotatingRecording;
import carom.server.session.Admission;
import carom.server.session.Ownership;
import carom.server.session.SeatRequests;
import carom.server.session.Seats;
import carom.server.session.Session;
import carom.server.threads.LoaderThread;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * A room: one match after the other at a fixed rate, and the sessions that steer and see them. All
 * matches but the first begin because the game or an operator wants another level or game; players
 * and links stay.
 *
 * <p>{@link #doWork} is one turn of the duty cycle: it takes what has arrived and runs the ticks
 * that are due. {@link RoomParts} lists what a room consists of, {@link RoomTick} what a tick does
 * in which order, and {@link RoomEnd} how a room ends.
 *
 * <pre>
 *   sockets ──► Session, Arrivals ──► RoomTick: Simulation ─► FrameCapture ──► Session ──► sockets
 *                                        │
 *                  recordings, checkpoints, MatchChange
 * </pre>
 *
 * <p>Only {@link #admit}, {@link #seatRequests}, {@link #operator}, {@link #number}, {@link #name},
 * {@link #match}, {@link #tick}, {@link #age}, {@link #seats}, {@link #counters}, {@link #stages},
 * {@link #pictures}, {@link #isPaused} and {@link #hasFailed} may be called from any thread; the
 * rest belongs to the room's thread: the one that has its turn, {@link #doWork}. That may be
 * another one each time; turns don't overlap, and each sees what those before it wrote. A tick in
 * the steady state allocates next to nothing. A client can hurt only its own session, and a game
 * only its own room: rooms share nothing that changes.
 */
public final class Room implements FleetRoom {
  /** Number of ticks that send snapshots, the last ones, when several are made good in one turn. */
  private static final int MAX_SENDS_PER_BURST = 2;

  private final RoomParts parts;
  private final RoomContext context;
  private final int number;
  private volatile RoomConfig settings;
  private final RoomPictures pictures;
  private final RoomEnd end;
  private final RoomTick ticks;
  private final OperatorCommands operator;
  private final AtomicReference<Runnable> next = new AtomicReference<>();

  /** Number of ticks that are due and haven't been begun, since one before them is held. */
  private int owed;

  private volatile boolean paused;
  private volatile Runnable wake = () -> {};

  /**
   * Builds the level and sets up the game of the first match.
   *
   * @param config returns the present settings of the server
   * @param number 1 for the server's first room
   * @param label begins each log line; empty for a room without a name
   * @param settings the room's own
   * @param library finds games and levels
   * @param loads runs what builds further matches, on a thread that no tick waits for
   * @param clock nanoseconds, to measure how long ticks take
   * @param seats this room's seats, shared with the lobby
   * @param directory the server's rooms
   * @param counters those of a room whose place this one takes, or new ones
   * @param ownership whether the server owns the room; the room stands still while it doesn't
   * @param journal folder from which the room will {@link #resume}; null to begin anew
   * @throws IllegalArgumentException when the first match can't be played; the message says why
   */
  public Room(
      Supplier<ServerConfig> config,
      int number,
      String label,
      RoomConfig settings,
      MatchLibrary library,
      LoaderThread loads,
      LongSupplier clock,
      Seats seats,
      RoomDirectory directory,
      Counters counters,
      Ownership ownership,
      Path journal) {
    this.number = number;
    this.settings = settings;
    parts =
        new RoomParts(
            config, label, settings, library, loads, clock, seats, directory, counters, ownership,
            journal, this);
    context = parts.context;
    end = new RoomEnd(parts);
    ticks = new RoomTick(parts, end);
    operator = new OperatorCommands(parts, settings.name(), end::isClosed, () -> wake.run());
    pictures = new RoomPictures(this::wakeIfPaused);
    if (journal == null) {
      context.match().capture().capture();
    }
  }

  /**
   * Lets other threads help with stepping the world; call before the first turn.
   *
   * @param helpers null for none; for the worlds of this room alone
   */
  public void helpedBy(Workers helpers) {
    context.helpedBy(helpers);
  }

  /**
   * Sets what gives a paused room a turn when it is needed: a player comes, somebody watches, an
   * operator asks something, or somebody wants a picture. Before the first turn.
   *
   * @param newWake runs on any thread and returns at once
   */
  public void onNeeded(Runnable newWake) {
    wake = newWake;
  }

  /** Sets how many people watch; the room goes on for them without players. The lobby's thread. */
  public void watchedBy(long spectators) {
    counters().set(Counter.SPECTATORS, spectators);
    wake.run();
  }

  private void wakeIfPaused() {
    if (paused) {
      wake.run();
    }
  }

  /**
   * Records the present match from now on, between two ticks. The last block tells why it ended
   * when the match ends or the room closes.
   *
   * @param sink takes the blocks, on the room's thread; stays the caller's to close
   */
  public void record(BlockSink sink) {
    parts.recording.begin(sink);
  }

  /**
   * Records each match into a file of its own, from now on.
   *
   * @param files stay the caller's to close
   * @throws IOException when the first file can't be created
   */
  public void record(RecordingFiles files) throws IOException {
    parts.recording.begin(files);
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
    parts.recording.begin(files);
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
    RoomCheckpoints checkpoints = journal(folder, disk, seconds);
    parts.journals.own(checkpoints);
    parts.changes.keep(checkpoints, parts.clock.getAsLong());
    ticks.show();
  }

  /**
   * Goes on where a room of this name was, as its owner's journal has it, with its players in their
   * grace period; or begins anew, if the journal can't be used. Before the first {@link #doWork}.
   *
   * @param folder the journal's, which isn't written
   * @throws IOException if the folder can't be used
   * @throws IllegalArgumentException if the room must begin anew and can't; the message says why
   */
  public void resume(Path folder) throws IOException {
    if (!parts.changes.resume(journal(folder, new SlotDisk(), 1), parts.clock.getAsLong())) {
      parts.changes.beginAnew();
    }
    ticks.show();
  }

  /**
   * Keeps the room on the disk from now on, in its present state, whatever an earlier room of this
   * name has left there. Before the first {@link #doWork}.
   *
   * @param disk as above
   * @param folder as above
   * @param seconds as above
   * @throws IOException if the folder can't be used
   */
  public void checkpointAnew(SlotDisk disk, Path folder, int seconds) throws IOException {
    RoomCheckpoints checkpoints = journal(folder, disk, seconds);
    checkpoints.forgetAll();
    parts.journals.own(checkpoints);
    parts.changes.beginJournal(checkpoints, parts.clock.getAsLong());
  }

  @Override
  public boolean isFollowed() {
    RoomCheckpoints follower = parts.journals.follower();
    return follower != null && follower.isSafe();
  }

  @Override
  public int followerLag() {
    RoomCheckpoints follower = parts.journals.follower();
    return follower == null ? 0 : follower.uncertainBlocks();
  }

  @Override
  public int lostTicks() {
    return parts.changes.lostTicks();
  }

  private RoomCheckpoints journal(Path folder, SlotDisk disk, int seconds) {
    return new RoomCheckpoints(kept(), disk, folder, seconds);
  }

  private RoomCheckpoints.KeptRoom kept() {
    return new RoomCheckpoints.KeptRoom(
        context.config(),
        this::settings,
        number,
        context.label(),
        counters(),
        seats(),
        ownership(),
        parts.accounts,
        parts.sessions.bySeat());
  }

  @Override
  public void followedBy(SlotDisk disk, SlotLink link, int seconds, boolean waits) {
    next.set(
        () -> {
          RoomCheckpoints before = parts.journals.follower();
          if (before != null) {
            before.endMatch("ANOTHER FOLLOWER");
          }
          boolean begins = link != null && !end.isClosed();
          RoomCheckpoints follower = null;
          if (begins) {
            follower =
                waits
                    ? new RoomCheckpoints(kept(), disk, link, seconds, () -> wake.run())
                    : new RoomCheckpoints(kept(), disk, link, seconds);
          }
          parts.journals.follower(follower);
          if (follower != null) {
            parts.changes.beginJournal(follower, parts.clock.getAsLong());
          }
        });
    wake.run();
  }

  @Override
  public Set<Long> linked() {
    return parts.sessions.linked();
  }

  @Override
  public void closeClients() {
    parts.sessions.closeLinks("another server has the room");
  }

  @Override
  public void sendOn(ServerMessage.Move move, Set<Long> standbys) {
    parts.sessions.sendToOthers(move, standbys);
  }

  @Override
  public void handOver(Function<Link.Door, ServerMessage.Redirect> where, Runnable ended) {
    next.set(
        () -> {
          end.handOver(where, parts.clock.getAsLong());
          ended.run();
        });
    wake.run();
  }

  /**
   * Gives up the seats of players who, as other rooms were kept, have gone there; after all rooms
   * go on from their checkpoints, and before the first {@link #doWork}.
   *
   * @param rooms all rooms of the server; others may be running
   */
  public void reconcile(List<Room> rooms) {
    parts.switches.reconcile(rooms, parts.clock.getAsLong());
  }

  /** Returns the best lists of the game that the room plays, as they were lately; any thread. */
  public List<BestLists.Table> best() {
    return parts.accounts.best();
  }

  /** Lets go what a room that has ended has noted of accounts, as its journals are closed. */
  public void letAccountsGo() {
    parts.accounts.letGo();
  }

  /** Returns whether players who come are on the disk in a moment; from any thread. */
  boolean isKept() {
    return parts.journals.isKept();
  }

  /**
   * Hands over a player whose level is loaded; from any thread.
   *
   * @return false when too many are on their way or the room is closed; the link and the claim stay
   *     the caller's
   */
  public boolean admit(Admission admission) {
    Admission guarded = admission.over(context.ownership().guard(admission.link()));
    if (end.isClosed() || !parts.arrivals.offer(guarded)) {
      return false;
    }
    wake.run();
    // A room that closes in between has either told this player goodbye, or never will.
    return !end.isClosed() || !parts.arrivals.withdraw(guarded);
  }

  /**
   * Does one turn: takes what has arrived and runs the ticks that are due, at most {@code
   * catchUpTicks}.
   *
   * @param nowNs monotonic time
   * @return the amount of work done; 0 when the caller may wait until {@link #nextDeadlineNs}
   */
  public int doWork(long nowNs) {
    Runnable asked = next.getAndSet(null);
    if (asked != null) {
      asked.run();
    }
    if (ticks.isHeld() && !end.isClosed()) {
      ticks.goOn(nowNs);
      if (ticks.isHeld()) {
        return 0;
      }
    }
    operator.serve();
    if (end.isClosed()) {
      parts.accounts.letGo();
      return parts.partings.doWork(nowNs);
    }
    if (!context.ownership().holds()) {
      paused = true;
      parts.pace.due(true, ticks.tick(), nowNs);
      return 0;
    }
    int work = pollAll(nowNs) + parts.partings.doWork(nowNs);
    seats().expire(nowNs);
    paused = isIdle();
    if (paused) {
      parts.journals.rests(nowNs);
      parts.accounts.letGo();
    }
    int due = owed > 0 ? owed : parts.pace.due(paused, ticks.tick(), nowNs);
    for (owed = due; owed > 0 && !end.isClosed() && !ticks.isHeld(); owed--) {
      ticks.run(nowNs, owed <= MAX_SENDS_PER_BURST);
    }
    if ((due > 0 || paused) && pictures.isWanted()) {
      parts.stages.begin();
      pictures.take(context.match().info(), context.simulation(), parts.sessions.bySeat());
      parts.stages.end(TurnStage.PICTURE);
    }
    return work + due;
  }

  private boolean isIdle() {
    return context.config().get(ServerConfig.IDLE) == ServerConfig.Idle.PAUSE
        && context.age() > 0
        && parts.sessions.count() == 0
        && parts.arrivals.isEmpty()
        && !parts.recording.needsTicks();
  }

  /** Returns when the next tick is due; valid after the first {@link #doWork}. */
  public long nextDeadlineNs() {
    return ticks.isHeld() ? ticks.heldUntilNs() : parts.pace.nextDeadlineNs();
  }

  private int pollAll(long nowNs) {
    int work = 0;
    for (int i = parts.sessions.count() - 1; i >= 0; i--) {
      Session session = parts.sessions.get(i);
      if (session.state() == SessionState.PLAYING || session.state() == SessionState.LOADING) {
        try {
          work += session.poll(nowNs);
        } catch (RuntimeException e) {
          parts.departures.fail(session, e, nowNs);
        }
      }
    }
    return work;
  }

  /** Returns the requests of newcomers for seats; any thread may ask. */
  public SeatRequests seatRequests() {
    return parts.departures.requests();
  }

  /**
   * Closes the room for an error that it can't go on after, and tells its players.
   *
   * @param why for the log
   */
  public void fail(String why) {
    end.fail(why, tick());
  }

  /**
   * Tells all players why the game ends and runs no further tick. The links stay open for a moment,
   * while {@link #doWork} is called, so that the goodbye arrives; {@link #closeLinks} ends that.
   */
  public void close(GoodbyeReason reason, String text, long nowNs) {
    end.close(reason, text, nowNs);
  }

  /**
   * Gives the room up because its thread doesn't come back from the game: closes all links, and
   * makes it keep nothing more. From any thread. The room's own ends when it comes back.
   *
   * @param why for logs
   */
  public void abandon(String why) {
    end.abandon(why);
  }

  /**
   * Puts other settings in force: seats, levels and metadata. Waits for the room; any thread but
   * its own.
   *
   * @param next with the room's name
   * @return null, or why nothing has changed
   */
  public String reconfigure(RoomConfig next) {
    return operator.run(
        () -> {
          parts.changes.settings(next);
          seats().resize(next.places());
          settings = next;
          return null;
        });
  }

  /**
   * Closes the room: its players go to other rooms that have a seat, and the others are told
   * goodbye. Waits for the room; any thread but its own.
   *
   * @param text for the players that find no room, may be empty
   * @return what became of the players, or why the room doesn't answer
   */
  public String dissolve(String text) {
    return operator.run(
        () -> {
          long nowNs = parts.clock.getAsLong();
          int moved = parts.switches.switchAll(nowNs);
          int dismissed = parts.sessions.count();
          parts.departures.logDismissed(text);
          end.close(GoodbyeReason.ROOM_CLOSED, text, nowNs);
          return "moved players=" + moved + ", dismissed players=" + dismissed;
        });
  }

  /** Closes the links of those who are about to enter a room that was handed over; any thread. */
  public void closeArrivals() {
    end.closeArrivals();
  }

  @Override
  public boolean isClosed() {
    return end.isClosed();
  }

  /** Returns whether all links have said goodbye. */
  public boolean isDeserted() {
    return parts.sessions.count() == 0 && parts.partings.isEmpty();
  }

  /** Closes the links that linger after {@link #close}. */
  public void closeLinks() {
    parts.partings.closeAll();
  }

  /** Returns what an operator may ask of the room; from any thread but the room's. */
  public OperatorCommands operator() {
    return operator;
  }

  /**
   * Waits until the recording that ended last is written, at most 5 s; when the room has closed.
   */
  public void awaitRecording() {
    parts.recording.awaitEnd();
  }

  /** Returns the room's number, from 1 on; from any thread. */
  public int number() {
    return number;
  }

  @Override
  public String name() {
    return settings.name();
  }

  /** Returns whether the operator has named the room, so that logs and files have its name. */
  public boolean isNamed() {
    return !context.label().isEmpty();
  }

  @Override
  public RoomConfig settings() {
    return settings;
  }

  /** Returns what clients must know to play the present match; from any thread. */
  public MatchInfo match() {
    return context.match().info();
  }

  @Override
  public ServerMessage.RoomEntry entry() {
    MatchInfo match = match();
    return new ServerMessage.RoomEntry(
        name(),
        match.game(),
        match.level().level().name(),
        ticks.phase(),
        seats().takenCount(),
        seats().count(),
        (int) counters().get(Counter.SPECTATORS),
        settings.metadata());
  }

  @Override
  public int players() {
    return seats().takenCount();
  }

  @Override
  public Set<String> parties() {
    return seats().parties();
  }

  @Override
  public Set<String> accounts() {
    return seats().accounts();
  }

  @Override
  public int loadPercent() {
    return (int) counters().get(Counter.LOAD_PERCENT);
  }

  @Override
  public RoomOffer offer() {
    MatchInfo match = match();
    return new RoomOffer(
        match.game(),
        seats().takenCount(),
        seats().count(),
        match.skill() == null ? null : seats().skill(match.game(), match.skill()));
  }

  /** Returns the number of ticks that the room has run, of all matches; from any thread. */
  public int age() {
    return context.age();
  }

  @Override
  public int tick() {
    return ticks.tick();
  }

  @Override
  public boolean hasFailed() {
    return end.hasFailed();
  }

  /**
   * Returns whether the room doesn't tick because no player, spectator or recording needs it, see
   * {@link ServerConfig#pausesIdleRooms}; from any thread.
   */
  public boolean isPaused() {
    return paused;
  }

  @Override
  public Ownership ownership() {
    return context.ownership();
  }

  @Override
  public void ownershipChanged() {
    wake.run();
  }

  /** Returns the seats, shared with the lobby. */
  public Seats seats() {
    return context.seats();
  }

  /** Returns what the room counts; from any thread. */
  public Counters counters() {
    return context.counters();
  }

  @Override
  public int tickRateHz() {
    return context.config().get(ServerConfig.TICK_RATE);
  }

  /** Returns how long the stages of its turns took; from any thread. */
  public StageTimes stages() {
    return parts.stages;
  }

  /** Returns the pictures of the room for people who watch it; from any thread. */
  public RoomPictures pictures() {
    return pictures;
  }

  /** Returns the world and the players of the present match, for reading. */
  public SimulationHost simulation() {
    return context.simulation();
  }

  /** Returns the frame states of the last ticks, for reading. */
  public FrameRing frames() {
    return context.match().capture().frames();
  }

  /**
   * Questions about the world as a session's client shows it: casts, overlaps, nearest points; see
   * {@link SimulationHost#asSeenBy}. On the room's thread.
   *
   * @throws IllegalStateException when the game doesn't look back
   */
  public Queries<HostEntity> asSeenBy(Session session) {
    return simulation().pastQueries(session.player());
  }

  /** Returns the session on a seat, or null. */
  public Session session(int playerId) {
    return parts.sessions.onSeat(playerId);
  }
}
