package carom.lab.soak;

import carom.server.room.Room;
import carom.server.session.Seats;
import carom.server.session.Session;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Remembers the hashes and the seats of the last ticks of each room, and compares them with the
 * state in which the next server's rooms begin. A room goes on from the last tick of its log: the
 * players who had seats after that tick, and no others, must have the same seats again. So a player
 * whose coming is in the log keeps the seat, and one whose leaving is has none.
 */
final class ProvenStates {
  /** Ticks of play that a crash may cost: one second. */
  private static final int MOST_LOST = 60;

  private static final int KEPT = 4 * MOST_LOST;

  /** The last ticks of a room. */
  private static final class Past {
    final int[] matches = new int[KEPT];
    final int[] ticks = new int[KEPT];
    final long[] hashes = new long[KEPT];

    /** The secrets of the players by seat, 0 for none. */
    final long[][] seats = new long[KEPT][Soak.SEATS];

    int count;

    boolean isAt(int at, int match, int tick) {
      return matches[at] == match && ticks[at] == tick;
    }

    /** Returns whether a tick was not seen, as the server caught up by several in one turn. */
    boolean skipped(int earlier, int later, int match, int tick) {
      return matches[later] == match
          && tick < ticks[later]
          && (matches[earlier] == match ? tick > ticks[earlier] : matches[earlier] < match);
    }
  }

  private final Map<String, Past> rooms = new HashMap<>();

  /** Players of the last server who had changed rooms and had a seat in it. */
  private final Set<Long> moved = new HashSet<>();

  private int worstLost;
  private int compared;
  private int unseen;
  private long seatsCompared;
  private int reserved;

  /** Takes note of a tick. */
  void tick(Room room) {
    Past past = rooms.computeIfAbsent(room.name(), name -> new Past());
    int at = past.count++ % KEPT;
    past.matches[at] = room.match().number();
    past.ticks[at] = room.tick();
    past.hashes[at] = room.simulation().stateHash();
    takeSeats(room, past.seats[at]);
  }

  private static void takeSeats(Room room, long[] to) {
    for (int id = 0; id < to.length; id++) {
      Session session = room.session(id);
      to[id] = session == null ? 0 : session.seat().secret();
    }
  }

  /** Takes note of who has a seat when a server ends. */
  void serverEnds(List<Room> ending) {
    moved.clear();
    for (Room room : ending) {
      for (int id = 0; id < Soak.SEATS; id++) {
        Session session = room.session(id);
        if (session != null && session.seat().switches() > 0) {
          moved.add(session.seat().secret());
        }
      }
      room.seats().reserved().forEach(seat -> moved.add(seat.secret()));
    }
  }

  /**
   * Requires that each room of a new server, before its first tick, is in a state that it was in
   * before: the last one, or after a crash one of the last second. Requires that the seats are
   * those of that state, and that nobody has lost the seats of both rooms by going from one to the
   * other.
   */
  void requireResumed(List<Room> resumed, boolean crashed) {
    if (rooms.isEmpty()) {
      return;
    }
    Set<Long> seated = new HashSet<>();
    for (Room room : resumed) {
      Past past = rooms.get(room.name());
      if (past != null) {
        requireResumed(room, past, crashed ? MOST_LOST : 0);
        tick(room); // the server may end before its first tick
      }
      long[] secrets = new long[Soak.SEATS];
      takeSeats(room, secrets);
      Arrays.stream(secrets).forEach(seated::add);
    }
    for (Room room : resumed) {
      for (Seats.Seat seat : room.seats().reserved()) {
        reserved++;
        if (!seated.add(seat.secret())) {
          throw new AssertionError(
              "a seat beside another one: " + describe(resumed, seat.secret()));
        }
        if (!moved.contains(seat.secret()) && !wasThereLately(room, seat.secret())) {
          throw new AssertionError("a seat of nobody: " + describe(resumed, seat.secret()));
        }
      }
    }
    for (long secret : moved) {
      if (!seated.contains(secret)) {
        throw new AssertionError("a player who changed rooms has no seat, secret=" + secret);
      }
    }
  }

