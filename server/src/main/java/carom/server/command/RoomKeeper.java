package carom.server.command;

import carom.server.config.RoomConfig;
import carom.server.room.Room;
import java.util.function.UnaryOperator;

/** Adds, removes and changes rooms of a server that runs. Any thread but a room's. */
public interface RoomKeeper {
  /**
   * Adds a room. Waits while its first match is built.
   *
   * @param own the room's settings; the seed is the server's choice
   * @return the room
   * @throws IllegalArgumentException if there can't be such a room; nothing has changed then
   */
  Room addRoom(RoomConfig own);

  /**
   * Removes a room. Its players go to other rooms that have a seat; the others are told goodbye.
   *
   * @param text for the players who find no room, may be empty
   * @return what became of the players
   * @throws IllegalArgumentException if it is the last one that runs; nothing has changed then
   */
  String removeRoom(Room room, String text);

  /**
   * Changes seats, levels or metadata of a room.
   *
   * @param change returns the next settings for the present ones
   * @throws IllegalArgumentException if they can't be; nothing has changed then
   */
  void changeRoom(Room room, UnaryOperator<RoomConfig> change);

  /** Returns the seats of a room that doesn't say how many it has. */
  int usualPlaces();
}
