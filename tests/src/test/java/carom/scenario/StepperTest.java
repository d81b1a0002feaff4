package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.transport.Impairment;
import carom.testkit.Condition;
import carom.testkit.Scripts;
import carom.testkit.Stepper;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: the stepper, on which the scenarios rely, is deterministic and sound. Method: the same run
 * twice, another seed, and a condition that never comes true.
 */
class StepperTest {
  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer"})
  void equalRunsGiveEqualHashes(String game) {
    long first = run(game, Stepper.SEED);
    assertEquals(first, run(game, Stepper.SEED), "seed=" + Stepper.SEED);
    assertNotEquals(first, run(game, Stepper.SEED + 1), "seed=" + Stepper.SEED);
  }

  private static long run(String game, long seed) {
    try (Stepper stepper = Stepper.of(game)) {
      for (int i = 0; i < 4; i++) {
        stepper.add(
            "p" + i, Condition.MIXED.impairment(seed).withSeed(seed), Scripts.wander(seed + i));
      }
      stepper.run(6);
      assertTrue(stepper.compared() > 500, stepper.describe());
      return stepper.hash();
    }
  }

  @Test
  void waitingInVainEndsWithAMessageThatTellsTheSeed() {
    try (Stepper stepper = Stepper.of("arena")) {
      stepper.add("p", Impairment.NONE, Scripts.hold(0, 0));
      AssertionError e =
          assertThrows(AssertionError.class, () -> stepper.runUntil("pigs fly", () -> false, 0.1));
      assertTrue(e.getMessage().contains("pigs fly"), e.getMessage());
      assertTrue(e.getMessage().contains("seed=" + Stepper.SEED), e.getMessage());
    }
  }
}
