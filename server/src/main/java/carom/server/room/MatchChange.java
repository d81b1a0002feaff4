package carom.server.room;

import carom.net.protocol.DatagramMark;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.SessionState;
import carom.server.checkpoint.ResumedRoom;
import carom.server.checkpoint.RoomCheckpoints;
import carom.server.checkpoint.RoomCourse;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.Match;
import carom.server.match.MatchInfo;
import carom.server.match.MatchLoader;
import carom.server.match.RoomContext;
import carom.server.match.SavedMatch;
import carom.server.metrics.Counter;
import carom.server.session.LevelUpload;
import carom.server.session.Session;
import carom.server.threads.LoaderThread;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Newcomer;
import carom.sim.outbox.NextMatch;
import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Puts another match in the place of a room's present one, because the game or an operator wants
 * it. The next match is built beside the present one, which goes on until then. A match that can't
 * be built changes nothing.
 *
 * <pre>
 *   game: playNext, matchOver ──► load, on another thread ──┐
 *   operator: change ───────────► load, on another thread ──┴─► begin, between two ticks
 *                                                                 │
 *            recording ends and another begins ◄──────────────────┤
 *            players join the new simulation, links stay ◄────────┤
 *            clients get a Welcome and load: PLAYING ─► LOADING ◄─┘
 * </pre>
 *
 * <p>The room's thread, but for {@link #load}.
 */
final class MatchChange implements RoomCourse {
  private static final Logger LOG = LoggerFactory.getLogger(MatchChange.class);

  /** Time for which a request that couldn't be fulfilled isn't tried again. */
  private static final long RETRY_NS = 10_000_000_000L;

  private final RoomContext room;
  private final MatchLoader loader;
  private final LoaderThread loads;
  private RoomConfig settings;
  private final RoomSessions sessions;
  private final RoomRecording recording;
  private final RosterNews roster;
  private final Announcer announcer;

  /** The match that the other thread loads or has loaded, or null. */
  private Load load;

  /** The match that is being loaded, or that an earlier run of the room was loading; or null. */
  private NextMatch pending;

  private final RoomJournals journals;
  private final RoomAccounts accounts;
  private volatile int lostTicks;
  private int inRotation;

  /** {@link #inRotation} of the present match. */
  private int presentInRotation;

  private NextMatch failed;
  private long failedNs;

  /** Builds a match. */
  private interface Build {
    /**
     * Builds it.
     *
     * @param onGame receives the name of the game before its code is called
     * @throws MatchLoader.Unplayable when it can't be played
     */
    Match build(Consumer<String> onGame) throws MatchLoader.Unplayable;
  }

  /** A match while it is built. The first outcome counts, which may be that it never ends. */
  private final class Load implements LoaderThread.Load {
    private final NextMatch wanted;
    private final NextMatch named;
    private final Build build;
    private final CompletableFuture<Match> outcome = new CompletableFuture<>();

    /** The game that is set up, as far as that is known. */
    private volatile String game;

    Load(NextMatch wanted, NextMatch named, Build build) {
      this.wanted = wanted;
      this.named = named;
      this.build = build;
      game = named.game();
    }

    @Override
    public String title() {
      return "room %s: game=\"%s\" level=\"%s\"".formatted(settings.name(), game, named.level());
    }

    @Override
    public void run() {
      try {
        outcome.complete(build.build(name -> game = name));
      } catch (MatchLoader.Unplayable e) {
        fail(e);
      } catch (RuntimeException | Error e) { // such as too little memory for the level
        fail(new MatchLoader.Unplayable("it can't be built: " + e, e));
      }
    }

    @Override
    public void abandoned(String why) {
      room.counters().add(Counter.CALLBACKS_ABANDONED, 1);
      fail(new MatchLoader.Unplayable(why, null));
    }

    @Override
    public void cancelled(String why) {
      fail(new MatchLoader.Unplayable(why, null));
    }

    private void fail(MatchLoader.Unplayable why) {
      outcome.completeExceptionally(why);
    }

    /**
     * Waits for the match.
     *
     * @throws MatchLoader.Unplayable when it can't be played
     */
    Match await() throws MatchLoader.Unplayable {
      try {
        return outcome.get();
      } catch (ExecutionException e) {
        throw (MatchLoader.Unplayable) e.getCause();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new MatchLoader.Unplayable("interrupted while it was built", null);
      }
    }
  }

