package carom.game;

import carom.sim.Game;
import carom.sim.Suggestion;
import carom.sim.scene.SceneGame;
import carom.sim.scene.Scenes;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.ServiceLoader;

/**
 * Finds games by name. A game is listed by naming its class in {@code
 * META-INF/services/carom.sim.Game} of any jar on the class path; it needs a public constructor
 * without parameters. {@code scene:NAME} is the scene of that name, to be watched.
 */
public final class Games {
  /** The game a server starts unless told otherwise. */
  public static final String DEFAULT = "arena";

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
    for (Game game : ServiceLoader.load(Game.class, Games.class.getClassLoader())) {
      if (game.name().equals(name)) {
        return game;
      }
    }
    List<String> names = names();
    throw new IllegalArgumentException(
        "game=\""
            + name
            + "\" is unknown, known are "
            + names
            + Suggestion.didYouMean(name, names));
  }

  /** The names of all games, sorted. */
  public static List<String> names() {
    List<String> names = new ArrayList<>();
    for (Game game : ServiceLoader.load(Game.class, Games.class.getClassLoader())) {
      names.add(game.name());
    }
    Collections.sort(names);
    return names;
  }
}