  private void requireResumed(Room room, Past past, int mostLost) {
    int match = room.match().number();
    int tick = room.simulation().tick();
    int last = (past.count - 1) % KEPT;
    for (int lost = 0; lost <= mostLost && lost < Math.min(past.count, KEPT); lost++) {
      int at = (past.count - 1 - lost) % KEPT;
      if (past.isAt(at, match, tick)) {
        worstLost = Math.max(worstLost, lost);
        requireSame(room, past, at);
        return;
      }
      if (lost > 0 && past.skipped(at, (at + 1) % KEPT, match, tick)) {
        unseen++;
        return;
      }
    }
    throw new AssertionError(
        String.format(
            Locale.ROOT,
            "room=%s goes on at match=%d tick=%d, it was at match=%d tick=%d; at most %d are lost",
            room.name(),
            match,
            tick,
            past.matches[last],
            past.ticks[last],
            mostLost));
  }

  private void requireSame(Room room, Past past, int at) {
    compared++;
    String where =
        String.format(
            Locale.ROOT,
            "room=%s goes on at match=%d tick=%d with ",
            room.name(),
            past.matches[at],
            past.ticks[at]);
    long hash = room.simulation().stateHash();
    if (hash != past.hashes[at]) {
      throw new AssertionError(
          where + String.format(Locale.ROOT, "hash=%016x, it was %016x", hash, past.hashes[at]));
    }
    long[] seats = new long[Soak.SEATS];
    takeSeats(room, seats);
    if (!Arrays.equals(seats, past.seats[at])) {
      throw new AssertionError(
          where + "seats=%s, they were %s".formatted(hex(seats), hex(past.seats[at])));
    }
    seatsCompared += Arrays.stream(seats).filter(secret -> secret != 0).count();
  }

  private static String hex(long[] seats) {
    return Arrays.stream(seats).mapToObj(Long::toHexString).toList().toString();
  }

  private boolean wasThereLately(Room room, long secret) {
    Past past = rooms.get(room.name());
    for (int back = 0; back < MOST_LOST && past != null && back < past.count; back++) {
      for (long one : past.seats[(past.count - 1 - back) % KEPT]) {
        if (one == secret) {
          return true;
        }
      }
    }
    return false;
  }

  /**
   * Requires that no player plays in two rooms. Before its first tick a server that resumes may
   * have a player twice.
   */
  static void requireOneSeatEach(List<Room> running) {
    Set<Long> seen = new HashSet<>();
    for (Room room : running) {
      for (int id = 0; id < Soak.SEATS; id++) {
        Session session = room.session(id);
        if (session != null && !seen.add(session.seat().secret())) {
          throw new AssertionError(
              "two seats of one player: " + describe(running, session.seat().secret()));
        }
      }
    }
  }

  private static String describe(List<Room> rooms, long secret) {
    List<String> all = new ArrayList<>();
    for (Room room : rooms) {
      for (int id = 0; id < Soak.SEATS; id++) {
        Session session = room.session(id);
        if (session != null && session.seat().secret() == secret) {
          all.add(room.name() + " seat=" + id + " moves=" + session.seat().switches());
        }
      }
      for (Seats.Seat seat : room.seats().reserved()) {
        if (seat.secret() == secret) {
          all.add(room.name() + " reserved=" + seat.id() + " moves=" + seat.switches());
        }
      }
    }
    return all + " secret=" + Long.toHexString(secret);
  }

  /** Forgets all, because the next rooms begin anew. */
  void forget() {
    rooms.clear();
  }

  /** Returns how many rooms went on from a state that was. */
  int resumed() {
    return compared;
  }

  /** Returns what was seen, for people. */
  String summary() {
    return String.format(
        Locale.ROOT,
        "rooms resumed with equal hash and seats=%d, seats=%d, reserved=%d, at a tick between"
            + " two seen=%d, most ticks lost=%d",
        compared,
        seatsCompared,
        reserved,
        unseen,
        worstLost);
  }
}
