package carom.server;

import carom.game.Games;
import carom.server.config.RoomConfig;
import carom.server.config.RoomFlag;
import carom.server.config.ServerConfig;
import carom.server.match.HandedInMatch;
import carom.server.match.MatchLibrary;
import carom.server.upload.UploadedLevel;
import carom.server.upload.Uploads;
import carom.sim.Game;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneGame;
import carom.sim.scene.Scenes;
import carom.text.Suggestion;
import carom.tiled.TiledImport;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Holds what {@code --game}, {@code --level}, {@code --levels}, {@code --room} and {@code --scene}
 * choose: the rooms, each with its levels, and the game and level of the first.
 */
final class GameChoice {
  private static final String DEFAULT_GAME = "arena";

  /**
   * Most bodies of a level that the warm-up plays. For a larger level it plays the default level of
   * the game.
   */
  private static final int MAX_WARM_UP_BODIES = 1_000;

  private final ServerFlags flags;
  private final Level level;
  private final String levelName;
  private final String gameName;

  /** The rooms of {@code --room}, with names of levels that are there; empty without the flag. */
  private final List<RoomFlag> named;

  /** The levels of {@code --levels}, which are there; empty without the flag. */
  private final List<String> rotation;

  /**
   * Reads the flags and loads each level that they name.
   *
   * @throws carom.options.BadFlag when a flag names an unknown game, level or scene, or when the
   *     flags don't fit together
   */
  GameChoice(ServerFlags flags) {
    this.flags = flags;
    flags.checkRooms();
    named = flags.get(ServerConfig.ROOM).stream().map(this::named).toList();
    rotation =
        flags.get(ServerConfig.LEVELS) == null
            ? List.of()
            : rotation(flags.get(ServerConfig.LEVELS));
    Scene scene = flags.get(ServerConfig.SCENE) == null ? null : chooseScene();
    levelName = scene == null ? chooseLevelName() : "";
    level = scene == null ? load("--level=" + levelName, levelName) : SceneGame.level(scene);
    gameName = chooseGame().name();
  }

  private RoomFlag named(String text) {
    try {
      RoomFlag room = RoomFlag.parse(text);
      String flag = "--room=" + text;
      return new RoomFlag(
          room.name(),
          room.levels().stream().map(name -> nameOfLevel(flag, name)).toList(),
          room.places());
    } catch (IllegalArgumentException e) {
      throw flags.bad(e.getMessage());
    }
  }

  private List<String> rotation(String text) {
    try {
      String flag = "--levels=" + text;
      return RoomFlag.levels(flag, text).stream().map(name -> nameOfLevel(flag, name)).toList();
    } catch (IllegalArgumentException e) {
      throw flags.bad(e.getMessage());
    }
  }

  /** Returns the name of a level that is there, for the name of a level, file or game. */
  private String nameOfLevel(String flag, String name) {
    boolean isGame =
        !Files.isRegularFile(path(flag, name))
            && !MatchLibrary.builtInLevels().contains(name)
            && Games.names().contains(name);
    String levelName = isGame ? Games.create(name).defaultLevel() : name;
    load(flag, levelName);
    return levelName;
  }

  /**
   * Returns the settings of the rooms.
   *
   * @throws carom.options.BadFlag when they don't fit together
   */
  List<RoomConfig> rooms(ServerConfig config) {
    List<RoomConfig> rooms = roomsWithoutInfo(config);
    Map<String, Map<String, String>> metadata = new LinkedHashMap<>();
    rooms.forEach(room -> metadata.put(room.name(), new LinkedHashMap<>()));
    try {
      flags.get(ServerConfig.ROOM_INFO).forEach(info -> RoomFlag.readInfo(info, metadata));
      return rooms.stream().map(room -> room.withMetadata(metadata.get(room.name()))).toList();
    } catch (IllegalArgumentException e) {
      throw flags.bad(e.getMessage());
    }
  }

  private List<RoomConfig> roomsWithoutInfo(ServerConfig config) {
    if (named.isEmpty()) {
      List<String> levels =
          !rotation.isEmpty() ? rotation : List.of(levelName.isEmpty() ? level.name() : levelName);
      return RoomConfig.equalRooms(config, levels);
    }
    List<RoomConfig> rooms = new ArrayList<>();
    for (RoomFlag room : named) {
      rooms.add(
          new RoomConfig(
              room.name(),
              "",
              room.levels(),
              room.places() == 0 ? config.get(ServerConfig.MAX_PLAYERS) : room.places(),
              config.get(ServerConfig.SEED) + rooms.size(),
              Map.of()));
    }
    return List.copyOf(rooms);
  }

