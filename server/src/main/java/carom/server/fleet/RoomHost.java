package carom.server.fleet;

import carom.server.config.RoomConfig;
import carom.server.room.FleetRoom;
import carom.server.session.Ownership;
import java.nio.file.Path;
import java.util.List;

/** The server whose rooms a fleet gives and takes, all of which it has built. Any thread. */
public interface RoomHost {

  /** Returns the rooms; the list is live. */
  List<? extends FleetRoom> rooms();

  /** Returns whether threads drive the rooms. */
  boolean hasThreads();

  /** Returns the room of a name, or null. */
  default FleetRoom room(String name) {
    for (FleetRoom room : rooms()) {
      if (room.name().equals(name)) {
        return room;
      }
    }
    return null;
  }

  /**
   * Builds a room that has another owner, or none. It takes as long as its level takes to build, so
   * best while the owner lives; without {@link #takeOver} nothing comes of it.
   *
   * @param settings of the room
   * @param slots folder of its followed state, which the room will go on from; null to begin anew
   * @param ownership whether this server owns the room
   * @throws IllegalArgumentException if it can't be played here; the message says why
   */
  FleetRoom prepare(RoomConfig settings, Path slots, Ownership ownership);

  /**
   * Adds a room that this server owns by now.
   *
   * @param room was prepared, once
   * @param slots as above
   * @throws IllegalArgumentException if it can't be played here; the message says why
   */
  void takeOver(FleetRoom room, Path slots);

  /**
   * Drops a room that another server owns. Its links are closed without a word, because its clients
   * must not take any of this server's for the owner's.
   */
  void drop(FleetRoom room, String why);

  /**
   * Removes a room that was handed over. Its clients' links stay, see {@link
   * FleetRoom#closeClients}.
   */
  void forget(FleetRoom room);
}
