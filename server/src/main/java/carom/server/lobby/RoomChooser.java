package carom.server.lobby;

import carom.server.room.Room;
import java.util.List;

/** Finds the room for a newcomer. Rooms that have failed count as full. */
final class RoomChooser {
  private final List<Room> rooms;

  RoomChooser(List<Room> rooms) {
    this.rooms = rooms;
  }

  /** Returns the room that holds a seat for a session's secret, or null. */
  Room expecting(long resumeSecret) {
    for (Room room : rooms) {
      if (!room.hasFailed() && room.seats().knows(resumeSecret)) {
        return room;
      }
    }
    return null;
  }

  /** Returns the fullest room that still has a seat, the first among equals, or null. */
  Room fullestWithSeat() {
    Room fullest = null;
    int most = -1;
    for (Room room : rooms) {
      int taken = room.seats().takenCount();
      if (taken > most && taken < room.seats().count() && !room.hasFailed()) {
        most = taken;
        fullest = room;
      }
    }
    return fullest;
  }

  /** Returns the seats of all open rooms that are neither taken nor promised. */
  int seatsLeft() {
    int left = 0;
    for (Room room : rooms) {
      left += room.hasFailed() ? 0 : room.seats().count() - room.seats().takenCount();
    }
    return left;
  }

  /** Asks the rooms in turn to give up a seat that nobody plays in. Returns whether one will. */
  boolean askToGiveWay() {
    for (Room room : rooms) {
      if (!room.hasFailed() && room.giveWay()) {
        return true;
      }
    }
    return false;
  }
}
