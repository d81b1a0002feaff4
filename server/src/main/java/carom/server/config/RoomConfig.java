package carom.server.config;

import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.RoomName;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * The settings of one room. Immutable. The constructor refuses a value outside its range with a
 * message that names the setting, the value and the limits.
 *
 * @param name name by which players find the room, see {@link RoomName}
 * @param game name of the game it begins with; empty for the one that the first level is made for
 * @param levels files or names of levels; it begins with the first, and goes round them when the
 *     game says that a match is over. Empty for the default level of the game
 * @param places seats of the room, 1..1,024
 * @param seed seed of the first match's random numbers
 * @param metadata what players can choose the room by, shown in lists of rooms; see {@link
 *     RoomName#metadataProblem}
 */
public record RoomConfig(
    String name,
    String game,
    List<String> levels,
    int places,
    long seed,
    Map<String, String> metadata) {

  /**
   * Checks every setting.
   *
   * @throws IllegalArgumentException if a setting is out of range; the message names the first
   */
  public RoomConfig {
    String problem = RoomName.problem(name);
    if (problem != null) {
      throw new IllegalArgumentException(problem);
    }
    if (game.isEmpty() && levels.isEmpty()) {
      throw new IllegalArgumentException(
          "room=" + name + " has neither a game nor a level; name one of them");
    }
    if (places < 1 || places > ProtocolLimits.MAX_PLAYERS) {
      throw new IllegalArgumentException(
          "places=" + places + " is outside 1.." + ProtocolLimits.MAX_PLAYERS);
    }
    problem = RoomName.metadataProblem(metadata);
    if (problem != null) {
      throw new IllegalArgumentException(problem);
    }
    levels = List.copyOf(levels);
    metadata = Collections.unmodifiableMap(new LinkedHashMap<>(metadata));
  }

  /** Returns these settings with other metadata. */
  public RoomConfig withMetadata(Map<String, String> entries) {
    return new RoomConfig(name, game, levels, places, seed, entries);
  }

  /** Returns these settings with another name. */
  public RoomConfig withName(String value) {
    return new RoomConfig(value, game, levels, places, seed, metadata);
  }

  /** Returns these settings with another seed. */
  public RoomConfig withSeed(long value) {
    return new RoomConfig(name, game, levels, places, value, metadata);
  }

  /** Returns these settings with other levels. */
  public RoomConfig withLevels(List<String> names) {
    return new RoomConfig(name, "", names, places, seed, metadata);
  }

  /** Returns these settings with another number of seats. */
  public RoomConfig withPlaces(int value) {
    return new RoomConfig(name, game, levels, value, seed, metadata);
  }

  /**
   * Returns the number of seats of several rooms.
   *
   * @throws IllegalArgumentException when rooms have the same name, or too many seats together
   */
  public static int places(List<RoomConfig> rooms) {
    Set<String> names = new HashSet<>();
    int places = 0;
    for (RoomConfig room : rooms) {
      if (!names.add(room.name)) {
        throw new IllegalArgumentException(
            "name=" + room.name + " belongs to two rooms; give each a name of its own");
      }
      places += room.places;
    }
    if (places > ServerConfig.MAX_PLACES) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "places=%d in all rooms are more than limit=%d; lower the players of some rooms",
              places,
              ServerConfig.MAX_PLACES));
    }
    return places;
  }

  /**
   * Returns the rooms of a server in which all are equal, with the names 1, 2, 3 and so on.
   *
   * @param levels as in {@link #levels}
   */
  public static List<RoomConfig> equalRooms(ServerConfig config, List<String> levels) {
    List<RoomConfig> rooms = new ArrayList<>();
    for (int number = 1; number <= config.get(ServerConfig.ROOMS); number++) {
      rooms.add(
          new RoomConfig(
              String.valueOf(number),
              levels.isEmpty() ? config.get(ServerConfig.GAME) : "",
              levels,
              config.get(ServerConfig.MAX_PLAYERS),
              config.get(ServerConfig.SEED) + number - 1,
              Map.of()));
    }
    return List.copyOf(rooms);
  }
}
