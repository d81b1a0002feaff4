package carom.server.match;

import carom.server.session.LoadedLevel;
import carom.sim.Game;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.util.function.Supplier;

/** The installed games and levels, and the game and level that a caller hands in. */
public final class HandedInMatch implements MatchLibrary {
  private final Supplier<Game> games;
  private final LoadedLevel level;
  private Game next;

  /**
   * Creates a library.
   *
   * @param games creates a game
   * @param level its level, found under its name
   */
  public HandedInMatch(Supplier<Game> games, Level level) {
    this.games = games;
    this.level = new LoadedLevel(level);
  }

  @Override
  public synchronized Game game(String name) {
    Game game = next == null ? games.get() : next;
    next = game.name().equals(name) ? null : game;
    return next == null ? game : INSTALLED.game(name);
  }

  @Override
  public LoadedLevel level(String name) throws LevelException {
    return name.equals(level.level().name()) ? level : INSTALLED.level(name);
  }
}
