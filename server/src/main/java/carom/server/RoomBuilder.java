package carom.server;

import carom.physics.threads.WorkerThreads;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.MatchLibrary;
import carom.server.metrics.Counters;
import carom.server.room.Room;
import carom.server.room.RoomDirectory;
import carom.server.session.Seats;
import carom.server.threads.LoaderThread;
import java.security.SecureRandom;
import java.util.List;
import java.util.function.LongSupplier;

/** Builds the rooms of a server from what they share and what is their own. Any thread. */
record RoomBuilder(
    ServerConfig config,
    List<RoomConfig> rooms,
    MatchLibrary library,
    LoaderThread loads,
    LongSupplier clock,
    RoomDirectory directory,
    WorkerThreads helpers,
    SecureRandom random) {

  /**
   * Builds a room with its first match.
   *
   * @param index place in the list of rooms
   * @param counters of the room
   * @throws IllegalArgumentException when the match can't be played; the message says why
   */
  Room build(int index, Counters counters) {
    RoomConfig own = rooms.get(index);
    Seats seats = new Seats(own.places(), random::nextLong);
    boolean alone = rooms.size() == 1;
    Room room =
        new Room(config, index + 1, alone, own, library, loads, clock, seats, directory, counters);
    room.helpedBy(helpers);
    return room;
  }
}
