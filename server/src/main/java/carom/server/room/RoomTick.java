package carom.server.room;

import carom.net.transport.Broadcast;
import carom.server.config.ServerConfig;
import carom.server.match.Match;
import carom.server.match.RoomContext;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.metrics.TurnStage;
import carom.server.session.Session;
import carom.sim.MatchClock;
import carom.sim.SimulationHost;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One tick of a room, in order:
 *
 * <pre>
 *   Arrivals            players from the lobby get a session
 *   Departures          sessions end, or begin their grace period
 *   RoomSwitches        players see the other rooms, and go there
 *   Session             one input per player
 *   SimulationHost.step
 *   FrameCapture        the frame state, quantised once for all sessions
 *   RoomJournals        the server that follows the room has the tick, if that is asked for
 *   SnapshotRound       each session's snapshot
 *   MessageDelivery     messages of the game, which Session collected before the step
 *   Announcer           notices of the game
 *   RosterNews          players and scores that changed
 *   Counters, RoomRecording
 *   MatchChange         another match, if one is wanted and loaded
 * </pre>
 *
 * <p>With {@code --durability sync} the tick is held where it would be told, and the turn ends: the
 * rest comes in a later turn, when the follower has the tick. The next tick waits for that.
 *
 * <p>A tick that throws is logged, and the room goes on; a second of such ticks closes it. The
 * room's thread, but for {@link #tick} and {@link #phase}. The steady state allocates next to
 * nothing.
 */
final class RoomTick {
  /** The room closes in good order before tick numbers run out: 413 days at 60 Hz. */
  private static final int LAST_TICK = Integer.MAX_VALUE - (1 << 20);

  /** Longest time for which a tick waits for the follower, ns. */
  private static final long MOST_HELD_NS = 250_000_000;

  private static final Logger LOG = LoggerFactory.getLogger(RoomTick.class);

  private final RoomParts parts;
  private final RoomContext context;
  private final RoomSessions sessions;
  private final Counters counters;
  private final StageTimes stages;
  private final RoomEnd end;
  private final Consumer<String> sendNotice;
  private final BiConsumer<Session, Broadcast> sendTo;
  private int failedTicks;

  /** True while the tick that was computed last isn't told yet. */
  private boolean held;

  private long heldNs;
  private long tookNs;
  private boolean sends;
  private boolean stepped;
  private volatile int tick;
  private volatile String phase;

  /** Creates the tick of a room whose first match has begun. */
  RoomTick(RoomParts parts, RoomEnd end) {
    this.parts = parts;
    this.end = end;
    context = parts.context;
    sessions = parts.sessions;
    counters = context.counters();
    stages = parts.stages;
    sendNotice = parts.announcer::notice;
    sendTo = sessions::sendTo;
    show();
  }

  /** Lets other threads see the tick and phase of the present match. */
  void show() {
    SimulationHost simulation = context.simulation();
    tick = simulation.tick();
    phase = simulation.game().clock() == null ? "" : MatchClock.phase(simulation).text();
  }

  /** Returns the last tick of the present match that was computed; from any thread. */
  int tick() {
    return tick;
  }

  /** Returns the phase of the match for people, empty if the game has no clock; any thread. */
  String phase() {
    return phase;
  }

  /**
   * Does a tick and guards it. An exception that gets through every inner guard is a bug. Counted
   * by ticks, not by turns: most turns have no tick to do and succeed.
   *
   * @param newSends whether the tick sends snapshots
   */
  void run(long nowNs, boolean newSends) {
    sends = newSends;
    run(nowNs);
  }

  /** Returns whether a tick that was computed isn't told yet, because the follower lacks it. */
  boolean isHeld() {
    return held;
  }

  /** Returns when the room waits no longer for the follower; valid while a tick is held. */
  long heldUntilNs() {
    return heldNs + MOST_HELD_NS;
  }

