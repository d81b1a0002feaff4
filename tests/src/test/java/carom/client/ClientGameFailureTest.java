package carom.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.client.link.ConnectionPhase;
import carom.client.view.ClientView;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.sim.Game;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/**
 * Goal: a game that throws at the client ends no client with a stack trace. Method: for each
 * callback of {@link Game} the arena, whose callback throws at the client alone, from the start or
 * in mid-game; throwables of all kinds take turns.
 */
final class ClientGameFailureTest {
  /** Callbacks that a client certainly calls while it joins, and while it plays. */
  private static final Set<String> AT_JOIN = Set.of("world", "fields", "rules", "clock", "setUp");

  private static final Set<String> IN_PLAY = Set.of("input", "forces", "collision", "hit");

  private boolean atClient;
  private String failing = "";
  private int kind;
  private boolean thrown;
  private Games.Loan loan;

  /** Callbacks have names of their own, so that a name says which one throws. */
  private static Stream<String> callbacks() {
    return Arrays.stream(Game.class.getMethods())
        .map(Method::getName)
        .filter(name -> !name.equals("name"))
        .distinct()
        .sorted();
  }

  @TestFactory
  Stream<DynamicTest> aCallbackThatAlwaysThrows() {
    return callbacks().map(name -> DynamicTest.dynamicTest(name, () -> always(name)));
  }

  @TestFactory
  Stream<DynamicTest> aCallbackThatThrowsInMidGame() {
    return callbacks().map(name -> DynamicTest.dynamicTest(name, () -> midGame(name)));
  }

  private void always(String callback) {
    try (Stepper stepper = stepper()) {
      fail(callback);
      SimulatedClient client = stepper.add("Ann", Impairment.NONE, new Bot(Stepper.SEED));
      ClientView view = client.view();
      run(
          stepper,
          5,
          () ->
              view.phase() == ConnectionPhase.ENDED
                  || (view.own() != null && thrown && view.predictedWorld() == null));
      if (AT_JOIN.contains(callback)) {
        assertEquals(ConnectionPhase.ENDED, view.phase(), callback);
        says(view.message(), callback, view);
        return;
      }
      assertEquals(ConnectionPhase.PLAYING, view.phase(), view::message);
      goesOn(stepper, client, callback);
    } finally {
      end();
    }
  }

  private void midGame(String callback) {
    try (Stepper stepper = stepper()) {
      SimulatedClient client = stepper.join("Ann", Impairment.NONE, new Bot(Stepper.SEED));
      fail(callback);
      run(stepper, IN_PLAY.contains(callback) ? 60 : 1, () -> thrown);
      assertEquals(IN_PLAY.contains(callback), thrown, callback + " at the client");
      goesOn(stepper, client, callback);
    } finally {
      end();
    }
  }

  /** Requires that the client plays, without prediction if the callback threw, and says why. */
  private void goesOn(Stepper stepper, SimulatedClient client, String callback) {
    ClientView view = client.view();
    if (thrown) {
      assertNull(view.predictedWorld(), callback);
      assertEquals(1, told(view).size(), () -> told(view).toString());
      says(told(view).get(0), callback, view);
    }
    run(stepper, 1, () -> false);
    float[] from = {view.own().x(), view.own().y()};
    run(
        stepper,
        20,
        () ->
            view.own() != null
                && Math.hypot(view.own().x() - from[0], view.own().y() - from[1]) > 1);
    assertTrue(
        Math.hypot(view.own().x() - from[0], view.own().y() - from[1]) > 1,
        "the own body moves with the player's input");
    assertEquals(ConnectionPhase.PLAYING, view.phase(), view::message);
    assertTrue(told(view).size() <= 1, () -> "told once: " + told(view));
  }

  private static List<String> told(ClientView view) {
    return view.notices().stream()
        .map(ClientView.Notice::text)
        .filter(text -> text.contains("failed"))
        .toList();
  }

  private static void says(String text, String callback, ClientView view) {
    for (String part :
        List.of(
            callback,
            " at tick ",
            " player " + Math.max(0, view.playerId()),
            "broken on purpose",
            ClientGameFailureTest.class.getName() + ".invoke:")) {
      assertTrue(text.contains(part), () -> "lacks \"" + part + "\": " + text);
    }
  }

  // ---- the game

  private Stepper stepper() {
    Supplier<Game> real = Games.supplier("arena");
    loan = Games.lend(() -> failingGame(real.get()));
    return Stepper.of("arena");
  }

  private void fail(String callback) {
    failing = callback;
    kind++;
  }

  private Game failingGame(Game real) {
    return (Game)
        Proxy.newProxyInstance(
            Game.class.getClassLoader(),
            new Class<?>[] {Game.class},
            (proxy, method, args) -> invoke(real, method, args));
  }

  private Object invoke(Game real, Method method, Object[] args) throws Throwable {
    if (atClient && method.getName().equals(failing)) {
      thrown = true;
      String text = "broken on purpose";
      switch (kind % 4) {
        case 0 -> throw new IllegalStateException(text);
        case 1 -> throw new AssertionError(text);
        case 2 -> throw new StackOverflowError(text);
        default -> throw new NoSuchFieldError(text);
      }
    }
    try {
      return method.invoke(real, args);
    } catch (InvocationTargetException e) {
      throw e.getCause();
    }
  }

  /** Runs until something is so, at most for a time; the game knows in whose hands it is. */
  private void run(Stepper stepper, double seconds, BooleanSupplier until) {
    long end = stepper.nowNs() + (long) (seconds * 1e9);
    while (stepper.nowNs() < end && !until.getAsBoolean()) {
      stepper.stepTimeAndServer();
      atClient = true;
      stepper.stepClients();
      atClient = false;
    }
  }

  private void end() {
    failing = "";
    thrown = false;
    atClient = false;
    loan.close();
  }
}
