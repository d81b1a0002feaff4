package carom.game;

import carom.sim.Game;
import carom.sim.level.Suggestion;
import carom.sim.scene.SceneGame;
import carom.sim.scene.Scenes;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Iterator;
import java.util.List;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;

/**
 * Finds games by name. A game is listed by naming its class in {@code
 * META-INF/services/carom.sim.Game} of any jar on the class path, on which the installed programs
 * have the folder {@code games}; it needs a public constructor without parameters. One that can't
 * be loaded is passed over, and told when an unknown one is asked for. {@code scene:NAME} is the
 * scene of that name, to be watched.
 */
public final class Games {
  /** The game a server starts unless told otherwise. */
  public static final String DEFAULT = "arena";

  /** A jar that can't be read at all may fail at every question. */
  private static final int MAX_ERRORS = 100;

  private Games() {}

  /**
   * A new instance, for one simulation.
   *
   * @throws IllegalArgumentException when there is no such game; the message lists those there are
   */
  public static Game create(String name) {
    if (name.startsWith(SceneGame.PREFIX)) {
      return new SceneGame(Scenes.get(name.substring(SceneGame.PREFIX.length())));
    }
    List<String> names = new ArrayList<>();
    StringBuilder broken = new StringBuilder();
    for (Game game : all(broken)) {
      if (game.name().equals(name)) {
        return game;
      }
      names.add(game.name());
    }
    Collections.sort(names);
    throw new IllegalArgumentException(
        "game=\""
            + name
            + "\" is unknown, known are "
            + names
            + Suggestion.didYouMean(name, names)
            + broken);
  }

  /** The names of all games, sorted. */
  public static List<String> names() {
    List<String> names = new ArrayList<>();
    all(new StringBuilder()).forEach(game -> names.add(game.name()));
    Collections.sort(names);
    return names;
  }

  /**
   * New instances of all games that can be loaded; a jar with a broken one mustn't keep the others
   * from being played.
   *
   * @param broken receives what is wrong with the others
   */
  private static List<Game> all(StringBuilder broken) {
    List<Game> games = new ArrayList<>();
    Iterator<Game> found = ServiceLoader.load(Game.class, Games.class.getClassLoader()).iterator();
    for (int errors = 0; errors <= MAX_ERRORS; ) {
      try {
        if (!found.hasNext()) {
          break;
        }
        games.add(found.next());
      } catch (ServiceConfigurationError | LinkageError e) {
        errors++;
        broken.append("; a game can't be loaded: ").append(reason(e));
      }
    }
    return games;
  }

  /** What a game's own constructor threw tells more than that it threw. */
  private static String reason(Error e) {
    Throwable cause = e.getCause();
    return cause == null ? e.toString() : e.getMessage() + ": " + cause;
  }
}
