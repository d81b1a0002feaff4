package carom.server.fleet;

import carom.server.config.RoomConfig;
import carom.server.room.Room;
import java.nio.file.Path;
import java.util.List;

/** The server whose rooms a fleet gives and takes. Any thread. */
public interface RoomHost {

  /** Returns the rooms; the list is live. */
  List<Room> rooms();

  /** Returns whether threads drive the rooms. */
  boolean hasThreads();

  /** Returns the room of a name, or null. */
  default Room room(String name) {
    for (Room room : rooms()) {
      if (room.name().equals(name)) {
        return room;
      }
    }
    return null;
  }

  /**
   * Adds a room that had another owner, or none. It may take as long as its level takes to build.
   *
   * @param settings of the room
   * @param slots folder of its followed state, which the room goes on from; null to begin anew
   * @throws IllegalArgumentException if it can't be played here; the message says why
   */
  Room takeOver(RoomConfig settings, Path slots);

  /**
   * Drops a room that another server owns. Its links are closed without a word, because its clients
   * must not take any of this server's for the owner's.
   */
  void drop(Room room, String why);

  /** Removes a room that was handed over, and closes its links when its clients have gone on. */
  void forget(Room room);
}
