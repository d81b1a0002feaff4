package carom.server;

import carom.game.Games;
import carom.sim.Game;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneGame;
import carom.sim.scene.catalog.Scenes;
import carom.values.Suggestion;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** Holds what {@code --game}, {@code --level} and {@code --scene} choose: a game and its level. */
final class GameChoice {
  private static final String DEFAULT_GAME = "arena";

  /**
   * Most bodies of a level that the warm-up plays. For a larger level it plays the default level of
   * the game.
   */
  private static final int MAX_WARM_UP_BODIES = 1_000;

  private final ServerFlags flags;
  private final Level level;
  private final String gameName;

  /**
   * Reads the flags and loads the level.
   *
   * @throws carom.options.BadFlag when a flag names an unknown game, level or scene, or when the
   *     flags don't fit together
   */
  GameChoice(ServerFlags flags) {
    this.flags = flags;
    level = flags.scene == null ? chooseLevel() : SceneGame.level(chooseScene());
    gameName = chooseGame().name();
  }

  /** Returns the level. */
  Level level() {
    return level;
  }

  /** Returns the name of the game. */
  String gameName() {
    return gameName;
  }

  /** Returns a new instance of the game. */
  Game newGame() {
    return Games.create(gameName);
  }

  /**
   * Returns the level for the warm-up. A large level would take longer to build and step than the
   * warm-up may last, so the default level of the game replaces it.
   */
  Level warmUpLevel() {
    if (level.bodies().size() <= MAX_WARM_UP_BODIES || flags.scene != null) {
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
    String scene = flags.scene;
    if (flags.game != null || flags.level != null) {
      throw flags.bad(
          "--scene and %s exclude each other: a scene is a world of its own"
              .formatted(flags.game != null ? "--game" : "--level"));
    }
    if (!Scenes.names().contains(scene)) {
      throw flags.bad(
          "--scene: unknown scene=%s%s; carom-client --scene list shows all"
              .formatted(scene, Suggestion.didYouMean(scene, Scenes.names())));
    }
    Scene chosen = Scenes.get(scene);
    if (flags.tickRate != chosen.tickRate()) {
      throw flags.bad(
          "--tick-rate=%d doesn't fit --scene=%s, which runs at %d Hz"
              .formatted(flags.tickRate, scene, chosen.tickRate()));
    }
    return chosen;
  }

  private Level chooseLevel() {
    String wanted = flags.level;
    try {
      if (wanted == null) {
        String game = flags.game == null ? DEFAULT_GAME : flags.game;
        return Level.builtIn(createGame(game).defaultLevel());
      }
      Path file = Path.of(wanted);
      if (Files.exists(file)) {
        return Level.load(file);
      }
      if (builtInLevels().contains(wanted)) {
        return Level.builtIn(wanted);
      }
    } catch (LevelException | InvalidPathException e) {
      throw flags.bad("--level: " + e.getMessage());
    }
    throw flags.bad(
        "--level=%s: there is no such file, and the levels that come with the program are %s"
            .formatted(wanted, String.join(", ", builtInLevels())));
  }

  private static List<String> builtInLevels() {
    return Stream.concat(
            Games.names().stream().map(name -> Games.create(name).defaultLevel()),
            Stream.of("commons", "lagoon"))
        .toList();
  }

  private Game chooseGame() {
    Game chosen = createGame(flags.game == null ? level.gameName() : flags.game);
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
