package carom.server.room;

import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.transport.Broadcast;
import carom.net.transport.Link;
import carom.server.account.Stay;
import carom.server.config.ServerConfig;
import carom.server.match.RoomContext;
import carom.server.session.Admission;
import carom.server.session.Seats;
import carom.server.session.Session;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.concurrent.Future;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Lets players see the other rooms and go there, and tells them the best lists and the levels of
 * players. A player who changes the room keeps link, secret and name; the session ends here, and
 * the other room begins one that loads its match.
 *
 * <p>A crash at any moment of that leaves the player one seat: in the other room if its log has the
 * arrival, or else here. The room's thread.
 */
final class RoomSwitches {
  private static final Logger LOG = LoggerFactory.getLogger(RoomSwitches.class);

  private static final long NS_PER_MS = 1_000_000;

  /** A client is told the rooms at most so often. */
  private static final int LISTS_PER_SECOND = 2;

  private final RoomContext room;
  private final Room self;
  private final RoomDirectory directory;
  private final RoomSessions sessions;
  private final Departures departures;
  private final RoomAccounts accounts;
  private final LevelChoices levels;

  /** Tickets to other servers that were asked for. */
  private final IdentityHashMap<Session, Future<ServerMessage>> tickets = new IdentityHashMap<>();

  /** Creates an object without players to move. */
  RoomSwitches(
      RoomContext room,
      Room self,
      RoomDirectory directory,
      RoomSessions sessions,
      Departures departures,
      RoomAccounts accounts,
      LevelChoices levels) {
    this.room = room;
    this.self = self;
    this.directory = directory;
    this.sessions = sessions;
    this.departures = departures;
    this.accounts = accounts;
    this.levels = levels;
  }

  /** Answers the sessions that ask for the list of rooms, and moves those that want to go. */
  void serve(long nowNs) {
    int rate = room.config().get(ServerConfig.TICK_RATE);
    levels.serve(nowNs);
    if (!tickets.isEmpty()) {
      tickets.keySet().removeIf(session -> session.state() == SessionState.CLOSED);
    }
    for (int i = sessions.count() - 1; i >= 0; i--) {
      Session session = sessions.get(i);
      if (session.takeRoomsRequest(rate / LISTS_PER_SECOND)) {
        session.answer().begin(directory.list(session.door(), nowNs));
      }
      if (session.takeBestRequest(rate / LISTS_PER_SECOND)) {
        session.answer().begin(List.of(new Broadcast(accounts.best(session.seat().account()))));
      }
      if (session.takeLevelsRequest(rate / LISTS_PER_SECOND)) {
        session.answer().begin(levels.list(session));
      }
      for (Broadcast part; (part = session.answer().take(nowNs)) != null; ) {
        sessions.sendTo(session, part);
      }
      session.tellFleet(room.ownership().servers(session.door()));
      String request = session.requestedRoom();
      if (request != null
          && session.answer().isSent()
          && session.state() == SessionState.PLAYING
          && session.playedTicks() >= rate) {
        move(session, request, nowNs);
      }
    }
  }

  /**
   * Moves the players that have a link to other rooms, as far as these have seats; when this room
   * closes for good, and the directory doesn't list it any longer.
   *
   * @return the number of players that have gone
   */
  int switchAll(long nowNs) {
    int moved = 0;
    for (int i = sessions.count() - 1; i >= 0; i--) {
      Session session = sessions.get(i);
      Room to = refuge(session);
      if (to != null && session.state() != SessionState.GRACE && !session.isBot()) {
        move(session, to.name(), nowNs);
        moved += sessions.onSeat(session.seat().id()) == session ? 0 : 1;
      }
    }
    return moved;
  }

  /** Returns where a player goes whose room closes: to its party, or to much company. */
  private Room refuge(Session session) {
    String party = session.seat().party();
    Room friends = directory.ofParty(party);
    return friends != null && friends.seats().takenCount() < friends.seats().count()
        ? friends
        : directory.best(
            new FillUp(room.match().info().game(), !party.isEmpty()), other -> other != self);
  }

