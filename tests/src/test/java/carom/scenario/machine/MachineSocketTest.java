package carom.scenario.machine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.view.ClientView;
import carom.fixtures.AnchorGaps;
import carom.fixtures.MachineGame;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.suite.Needs;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Goal: machines are shared over real sockets as in virtual time. Method: KryoNet on loopback in
 * real time, 150 ms there and back, 2 % loss. A busy computer delays inputs, and the server then
 * steps with a guess that no client can predict. So a second counts only if every input was there
 * in time, in it and in the second before.
 */
@Needs("sockets")
@Timeout(120)
class MachineSocketTest {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 5).withLoss(2).withSeed(Stepper.SEED);

  private static final int LEAST_SECONDS = 5;
  private static final int MOST_SECONDS = 40;

  private boolean drives = true;

  @ParameterizedTest(name = "{0}")
  @CsvSource(
      delimiter = '|',
      value = {
        "ragdolls | ', {\"name\": \"ragdoll\", \"at\": [-18, 0.1]}'",
        "a crane | ', {\"name\": \"crane\", \"at\": [-20, 6]}, {\"name\": \"crate\", \"at\": [-16,"
            + " 1]}'",
        "a bridge | ', {\"name\": \"bridge\", \"at\": [-20, 3.5], \"team\": 12}'"
      })
  void machinesArePredicted(String what, String more) {
    try (Stepper stepper = Stepper.overSockets(MachineGame.level(more), ServerConfig.defaults())) {
      SimulatedClient ann = stepper.join("ann", FAR, driver(0));
      stepper.run(3);
      AnchorGaps gaps = new AnchorGaps(stepper.room().simulation(), ann);
      long awake = 0;
      long exact = 0;
      long corrections = 0;
      int calm = 0;
      long delayed = -1;
      for (int second = 0; second < MOST_SECONDS && calm < LEAST_SECONDS; second++) {
        final long awakeBefore = ann.stats().awakeBodies();
        final long exactBefore = ann.stats().exactBodies();
        final long correctionsBefore = ann.stats().corrections();
        final long delayedBefore = delayed;
        gaps.run(stepper, 1);
        delayed = stepper.count(Counter.INPUTS_MISSING) + stepper.count(Counter.TICKS_DROPPED);
        if (delayed == delayedBefore) {
          calm++;
          awake += ann.stats().awakeBodies() - awakeBefore;
          exact += ann.stats().exactBodies() - exactBefore;
          corrections += ann.stats().corrections() - correctionsBefore;
        }
      }
      double right = 100.0 * exact / awake;
      String about =
          String.format(
              Locale.ROOT,
              "%s: seconds=%d right=%.3f of %d corrections=%d %s %s",
              what,
              calm,
              right,
              awake,
              corrections,
              gaps,
              stepper.describe());
      assertTrue(calm >= LEAST_SECONDS && awake > 300, about);
      assertTrue(right >= 99, about);
      assertEquals(0, corrections, about);
      assertTrue(gaps.worst() < 0.02, about);
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), about);
    }
  }

  @Test
  void twoDriversSeeTheSameMachines() {
    // Method: two drivers, a ragdoll and a bridge; then all stand still, and both pictures are
    // compared with the server's world.
    String more =
        ", {\"name\": \"ragdoll\", \"at\": [-18, 0.1]},"
            + " {\"name\": \"bridge\", \"at\": [18, 4], \"team\": 8}";
    try (Stepper stepper = Stepper.overSockets(MachineGame.level(more), ServerConfig.defaults())) {
      stepper.join("ann", FAR, driver(0));
      stepper.join("bob", FAR, driver(90));
      stepper.run(6);
      drives = false;
      SimulationHost server = stepper.room().simulation();
      stepper.runUntil("the machines stand still", () -> isStill(server), 30);
      stepper.run(1);
      String about = stepper.describe();
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), about);
      for (SimulatedClient client : stepper.clients()) {
        assertEquals(server.world().jointCount(), client.view().jointCount(), about);
        for (int id = 0; id < server.entityCapacity(); id++) {
          HostEntity e = server.entity(id);
          if (e != null) {
            ClientView.Drawn drawn = client.view().find(id);
            assertNotNull(drawn, e + " " + about);
            assertEquals(e.body().x(), drawn.x(), 0.01f, e + " " + about);
            assertEquals(e.body().y(), drawn.y(), 0.01f, e + " " + about);
          }
        }
      }
    }
  }

  private static boolean isStill(SimulationHost s) {
    for (int id = 0; id < s.entityCapacity(); id++) {
      HostEntity e = s.entity(id);
      if (e != null && Math.hypot(e.body().velocityX(), e.body().velocityY()) > 0.01) {
        return false;
      }
    }
    return true;
  }

  /** Returns a driver who goes to and fro, two seconds each way. */
  private InputSource driver(int phase) {
    return (view, tick, in) -> {
      float throttle = (tick + phase) / 120 % 2 == 0 ? 1 : -0.6f;
      in.move(drives ? throttle : 0, 0);
    };
  }
}
