package carom.server.command;

import carom.game.Games;
import carom.server.config.DataFolder;
import carom.server.replication.LinkFigures;
import carom.server.room.OperatorCommands;
import carom.server.room.Room;
import carom.server.session.PlayerInfo;
import carom.server.upload.Uploads;
import carom.sim.message.BuiltInKinds;
import carom.text.Suggestion;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;

/** The commands that are about a room: who plays, what is played, and what is recorded. */
public final class RoomCommands {
  private static final String STOP = "stop";

  /** Most saved matches that a message names. */
  private static final int MAX_SHOWN = 20;

  private static final String MATCH = "match";
  private static final Pattern NEXT_FIELD = Pattern.compile(" (?=[-\\w.\\[\\]]+=)");

  private final RoomFinder finder;
  private final List<Room> rooms;
  private final DataFolder data;
  private final SaveSource saves;
  private final LevelWords levelWords;

  private RoomCommands(List<Room> rooms, DataFolder data, Uploads uploads, SaveSource saves) {
    this.finder = new RoomFinder(rooms);
    this.rooms = rooms;
    this.data = data;
    this.saves = saves;
    levelWords = new LevelWords(data, uploads);
  }

  /**
   * Adds the commands to a registry.
   *
   * @param rooms all rooms of the server
   * @param data the server's files
   * @param uploads levels of players, or null if the server takes none
   * @param saves of other servers
   */
  public static void add(
      CommandRegistry registry,
      List<Room> rooms,
      DataFolder data,
      Uploads uploads,
      SaveSource saves) {
    RoomCommands all = new RoomCommands(rooms, data, uploads, saves);
    all.addForPlayers(registry);
    all.addForMatches(registry);
  }

  private void addForPlayers(CommandRegistry registry) {
    registry.add(
        new Command("list", "[@ROOM]", "Shows the players.", this::list, this::onlyRooms)
            .forModerators()
            .thatShows());
    registry.add(
        new Command("rooms", "", "Shows the rooms and what they play.", this::rooms, Command.NONE)
            .thatShows());
    registry.add(
        new Command(
                "say",
                "[@ROOM] TEXT",
                "Says a line to all players, or to those of a room.",
                this::say,
                this::onlyRooms)
            .forModerators());
    registry.add(
        new Command(
                "kick",
                "PLAYER [REASON]",
                "Removes a player, by name or id, who may join again.",
                this::kick,
                this::players)
            .forModerators());
    registry.add(
        new Command(
                "mute",
                "PLAYER",
                "Drops a player's chat and emotes for the rest of its stay.",
                words -> mute(words, true),
                this::players)
            .forModerators());
    registry.add(
        new Command(
                "unmute",
                "PLAYER",
                "Lets a muted player chat again.",
                words -> mute(words, false),
                this::players)
            .forModerators());
    registry.add(
        new Command(
                "spectate",
                "PLAYER",
                "Makes a player a spectator, who may ask to play again.",
                this::spectate,
                this::players)
            .forModerators());
  }

  private void addForMatches(CommandRegistry registry) {
    registry.add(
        new Command(
            "level",
            "[@ROOM] LEVEL",
            "Goes on with another level: a file, one of the data folder, or one that comes along.",
            this::level,
            behindRoom(this::levels)));
    registry.add(
        new Command(
            "game",
            "[@ROOM] GAME [LEVEL]",
            "Goes on with another game, in its default level or another.",
            this::game,
            behindRoom(this::games)));
    registry.add(
        new Command(
            "record",
            "[@ROOM] [FILE | stop]",
            "Begins to record, to the data folder or a file or folder; or ends that.",
            this::record,
            behindRoom(place -> place == 0 ? List.of(STOP) : List.of())));
    registry.add(
        new Command(
            "save",
            "[@ROOM] [NAME]",
            "Saves the match to the data folder, under the room's name or another.",
            this::save,
            behindRoom(Command.NONE)));
    registry.add(
        new Command(
            "load",
            "[@ROOM] [NAME]",
            "Goes on with a saved match.",
            this::load,
            behindRoom(place -> place == 0 ? data.savedNames() : List.of())));
    registry.add(
        new Command(
                "why",
                "PLAYER ENTITY",
                "Explains why a player was not sent an entity, or that it was.",
                this::why,
                this::players)
            .thatShows());
    registry.add(
        new Command(
                "fields",
                "[@ROOM] match | player N | entity N",
                "Shows the values of fields.",
                this::fields,
                behindRoom(place -> place == 0 ? List.of(MATCH, "player", "entity") : List.of()))
            .thatShows());
  }

  /** Adds the rooms to the words of a command that is about one room, if there are several. */
  private Command.Completer behindRoom(Command.Completer others) {
    return place -> {
      List<String> words = new ArrayList<>(others.words(place));
      if (rooms.size() > 1) {
        words.addAll(finder.names());
      }
      return words;
    };
  }

  private List<String> onlyRooms(int place) {
    return finder.names();
  }

  private List<String> players(int place) {
    return place == 0 ? finder.playerNames() : List.of();
  }

  private List<String> levels(int place) {
    return place == 0 ? levelWords.names() : List.of();
  }

  private List<String> games(int place) {
    return place == 0 ? Games.names() : levels(place - 1);
  }

  private String list(CommandWords words) throws CommandException {
    words.requireAtMost(0);
    TextTable table =
        new TextTable("id", "name", "room", "address", "state", "team", "score", "ping", "loss");
    int count = 0;
    for (Room room : finder.all(words)) {
      for (PlayerInfo player : room.operator().players()) {
        table.add(
            player.id(),
            player.name(),
            room.name(),
            player.remote(),
            player.state(),
            player.team(),
            player.score(),
            player.link().roundTripMs() + " ms",
            loss(player.link()));
        count++;
      }
    }
    return count == 0 ? "nobody plays" : table.toString();
  }

