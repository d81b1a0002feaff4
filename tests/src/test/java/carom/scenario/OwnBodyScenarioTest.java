package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.server.config.ServerConfig;
import carom.server.session.InputBuffer;
import carom.sim.level.Level;
import carom.testkit.Condition;
import carom.testkit.Levels;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
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
    // Method: a wanderer for twenty seconds; each tick without an input at the server excuses one
    // correction.
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("p", condition.impairment(Stepper.SEED), Scripts.wander(Stepper.SEED));
      stepper.run(4);
      InputBuffer inputs = stepper.room().session(client.view().playerId()).inputs();
      final long missing = inputs.missing();
      stepper.run(1); // what is corrected at the beginning was missing before
      final long compared = client.stats().compared();
      final long corrections = client.stats().corrections();
      stepper.run(10);
      if (condition.hasBlackout()) {
        stepper.blackout(client, 1);
      }
      stepper.run(10);
      long missed = inputs.missing() - missing;
      long corrected = client.stats().corrections() - corrections;
      String about =
          "corrections=" + corrected + " missing=" + missed + " " + level.name() + " " + condition;
      assertTrue(client.stats().compared() - compared > 300, about);
      assertTrue(corrected <= missed, about);
      if (condition == Condition.CLEAN || condition == Condition.LATENCY_300) {
        assertEquals(0, missed, about);
      }
    }
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
