package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.view.ClientView.Drawn;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.scene.SceneGame;
import carom.sim.scene.catalog.Scenes;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: players watch a scene over the network. Method: two spectators, one of them on a bad line,
 * of a scene that moves and of one that makes bodies while it runs; every snapshot must be the
 * server's frame, and every body must be drawn where it was within the last half second.
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
      double[][] ways = waysOfHalfASecond(stepper);
      for (SimulatedClient client : stepper.clients()) {
        assertNull(client.view().own());
        assertTrue(client.compared() > 50, name + " compared=" + client.compared());
        assertEquals("scene:" + name, client.view().game());
        int seen = 0;
        for (int i = 0; i < client.view().entityCount(); i++) {
          Drawn drawn = client.view().entity(i);
          Entity entity = stepper.room().simulation().entity(drawn.id());
          if (entity != null) {
            double apart = distance(ways[drawn.id()], drawn.x(), drawn.y());
            assertTrue(apart < 0.1, name + " " + drawn.id() + " apart=" + apart);
            seen++;
          }
        }
        int bodies = stepper.room().simulation().entityCount();
        assertTrue(seen >= bodies - 1, name + " seen=" + seen + " of " + bodies);
      }
    }
  }

  /** Runs for half a second and returns each body's ways: x and y of every tick, by id. */
  private static double[][] waysOfHalfASecond(Stepper stepper) {
    Simulation simulation = stepper.room().simulation();
    int ticks = simulation.tickRate() / 2;
    double[][] ways = new double[Simulation.MAX_ENTITIES][];
    for (int tick = 0; tick < ticks; tick++) {
      stepper.run(simulation.tickSeconds());
      for (int id = 0; id < simulation.entityCapacity(); id++) {
        Entity entity = simulation.entity(id);
        if (entity != null) {
          ways[id] = ways[id] == null ? filled(2 * ticks) : ways[id];
          ways[id][2 * tick] = entity.body().x();
          ways[id][2 * tick + 1] = entity.body().y();
        }
      }
    }
    return ways;
  }

  private static double[] filled(int length) {
    double[] never = new double[length];
    Arrays.fill(never, Double.NaN);
    return never;
  }

  /** Returns the distance from a point to the nearest place of a way, m. */
  private static double distance(double[] way, double x, double y) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < way.length; i += 2) {
      double apart = Math.hypot(way[i] - x, way[i + 1] - y);
      least = apart < least ? apart : least;
    }
    return least;
  }
}
