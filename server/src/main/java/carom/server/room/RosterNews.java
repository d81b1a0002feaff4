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
 * Tells clients the roster: the players and their scores. A client that knows the roster is told
 * the changes, and a client on a new link all of it. So a crowd that comes in costs each client a
 * line for each newcomer, not the whole list each time.
 *
 * <p>The room's thread. Allocates only when something has changed.
 */
final class RosterNews {
  private static final long NS_PER_MS = 1_000_000;
  private static final String NOBODY = "";

  /**
   * Limit of sends per tick: a write to a socket takes about 10 us, and 500 of them half a tick.
   */
  private static final int MAX_SENDS_PER_TICK = 64;

  private final String[] names;
  private final int[] scores;
  private final long intervalNs;
  private boolean old;
  private long begunNs;

  // The round that is going on: the messages, null between rounds, and the next seat to serve.
  private List<Broadcast> changes;
  private List<Broadcast> wholeRoster;
  private int nextSeat;

  /**
   * Creates the news of a room without players.
   *
   * @param seats number of seats of the room
   * @param intervalMs shortest time between the beginnings of two rounds, ms
   */
  RosterNews(int seats, int intervalMs) {
    names = new String[seats];
    Arrays.fill(names, NOBODY);
    scores = new int[seats];
    intervalNs = intervalMs * NS_PER_MS;
  }

  /** Notes that a player came, came back, or went. */
  void changed() {
    old = true;
  }

  /**
   * Sends changes if there are any and it is time, to some sessions in each tick.
   *
   * @param bySeat the sessions by player id, null where there is none
   * @param send takes a session that plays and a message for it
   */
  void send(Session[] bySeat, long nowNs, BiConsumer<Session, Broadcast> send) {
    if (changes == null) {
      markOldIfScoresChanged(bySeat);
      if (!old || nowNs - begunNs < intervalNs) {
        return;
      }
      old = false;
      begunNs = nowNs;
      changes = changes(bySeat);
      wholeRoster = null;
      nextSeat = 0;
    }
    for (int sends = 0; nextSeat < bySeat.length && sends < MAX_SENDS_PER_TICK; nextSeat++) {
      Session session = bySeat[nextSeat];
      if (session != null && session.state() == SessionState.PLAYING) {
        messagesFor(session).forEach(message -> send.accept(session, message));
        session.toldRoster();
        sends++;
      }
    }
    if (nextSeat == bySeat.length) {
      changes = null;
    }
  }

  private void markOldIfScoresChanged(Session[] bySeat) {
    for (int id = 0; id < bySeat.length && !old; id++) {
      old = bySeat[id] != null && scores[id] != bySeat[id].player().score();
    }
  }

  /**
   * Returns the messages of this round for a session. A session that joined during the round gets
   * the whole roster, as the others know it after the round.
   */
  private List<Broadcast> messagesFor(Session session) {
    if (session.knowsRoster()) {
      return changes;
    }
    if (wholeRoster == null) {
      wholeRoster = wholeRoster();
    }
    return wholeRoster;
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

  private List<Broadcast> wholeRoster() {
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
