package carom.server;

import carom.physics.threads.WorkerThreads;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.MatchLibrary;
import carom.server.metrics.Counters;
import carom.server.room.Room;
import carom.server.room.RoomDirectory;
import carom.server.session.Ownership;
import carom.server.session.Seats;
import carom.server.threads.LoaderThread;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.function.Function;
import java.util.function.LongSupplier;

/** Builds the rooms of a server from what they share and what is their own. Any thread. */
record RoomBuilder(
    LiveConfig config,
    MatchLibrary library,
    LoaderThread loads,
    LongSupplier clock,
    RoomDirectory directory,
    Function<RoomConfig, Ownership> ownerships,
    WorkerThreads helpers,
    SecureRandom random) {

  /**
   * Builds a room with its first match.
   *
   * @param own the room's settings
   * @param number of the room, from 1 on
   * @param counters of the room
   * @throws IllegalArgumentException when the match can't be played; the message says why
   */
  Room build(RoomConfig own, int number, Counters counters) {
    return build(own, number, counters, ownerships.apply(own), null);
  }

  /**
   * Builds a room as above.
   *
   * @param ownership whether the server owns the room
   * @param journal folder from which the room will {@link Room#resume}; null to begin anew
   */
  Room build(RoomConfig own, int number, Counters counters, Ownership ownership, Path journal) {
    Seats seats = new Seats(own.places(), random::nextLong);
    boolean named = config.get().get(ServerConfig.ROOMS) > 1 || !own.name().equals("1");
    String label = named ? "room " + own.name() + ": " : "";
    Room room =
        new Room(
            config, number, label, own, library, loads, clock, seats, directory, counters,
            ownership, journal);
    room.helpedBy(helpers == null ? null : helpers.forOneWorld());
    return room;
  }
}