  /** Returns where the rooms find their games and levels. */
  MatchLibrary library() {
    return flags.get(ServerConfig.SCENE) == null
        ? MatchLibrary.in(flags.dataFolder(), MatchLibrary.INSTALLED)
        : new HandedInMatch(this::newGame, level);
  }

  /** Returns the name of the game of the first room's first level. */
  String gameName() {
    return gameName;
  }

  /** Returns a new instance of that game. */
  Game newGame() {
    return Games.create(gameName);
  }

  /**
   * Returns the level for the warm-up. A large level would take longer to build and step than the
   * warm-up may last, so the default level of the game replaces it.
   */
  Level warmUpLevel() {
    if (level.bodies().size() <= MAX_WARM_UP_BODIES || flags.get(ServerConfig.SCENE) != null) {
      return level;
    }
    try {
      return Level.builtIn(newGame().defaultLevel());
    } catch (LevelException e) {
      throw new IllegalStateException(e); // a built-in level can always be read
    }
  }

  /** Returns the scene of {@code --scene}. A scene runs at its own tick rate only. */
  private Scene chooseScene() {
    String scene = flags.get(ServerConfig.SCENE);
    if (flags.get(ServerConfig.GAME) != null || flags.get(ServerConfig.LEVEL) != null) {
      throw flags.bad(
          "--scene and %s exclude each other: a scene is a world of its own"
              .formatted(flags.get(ServerConfig.GAME) != null ? "--game" : "--level"));
    }
    if (!Scenes.names().contains(scene)) {
      throw flags.bad(
          "--scene: unknown scene=%s%s; carom-client --scene list shows all"
              .formatted(scene, Suggestion.didYouMean(scene, Scenes.names())));
    }
    Scene chosen = Scenes.get(scene);
    if (flags.get(ServerConfig.TICK_RATE) != chosen.tickRate()) {
      throw flags.bad(
          String.format(
              Locale.ROOT,
              "--tick-rate=%d doesn't fit --scene=%s, which runs at %d Hz",
              flags.get(ServerConfig.TICK_RATE),
              scene,
              chosen.tickRate()));
    }
    return chosen;
  }

  /** Returns the file or name of the first level of the first room. */
  private String chooseLevelName() {
    if (!named.isEmpty()) {
      return named.get(0).levels().get(0);
    }
    if (!rotation.isEmpty()) {
      return rotation.get(0);
    }
    return flags.get(ServerConfig.LEVEL) != null
        ? flags.get(ServerConfig.LEVEL)
        : createGame(
                flags.get(ServerConfig.GAME) == null ? DEFAULT_GAME : flags.get(ServerConfig.GAME))
            .defaultLevel();
  }

  private Level load(String flag, String wanted) {
    try {
      Path file = path(flag, wanted);
      boolean isBuiltIn = MatchLibrary.builtInLevels().contains(wanted);
      if (isBuiltIn ? Files.isRegularFile(file) : Files.exists(file)) { // no folder of that name
        return TiledImport.load(file);
      }
      if (isBuiltIn) {
        return Level.builtIn(wanted);
      }
      if (wanted.startsWith(UploadedLevel.PREFIX) && flags.get(ServerConfig.UPLOADS)) {
        return Uploads.level(flags.dataFolder().uploads(), wanted);
      }
    } catch (LevelException e) {
      throw flags.bad(flag + ": " + e.getMessage());
    }
    String ofPlayers =
        wanted.startsWith(UploadedLevel.PREFIX) ? "; levels of players need --uploads" : "";
    throw flags.bad(
        "%s: there is no file level=%s, and the levels that come with the program are %s%s"
            .formatted(flag, wanted, String.join(", ", MatchLibrary.builtInLevels()), ofPlayers));
  }

  private Path path(String flag, String name) {
    try {
      return Path.of(flags.dataFolder().level(name));
    } catch (InvalidPathException e) {
      throw flags.bad(flag + ": level=" + name + " can't be the name of a file or level");
    }
  }

  private Game chooseGame() {
    Game chosen =
        createGame(
            flags.get(ServerConfig.GAME) == null ? level.gameName() : flags.get(ServerConfig.GAME));
    if (!chosen.name().equals(level.gameName())) {
      throw flags.bad(
          ("--game=%s doesn't fit level %s, which is made for game %s; "
                  + "leave --game out or choose another level")
              .formatted(chosen.name(), level.name(), level.gameName()));
    }
    return chosen;
  }

  private Game createGame(String wanted) {
    try {
      return Games.create(wanted);
    } catch (IllegalArgumentException e) {
      throw flags.bad("--game: " + e.getMessage());
    }
  }
}
