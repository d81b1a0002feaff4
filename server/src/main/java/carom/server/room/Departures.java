package carom.server.room;

import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.transport.Link;
import carom.server.config.ServerConfig;
import carom.server.match.RoomContext;
import carom.server.metrics.Counter;
import carom.server.session.PartingLinks;
import carom.server.session.SeatRequests;
import carom.server.session.Session;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Ends the sessions of a room whose time has come. A session ends when the player leaves or is
 * expelled, the link is lost or silent, the grace period is over, or a newcomer needs the seat. The
 * room's thread, but for {@link #requests}.
 */
final class Departures {
  private static final Logger LOG = LoggerFactory.getLogger(Departures.class);
  private static final long NS_PER_MS = 1_000_000;

  /** A link stays open for this long after its goodbye, so that the goodbye arrives. */
  private static final long PARTING_MS = 1_000;

  /** A crowd that goes at once must not cost the others a tick: at most so many a tick. */
  private static final int MAX_PER_TICK = 16;

  private final RoomContext room;
  private final RoomSessions sessions;
  private final RosterNews roster;
  private final Announcer announcer;
  private final PartingLinks partings;
  private final RoomAccounts accounts;
  private final RoomBots bots;
  private final SeatRequests requests;

  /**
   * Creates an object without players to remove.
   *
   * @param partings takes the links
   */
  Departures(
      RoomContext room,
      RoomSessions sessions,
      RosterNews roster,
      Announcer announcer,
      PartingLinks partings,
      RoomAccounts accounts,
      RoomBots bots) {
    this.room = room;
    this.sessions = sessions;
    this.roster = roster;
    this.announcer = announcer;
    this.partings = partings;
    this.accounts = accounts;
    this.bots = bots;
    requests = new SeatRequests(room.counters(), room.seats(), room.config());
  }

  /** Returns the requests of newcomers for seats; any thread may ask. */
  SeatRequests requests() {
    return requests;
  }

  /** Ends the sessions whose time has come. */
  void serve(long nowNs) {
    Session givesWay = requests.next(sessions.all(), nowNs);
    Session crowding = requests.takeCrowding(sessions.bySeat());
    if (crowding != null) {
      crowding.sayGoodbye(GoodbyeReason.CROWDED, "");
      remove(crowding, "gave way: its network has too many seats", " gave way", nowNs);
    }
    int departures = 0;
    for (int i = sessions.count() - 1; i >= 0 && departures < MAX_PER_TICK; i--) {
      departures += endIfDue(sessions.get(i), givesWay, nowNs) ? 1 : 0;
    }
  }

  /** Ends a session, or begins its grace period, if it is time. Returns whether it was. */
  private boolean endIfDue(Session session, Session givesWay, long nowNs) {
    if (session.state() == SessionState.GRACE) {
      if (session == givesWay) {
        requests.served();
        remove(session, "gave way to a newcomer", " is gone", nowNs);
      } else if (session.graceIsOver(nowNs) && !room.seats().isClaimed(session.seat())) {
        remove(session, "did not come back", " is gone", nowNs);
      } else {
        return false;
      }
    } else if (session == givesWay) {
      requests.served();
      session.sayGoodbye(GoodbyeReason.IDLE, "");
      String why = session.isBot() ? "is a bot" : "was idle";
      remove(session, why + ", gave way to a newcomer", " " + why + " and gave way", nowNs);
    } else if (session.isStandIn() && session.graceIsOver(nowNs)) {
      accounts.left(session);
      room.seats().forsake(session.seat());
      LOG.info("{}the bot has the seat of {}", room.label(), session.seat().name());
    } else if (session.departure().leaves()) {
      room.counters().add(Counter.LEAVES, 1);
      session.sayGoodbye(GoodbyeReason.LEFT, "");
      if (bots.takesOver(session)) {
        handOver(session, "left", " left: a bot plays on", nowNs);
      } else {
        remove(session, "left", " left", nowNs);
      }
    } else if (session.departure().offence() != null) {
      room.counters().add(Counter.SESSIONS_EXPELLED, 1);
      session.sayGoodbye(
          GoodbyeReason.PROTOCOL_ERROR, "Received " + session.departure().offence() + ".");
      remove(session, "expelled for " + session.departure().offence(), " was removed", nowNs);
    } else if (session.departure().isLinkLost()) {
      lose(session, "link lost: " + session.departure().linkLostReason(), nowNs);
    } else if (session.isTooSlow()) {
      lose(
          session,
          "has not loaded the match in " + room.config().get(ServerConfig.LOAD_TIMEOUT_MS) + " ms",
          nowNs);
    } else if (session.isSilent()) {
      lose(
          session,
          "silent for " + room.config().get(ServerConfig.SILENCE_TIMEOUT_MS) + " ms",
          nowNs);
    } else {
      return false;
    }
    return true;
  }

