package carom.server.match;

import carom.game.GameFault;
import carom.replay.RecordingHeader;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counters;
import carom.server.session.LoadedLevel;
import carom.sim.Game;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.outbox.NextMatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Builds the matches of a room: finds game and level, builds the world and sets the game up. That
 * takes a large level many ticks, so that any thread may do it while the room plays.
 */
public final class MatchLoader {
  /** Step of the seed from match to match: the most rooms, so that no two matches share a seed. */
  private static final int SEED_STEP = ServerConfig.MAX_ROOMS;

  private final Supplier<ServerConfig> config;
  private final RoomConfig room;
  private final MatchLibrary library;
  private final String label;
  private final Counters counters;
  private final AtomicInteger built = new AtomicInteger();
  private volatile long firstSeed;

  /** The match that {@link #prepare} has built and nobody has taken yet, or null. */
  private Match prepared;

  /** Says in one line why a match can't be played. */
  public static final class Unplayable extends Exception {
    private static final long serialVersionUID = 1;

    /**
     * Creates an exception.
     *
     * @param why one line for people
     * @param cause null if that line says all
     */
    public Unplayable(String why, Throwable cause) {
      super(why, cause);
    }
  }

  /**
   * Creates a loader that has built no match.
   *
   * @param label begins each log line
   */
  public MatchLoader(
      Supplier<ServerConfig> config,
      RoomConfig room,
      MatchLibrary library,
      String label,
      Counters counters) {
    this.config = config;
    this.room = room;
    this.library = library;
    this.label = label;
    this.counters = counters;
    firstSeed = room.seed();
  }

  /** Returns the match that the room begins with. */
  public Match first() throws Unplayable {
    String level = room.levels().isEmpty() ? "" : room.levels().get(0);
    return load(new NextMatch(room.game(), level, false, false));
  }

  /**
   * Builds a match.
   *
   * @param wanted names a game, a level or both
   * @throws Unplayable when the game or level isn't there, or the game can't be played in it
   */
  public Match load(NextMatch wanted) throws Unplayable {
    return load(wanted, game -> {});
  }

  /**
   * Builds a match as above.
   *
   * @param found hears the name of the game before it is created
   */
  public Match load(NextMatch wanted, Consumer<String> found) throws Unplayable {
    Game game = null;
    try {
      game = wanted.game().isEmpty() ? null : game(wanted.game());
      String levelName = wanted.level().isEmpty() ? game.defaultLevel() : wanted.level();
      LoadedLevel level = library.level(levelName);
      String madeFor = level.level().gameName();
      if (game == null) {
        found.accept(madeFor);
        game = game(madeFor);
      } else if (!game.name().equals(madeFor)) {
        throw new Unplayable(
            "game=%s doesn't fit level=%s, which is made for game=%s"
                .formatted(game.name(), levelName, madeFor),
            null);
      }
      return match(game, level, 0);
    } catch (LevelException e) {
      throw new Unplayable(e.getMessage(), null); // which says all
    } catch (IllegalArgumentException e) {
      throw new Unplayable(
          game == null ? e.getMessage() : GameFault.refusal(game.getClass(), e), e);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      throw new Unplayable("the set-up failed: " + GameFault.describe(e), e);
    }
  }

  private Game game(String name) throws Unplayable {
    try {
      return library.game(name);
    } catch (IllegalArgumentException e) {
      throw new Unplayable(e.getMessage(), null); // which says all
    }
  }

  /**
   * Builds a match in a saved state.
   *
   * @throws Unplayable when the game isn't there, or the state doesn't fit it
   */
  public Match load(SavedMatch saved) throws Unplayable {
    try {
      Match match = match(library.game(saved.game()), saved.level(), saved.seed());
      saved.restore(match.simulation());
      return match;
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      throw new Unplayable(e.getMessage(), e);
    }
  }

  /**
   * Builds a match of an earlier run of the room again, at tick 0.
   *
   * @param header names the game, and has the level and the seed
   * @param number the match's number in that run
   * @throws Unplayable when the game isn't there, or can't be played in the level
   */
  public Match again(RecordingHeader header, int number) throws Unplayable {
    Match ready = prepared;
    prepared = null;
    if (ready != null && ready.info().isThatOf(header, number)) {
      return ready;
    }
    try {
      LoadedLevel level = new LoadedLevel(Level.parse(header.levelName(), header.level()));
      return match(library.game(header.game()), level, number, header.seed());
    } catch (LevelException e) {
      throw new Unplayable(e.getMessage(), null);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      throw new Unplayable(e.getMessage(), e);
    }
  }

  /**
   * Builds a match as {@link #again} does, which returns this one when it is asked for it next.
   *
   * @param header as above
   * @param number as above
   * @throws Unplayable as above
   */
  public Match prepare(RecordingHeader header, int number) throws Unplayable {
    prepared = again(header, number);
    return prepared;
  }

  /** Returns whether a level of the rotation has been removed. */
  public boolean isGone(String level) {
    return library.isGone(level);
  }

  /** Returns the seed of the room's first match. */
  public long firstSeed() {
    return firstSeed;
  }

  /**
   * Goes on behind a match of an earlier run of the room.
   *
   * @param number the match's number
   * @param seed seed of that run's first match
   */
  public void goOn(int number, long seed) {
    built.set(number);
    firstSeed = seed;
  }

  /** Builds a match; a seed of 0 is the next one. */
  private Match match(Game game, LoadedLevel level, long seed) {
    int number = built.incrementAndGet();
    long next = firstSeed + (long) SEED_STEP * (number - 1);
    return match(game, level, number, seed == 0 ? next : seed);
  }

  private Match match(Game game, LoadedLevel level, int number, long seed) {
    return new Match(room.name(), number, game, level, seed, config, label, counters);
  }
}
