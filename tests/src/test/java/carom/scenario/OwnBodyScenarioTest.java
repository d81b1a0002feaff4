package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.fixtures.Levels;
import carom.server.config.ServerConfig;
import carom.server.session.InputBuffer;
import carom.sim.Journal;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import carom.testkit.Condition;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Goal: the client predicts its own body exactly and shows corrections of mispredictions smoothly.
 * Method: real client and server in virtual time, the client's own count of corrections.
 */
class OwnBodyScenarioTest {
  static Stream<Arguments> levelsAndConditions() {
    return Stream.of(Levels.emptyArena(), Levels.emptyPlatformer())
        .flatMap(level -> Stream.of(Condition.values()).map(c -> Arguments.of(level, c)));
  }

  @ParameterizedTest
  @MethodSource("levelsAndConditions")
  void aloneAmongStaticsEveryPredictionIsExact(Level level, Condition condition) {
    // Goal: not one correction, whatever the network, as long as the server got the inputs.
    // Method: a wanderer for twenty seconds; each tick for which the server took another input than
    // the player gave excuses one correction. What the server counts as missing is no excuse: it
    // learns that a held input was wrong when the right one arrives, and that may never be.
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      Map<Integer, Long> given = new HashMap<>();
      InputSource wander = Scripts.wander(Stepper.SEED);
      SimulatedClient client =
          stepper.join(
              "p",
              condition.impairment(Stepper.SEED),
              (view, tick, out) -> {
                wander.sample(view, tick, out);
                given.put(tick, out.pack());
              });
      HostPlayer player = stepper.room().simulation().player(client.view().playerId());
      WrongInputs wrong = new WrongInputs(given, player);
      stepper.room().simulation().addJournal(wrong);
      long before = client.stats().corrections();
      stepper.run(4);
      InputBuffer inputs = stepper.room().session(player.id()).inputs();
      final long missing = inputs.missing();
      final long compared = client.stats().compared();
      stepper.run(10);
      if (condition.hasBlackout()) {
        stepper.blackout(client, 1);
      }
      stepper.run(10);
      long corrected = client.stats().corrections() - before;
      String about =
          "corrections="
              + corrected
              + " wrong="
              + wrong.ticks
              + " "
              + level.name()
              + " "
              + condition;
      assertTrue(client.stats().compared() - compared > 300, about);
      assertTrue(corrected <= wrong.ticks, about);
      if (condition == Condition.CLEAN || condition == Condition.LATENCY_300) {
        assertEquals(0, inputs.missing() - missing, about);
        assertEquals(0, corrected, about);
      }
    }
  }

  /** Counts the ticks for which the server took another input than the player gave. */
  private static final class WrongInputs implements Journal {
    private final Map<Integer, Long> given;
    private final HostPlayer player;
    private int ticks;

    WrongInputs(Map<Integer, Long> given, HostPlayer player) {
      this.given = given;
      this.player = player;
    }

    @Override
    public void stepping(SimulationHost s) {
      Long input = given.get(s.tick() + 1);
      if (input == null || input != player.input().pack()) {
        ticks++;
      }
    }

    @Override
    public void stepped(SimulationHost s) {}
  }

  @ParameterizedTest
  @MethodSource("levelsAndConditions")
  void afterAForeignPushTheErrorIsGoneWithinAQuarterOfASecond(Level level, Condition condition) {
    // Goal: a surprise is seen as a quick glide. Method: the server kicks the body; from the first
    // correction on, 250 ms until less than a centimetre of it is left on the screen.
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("p", condition.impairment(Stepper.SEED), InputSource.IDLE);
      stepper.run(4);
      for (int i = 0; i < 5; i++) {
        long before = client.stats().corrections();
        float direction = i % 2 == 0 ? 1 : -1;
        stepper.body(client).body().setVelocity(8 * direction, 3 * direction);
        stepper.runUntil("a correction", () -> client.stats().corrections() > before, 3);
        stepper.run(0.25);
        double error = client.game().visualErrorMetres();
        assertEquals(0, error, 0.01, "push " + i + " " + level.name() + " " + condition);
        stepper.run(1);
      }
    }
  }
}
