package carom.server.match;

import carom.game.Games;
import carom.server.config.DataFolder;
import carom.server.session.LoadedLevel;
import carom.sim.Game;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.text.Suggestion;
import carom.tiled.TiledImport;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** Finds games and levels by name, for rooms that begin a match. Any thread may ask. */
public interface MatchLibrary {
  /** The games on the class path; level files, and levels that come with the program. */
  MatchLibrary INSTALLED =
      new MatchLibrary() {
        @Override
        public Game game(String name) {
          return Games.create(name);
        }

        @Override
        public LoadedLevel level(String name) throws LevelException {
          return new LoadedLevel(find(name));
        }
      };

  /**
   * Returns a new instance of a game.
   *
   * @throws IllegalArgumentException when there is no such game; the message lists the known ones
   */
  Game game(String name);

  /**
   * Returns a level.
   *
   * @param name a file, or the name or title of a level that comes with the program
   * @throws LevelException when there is none, or when it can't be used
   */
  LoadedLevel level(String name) throws LevelException;

  /** Returns whether a level that was there has been removed. */
  default boolean isGone(String name) {
    return false;
  }

  /**
   * Returns the names of the levels that come with the program: those of games, and others. A game
   * whose level is a file of its own, or isn't there, adds none.
   */
  static List<String> builtInLevels() {
    return Stream.concat(
            Games.names().stream().map(name -> Games.create(name).defaultLevel()),
            Stream.of(
                "commons", "harbour", "lagoon", "orbit", "quarry", "rink", "ruins", "sluice",
                "towers"))
        .distinct()
        .filter(Level::isBuiltIn)
        .toList();
  }

  /**
   * Returns a library that finds levels in the data folder before it asks another.
   *
   * @param otherwise finds games, and levels that aren't there
   */
  static MatchLibrary in(DataFolder data, MatchLibrary otherwise) {
    return new MatchLibrary() {
      @Override
      public Game game(String name) {
        return otherwise.game(name);
      }

      @Override
      public LoadedLevel level(String name) throws LevelException {
        return otherwise.level(data.level(name));
      }

      @Override
      public boolean isGone(String name) {
        return otherwise.isGone(name);
      }
    };
  }

  /**
   * Returns a library that has a level that is in no file, by its title.
   *
   * @param otherwise finds games, and all other levels
   */
  static MatchLibrary with(Level level, MatchLibrary otherwise) {
    return new MatchLibrary() {
      @Override
      public Game game(String name) {
        return otherwise.game(name);
      }

      @Override
      public LoadedLevel level(String name) throws LevelException {
        return name.equals(level.name()) ? new LoadedLevel(level) : otherwise.level(name);
      }
    };
  }

  /**
   * Returns a library that tells whenever it gives a game.
   *
   * @param gives runs before, on the thread that asks
   */
  static MatchLibrary heard(MatchLibrary library, Runnable gives) {
    return new MatchLibrary() {
      @Override
      public Game game(String name) {
        gives.run();
        return library.game(name);
      }

      @Override
      public LoadedLevel level(String name) throws LevelException {
        return library.level(name);
      }

      @Override
      public boolean isGone(String name) {
        return library.isGone(name);
      }
    };
  }

  private static Level find(String name) throws LevelException {
    try {
      Path file = Path.of(name);
      if (Files.isRegularFile(file)) {
        return TiledImport.load(file);
      }
    } catch (InvalidPathException e) {
      throw new LevelException(name, 0, 0, "", "this can't be the name of a file or level");
    }
    Level builtIn = builtInLevel(name);
    if (builtIn != null) {
      return builtIn;
    }
    List<String> known = builtInLevels();
    throw new LevelException(
        name,
        0,
        0,
        "",
        "there is no such file or level; levels here are %s%s"
            .formatted(String.join(", ", known), Suggestion.didYouMean(name, known)));
  }

  /** Returns the level that comes with the program under a name or title, or null. */
  private static Level builtInLevel(String name) throws LevelException {
    if (Level.isBuiltIn(name)) {
      return Level.builtIn(name);
    }
    for (String other : builtInLevels()) {
      Level level = Level.builtIn(other);
      if (asTyped(level.name()).equals(asTyped(name))) {
        return level;
      }
    }
    return null;
  }

  /** Returns whether a text names a level that comes with the program, and no file that is here. */
  static boolean isBuiltInLevel(String name) {
    try {
      return !Files.exists(Path.of(name)) && builtInLevel(name) != null;
    } catch (LevelException | InvalidPathException e) {
      return false;
    }
  }

  /** Returns a level's title without what people leave out when they type it. */
  private static String asTyped(String title) {
    return title.toLowerCase(Locale.ROOT).replaceAll("[\\s_-]+", "");
  }
}
