package carom.server.room;

import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.LoadedLevel;
import carom.server.match.MatchLibrary;
import carom.server.match.SavedMatch;
import carom.server.metrics.Counters;
import carom.sim.Game;
import carom.sim.level.LevelException;
import carom.sim.match.NextMatch;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Builds the matches of a room: finds game and level, builds the world and sets the game up. That
 * takes a large level many ticks, so that any thread may do it while the room plays.
 */
final class MatchLoader {
  /** From match to match the seed grows by the most rooms, so that no two matches share one. */
  private static final int SEED_STEP = 64;

  private final ServerConfig config;
  private final RoomConfig room;
  private final MatchLibrary library;
  private final String label;
  private final Counters counters;
  private final AtomicInteger built = new AtomicInteger();

  /** Says in one line why a match can't be played. */
  static final class Unplayable extends Exception {
    private static final long serialVersionUID = 1;

    Unplayable(String why, Throwable cause) {
      super(why, cause);
    }
  }

  /**
   * Creates a loader that has built no match.
   *
   * @param label begins each log line
   */
  MatchLoader(
      ServerConfig config, RoomConfig room, MatchLibrary library, String label, Counters counters) {
    this.config = config;
    this.room = room;
    this.library = library;
    this.label = label;
    this.counters = counters;
  }

  /** Returns the match that the room begins with. */
  Match first() throws Unplayable {
    String level = room.levels().isEmpty() ? "" : room.levels().get(0);
    return load(new NextMatch(room.game(), level, false, false));
  }

  /**
   * Builds a match.
   *
   * @param wanted names a game, a level or both
   * @throws Unplayable when the game or level isn't there, or the game can't be played in it
   */
  Match load(NextMatch wanted) throws Unplayable {
    try {
      Game game = wanted.game().isEmpty() ? null : library.game(wanted.game());
      String levelName = wanted.level().isEmpty() ? game.defaultLevel() : wanted.level();
      LoadedLevel level = library.level(levelName);
      String madeFor = level.level().gameName();
      if (game == null) {
        game = library.game(madeFor);
      } else if (!game.name().equals(madeFor)) {
        throw new IllegalArgumentException(
            "game=%s doesn't fit level=%s, which is made for game=%s"
                .formatted(game.name(), levelName, madeFor));
      }
      return match(game, level, 0);
    } catch (LevelException e) {
      throw new Unplayable(e.getMessage(), null); // which says all
    } catch (IllegalArgumentException e) {
      throw new Unplayable(e.getMessage(), e);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      throw new Unplayable("the set-up failed: " + e, e);
    }
  }

  /**
   * Builds a match in a saved state.
   *
   * @throws Unplayable when the game isn't there, or the state doesn't fit it
   */
  Match load(SavedMatch saved) throws Unplayable {
    try {
      Match match = match(library.game(saved.game()), saved.level(), saved.seed());
      saved.restore(match.simulation());
      return match;
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      throw new Unplayable(e.getMessage(), e);
    }
  }

  /** Builds a match; a seed of 0 is the next one. */
  private Match match(Game game, LoadedLevel level, long seed) {
    int number = built.incrementAndGet();
    long next = room.seed() + (long) SEED_STEP * (number - 1);
    long chosen = seed == 0 ? next : seed;
    return new Match(room.name(), number, game, level, chosen, config, label, counters);
  }
}
