package carom.testkit;

import carom.game.GameFault;
import carom.sim.Game;
import carom.sim.Rules;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Passes all calls of a game on, and remembers what the game threw. One thread. */
final class GameWatch implements InvocationHandler {
  private final Game game;
  private final Map<String, Integer> failures;

  private GameWatch(Game game, Map<String, Integer> failures) {
    this.game = game;
    this.failures = failures;
  }

  /**
   * Returns makers of watched games.
   *
   * @param failures receives each failure in words, and how often it happened
   */
  static Supplier<Game> over(Supplier<Game> games, Map<String, Integer> failures) {
    // A proxy, so that callbacks that Game gains are passed on, too.
    return () ->
        (Game)
            Proxy.newProxyInstance(
                Game.class.getClassLoader(),
                new Class<?>[] {Game.class},
                new GameWatch(games.get(), failures));
  }

  /** Returns an empty list of failures, in the order in which they are found. */
  static Map<String, Integer> failures() {
    return new LinkedHashMap<>();
  }

  @Override
  @SuppressWarnings("unchecked") // of all that a game returns, only its rules are consumers
  public Object invoke(Object proxy, Method method, Object[] args) throws Throwable {
    try {
      Object answer = method.invoke(game, args);
      return answer instanceof Consumer<?> rules ? watched((Consumer<Rules>) rules) : answer;
    } catch (InvocationTargetException e) {
      noteFailure(method.getName(), e.getCause());
      throw e.getCause();
    }
  }

  /** Returns rules whose failures are noted, too: they run after the call that returned them. */
  private Consumer<Rules> watched(Consumer<Rules> rules) {
    return r -> {
      try {
        rules.accept(r);
      } catch (RuntimeException | Error e) {
        noteFailure("rules", e);
        throw e;
      }
    };
  }

  private void noteFailure(String callback, Throwable failure) {
    failures.merge(words(callback, failure), 1, Integer::sum);
  }

  /** Returns the callback, the exception and the line of the game's own code. */
  private String words(String callback, Throwable failure) {
    String where = "";
    GameCode code = new GameCode(game.getClass());
    for (StackTraceElement line : failure.getStackTrace()) {
      if (code.isOfGame(line.getClassName())) {
        where = " at " + line.getFileName() + ":" + line.getLineNumber();
        break;
      }
    }
    return callback + " throws " + failure + where + GameFault.remedy(failure);
  }
}