  /**
   * Creates an object that has nothing to change.
   *
   * @param loads runs what builds matches for the game, on a thread that no tick waits for
   * @param settings with the levels that follow each other; the room plays the first
   */
  MatchChange(
      RoomContext room,
      MatchLoader loader,
      LoaderThread loads,
      RoomConfig settings,
      RoomSessions sessions,
      RoomRecording recording,
      RoomJournals journals,
      RosterNews roster,
      Announcer announcer,
      RoomAccounts accounts) {
    this.journals = journals;
    this.accounts = accounts;
    this.announcer = announcer;
    this.room = room;
    this.loader = loader;
    this.loads = loads;
    this.settings = settings;
    this.sessions = sessions;
    this.recording = recording;
    this.roster = roster;
  }

  /**
   * Changes the levels that follow each other. The present match goes on. The next level is the one
   * behind it in the new list, or the first if the list doesn't have it.
   */
  void settings(RoomConfig next) {
    if (!next.levels().equals(settings.levels()) && !next.levels().isEmpty()) {
      int last = next.levels().size() - 1;
      int present =
          settings.levels().isEmpty()
              ? last
              : next.levels().indexOf(settings.levels().get(presentInRotation));
      inRotation = present < 0 ? last : present;
      presentInRotation = inRotation;
    }
    settings = next;
  }

  /**
   * Keeps the room by checkpoints from now on, and goes on from the last one of an earlier run, if
   * there is one. Before the first tick.
   *
   * @throws IOException if the checkpoints can't be kept
   */
  void keep(RoomCheckpoints newCheckpoints, long nowNs) throws IOException {
    resume(newCheckpoints, nowNs);
    beginJournal(newCheckpoints, nowNs);
  }

  /** Returns how many ticks of its journal the room couldn't compute again; from any thread. */
  int lostTicks() {
    return lostTicks;
  }

  /** Begins a journal with the present state. */
  void beginJournal(RoomCheckpoints journal, long nowNs) {
    journal.begin(this, loader.firstSeed(), nowNs);
  }

