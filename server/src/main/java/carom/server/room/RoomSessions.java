package carom.server.room;

import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.transport.Broadcast;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.session.Session;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The sessions of a room, in order of arrival and by seat, and messages to all of them. */
final class RoomSessions {
  private static final Logger LOG = LoggerFactory.getLogger(RoomSessions.class);

  private final String label;
  private final Counters counters;
  private final List<Session> sessions = new ArrayList<>();
  private final List<Session> all = Collections.unmodifiableList(sessions);
  private final Session[] bySeat;

  /**
   * Creates an empty list.
   *
   * @param label begins each log line
   */
  RoomSessions(int seats, String label, Counters counters) {
    this.label = label;
    this.counters = counters;
    bySeat = new Session[seats];
  }

  int count() {
    return sessions.size();
  }

  /** Returns the sessions in order of arrival, live. For reading only. */
  List<Session> all() {
    return all;
  }

  /** Returns a session by its place in the order of arrival. */
  Session get(int index) {
    return sessions.get(index);
  }

  /** Returns the session on a seat, or null when the seat is empty or there is no such seat. */
  Session onSeat(int id) {
    return id >= 0 && id < bySeat.length ? bySeat[id] : null;
  }

  /** Returns the live array of sessions by seat, null where a seat is empty. For reading only. */
  Session[] bySeat() {
    return bySeat;
  }

  void add(Session session) {
    sessions.add(session);
    bySeat[session.seat().id()] = session;
  }

  void remove(Session session) {
    sessions.remove(session);
    bySeat[session.seat().id()] = null;
  }

  /** Closes the links of all sessions; from any thread. */
  void closeLinks(String why) {
    for (Session session : bySeat) {
      if (session != null) {
        session.closeLink(why);
      }
    }
  }

  /** Returns the secrets of the sessions whose clients can stand by; from any thread. */
  Set<Long> linked() {
    Set<Long> linked = new HashSet<>();
    for (Session session : bySeat) {
      if (session != null && session.mayStandBy()) {
        linked.add(session.secret());
      }
    }
    return linked;
  }

  /** Sends a message to those of {@link #linked} whose secrets aren't among some; any thread. */
  void sendToOthers(ServerMessage message, Set<Long> secrets) {
    for (Session session : bySeat) {
      if (session != null && session.mayStandBy() && !secrets.contains(session.secret())) {
        session.send(message);
      }
    }
  }

  void clear() {
    sessions.clear();
    Arrays.fill(bySeat, null);
  }

  /**
   * Sends a message to all sessions that play.
   *
   * @param except a session that doesn't get it, or null
   */
  void sendToAll(ServerMessage message, Session except) {
    Broadcast broadcast = new Broadcast(message);
    for (int i = 0; i < sessions.size(); i++) {
      Session session = sessions.get(i);
      if (session != except && session.state() == SessionState.PLAYING) {
        sendTo(session, broadcast);
      }
    }
  }

  /** Sends a message to one session. An exception is counted and logged. */
  void sendTo(Session session, Broadcast message) {
    try {
      session.send(message); // a link that refuses closes, and is found closed at its next poll
    } catch (RuntimeException e) {
      counters.add(Counter.SESSIONS_FAILED, 1);
      LOG.error("{}message {} could not be sent, {}", label, message, session, e);
    }
  }

  /** Counts how many sessions play, and how many wait for their players. */
  void updateGauges() {
    int inGrace = 0;
    int bots = 0;
    for (int i = 0; i < sessions.size(); i++) {
      if (sessions.get(i).state() == SessionState.GRACE) {
        inGrace++;
      }
      bots += sessions.get(i).isBot() ? 1 : 0;
    }
    counters.set(Counter.BOTS, bots);
    counters.set(Counter.PLAYERS, sessions.size() - inGrace);
    counters.set(Counter.PLAYERS_IN_GRACE, inGrace);
  }
}
