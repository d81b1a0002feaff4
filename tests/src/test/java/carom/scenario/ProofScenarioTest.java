package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.client.InputSource;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.Level;
import carom.testkit.Condition;
import carom.testkit.Levels;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Goal: bad networks are never taken for wrong computation, and wrong computation is seen. Method:
 * the server's counters while clients play in virtual time.
 */
final class ProofScenarioTest {
  static Stream<Arguments> levelsAndConditions() {
    return Stream.of(Levels.emptyArena(), Levels.emptyPlatformer())
        .flatMap(
            level ->
                Stream.of(Condition.MIXED, Condition.BURSTS_30_PERCENT, Condition.BLACKOUT_1_S)
                    .map(c -> Arguments.of(level, c)));
  }

  @ParameterizedTest
  @MethodSource("levelsAndConditions")
  void aloneEverythingIsExplained(Level level, Condition condition) {
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("p", condition.impairment(Stepper.SEED), Scripts.wander(Stepper.SEED));
      stepper.run(5);
      if (condition.hasBlackout()) {
        stepper.blackout(client, 1);
      }
      stepper.run(8);
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), stepper::describe);
    }
  }

  @Test
  void aBodyThatObeysOtherLawsIsNoticedOnceWithBothStates() {
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("p", Impairment.NONE.withLatency(40, 5), InputSource.IDLE);
      stepper.run(3);
      assertEquals(0, stepper.count(Counter.DIVERGENCES_REPORTED));
      // As if the server computed something else: it changes the last bit of the velocity.
      float vx = stepper.body(client).body().velocityX();
      stepper.body(client).body().setVelocity(Math.nextUp(vx + 0.5f), 0);
      stepper.run(1);
      assertEquals(1, stepper.count(Counter.DIVERGENCES_REPORTED));
      assertEquals(1, stepper.count(Counter.DIVERGENCES_UNEXPLAINED));
      stepper.run(5);
      assertEquals(1, stepper.count(Counter.DIVERGENCES_REPORTED), "corrected, and in step again");
    }
  }
}
