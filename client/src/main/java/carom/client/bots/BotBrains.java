package carom.client.bots;

import carom.game.GameJars;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Finds the {@linkplain BotBrain brains} of games. A brain that can't be loaded is logged and left
 * out, so that it keeps no game from being played. Any thread may use it.
 */
public final class BotBrains {
  private static final Logger LOG = LoggerFactory.getLogger(BotBrains.class);

  /** Most errors before the search ends. A jar that cannot be read may fail at every question. */
  private static final int MAX_ERRORS = 100;

  /** Brains that the program itself brings. */
  private static final Map<String, Supplier<BotBrain>> ADDED = new ConcurrentHashMap<>();

  private static final Map<String, Found> FOUND = new ConcurrentHashMap<>();

  /** The brain that was found in some jars, if they have one. */
  private record Found(ClassLoader jars, Optional<Supplier<BotBrain>> brain) {}

  private BotBrains() {}

  /**
   * Adds a brain that needs no entry in a file of services: that of a program that embeds Carom, or
   * of a test. It replaces another one for its game.
   *
   * @param brain makes a new instance for each bot
   */
  public static void add(Supplier<BotBrain> brain) {
    ADDED.put(brain.get().game(), brain);
  }

  /** Forgets the brain that was added or found for a game; it is looked for again when needed. */
  public static void remove(String game) {
    ADDED.remove(game);
    FOUND.remove(game);
  }

  /** Returns a new instance of the brain for a game, or null if the game has none. */
  public static BotBrain create(String game) {
    Supplier<BotBrain> added = ADDED.get(game);
    if (added != null) {
      return added.get();
    }
    ClassLoader jars = GameJars.loader();
    Found found =
        FOUND.compute(
            game, (g, old) -> old != null && old.jars == jars ? old : new Found(jars, find(g)));
    return found.brain.map(Supplier::get).orElse(null);
  }

  /** Returns a new instance of Carom's own brain for one of its games, or null. */
  static BotBrain shipped(String game) {
    return switch (game) {
      case "arena" -> new ArenaBrain(null);
      case "platformer" -> new PlatformerBrain(null);
      default -> null;
    };
  }

  private static Optional<Supplier<BotBrain>> find(String game) {
    Iterator<ServiceLoader.Provider<BotBrain>> all =
        ServiceLoader.load(BotBrain.class, GameJars.loader()).stream().iterator();
    for (int errors = 0; errors <= MAX_ERRORS; ) {
      try {
        if (!all.hasNext()) {
          break;
        }
        ServiceLoader.Provider<BotBrain> provider = all.next();
        if (provider.get().game().equals(game)) {
          return Optional.of(provider);
        }
      } catch (ServiceConfigurationError | LinkageError e) {
        errors++;
        LOG.warn("a bot brain can't be loaded, so bots of its game try all keys", e);
      }
    }
    return Optional.empty();
  }
}
