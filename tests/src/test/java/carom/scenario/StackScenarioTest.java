package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.InputSource;
import carom.client.PredictionMode;
import carom.client.view.ClientView.Drawn;
import carom.net.transport.Impairment;
import carom.physics.Body;
import carom.sim.entity.HostEntity;
import carom.sim.level.Appearance.Look;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Goal: a stack that is partly in the predicted set looks at rest. Method: stand beside the top of
 * the platformer's crate tower, far from its foot, on a slow line, and compare every crate on the
 * screen with the server's. If the client predicted the upper crates alone, they would sink into
 * the ones below.
 */
final class StackScenarioTest {
  private static final Impairment FAR = Impairment.NONE.withLatency(100, 0);

  /** The tower may come near in parts: what is not here yet must not let the others fall. */
  @ParameterizedTest
  @EnumSource(
      value = PredictionMode.class,
      names = {"ISLAND", "ALL"})
  void aTowerBesideThePlayerStands(PredictionMode mode) {
    try (Stepper stepper = Stepper.of("platformer")) {
      ClientConfig config = ClientConfig.of("p").with(ClientConfig.PREDICTION, mode);
      SimulatedClient client = stepper.add(config, FAR, InputSource.IDLE);
      stepper.awaitPlaying(client);
      stepper.run(1);
      Body<HostEntity> own = stepper.body(client).body();
      own.setPose(34.3f, 5.3f, 0);
      own.setVelocity(0, 0);
      stepper.run(3);
      int seen = 0;
      int predicted = 0;
      for (int frame = 0; frame < 60; frame++) {
        stepper.run(1 / 60.0);
        for (int i = 0; i < client.view().entityCount(); i++) {
          Drawn drawn = client.view().entity(i);
          if (drawn.archetype().appearance().look() == Look.CRATE && drawn.x() > 35) {
            Body<HostEntity> real = stepper.room().simulation().entity(drawn.id()).body();
            String about = "crate " + drawn.id() + " mode=" + mode;
            assertEquals(real.y(), drawn.y(), 0.03, about);
            assertEquals(real.x(), drawn.x(), 0.03, about);
            seen++;
            predicted += drawn.predicted() > 0.5f ? 1 : 0;
          }
        }
      }
      assertTrue(seen >= 600, "seen=" + seen);
      assertTrue(predicted > 0, "the upper crates are near enough to be predicted");
    }
  }
}
