package carom.server.room;

import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage.Roster;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.net.protocol.SessionState;
import carom.net.transport.Broadcast;
import carom.server.session.Session;
import carom.sim.entity.HostPlayer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.function.BiConsumer;

/**
 * Tells clients the roster: players and spectators with name, team, role, readiness, score, whether
 * they are alive, and ping. A client that knows the roster is told the changes, and a client on a
 * new link all of it. So a crowd that comes in costs each client a line for each newcomer, not the
 * whole list each time. Pings are looked at rarely and told in coarse steps.
 *
 * <p>The room's thread. Allocates only when something has changed.
 */
final class RosterNews {
  private static final long NS_PER_MS = 1_000_000;
  private static final long PING_NS = 2_000 * NS_PER_MS;

  /** A ping is told again when it differs by so many milliseconds and by a quarter. */
  private static final int PING_STEP_MS = 10;

  /**
   * Limit of sends per tick: a write to a socket takes about 10 us, and 500 of them half a tick.
   */
  private static final int MAX_SENDS_PER_TICK = 64;

  /** Entries of the roster as the clients know them, by seat; null for nobody. */
  private final RosterEntry[] told;

  private final int[] pings;
  private final long intervalNs;
  private boolean old;
  private long begunNs;
  private long pingedNs;

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
  public RosterNews(int seats, int intervalMs) {
    told = new RosterEntry[seats];
    pings = new int[seats];
    intervalNs = intervalMs * NS_PER_MS;
  }

  /** Notes that a participant came, came back, or went. */
  public void changed() {
    old = true;
  }

  /**
   * Sends changes if there are any and it is time, to some sessions in each tick.
   *
   * @param all the sessions
   * @param bySeat the same by player id, null where there is none
   * @param send takes a session that plays and a message for it
   */
  public void send(
      List<Session> all, Session[] bySeat, long nowNs, BiConsumer<Session, Broadcast> send) {
    if (changes == null) {
      if (nowNs - begunNs < intervalNs) {
        return;
      }
      measurePings(bySeat, nowNs);
      for (int i = 0; i < all.size() && !old; i++) { // who has gone is noted
        old = !isTold(all.get(i).seat().id(), all.get(i));
      }
      if (!old) {
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

  private void measurePings(Session[] bySeat, long nowNs) {
    if (nowNs - pingedNs < PING_NS) {
      return;
    }
    pingedNs = nowNs;
    for (int id = 0; id < bySeat.length; id++) {
      boolean linked = bySeat[id] != null && bySeat[id].state() == SessionState.PLAYING;
      int ping = linked ? bySeat[id].replication().roundTripMs() : 0;
      int difference = Math.abs(ping - pings[id]);
      if (ping == 0 || difference >= PING_STEP_MS && difference >= pings[id] / 4) {
        pings[id] = Math.min(RosterEntry.MAX_PING_MS, ping);
      }
    }
  }

  /** Returns whether clients know how it stands with a seat. */
  private boolean isTold(int id, Session session) {
    RosterEntry entry = told[id];
    if (session == null || entry == null) {
      return session == null && entry == null;
    }
    HostPlayer p = session.player();
    return entry.score() == p.score()
        && entry.team() == p.team()
        && entry.spectator() == p.isSpectator()
        && entry.ready() == p.isReady()
        && entry.alive() == p.isAlive()
        && entry.pingMs() == pings[id]
        && entry.colour() == p.colour().number()
        && entry.name().equals(session.shownName());
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
      wholeRoster = messages(Arrays.stream(told).filter(Objects::nonNull).toList());
    }
    return wholeRoster;
  }

  private List<Broadcast> changes(Session[] bySeat) {
    List<RosterEntry> entries = new ArrayList<>();
    for (int id = 0; id < told.length; id++) {
      Session session = bySeat[id];
      if (!isTold(id, session)) {
        told[id] = session == null ? null : entry(session, pings[id]);
        entries.add(session == null ? RosterEntry.gone(id) : told[id]);
      }
    }
    return messages(entries);
  }

  private static RosterEntry entry(Session session, int pingMs) {
    HostPlayer p = session.player();
    return new RosterEntry(
        p.id(),
        session.shownName(),
        p.team(),
        p.score(),
        p.isSpectator(),
        p.isReady(),
        p.isAlive(),
        pingMs,
        p.colour().number());
  }

  private static List<Broadcast> messages(List<RosterEntry> entries) {
    List<Broadcast> messages = new ArrayList<>();
    for (int from = 0; from < entries.size(); from += ProtocolLimits.MAX_ROSTER_ENTRIES) {
      int to = Math.min(entries.size(), from + ProtocolLimits.MAX_ROSTER_ENTRIES);
      messages.add(new Broadcast(new Roster(List.copyOf(entries.subList(from, to)))));
    }
    return messages;
  }
}
