package carom.server.room;

import carom.net.protocol.Limits;
import carom.net.protocol.ServerMessage.Roster;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.net.protocol.SessionState;
import carom.net.transport.Broadcast;
import carom.server.session.Session;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiConsumer;

/**
 * Who plays, and with which score, as the clients know it: tells everybody what has changed, and
 * who is new on its link all of it. A crowd that comes in costs each client a line for each who
 * comes, not the whole list each time.
 *
 * <p>The room's thread. Allocates only when something has changed.
 */
final class RosterNews {
  private static final long NS_PER_MS = 1_000_000;
  private static final String NOBODY = "";

  private final String[] names;
  private final int[] scores;
  private final long intervalNs;
  private boolean old;
  private long sentNs;

  /**
   * @param seats of the room
   * @param intervalMs no two rosters come closer
   */
  RosterNews(int seats, int intervalMs) {
    names = new String[seats];
    Arrays.fill(names, NOBODY);
    scores = new int[seats];
    intervalNs = intervalMs * NS_PER_MS;
  }

  /** Somebody came, came back, or went. */
  void changed() {
    old = true;
  }

  /**
   * Sends what has changed, when anything has and it is time.
   *
   * @param bySeat who plays, by player id
   * @param send takes a session that plays and a message for it
   */
  void send(
      List<Session> sessions, Session[] bySeat, long nowNs, BiConsumer<Session, Broadcast> send) {
    for (int i = sessions.size() - 1; i >= 0 && !old; i--) {
      Session session = sessions.get(i);
      old = scores[session.seat().id()] != session.player().score();
    }
    if (!old || nowNs - sentNs < intervalNs) {
      return;
    }
    old = false;
    sentNs = nowNs;
    List<Broadcast> changes = changes(bySeat);
    List<Broadcast> all = null;
    for (int i = 0; i < sessions.size(); i++) {
      Session session = sessions.get(i);
      if (session.state() != SessionState.PLAYING) {
        continue;
      }
      if (all == null && !session.knowsRoster()) {
        all = all();
      }
      List<Broadcast> messages = session.knowsRoster() ? changes : all;
      messages.forEach(message -> send.accept(session, message));
      session.toldRoster();
    }
  }

  private List<Broadcast> changes(Session[] bySeat) {
    List<RosterEntry> entries = new ArrayList<>();
    for (int id = 0; id < names.length; id++) {
      String name = bySeat[id] == null ? NOBODY : bySeat[id].seat().name();
      int score = bySeat[id] == null ? 0 : bySeat[id].player().score();
      if (score != scores[id] || !name.equals(names[id])) {
        names[id] = name;
        scores[id] = score;
        entries.add(new RosterEntry(id, name, score));
      }
    }
    return messages(entries);
  }

  private List<Broadcast> all() {
    List<RosterEntry> entries = new ArrayList<>();
    for (int id = 0; id < names.length; id++) {
      if (!names[id].equals(NOBODY)) {
        entries.add(new RosterEntry(id, names[id], scores[id]));
      }
    }
    return messages(entries);
  }

  private static List<Broadcast> messages(List<RosterEntry> entries) {
    List<Broadcast> messages = new ArrayList<>();
    for (int from = 0; from < entries.size(); from += Limits.MAX_ROSTER_ENTRIES) {
      int to = Math.min(entries.size(), from + Limits.MAX_ROSTER_ENTRIES);
      messages.add(new Broadcast(new Roster(List.copyOf(entries.subList(from, to)))));
    }
    return messages;
  }
}