  /** Begins with the first match, because the room can't go on with another one. */
  void beginAnew() {
    loader.goOn(0, loader.firstSeed());
    try {
      room.play(loader.first());
    } catch (MatchLoader.Unplayable e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
    room.match().capture().capture();
  }

  /** Goes on where an earlier run of the room has left off; returns whether there is one. */
  boolean resume(RoomCheckpoints from, long nowNs) throws IOException {
    ResumedRoom resumed = from.resume(loader, nowNs);
    if (resumed != null) {
      lostTicks = resumed.lostTicks();
      room.play(resumed.match());
      resumed.sessions().forEach(sessions::add);
      accounts.resumed();
      sessions.updateGauges();
      inRotation = resumed.rotation();
      presentInRotation = inRotation;
      pending = resumed.pending();
    }
    return resumed != null;
  }

  @Override
  public Match match() {
    return room.match();
  }

  @Override
  public int rotation() {
    return presentInRotation;
  }

  @Override
  public NextMatch pending() {
    return pending;
  }

  /** Fulfils what the game asked for in the tick that ends, as soon as it is loaded. */
  void tickEnds(long nowNs) {
    NextMatch asked = room.simulation().outbox().takeNextMatch();
    NextMatch wanted = asked == null ? pending : asked;
    if (wanted != null && load == null) {
      request(wanted, nowNs);
    }
    Load done = load;
    if (done == null || !done.outcome.isDone()) {
      return;
    }
    load = null;
    pending = null;
    try {
      begin(done.await(), done.wanted, nowNs);
    } catch (MatchLoader.Unplayable e) {
      logFailure(done.named, e);
      failed = done.wanted;
      failedNs = nowNs;
      announcer.notice("The next match can't be played. This one goes on.");
    }
  }

  /** Plays a match as soon as it is built, unless another is under way. */
  void play(NextMatch wanted, long nowNs) {
    if (load == null) {
      request(wanted, nowNs);
    }
  }

  private void request(NextMatch wanted, long nowNs) {
    if (wanted.equals(failed) && nowNs - failedNs < RETRY_NS) {
      return;
    }
    failed = null;
    pending = wanted;
    NextMatch named = wanted.isOfRotation() ? nextOfRotation(wanted) : wanted;
    load = new Load(wanted, named, onGame -> loader.load(named, onGame));
    loads.execute(load);
  }

  /** Returns the next level of the rotation; the same one again if there is no other. */
  private NextMatch nextOfRotation(NextMatch wanted) {
    String game = settings.game();
    String level = "";
    int levels = settings.levels().size();
    for (int i = 0; i < levels && level.isEmpty(); i++) {
      inRotation = (inRotation + 1) % levels;
      String next = settings.levels().get(inRotation);
      level = loader.isGone(next) ? "" : next;
    }
    if (!level.isEmpty()) {
      game = "";
    } else if (game.isEmpty()) {
      game = room.match().info().game(); // whose default level is always there
    }
    return new NextMatch(game, level, wanted.keepsTeams(), wanted.keepsScores());
  }

  private void logFailure(NextMatch named, MatchLoader.Unplayable e) {
    LOG.error(
        "{}can't change to game=\"{}\" level=\"{}\": {}; the match goes on",
        room.label(),
        named.game(),
        named.level(),
        e.getMessage(),
        e.getCause());
  }

  /**
   * Builds a match for an operator, who waits. It logs failures of the game's code, whose stack the
   * answer doesn't tell. Not on the room's thread.
   *
   * @throws MatchLoader.Unplayable when it can't be played
   */
  Match load(NextMatch named) throws MatchLoader.Unplayable {
    return load(named, onGame -> loader.load(named, onGame));
  }

  /**
   * Builds a match in a saved state as the other {@code load}.
   *
   * @throws MatchLoader.Unplayable when it can't be played
   */
  Match load(SavedMatch saved) throws MatchLoader.Unplayable {
    NextMatch named = new NextMatch(saved.game(), saved.level().level().name(), false, false);
    return load(named, onGame -> loader.load(saved));
  }

  private Match load(NextMatch named, Build build) throws MatchLoader.Unplayable {
    Load ordered = new Load(named, named, build);
    loads.execute(ordered);
    try {
      return ordered.await();
    } catch (MatchLoader.Unplayable e) {
      if (e.getCause() != null) {
        logFailure(named, e);
      }
      throw e;
    }
  }

  /**
   * Goes on with a match that was built. In a saved state, players of the same id and name go on as
   * they were, and those who aren't here leave.
   *
   * @param wanted says what players bring with them
   */
  void begin(Match next, NextMatch wanted, long nowNs) {
    SimulationHost simulation = next.simulation();
    boolean brings =
        (wanted.keepsTeams() || wanted.keepsScores()) && !simulation.game().keepsMore();
    boolean begun = simulation.tick() > 0;
    accounts.noteAll(false);
    recording.endMatch();
    journals.endMatch("NEXT MATCH");
    room.play(next);
    presentInRotation = inRotation;
    if (!brings && !begun) {
      recording.beginMatch(); // from tick 0 without players, which needs no whole state
    }
    for (int id = 0; id < ProtocolLimits.MAX_PLAYERS; id++) {
      Session session = sessions.onSeat(id);
      HostPlayer saved = simulation.participant(id);
      if (saved != null && (session == null || !saved.name().equals(session.player().name()))) {
        simulation.leave(saved);
      }
      if (session != null) {
        HostPlayer player = enter(simulation, session, wanted, brings);
        session.enter(player, next.replicationTo(player), next.messagesOf(player));
      }
    }
    if (brings || begun) {
      recording.beginMatch();
    }
    next.capture().capture();
    journals.beginMatch(nowNs);
    for (int i = 0; i < sessions.count(); i++) {
      if (sessions.get(i).state() != SessionState.GRACE) {
        tell(sessions.get(i));
      }
    }
    roster.changed();
    room.counters().add(Counter.MATCHES, 1);
    LOG.info(
        "{}match {}: game {}, level {}, {} players",
        room.label(),
        next.info().number(),
        next.info().game(),
        next.info().level().level().name(),
        sessions.count());
  }

  /** Lets a participant into the next match; spectators go on watching. */
  private HostPlayer enter(SimulationHost next, Session session, NextMatch wanted, boolean brings) {
    HostPlayer before = session.player();
    Newcomer newcomer = accounts.newcomer(session.seat(), before, next);
    HostPlayer saved = next.participant(before.id());
    if (saved != null) {
      if (newcomer.values() != null) {
        saved.fieldValues().begin(newcomer.values()); // what lasts doesn't go back with a match
      }
      return saved;
    }
    if (before.isSpectator()) {
      return next.joinAsSpectator(before.id(), newcomer);
    }
    return next.join(
        before.id(),
        newcomer,
        brings && wanted.keepsTeams() ? before.team() : 0,
        brings && wanted.keepsScores() ? before.score() : 0);
  }

  /** Tells a session's client what to load. It plays as soon as it has. */
  void tell(Session session) {
    MatchInfo match = room.match().info();
    int epoch = DatagramMark.nextEpoch(session.epoch());
    int rate = room.config().get(ServerConfig.TICK_RATE);
    session.load(
        new LevelUpload(match.level(), epoch),
        match.welcome(
            session.secret(),
            session.seat().id(),
            epoch,
            rate,
            room.simulation().tick(),
            room.ownership().claim(),
            room.seats().incarnation(),
            session.seat().courseTick()));
  }
}
