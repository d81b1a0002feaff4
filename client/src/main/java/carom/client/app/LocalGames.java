package carom.client.app;

import carom.net.transport.ClientTransport;
import carom.sim.level.Level;
import java.util.List;
import java.util.ServiceLoader;

/**
 * Starts games on this machine, for a client that has no server. The client knows no server: {@link
 * ServiceLoader} finds the implementation that {@code META-INF/services} names, if this build has
 * one.
 */
public interface LocalGames {
  /**
   * The level, the number of bots and the openness of a game to be played.
   *
   * @param level name of the level
   * @param bots players that the machine plays, 0..{@link #MAX_BOTS}
   * @param open whether others may join, over the network
   */
  record GameChoice(String level, int bots, boolean open) {}

  /** A game that runs, with its server in this process. */
  interface LocalGame extends AutoCloseable {
    /** Returns a transport whose links all lead to the server, for any address. */
    ClientTransport transport();

    /** Returns how others can join, in words for the player; empty if they can't. */
    String invitation();

    /** Stops the bots and the server. */
    @Override
    void close();
  }

  /** Most bots of a local game. */
  int MAX_BOTS = 20;

  /** Returns the names of the levels, the usual one first. */
  List<String> levels();

  /**
   * Returns a level.
   *
   * @param name one of {@link #levels}, or a file
   * @throws IllegalStateException in words for the player, when there is none
   */
  Level level(String name);

  /**
   * Starts a server with a game.
   *
   * @throws IllegalStateException in words for the player, when it can't be started
   */
  LocalGame start(GameChoice choice);

  /**
   * Starts a server with a level that is in no file, such as one that is edited.
   *
   * @param bots players that the machine plays, 0..{@link #MAX_BOTS}
   * @throws IllegalStateException in words for the player, when it can't be started
   */
  LocalGame start(Level level, int bots);

  /**
   * Returns what is legal in a level and surely not meant, as {@code carom level check} says it.
   */
  List<String> warnings(Level level);

  /** Returns the implementation of this build, or null. */
  static LocalGames find() {
    for (LocalGames games : ServiceLoader.load(LocalGames.class)) {
      return games;
    }
    return null;
  }
}
