package carom.lab.soak;

import carom.server.room.Room;
import carom.server.session.Session;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Looks whether players of a server that ended come back by themselves to the seats that they had.
 * That the seats have the same bodies follows from the hash of the state.
 */
final class Comebacks {
  /** Seats younger than that may not be on the disk, or belong to a tick that is lost, ns. */
  private static final long SETTLED_NS = 1_500_000_000L;

  /** A client without a line for longer may have lost its seat; the grace period is 30 s. */
  private static final long AWAY_NS = 25_000_000_000L;

  /** A seat, and since when it is a client's. */
  private record Stay(String room, int player, long sinceNs) {}

  private final Map<Guest, Stay> stays = new LinkedHashMap<>();

  /** Those who play and had a seat when the server ended; null until the link is lost. */
  private final Map<Guest, Boolean> lost = new LinkedHashMap<>();

  private final Map<Guest, Stay> expected = new LinkedHashMap<>();
  private long endedNs;
  private long came;

  /** Takes note of a moment. */
  void look(Guest guest, long nowNs) {
    if (!guest.isPlaying()) {
      stays.remove(guest);
      lost.computeIfPresent(guest, (g, was) -> true);
      return;
    }
    Stay stay = stays.get(guest);
    if (stay == null || stay.player != guest.playerId() || !stay.room.equals(guest.room())) {
      stays.put(guest, new Stay(guest.room(), guest.playerId(), nowNs));
    }
    if (lost.getOrDefault(guest, false)) {
      lost.remove(guest);
      requireSame(guest, expected.remove(guest), nowNs);
    }
  }

  private void requireSame(Guest guest, Stay had, long nowNs) {
    if (nowNs - endedNs > AWAY_NS) {
      return;
    }
    if (had.player != guest.playerId() || !had.room.equals(guest.room())) {
      throw new AssertionError(
          String.format(
              Locale.ROOT,
              "%s of seat=%d room=%s came back %.2f s after the server ended to seat=%d room=%s",
              guest,
              had.player,
              had.room,
              (nowNs - endedNs) * 1e-9,
              guest.playerId(),
              guest.room()));
    }
    came++;
  }

  /** Forgets a client that has left, or asked for another room. */
  void forget(Guest guest) {
    stays.remove(guest);
    lost.remove(guest);
    expected.remove(guest);
  }

  /**
   * Expects that all who play now come back.
   *
   * @param rooms of the server that ends; a client whose line is dead may have a seat of an older
   *     one in mind
   */
  void serverEnds(List<Room> rooms, long nowNs) {
    endedNs = nowNs;
    forgetAll();
    for (Map.Entry<Guest, Stay> one : stays.entrySet()) {
      Stay stay = one.getValue();
      if (nowNs - stay.sinceNs > SETTLED_NS && has(rooms, one.getKey(), stay)) {
        lost.put(one.getKey(), false);
        expected.put(one.getKey(), stay);
      }
    }
  }

  private static boolean has(List<Room> rooms, Guest guest, Stay stay) {
    for (Room room : rooms) {
      Session session = room.name().equals(stay.room) ? room.session(stay.player) : null;
      if (session != null && session.seat().wantedName().equals(guest.name())) {
        return true;
      }
    }
    return false;
  }

  /** Expects nobody, because the next rooms begin anew. */
  void forgetAll() {
    lost.clear();
    expected.clear();
  }

  /** Returns how many came back to their seats. */
  long came() {
    return came;
  }
}
