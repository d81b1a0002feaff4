package hill;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.bots.Bot;
import carom.net.transport.Impairment;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.List;
import org.junit.jupiter.api.Test;

class HillGameTest {
  /** There and back 150 ms; of 50 datagrams one is lost, in each direction. */
  private static final Impairment BAD = Impairment.NONE.withLatency(75, 5).withLoss(2);

  @Test
  void standingOnTheSummitGainsPoints() {
    InputSource walk =
        (view, tick, out) -> out.move(view.own() == null || view.own().x() > -1 ? 0 : 1, 0);
    try (Stepper world = Stepper.of(HillGame::new, "hill")) {
      SimulatedClient ann = world.join("Ann", BAD, walk);
      world.run(10); // seconds of virtual time
      assertTrue(world.player(ann).score() >= 5, world.describe());
    }
  }

  @Test
  void feelsRightOnABadNetwork() {
    try (Stepper world = Stepper.of(HillGame::new, "hill")) {
      SimulatedClient ann = world.join("Ann", BAD, new Bot(1));
      world.join("Bob", BAD, new Bot(2));
      world.run(10);
      assertEquals(List.of(), world.findings()); // breaks no rule of docs/games/GAMES.md
      assertTrue(ann.rightPercent() > 95, world.describe());
      assertTrue(ann.corrections() < 10, world.describe());
    }
  }
}
