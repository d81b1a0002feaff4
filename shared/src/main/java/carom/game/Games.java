package carom.game;

import carom.sim.Game;
import carom.sim.scene.SceneGame;
import carom.sim.scene.Scenes;
import carom.text.Suggestion;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Supplier;

/**
 * Finds games by name. A game is a class with a public constructor without parameters whose name is
 * listed in {@code META-INF/services/carom.sim.Game} of a jar on the class path. The class path of
 * the installed programs includes the jars in the folder {@code games}. A game that cannot be
 * loaded is skipped, and reported when an unknown game is asked for. {@code scene:NAME} is the
 * scene of that name as a game to watch.
 */
public final class Games {
  /** Name of the game that a server starts by default. */
  public static final String DEFAULT = "arena";

  /** Games that the program itself brings; replaced as a whole. */
  private static volatile List<Supplier<Game>> added = List.of();

  private Games() {}

  /**
   * Adds a game that needs no entry in a file of services: the game of a program that embeds Carom,
   * or of a test. It replaces one of the same name that was added before, and holds for all servers
   * and clients of the process.
   *
   * @param game makes a new instance for each simulation
   */
  public static synchronized void add(Supplier<Game> game) {
    String name = game.get().name();
    List<Supplier<Game>> all = new ArrayList<>(added);
    all.removeIf(known -> known.get().name().equals(name));
    all.add(game);
    added = List.copyOf(all);
  }

  /** A game that was lent to the process; {@link #close} takes it back. */
  public interface Loan extends AutoCloseable {
    @Override
    void close();
  }

  /**
   * Adds a game in the place of the one of the same name until the loan is closed, as for a test
   * that watches a game.
   *
   * @param game makes a new instance for each simulation
   */
  public static synchronized Loan lend(Supplier<Game> game) {
    List<Supplier<Game>> before = added;
    add(game);
    return () -> {
      synchronized (Games.class) {
        added = before;
      }
    };
  }

  /**
   * Returns what makes new instances of a game, whatever is added in its place later.
   *
   * @throws IllegalArgumentException as for {@link #create}
   */
  public static Supplier<Game> supplier(String name) {
    for (Supplier<Game> known : added) {
      if (known.get().name().equals(name)) {
        return known;
      }
    }
    Class<? extends Game> type = create(name).getClass();
    return () -> {
      try {
        return type.getConstructor().newInstance();
      } catch (ReflectiveOperationException e) {
        throw new IllegalStateException("game " + name + " can't be created", e);
      }
    };
  }

  /**
   * Returns a new instance, for one simulation.
   *
   * @throws IllegalArgumentException when there is no such game; the message lists the known ones
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
            + broken
            + GameJars.complaint());
  }

  /** Returns the names of all games, sorted. */
  public static List<String> names() {
    List<String> names = new ArrayList<>();
    all(new StringBuilder()).forEach(game -> names.add(game.name()));
    Collections.sort(names);
    return names;
  }

  /**
   * Returns new instances of all games that can be loaded. A broken game does not keep the others
   * from being played.
   *
   * @param broken receives what is wrong with the broken ones
   */
  private static List<Game> all(StringBuilder broken) {
    List<Game> games = new ArrayList<>();
    added.forEach(game -> games.add(game.get()));
    games.addAll(
        JarServices.all(
            Game.class, e -> broken.append("; a game can't be loaded: ").append(reason(e))));
    return games;
  }

  /**
   * Returns the message of an error, with its cause: an exception from a game's own constructor
   * says most.
   */
  private static String reason(Error e) {
    Throwable cause = e.getCause();
    return cause == null
        ? e + GameFault.remedy(e)
        : e.getMessage() + ": " + cause + GameFault.remedy(cause);
  }
}