  /** Tells the tick that is held, if the follower has it or has had its time. */
  void goOn(long nowNs) {
    if (nowNs - heldUntilNs() >= 0) {
      parts.journals.waitNoLonger();
    }
    if (parts.journals.isThere()) {
      run(nowNs);
    }
  }

  private void run(long nowNs) {
    try {
      if (held) {
        held = false;
        tell(nowNs);
      } else {
        tick(nowNs);
      }
      failedTicks = 0;
    } catch (RuntimeException | StackOverflowError e) {
      failedTicks++;
      if (failedTicks == 1) {
        LOG.error("{}tick {} failed; the room goes on", context.label(), tick + 1, e);
      }
      if (failedTicks >= context.config().get(ServerConfig.TICK_RATE)) {
        fail(failedTicks + " ticks in a row failed");
      }
    }
    if (tick >= LAST_TICK) {
      fail("it has run for as long as its ticks can be numbered; start the server again");
    }
  }

  private void fail(String why) {
    end.fail(why, tick);
  }

  private void tick(long nowNs) {
    long beginNs = parts.clock.getAsLong();
    stages.begin();
    parts.arrivals.admit(beginNs, nowNs);
    parts.departures.serve(nowNs);
    parts.bots.serve(nowNs, parts.departures);
    parts.switches.serve(nowNs);
    Match match = context.match();
    SimulationHost simulation = match.simulation();
    takeInputs(simulation.tick() + 1);
    stages.end(TurnStage.INPUTS);
    stepped = step(simulation);
    stages.end(TurnStage.STEP);
    if (stepped) {
      match.capture().capture();
      stages.end(TurnStage.CAPTURE);
      counters.add(Counter.EVENTS_LOST, match.takeDroppedEvents());
    }
    tookNs = parts.clock.getAsLong() - beginNs;
    if (stepped && !parts.journals.isThere()) {
      held = true;
      heldNs = nowNs;
    } else {
      tell(nowNs);
    }
  }

  /** Tells players, files and the room's next match about the tick that was computed. */
  private void tell(long nowNs) {
    long beginNs = parts.clock.getAsLong() - tookNs;
    stages.begin();
    Match match = context.match();
    boolean late = stepped && send(match, beginNs, nowNs);
    counters.add(Counter.TICKS, 1);
    context.passTick();
    parts.recording.tickEnds();
    if (stepped) {
      parts.changes.tickEnds(nowNs);
      parts.journals.tickEnds(nowNs);
      parts.accounts.tickEnds();
    }
    show();
    stages.end(TurnStage.REST);
    parts.pace.tickTook(parts.clock.getAsLong() - beginNs, late, nowNs);
    int rate = context.config().get(ServerConfig.TICK_RATE);
    if (match.failures().endTick() >= rate && !end.isClosed()) {
      String game = match.simulation().game().name();
      fail("game " + game + " failed in each of the last " + rate + " ticks");
    }
  }

  private void takeInputs(int next) {
    for (int i = sessions.count() - 1; i >= 0; i--) {
      sessions.get(i).consumeInput(next);
      sessions.get(i).tellPace(parts.pace.percent(), parts.pace.viewsAreNarrow());
    }
    parts.messages.collect();
  }

  /** Returns false when the step itself threw; the callbacks of the game can't. */
  private boolean step(SimulationHost simulation) {
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

  /** Returns whether snapshots have to wait because the tick took too long. */
  private boolean send(Match match, long beginNs, long nowNs) {
    boolean late = false;
    if (sends) {
      match.capture().narrowViews(parts.pace.viewsAreNarrow());
      late = parts.snapshots.run(beginNs, nowNs);
      stages.end(TurnStage.SNAPSHOTS);
    }
    parts.messages.send();
    match.simulation().outbox().drainNotices(sendNotice);
    match.failures().tell(match.simulation().findings());
    parts.roster.send(sessions.all(), sessions.bySeat(), nowNs, sendTo);
    return late;
  }
}
