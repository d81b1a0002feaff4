package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.view.ClientView.Drawn;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.pool.Pools;
import carom.sim.pool.ShownParticles;
import carom.sim.scene.SceneGame;
import carom.sim.scene.Scenes;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: players watch a scene over the network. Method: two spectators, one of them on a bad line,
 * of a scene that moves and of one that makes bodies while it runs; every snapshot must be the
 * server's frame, and every body must be drawn where it was within the last half second. Particles
 * must be the server's, bit for bit.
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
          HostEntity entity = stepper.room().simulation().entity(drawn.id());
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

  @ParameterizedTest
  @ValueSource(strings = {"dam_break", "water_wheel", "hourglass"})
  void spectatorsSeeTheServersParticlesAlsoIfTheyComeLate(String name) {
    try (Stepper stepper = Stepper.of(SceneGame.level(Scenes.get(name)), ServerConfig.defaults())) {
      SimulatedClient near = stepper.add("near", Impairment.NONE, InputSource.IDLE);
      stepper.run(4);
      SimulatedClient late =
          stepper.add("late", Impairment.NONE.withLatency(75, 5).withLoss(2), InputSource.IDLE);
      Map<Integer, Long> told = new HashMap<>();
      Map<SimulatedClient, Set<Integer>> compared = new HashMap<>();
      while (stepper.room().simulation().tick() < 12 * 60) {
        stepper.step();
        Pools server = stepper.room().simulation().pools();
        told.put(server.tick(), hash(server));
        for (SimulatedClient client : stepper.clients()) {
          Pools pools = client.view().pools();
          if (pools != null && pools.isKnown() && told.containsKey(pools.tick())) {
            assertEquals(told.get(pools.tick()), hash(pools), name + " tick=" + pools.tick());
            compared.computeIfAbsent(client, c -> new HashSet<>()).add(pools.tick());
          }
        }
      }
      for (SimulatedClient client : stepper.clients()) {
        int ticks = compared.get(client).size();
        assertTrue(ticks > 350, name + " compared=" + ticks);
        double behind = client.view().renderTick() - client.view().pools().tick();
        assertTrue(behind >= 0 && behind < 2, name + " behind its bodies: " + behind);
        assertTrue(client.view().pools().shown().get(0).particles().count() > 300, name);
      }
      assertTrue(near.view().pools().tick() > late.view().pools().tick(), "on a shorter line");
    }
  }

  /** Returns a hash of all particles. */
  private static long hash(Pools pools) {
    long hash = pools.shown().size();
    for (ShownParticles some : pools.shown()) {
      hash = 31 * hash + some.particles().stateHash();
    }
    return hash;
  }

  /** Runs for half a second and returns each body's ways: x and y of every tick, by id. */
  private static double[][] waysOfHalfASecond(Stepper stepper) {
    SimulationHost simulation = stepper.room().simulation();
    int ticks = simulation.tickRate() / 2;
    double[][] ways = new double[SimulationHost.MAX_ENTITIES][];
    for (int tick = 0; tick < ticks; tick++) {
      stepper.run(simulation.tickSeconds());
      for (int id = 0; id < simulation.entityCapacity(); id++) {
        HostEntity entity = simulation.entity(id);
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
