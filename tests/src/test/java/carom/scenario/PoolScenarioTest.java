package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.level.Level;
import carom.sim.pool.Pools;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;

/**
 * Goal: all clients have the particles of the server, and foresee what these do to bodies. Method:
 * the level that ships with pools, real server and clients in virtual time.
 */
class PoolScenarioTest {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);

  /** By tick: the hash of the particles, as the first of server and clients had them. */
  private final Map<Integer, Long> hashes = new HashMap<>();

  private int compared;
  private int different;

  private static Stepper sluice() throws Exception {
    return Stepper.of(Level.builtIn("sluice"), ServerConfig.defaults());
  }

  /** Lets time pass, and compares the particles of server and clients wherever both had a tick. */
  private void watch(Stepper stepper, double seconds, List<SimulatedClient> clients) {
    for (int i = 0; i < 60 * seconds; i++) {
      stepper.step();
      note(stepper.room().simulation().pools(), false);
      for (SimulatedClient client : clients) {
        Pools pools = client.view().pools();
        if (pools != null && pools.isKnown()) {
          note(pools, true);
        }
      }
    }
  }

  private void note(Pools pools, boolean counts) {
    long hash = 0;
    for (int i = 0; i < pools.count(); i++) {
      hash = 31 * hash + pools.get(i).particles().stateHash();
    }
    Long other = hashes.putIfAbsent(pools.tick(), hash);
    compared += counts && other != null ? 1 : 0;
    different += other != null && other != hash ? 1 : 0;
  }

  @Test
  void twoClientsHaveTheServersParticlesAndForeseeWhatTheyDoToBodies() throws Exception {
    try (Stepper stepper = sluice()) {
      ClientConfig all = ClientConfig.of("p").withPrediction(PredictionMode.ALL);
      SimulatedClient p = stepper.add(all, FAR, Scripts.wander(Stepper.SEED));
      SimulatedClient q = stepper.add("q", FAR, new Bot(2));
      stepper.run(4);
      final long awake = p.stats().awakeBodies();
      final long exact = p.stats().exactBodies();
      final long bytes = p.stats().bytesIn();
      watch(stepper, 30, List.of(p, q));
      long awakeBodies = p.stats().awakeBodies() - awake;
      double right = 100.0 * (p.stats().exactBodies() - exact) / awakeBodies;
      String about =
          String.format(
              Locale.ROOT,
              "right=%.2f %% of %d, compared=%d different=%d late=%d kbit/s=%.1f",
              right,
              awakeBodies,
              compared,
              different,
              p.view().tick() - p.view().pools().tick(),
              (p.stats().bytesIn() - bytes) * 8 / 30e3);
      assertTrue(compared > 3_000, about);
      assertEquals(0, different, about);
      assertTrue(right >= 98, about);
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), about);
      assertEquals(0, stepper.count(Counter.UNFORESEEN), about);
    }
  }

  @Test
  void whoComesLateOrComesBackHasTheSameParticles() throws Exception {
    try (Stepper stepper = sluice()) {
      SimulatedClient p = stepper.join("p", FAR, new Bot(1));
      stepper.run(8);
      SimulatedClient q = stepper.join("q", FAR, new Bot(2));
      watch(stepper, 4, List.of(p, q));
      int before = compared;
      p.cut();
      watch(stepper, 6, List.of(q));
      stepper.awaitPlaying(p);
      stepper.run(2);
      watch(stepper, 4, List.of(p));
      assertTrue(before > 200 && compared > before + 400, "compared=" + compared);
      assertEquals(0, different);
    }
  }

  @Test
  void aClientThatHeardNothingForSecondsLoadsTheStateAnew() throws Exception {
    try (Stepper stepper = sluice()) {
      SimulatedClient p = stepper.join("p", FAR, new Bot(1));
      stepper.run(5);
      stepper.blackout(p, 3);
      stepper.run(8);
      int before = compared;
      watch(stepper, 3, List.of(p));
      assertTrue(compared > before + 150, "compared=" + compared);
      assertEquals(0, different);
      int late = p.view().tick() - p.view().pools().tick();
      assertTrue(late < 3, "late=" + late);
    }
  }
}
