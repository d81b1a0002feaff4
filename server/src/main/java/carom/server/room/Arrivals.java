package carom.server.room;

import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.transport.Link;
import carom.server.config.ServerConfig;
import carom.server.match.RoomContext;
import carom.server.metrics.Counter;
import carom.server.session.Admission;
import carom.server.session.Session;
import carom.sim.entity.HostPlayer;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Message;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Lets players into a room: newcomers get a session and a player in the simulation, and players
 * that come back get their session with a new link. The room's thread, but for {@link #offer} and
 * {@link #withdraw}.
 */
final class Arrivals {
  private static final Logger LOG = LoggerFactory.getLogger(Arrivals.class);

  /** A crowd that comes at once must not cost the others a tick: at most so many a tick. */
  private static final int MAX_PER_TICK = 8;

  /** Arrivals take at most this part of a tick's time; the rest waits for the next tick. */
  private static final int TIME_PARTS = 8;

  private final RoomContext room;
  private final LongSupplier clock;
  private final RoomSessions sessions;
  private final Departures departures;
  private final RosterNews roster;
  private final Announcer announcer;
  private final MatchChange changes;
  private final RoomAccounts accounts;
  private final RoomBots bots;
  private final ArrayBlockingQueue<Admission> queue;

  /**
   * Creates an empty queue.
   *
   * @param clock nanoseconds, to measure how long admissions take
   * @param changes tells players what to load who loaded a match that is over
   */
  Arrivals(
      RoomContext room,
      LongSupplier clock,
      RoomSessions sessions,
      Departures departures,
      RosterNews roster,
      Announcer announcer,
      MatchChange changes,
      RoomAccounts accounts,
      RoomBots bots) {
    this.room = room;
    this.clock = clock;
    this.sessions = sessions;
    this.departures = departures;
    this.roster = roster;
    this.announcer = announcer;
    this.changes = changes;
    this.accounts = accounts;
    this.bots = bots;
    queue = new ArrayBlockingQueue<>(2 * ProtocolLimits.MAX_PLAYERS);
  }

  /** Queues a player, from any thread. Returns false when too many wait. */
  boolean offer(Admission admission) {
    return queue.offer(admission);
  }

  /** Returns whether no player waits; from any thread. */
  boolean isEmpty() {
    return queue.isEmpty();
  }

  /** Takes a player back out of the queue, from any thread. Returns false if it isn't there. */
  boolean withdraw(Admission admission) {
    return queue.remove(admission);
  }

  /**
   * Lets in the players that wait, as many as a tick has time for, and lets those play that have
   * loaded the match.
   *
   * @param beginNs when the tick began, by the clock
   */
  void admit(long beginNs, long nowNs) {
    for (int i = 0; i < sessions.count(); i++) {
      Session session = sessions.get(i);
      if (session.hasLoaded()) {
        session.play(room.simulation().tick());
        roster.changed();
      }
    }
    long timeNs = room.config().tickNs() / TIME_PARTS;
    for (int i = 0; i < MAX_PER_TICK; i++) {
      if (i > 0 && clock.getAsLong() - beginNs > timeNs) {
        break;
      }
      Admission a = queue.poll();
      if (a == null) {
        break;
      }
      room.seats().occupy(a.seat());
      try {
        admitOne(a, nowNs);
      } catch (RuntimeException e) {
        room.counters().add(Counter.SESSIONS_FAILED, 1);
        LOG.error("{}player {} could not be admitted", room.label(), a.seat().id(), e);
        departures.part(a.link(), "server error", nowNs);
        if (sessions.onSeat(a.seat().id()) == null) {
          room.seats().vacate(a.seat());
        }
      }
    }
  }

  private void admitOne(Admission a, long nowNs) {
    int id = a.seat().id();
    Session session = sessions.onSeat(id);
    boolean resumed = session != null;
    if (a.bot() && (resumed ? session.state() != SessionState.GRACE : !a.seat().isBots())) {
      departures.part(a.link(), "the player is back, or gone", nowNs);
      if (!resumed) {
        room.seats().vacate(a.seat());
      }
      return;
    }
    if (session == null) {
      Session inTheWay = a.bot() ? null : bots.inTheWay();
      if (inTheWay != null) {
        departures.remove(inTheWay, "is a bot, gave way to a newcomer", " left", nowNs);
      }
      HostPlayer player = accounts.join(a.seat());
      session =
          new Session(
              a.seat(),
              player,
              room.config(),
              room.match().replicationTo(player),
              room.match().messagesOf(player),
              room.counters());
      sessions.add(session);
    } else if (session.state() != SessionState.GRACE) {
      // The client is back before we noticed that its old link is dead, or it plays twice.
      session.sayGoodbye(GoodbyeReason.RESUMED_ELSEWHERE, "");
      departures.part(session.detach(nowNs), "resumed by another link", nowNs);
    }
    if (resumed) {
      accounts.standsIn(session, a.bot());
    }
    session.attach(a.link(), a.epoch(), a.bot());
    tellPage(a.link());
    if (a.match() == room.match().info().number()) {
      session.play(room.simulation().tick());
    } else {
      changes.tell(session);
    }
    roster.changed();
    room.counters().add(Counter.JOINS, a.bot() ? 0 : 1);
    room.counters().add(Counter.RESUMES, resumed && !a.bot() ? 1 : 0);
    LOG.info(
        "{}{}: {} as player {} from {}, {} of {} players",
        room.label(),
        a.bot() ? "bot" : resumed ? "back" : "join",
        a.seat().name(),
        id,
        a.link().remote(),
        sessions.count(),
        room.seats().count());
    String what = !resumed ? " joined" : a.bot() ? " is away: a bot plays on" : " is back";
    announcer.comingOrGoing(session, a.seat().name() + what, room.age());
    sessions.updateGauges();
    if (!resumed && !a.bot()) {
      greet(session, room.config().get(ServerConfig.WELCOME));
      greet(session, accounts.trouble(session));
    }
  }

  private void tellPage(Link link) {
    Integer port = room.config().get(ServerConfig.PLAY_PORT);
    if (port != null && port > 0) { // 0 is any port: none is known
      boolean encrypted = room.config().get(ServerConfig.TLS_CERT) != null;
      link.send(new ServerMessage.PlayPage(port, encrypted));
    }
  }

  private void greet(Session session, String text) {
    if (!text.isEmpty()) {
      Message said = BuiltInKinds.SAID.of(BuiltInKinds.SERVER, false, text);
      room.simulation().send(said).to(session.player());
    }
  }

  /** Closes the links of the players that still wait; from any thread. */
  void closeLinks(String why) {
    for (Admission a; (a = queue.poll()) != null; ) {
      a.link().close(why);
    }
  }

  /** Sends the players away that still wait, because the room closes. */
  void refuseAll(GoodbyeReason reason, String text, long nowNs) {
    for (Admission a; (a = queue.poll()) != null; ) {
      a.link().send(new ServerMessage.Goodbye(reason, text));
      departures.part(a.link(), reason.name(), nowNs);
    }
  }
}
