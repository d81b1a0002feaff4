package carom.server.room;

import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.server.session.Session;
import java.util.function.Function;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Ends a room: in good order, for an error that it can't go on after, or because its thread doesn't
 * come back from the game. The room's thread, but for {@link #abandon} and the questions.
 */
final class RoomEnd {
  private static final Logger LOG = LoggerFactory.getLogger(RoomEnd.class);

  private final RoomParts parts;
  private volatile boolean failed;
  private volatile boolean closed;

  /** Creates the end of a room that is open. */
  RoomEnd(RoomParts parts) {
    this.parts = parts;
  }

  /**
   * Closes the room for an error, and tells its players.
   *
   * @param why for the log
   * @param tick the last tick that was computed
   */
  void fail(String why, int tick) {
    String label = parts.context.label();
    LOG.error("{}closed at tick {}: {}", label.isEmpty() ? "room " : label, tick, why);
    failed = true;
    close(GoodbyeReason.SERVER_ERROR, "", parts.clock.getAsLong());
  }

  /** Tells all players why the game ends. The links stay open for a moment, see {@link Room}. */
  void close(GoodbyeReason reason, String text, long nowNs) {
    if (closed) {
      return;
    }
    closed = true;
    parts.recording.end(reason.name());
    parts.accounts.noteAll(!parts.journals.isKept());
    parts.journals.end(!failed, nowNs);
    parts.departures.endAll(reason, text, nowNs);
    parts.arrivals.refuseAll(reason, text, nowNs);
  }

  /**
   * Ends the room because another server goes on with it. Its links stay open and say nothing: the
   * clients hear from that server. Thin clients, which don't, are told where it is.
   *
   * @param where leads to the other server, by door; null where it can't be told
   */
  void handOver(Function<Link.Door, ServerMessage.Redirect> where, long nowNs) {
    if (closed) {
      return;
    }
    closed = true;
    parts.recording.end("HANDED OVER");
    parts.journals.end(true, nowNs); // the follower gets the last state, and computes nothing
    for (int i = 0; i < parts.sessions.count(); i++) {
      Session session = parts.sessions.get(i);
      var there = session.door() == Link.Door.OWN ? null : where.apply(session.door());
      if (there != null) {
        session.send(there);
      }
    }
  }

  /** Closes the links of those who are about to enter a room that was handed over; any thread. */
  void closeArrivals() {
    parts.arrivals.closeLinks("another server has the room");
  }

  /**
   * Closes all links, and makes the room keep nothing more; from any thread.
   *
   * @param why for logs
   */
  void abandon(String why) {
    closed = true;
    parts.journals.abandon(why);
    parts.arrivals.closeLinks(why);
    parts.sessions.closeLinks(why);
  }

  /** Returns whether the room has ended; from any thread. */
  boolean isClosed() {
    return closed;
  }

  /** Returns whether the room closed itself because of an error; from any thread. */
  boolean hasFailed() {
    return failed;
  }
}
