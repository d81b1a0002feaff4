package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.view.ClientView.Drawn;
import carom.net.transport.Impairment;
import carom.physics.Body;
import carom.server.config.ServerConfig;
import carom.sim.Entity;
import carom.sim.scene.SceneGame;
import carom.sim.scene.catalog.Scenes;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: players watch a scene over the network. Method: two spectators, one of them on a bad line,
 * of a scene that moves and of one that makes bodies while it runs; every snapshot must be the
 * server's frame, and every body must be drawn near where it is.
 */
final class SceneScenarioTest {
  @ParameterizedTest
  @ValueSource(strings = {"car", "conveyor", "dam_break"})
  void spectatorsSeeEveryBody(String name) {
    try (Stepper stepper = Stepper.of(SceneGame.level(Scenes.get(name)), ServerConfig.defaults())) {
      SimulatedClient near = stepper.add("near", Impairment.NONE, InputSource.IDLE);
      SimulatedClient far =
          stepper.add("far", Impairment.NONE.withLatency(80, 10).withLoss(5), InputSource.IDLE);
      stepper.runUntil(
          "both watch", () -> near.view().entityCount() > 0 && far.view().entityCount() > 0, 5);
      stepper.run(5);
      for (SimulatedClient client : stepper.clients()) {
        assertNull(client.view().own());
        assertTrue(client.compared() > 50, name + " compared=" + client.compared());
        assertEquals("scene:" + name, client.view().game());
        int seen = 0;
        for (int i = 0; i < client.view().entityCount(); i++) {
          Drawn drawn = client.view().entity(i);
          Entity entity = stepper.room().simulation().entity(drawn.id());
          if (entity != null) {
            Body<Entity> real = entity.body();
            double apart = Math.hypot(real.x() - drawn.x(), real.y() - drawn.y());
            double speed = Math.hypot(real.velocityX(), real.velocityY());
            assertTrue(apart < 0.5 + 0.5 * speed, name + " " + drawn.id() + " apart=" + apart);
            seen++;
          }
        }
        int bodies = stepper.room().simulation().entityCount();
        assertTrue(seen >= bodies - 1, name + " seen=" + seen + " of " + bodies);
      }
    }
  }
}
