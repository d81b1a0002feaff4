package carom.server.command;

import carom.net.protocol.ProtocolLimits;
import carom.server.config.DataFolder;
import carom.server.config.RoomConfig;
import carom.server.config.RoomFlag;
import carom.server.room.Room;
import carom.server.upload.Uploads;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The command {@code room}: adds, removes and changes rooms while the server runs, until its next
 * start, which has the rooms of the settings again.
 */
public final class RoomChangeCommands {
  private static final String ADD = "add";
  private static final String REMOVE = "remove";
  private static final String SET = "set";
  private static final Pattern INFO = Pattern.compile("([^=]+)=(.*)");

  private final RoomKeeper keeper;
  private final RoomFinder finder;
  private final LevelWords levels;

  private RoomChangeCommands(RoomKeeper keeper, RoomFinder finder, LevelWords levels) {
    this.keeper = keeper;
    this.finder = finder;
    this.levels = levels;
  }

  /**
   * Adds the command to a registry.
   *
   * @param rooms all rooms of the server, a live list
   * @param data the server's files
   * @param uploads levels of players, or null if the server takes none
   */
  public static void add(
      CommandRegistry registry,
      RoomKeeper keeper,
      List<Room> rooms,
      DataFolder data,
      Uploads uploads) {
    RoomChangeCommands all =
        new RoomChangeCommands(keeper, new RoomFinder(rooms), new LevelWords(data, uploads));
    registry.add(
        new Command(
            "room",
            "add NAME=LEVELS[:PLAYERS] [KEY=VALUE ...] | remove @ROOM [REASON] | set @ROOM players"
                + " N | levels A,B,C | info KEY=[VALUE]",
            "Adds, removes or changes a room until the next start; players of one that is removed"
                + " go to the others.",
            all::room,
            all::complete));
  }

  private List<String> complete(int place) {
    return switch (place) {
      case 0 -> List.of(ADD, REMOVE, SET);
      case 1 -> finder.names();
      case 2 -> List.of("players", "levels", "info");
      default -> List.of();
    };
  }

  private String room(CommandWords words) throws CommandException {
    String what = words.word(0, "add, remove or set");
    try {
      return switch (what) {
        case ADD -> add(words);
        case REMOVE -> remove(words);
        case SET -> set(words);
        default ->
            throw CommandException.ofWords("\"" + what + "\" is none of add, remove and set");
      };
    } catch (IllegalArgumentException e) {
      throw new CommandException("nothing has changed: " + e.getMessage());
    }
  }

  private String add(CommandWords words) throws CommandException {
    RoomFlag flag = RoomFlag.parse("", words.word(1, "NAME=LEVELS"));
    Map<String, String> info = new LinkedHashMap<>();
    for (int place = 2; words.has(place); place++) {
      putInfo(words.word(place, "KEY=VALUE"), info);
    }
    Room added =
        keeper.addRoom(
            new RoomConfig(
                flag.name(),
                "",
                levels.allowed(words, flag.levels()),
                flag.places() == 0 ? keeper.usualPlaces() : flag.places(),
                0,
                info));
    return "added " + describe(added);
  }

  private String remove(CommandWords words) throws CommandException {
    Room room = named(words);
    return "removed room=%s, %s".formatted(room.name(), keeper.removeRoom(room, words.rest(1)));
  }

  private String set(CommandWords words) throws CommandException {
    Room room = named(words);
    words.requireAtMost(3);
    String what = words.word(1, "players, levels or info");
    UnaryOperator<RoomConfig> change =
        switch (what) {
          case "players" -> places(words.word(2, "N"));
          case "levels" -> rotation(words);
          case "info" -> info(words.word(2, "KEY=VALUE"));
          default ->
              throw CommandException.ofWords(
                  "\"" + what + "\" is none of players, levels and info");
        };
    keeper.changeRoom(room, change);
    return "now " + describe(room);
  }

  private Room named(CommandWords words) throws CommandException {
    if (words.room() == null) {
      throw CommandException.ofWords(
          "no room is named; name one of " + String.join(", ", finder.names()));
    }
    return finder.one(words);
  }

  private static UnaryOperator<RoomConfig> places(String text) {
    if (!text.matches("\\d{1,4}")) {
      throw new IllegalArgumentException(
          "players=" + text + " is no number of 1.." + ProtocolLimits.MAX_PLAYERS);
    }
    int places = Integer.parseInt(text);
    return present -> present.withPlaces(places);
  }

  private UnaryOperator<RoomConfig> rotation(CommandWords words) throws CommandException {
    String text = words.word(2, "LEVELS");
    List<String> names = levels.allowed(words, RoomFlag.levels("levels=" + text, text));
    return present -> present.withLevels(names);
  }

  private static UnaryOperator<RoomConfig> info(String text) {
    return present -> {
      Map<String, String> entries = new LinkedHashMap<>(present.metadata());
      putInfo(text, entries);
      return present.withMetadata(entries);
    };
  }

  /** Puts an entry; one without a value goes. */
  private static void putInfo(String text, Map<String, String> entries) {
    Matcher parts = INFO.matcher(text);
    if (!parts.matches()) {
      throw new IllegalArgumentException("\"" + text + "\" has no \"=\"; write KEY=VALUE");
    }
    if (parts.group(2).isBlank()) {
      entries.remove(parts.group(1));
    } else {
      entries.put(parts.group(1), parts.group(2).strip());
    }
  }

  private static String describe(Room room) {
    RoomConfig own = room.settings();
    return "room="
        + own.name()
        + " levels="
        + String.join(",", own.levels())
        + " players="
        + own.places()
        + (own.metadata().isEmpty() ? "" : " info=" + own.metadata());
  }
}