  private void move(Session session, String name, long nowNs) {
    Room to = directory.find(name);
    if (to == null && moveAway(session, name, nowNs)) {
      return;
    }
    if (to == null) {
      stay(session, "There is no such room. " + directory.describe(session.door()));
      return;
    }
    if (to == self) {
      stay(session, "You are in room " + name + " already.");
      return;
    }
    Seats.Seat seat = to.seats().takeFor(session.seat(), room.seats());
    if (seat == null) {
      stay(session, "Room " + name + " is full. " + directory.describe(session.door()));
      return;
    }
    long untilNs = nowNs + room.config().graceMs() * NS_PER_MS;
    if (!room.seats().reserve(session.seat(), untilNs)) {
      to.seats().unclaim(seat); // the player comes back over another link; the request waits
      return;
    }
    if (!to.isKept()) {
      seat.settle(); // otherwise as soon as the arrival there is on the disk
    }
    Link link = departures.moveOut(session, name);
    Stay stay = session.seat().stay();
    seat.stay(stay == null ? null : stay.moved());
    if (!to.admit(new Admission(seat, link, session.epoch(), Admission.NO_MATCH, false))) {
      LOG.warn("{}{} could not enter room {}", room.label(), seat.name(), name);
      link.send(new ServerMessage.Goodbye(GoodbyeReason.SERVER_ERROR, "Try again in a moment."));
      departures.part(link, "room takes nobody", nowNs);
      to.seats().unclaim(seat);
    }
  }

  /**
   * Sends a player to the server of the fleet that owns a room, as soon as there is a ticket.
   *
   * @return false if no other server owns it
   */
  private boolean moveAway(Session session, String name, long nowNs) {
    Future<ServerMessage> ticket = tickets.get(session);
    if (ticket == null) {
      FleetDoor.Place there = directory.fleet().find(name, session.door());
      if (there == null) {
        return false;
      }
      FleetDoor.Guest guest =
          new FleetDoor.Guest(
              session.seat().wantedName(),
              session.seat().account(),
              name,
              "",
              session.seat().party(),
              session.seat().skill().claim(),
              false);
      tickets.put(session, directory.fleet().move(there, guest, session.door()));
      return true;
    }
    if (ticket.isDone()) {
      tickets.remove(session);
      ServerMessage move = FleetDoor.outcome(ticket);
      if (move == null) {
        stay(session, "The fleet's directory doesn't answer. Try again in a moment.");
      } else {
        session.send(move);
        departures.remove(
            session, "goes to room " + name + " of another server", " went to room " + name, nowNs);
      }
    }
    return true;
  }

  /**
   * Gives up the seats of players who have gone on to other rooms, after a crash that this room
   * survived in a state before and another one in a state after that; before the first tick. So
   * each player has one seat in all rooms.
   *
   * @param rooms all rooms of the server
   */
  void reconcile(List<Room> rooms, long nowNs) {
    for (int i = 0; i < sessions.count(); i++) {
      if (hasGoneOn(sessions.get(i).seat(), self, rooms)) {
        sessions.get(i).endGrace(nowNs);
      }
    }
    for (Room one : rooms) {
      for (Seats.Seat seat : one.seats().reserved()) {
        if (hasGoneOn(seat, one, rooms)) {
          one.seats().free(seat);
        }
      }
    }
  }

  private static boolean hasGoneOn(Seats.Seat seat, Room room, List<Room> rooms) {
    for (Room other : rooms) {
      if (other != room && other.seats().switchesOf(seat.secret()) > seat.switches()) {
        return true;
      }
    }
    return false;
  }

  private static void stay(Session session, String why) {
    session.clearRequestedRoom();
    session.send(new ServerMessage.Notice(why));
  }
}