  /** Begins the grace period, in which the body stays, or removes the session if there is none. */
  private void lose(Session session, String why, long nowNs) {
    room.counters().add(Counter.LINKS_LOST, 1);
    session.sayGoodbye(GoodbyeReason.TIMEOUT, "");
    if (room.config().graceMs() == 0 && bots.takesOver(session)) {
      handOver(session, why, " is gone: a bot plays on", nowNs);
      return;
    }
    if (room.config().graceMs() == 0 || session.seat().isBots()) {
      remove(session, why, " is gone", nowNs);
      return;
    }
    LOG.info(
        "{}lost: {}, player {}, {}; the body waits {} s",
        room.label(),
        session.seat().name(),
        session.seat().id(),
        why,
        room.config().get(ServerConfig.GRACE));
    part(session.detach(nowNs), why, nowNs);
    announce(session, " lost the connection");
    sessions.updateGauges();
  }

  /** Gives the seat of a player who has gone to a bot, which is on its way. */
  private void handOver(Session session, String why, String notice, long nowNs) {
    accounts.left(session);
    part(session.detach(nowNs), why, nowNs);
    session.endGrace(nowNs + RoomBots.COMING_NS);
    room.seats().forsake(session.seat());
    bots.order(session.seat(), nowNs);
    roster.changed();
    LOG.info(
        "{}leave: {}, player {}, {}, a bot gets the seat",
        room.label(),
        session.seat().name(),
        session.seat().id(),
        why);
    announce(session, notice);
    sessions.updateGauges();
  }

  /**
   * Ends a session and takes its player out of the game.
   *
   * @param why for the log
   * @param notice what the other players read behind the player's name
   */
  void remove(Session session, String why, String notice, long nowNs) {
    sessions.remove(session);
    part(session.end(), why, nowNs);
    room.simulation().leave(session.player());
    accounts.left(session);
    room.seats().vacate(session.seat());
    roster.changed();
    LOG.info(
        "{}leave: {}, player {}, {}, {} of {} players",
        room.label(),
        session.seat().name(),
        session.seat().id(),
        why,
        sessions.count(),
        room.seats().count());
    announce(session, notice);
    sessions.updateGauges();
  }

  /**
   * Ends the session of a player who goes to another room, and whose seat is free already.
   *
   * @param name name of the other room
   * @return the link, now the caller's
   */
  Link moveOut(Session session, String name) {
    sessions.remove(session);
    Link link = session.end();
    room.simulation().leave(session.player());
    accounts.note(session);
    roster.changed();
    LOG.info(
        "{}move: {}, player {}, goes to room {}, {} of {} players",
        room.label(),
        session.seat().name(),
        session.seat().id(),
        name,
        sessions.count(),
        room.seats().count());
    announce(session, " went to room " + name);
    sessions.updateGauges();
    return link;
  }

  /** Removes the session that was being served when an exception of ours was thrown. */
  void fail(Session session, RuntimeException e, long nowNs) {
    room.counters().add(Counter.SESSIONS_FAILED, 1);
    LOG.error("{}session failed, {}; it is closed, the others go on", room.label(), session, e);
    session.sayGoodbye(GoodbyeReason.SERVER_ERROR, "");
    remove(session, "server error", " was removed", nowNs);
  }

  /** Removes a player for an operator, and tells the player. */
  void kick(Session session, String text, long nowNs) {
    session.sayGoodbye(GoodbyeReason.KICKED, text);
    String why = text.isEmpty() ? "" : ": " + text;
    remove(session, "kicked by the operator" + why, " was removed", nowNs);
  }

  /** Removes a player, whose client goes to another server. */
  void redirect(Session session, ServerMessage.Redirect redirect, long nowNs) {
    session.send(redirect);
    remove(session, "sent to " + redirect.server(), " went to another server", nowNs);
  }

  /** Notes in the log which players the room sends away as it closes for good. */
  void logDismissed(String text) {
    for (int i = 0; i < sessions.count(); i++) {
      Session session = sessions.get(i);
      LOG.info(
          "{}leave: {}, player {}, the room is closed{}",
          room.label(),
          session.seat().name(),
          session.seat().id(),
          text.isEmpty() ? "" : ": " + text);
    }
  }

  /** Ends all sessions because the room closes. */
  void endAll(GoodbyeReason reason, String text, long nowNs) {
    for (int i = 0; i < sessions.count(); i++) {
      Session session = sessions.get(i);
      session.sayGoodbye(reason, text);
      part(session.end(), reason.name(), nowNs);
    }
    sessions.clear();
    sessions.updateGauges();
  }

  /**
   * Closes a link in a moment.
   *
   * @param link null for none
   */
  void part(Link link, String why, long nowNs) {
    if (link != null) {
      partings.add(link, why, nowNs + PARTING_MS * NS_PER_MS);
    }
  }

  private void announce(Session session, String what) {
    announcer.comingOrGoing(session, session.seat().name() + what, room.age());
  }
}
