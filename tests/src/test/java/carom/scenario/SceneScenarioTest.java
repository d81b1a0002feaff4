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
import carom.sim.Simulation;
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
      stepper.run(4.5);
      double[] fastest = fastestOfHalfASecond(stepper);
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
            assertTrue(
                apart < 0.5 + 0.5 * fastest[drawn.id()],
                name + " " + drawn.id() + " apart=" + apart);
            seen++;
          }
        }
        int bodies = stepper.room().simulation().entityCount();
        assertTrue(seen >= bodies - 1, name + " seen=" + seen + " of " + bodies);
      }
    }
  }

  /**
   * Runs on and returns each body's greatest speed, m/s: one that has just stopped is drawn late.
   */
  private static double[] fastestOfHalfASecond(Stepper stepper) {
    Simulation simulation = stepper.room().simulation();
    double[] fastest = new double[Simulation.MAX_ENTITIES];
    for (int tick = 0; tick < simulation.tickRate() / 2; tick++) {
      stepper.run(simulation.tickSeconds());
      for (int id = 0; id < simulation.entityCapacity(); id++) {
        Entity entity = simulation.entity(id);
        if (entity != null) {
          Body<Entity> body = entity.body();
          fastest[id] = Math.max(fastest[id], Math.hypot(body.velocityX(), body.velocityY()));
        }
      }
    }
    return fastest;
  }
}