  /** Returns the share of datagrams to a client that were lost since its link began. */
  private static String loss(LinkFigures link) {
    long lost = link.settled() - link.acked();
    return String.format(Locale.ROOT, "%.1f %%", 100.0 * lost / Math.max(1, link.settled()));
  }

  private String rooms(CommandWords words) throws CommandException {
    words.requireAtMost(0);
    TextTable table = new TextTable("room", "players", "game", "level", "tick", "state");
    for (Room room : rooms) {
      table.add(
          "@" + room.name(),
          room.seats().takenCount() + "/" + room.seats().count(),
          room.match().game(),
          room.match().level().level().name(),
          room.tick(),
          room.hasFailed() ? "failed" : room.isPaused() ? "paused" : "runs");
    }
    return table.toString();
  }

  private String say(CommandWords words) throws CommandException {
    String text = words.word(0, "TEXT").isEmpty() ? "" : words.rest(0);
    if (text.isBlank() || text.length() > BuiltInKinds.MAX_CHAT) {
      throw new CommandException(
          String.format(
              Locale.ROOT,
              "TEXT has %d characters, allowed are 1..%d",
              text.length(),
              BuiltInKinds.MAX_CHAT));
    }
    int heard = 0;
    for (Room room : finder.all(words)) {
      heard += room.operator().say(text);
    }
    return "said to " + heard + (heard == 1 ? " player" : " players");
  }

  private String mute(CommandWords words, boolean on) throws CommandException {
    words.requireAtMost(1);
    RoomFinder.Found found = finder.player(words, 0);
    return found.room().operator().mute(found.player().name(), on);
  }

  private String spectate(CommandWords words) throws CommandException {
    words.requireAtMost(1);
    RoomFinder.Found found = finder.player(words, 0);
    return found.room().operator().spectate(found.player().name());
  }

  private String kick(CommandWords words) throws CommandException {
    RoomFinder.Found found = finder.player(words, 0);
    return found.room().operator().kick(found.player().id(), words.rest(1));
  }

  private String level(CommandWords words) throws CommandException {
    words.requireAtMost(1);
    return finder.one(words).operator().change("", levelName(words, 0));
  }

  private String game(CommandWords words) throws CommandException {
    words.requireAtMost(2);
    String game = words.word(0, "GAME");
    String level = words.has(1) ? levelName(words, 1) : "";
    return finder.one(words).operator().change(game, level);
  }

  private String levelName(CommandWords words, int place) throws CommandException {
    return levelWords.allowed(words, words.word(place, "LEVEL"));
  }

  private String record(CommandWords words) throws CommandException {
    words.requireAtMost(1);
    OperatorCommands room = finder.one(words).operator();
    if (words.has(0) && words.word(0, "FILE").equals(STOP)) {
      return room.stopRecording();
    }
    try {
      boolean anywhere = words.has(0) && words.mayNameAnyFile();
      Path folder = anywhere ? data.recordings() : data.newRecordings();
      return room.record(
          words.has(0) ? NamedFiles.file(words, 0, "FILE", List.of(folder)) : folder);
    } catch (IOException e) {
      throw new CommandException(e.getMessage());
    }
  }

  private String save(CommandWords words) throws CommandException {
    Room room = finder.one(words);
    return room.operator().save(data.saved(savedName(room, words)));
  }

  private String load(CommandWords words) throws CommandException {
    Room room = finder.one(words);
    String name = savedName(room, words);
    try {
      String from = saves.bring(name);
      if (!Files.exists(data.saved(name))) {
        return "not loaded: there is no file " + data.saved(name) + others(name);
      }
      String done = room.operator().load(data.saved(name));
      return from.isEmpty() ? done : done + ", as saved at " + from;
    } catch (IOException e) {
      return "not loaded: " + e.getMessage();
    }
  }

  /** Returns which matches are saved, for one that isn't, and which was meant. */
  private String others(String name) {
    List<String> saved = data.savedNames();
    List<String> shown = saved.subList(0, Math.min(MAX_SHOWN, saved.size()));
    return Suggestion.didYouMean(name, saved)
        + (saved.isEmpty() ? "; none is saved yet" : "; saved are " + String.join(", ", shown))
        + (shown.size() < saved.size() ? " and " + (saved.size() - shown.size()) + " more" : "");
  }

  private static String savedName(Room room, CommandWords words) throws CommandException {
    words.requireAtMost(1);
    String name = words.has(0) ? words.word(0, "NAME") : room.name();
    if (!DataFolder.isSaveName(name)) {
      throw new CommandException(
          "NAME=" + name + " has other characters than letters, digits, - _");
    }
    return name;
  }

  private String why(CommandWords words) throws CommandException {
    words.requireAtMost(2);
    RoomFinder.Found found = finder.player(words, 0);
    String entity = words.word(1, "ENTITY");
    try {
      PlayerInfo player = found.player();
      return found
          .room()
          .operator()
          .why(player.id(), Integer.parseInt(entity), report -> WhyText.of(player.name(), report));
    } catch (NumberFormatException e) {
      throw new CommandException("ENTITY=" + entity + " is no number");
    }
  }

  private String fields(CommandWords words) throws CommandException {
    words.requireAtMost(2);
    String all = finder.one(words).operator().fields(words.has(0) ? words.rest(0) : MATCH);
    return NEXT_FIELD.matcher(all).replaceAll("\n");
  }
}
