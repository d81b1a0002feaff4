package carom.server.config;

import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.RoomName;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * One value of {@code --room}: {@code NAME=LEVEL[,LEVEL...][:PLAYERS]}. No character of it means
 * anything to a shell.
 *
 * @param name name of the room, see {@link RoomName}
 * @param levels files, names of levels, or names of games, which stand for their default levels
 * @param places seats of the room; 0 = as {@code --max-players} says
 */
public record RoomFlag(String name, List<String> levels, int places) {
  private static final String FORM =
      "; write NAME=LEVEL[,LEVEL...][:PLAYERS], for example cup=arena,commons:16";

  /** A number behind the last colon; a colon elsewhere belongs to a path. */
  private static final Pattern PLACES = Pattern.compile("(.*):(\\d+)");

  /** Names of rooms have no colon, keys no equals sign. */
  private static final Pattern INFO = Pattern.compile("([^:]+):([^=]+)=(.+)");

  /**
   * Reads a value.
   *
   * @throws IllegalArgumentException when it has another form; the message says how to write it
   */
  public static RoomFlag parse(String text) {
    return parse("--room=", text);
  }

  /**
   * Reads a value as above.
   *
   * @param flag what stands before the value in messages
   */
  public static RoomFlag parse(String flag, String text) {
    int equals = text.indexOf('=');
    if (equals < 0) {
      throw new IllegalArgumentException(flag + text + " has no \"=\"" + FORM);
    }
    String name = text.substring(0, equals);
    String problem = RoomName.problem(name);
    if (problem != null) {
      throw new IllegalArgumentException(flag + text + ": " + problem);
    }
    String levels = text.substring(equals + 1);
    int places = 0;
    Matcher withPlaces = PLACES.matcher(levels);
    if (withPlaces.matches()) {
      levels = withPlaces.group(1);
      places = number(withPlaces.group(2));
      if (places < 1 || places > ProtocolLimits.MAX_PLAYERS) {
        throw new IllegalArgumentException(
            String.format(
                Locale.ROOT,
                "%s%s: players=%s is outside 1..%d",
                flag,
                text,
                withPlaces.group(2),
                ProtocolLimits.MAX_PLAYERS));
      }
    }
    return new RoomFlag(name, levels(flag + text, levels), places);
  }

  /**
   * Reads a value of {@code --room-info}, {@code ROOM:KEY=VALUE}.
   *
   * @param metadata of each room by its name; gets the entry
   * @throws IllegalArgumentException when it has another form, there is no such room, or the room
   *     has the key already
   */
  public static void readInfo(String text, Map<String, Map<String, String>> metadata) {
    Matcher info = INFO.matcher(text);
    if (!info.matches()) {
      throw new IllegalArgumentException(
          "--room-info=" + text + "; write ROOM:KEY=VALUE, for example cup:skill=beginners");
    }
    Map<String, String> entries = metadata.get(info.group(1));
    if (entries == null) {
      throw new IllegalArgumentException(
          "--room-info=%s: there is no room=%s; rooms are %s"
              .formatted(text, info.group(1), String.join(", ", metadata.keySet())));
    }
    if (entries.put(info.group(2), info.group(3).strip()) != null) {
      throw new IllegalArgumentException(
          "--room-info=%s: room=%s has key=%s already; leave one of them out"
              .formatted(text, info.group(1), info.group(2)));
    }
  }

  /**
   * Splits a list of levels at its commas.
   *
   * @param flag begins the message of the exception
   * @throws IllegalArgumentException when there is none, or one is empty
   */
  public static List<String> levels(String flag, String text) {
    List<String> levels = List.of(text.split(",", -1)).stream().map(String::strip).toList();
    if (levels.contains("")) {
      throw new IllegalArgumentException(
          flag + " names " + (levels.size() == 1 ? "no level" : "an empty level") + FORM);
    }
    return levels;
  }

  private static int number(String digits) {
    return digits.length() > 4 ? Integer.MAX_VALUE : Integer.parseInt(digits);
  }
}
