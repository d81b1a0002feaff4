package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.link.ConnectionPhase;
import carom.fixtures.Levels;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: on a machine that is too slow, time passes more slowly for all alike, and play goes on
 * smoothly. Method: four predicting clients, 60 ms, in virtual time; the server's clock says that
 * its work takes longer and longer.
 */
class OverloadScenarioTest {
  private static final Impairment LINE = Impairment.NONE.withLatency(30, 2);

  /** What happened in some seconds. */
  private record Window(double ticksPerSecond, double missing, double corrections) {}

  private static Window window(Stepper stepper, List<SimulatedClient> clients, double seconds) {
    long ticks = stepper.room().age();
    long due = stepper.room().counters().get(Counter.INPUTS_DUE);
    long missing = stepper.room().counters().get(Counter.INPUTS_MISSING);
    long corrections = clients.stream().mapToLong(c -> c.stats().corrections()).sum();
    stepper.run(seconds);
    return new Window(
        (stepper.room().age() - ticks) / seconds,
        (double) (stepper.room().counters().get(Counter.INPUTS_MISSING) - missing)
            / (stepper.room().counters().get(Counter.INPUTS_DUE) - due),
        (clients.stream().mapToLong(c -> c.stats().corrections()).sum() - corrections) / seconds);
  }

  @Test
  void timeSlowsDownForAllAndTheClientsFollow() {
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), ServerConfig.defaults())) {
      List<SimulatedClient> clients = new ArrayList<>();
      for (int i = 0; i < 4; i++) {
        clients.add(stepper.join("p" + i, LINE.withSeed(Stepper.SEED + i), Scripts.wander(i)));
      }
      stepper.run(5);
      Window before = window(stepper, clients, 10);
      assertEquals(60, before.ticksPerSecond, 1);

      stepper.serverTakes(1_500_000);
      stepper.run(5);
      long pace = stepper.room().counters().get(Counter.PACE_PERCENT);
      assertTrue(pace < 90, "pace=" + pace);
      Window slow = window(stepper, clients, 10);
      assertEquals(
          stepper.room().counters().get(Counter.PACE_PERCENT) * 0.6, slow.ticksPerSecond, 4);
      assertTrue(slow.missing <= before.missing + 0.005, before + " " + slow);
      assertTrue(slow.corrections <= before.corrections + 0.5, before + " " + slow);

      stepper.serverTakes(0);
      stepper.run(12);
      Window after = window(stepper, clients, 10);
      assertEquals(60, after.ticksPerSecond, 1);
      assertTrue(after.missing <= before.missing + 0.005, before + " " + after);
      assertTrue(after.corrections <= before.corrections + 0.5, before + " " + after);
    }
  }

  @Test
  void aRoomThatHasNoTimeLetsNobodyElseInAndSaysWhy() {
    ServerConfig config = ServerConfig.defaults().withMaxLoadPercent(80);
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), config)) {
      SimulatedClient first = stepper.join("first", LINE, Scripts.wander(1));
      stepper.serverTakes(1_500_000);
      stepper.run(15);
      SimulatedClient late = stepper.add("late", LINE, Scripts.wander(2));
      stepper.run(2);
      String text = String.valueOf(late.view().message());
      assertTrue(text.contains("too busy"), text);
      first.cut();
      stepper.run(3);
      assertEquals(ConnectionPhase.PLAYING, first.view().phase(), "who plays comes back");
    }
  }
}
