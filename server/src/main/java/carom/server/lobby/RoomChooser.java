package carom.server.lobby;

import carom.net.admission.AddressGroup;
import carom.server.metrics.Counter;
import carom.server.room.Room;
import carom.server.session.Seats;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.IntSupplier;

/** Finds the room for a newcomer. Rooms that have failed count as full. */
final class RoomChooser {
  private final List<Room> rooms;
  private final IntSupplier maxLoadPercent;
  private final int ticksUntilLoadIsKnown;

  RoomChooser(List<Room> rooms, IntSupplier maxLoadPercent, int ticksUntilLoadIsKnown) {
    this.rooms = rooms;
    this.maxLoadPercent = maxLoadPercent;
    this.ticksUntilLoadIsKnown = ticksUntilLoadIsKnown;
  }

  /**
   * Returns the room that holds a seat for a session's secret, or null; of several, the one to
   * which the player went last.
   */
  Room expecting(long resumeSecret) {
    Room last = null;
    int most = -1;
    for (Room room : rooms) {
      int switches = room.hasFailed() ? -1 : room.seats().switchesOf(resumeSecret);
      if (switches > most) {
        most = switches;
        last = room;
      }
    }
    return last;
  }

  /** Returns the seat to which a token lets a bot, which is claimed then, and its room; or null. */
  Map.Entry<Room, Seats.Seat> claimForBot(String token) {
    for (Room room : rooms) {
      Seats.Seat seat = room.hasFailed() ? null : room.seats().claimForBot(token);
      if (seat != null) {
        return Map.entry(room, seat);
      }
    }
    return null;
  }

  /**
   * Returns whether a seat will be free in a moment, because its player has gone to another room.
   *
   * @param requested the one room that matters, or null for all open rooms
   */
  boolean hasReserved(Room requested) {
    for (Room room : requested == null ? rooms : List.of(requested)) {
      if (!room.hasFailed() && room.seats().hasReserved()) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns why a newcomer can't come in because of the load, or null.
   *
   * @param requested the one room that matters, or null for all open rooms
   */
  String overload(Room requested) {
    int least = Integer.MAX_VALUE;
    for (Room room : requested == null ? rooms : List.of(requested)) {
      if (!room.hasFailed() && !isOverloaded(room)) {
        return null;
      }
      least = Math.min(least, load(room));
    }
    return String.format(
        Locale.ROOT,
        "Its ticks take %d %% of their time; newcomers may come below %d %%.",
        least,
        maxLoadPercent.getAsInt());
  }

  /** Returns whether a room's load keeps newcomers out. */
  boolean isOverloaded(Room room) {
    int most = maxLoadPercent.getAsInt();
    return most > 0
        && room.counters().get(Counter.TICKS) >= ticksUntilLoadIsKnown
        && load(room) > most;
  }

  private static int load(Room room) {
    return (int) room.counters().get(Counter.LOAD_PERCENT);
  }

  /** Returns how many seats an account has in all rooms that have not failed. */
  int seatsOf(String account) {
    return rooms.stream()
        .filter(room -> !room.hasFailed())
        .mapToInt(room -> room.seats().countOf(account))
        .sum();
  }

  /**
   * Returns the seats that are neither taken nor promised.
   *
   * @param requested the one room that matters, or null for all open rooms
   */
  int seatsLeft(Room requested) {
    if (requested != null) {
      return left(requested);
    }
    int left = 0;
    for (Room room : rooms) {
      left += room.hasFailed() ? 0 : left(room);
    }
    return left;
  }

  /** Returns a room's free seats; a room whose seats were cut down may have more players. */
  private static int left(Room room) {
    return Math.max(0, room.seats().count() - room.seats().takenCount());
  }

  /**
   * Asks a room to give up an idle seat, or one of a network that holds more than its share.
   * Returns the room that will, or null.
   *
   * @param account the newcomer's account, or empty
   * @param origin where the newcomer comes from
   * @param requested the room, or null for all in turn
   */
  Room askToGiveWay(String account, AddressGroup origin, Room requested) {
    for (Room room : requested == null ? rooms : List.of(requested)) {
      if (!room.hasFailed() && room.seatRequests().ask(account, origin)) {
        return room;
      }
    }
    return null;
  }
}
