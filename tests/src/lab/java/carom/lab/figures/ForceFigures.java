package carom.lab.figures;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.fixtures.ForceGame;
import carom.lab.measure.Figure;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.pool.Pools;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Measures how often clients predict right in wind, water and sand. Virtual time. */
final class ForceFigures {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);

  private ForceFigures() {}

  /**
   * Measures a player among ten crates in wind, then on a raft among them, then two clients of the
   * level that ships with pools.
   */
  static List<Figure> measure(boolean quick) throws LevelException {
    return List.of(
        right("wind", ForceGame.wind(), quick),
        corrections("wind", ForceGame.wind(), quick),
        right("water with a raft", ForceGame.water(), quick),
        corrections("water with a raft", ForceGame.water(), quick),
        pools(quick));
  }

  private static Figure right(String what, Level level, boolean quick) {
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      SimulatedClient client = play(stepper);
      final long awake = client.stats().awakeBodies();
      final long exact = client.stats().exactBodies();
      stepper.run(quick ? 10 : 60);
      long compared = client.stats().awakeBodies() - awake;
      double right = 100.0 * (client.stats().exactBodies() - exact) / compared;
      return Figure.atLeast(
              99, what + ", ten crates, 150 ms and 2 % loss: perfect predictions", right, "%")
          .withNote("%d awake bodies compared, every bit", compared);
    }
  }

  private static Figure pools(boolean quick) throws LevelException {
    Map<Integer, Long> hashes = new HashMap<>();
    try (Stepper stepper = Stepper.of(Level.builtIn("sluice"), ServerConfig.defaults())) {
      SimulatedClient p = play(stepper);
      SimulatedClient q = stepper.join("q", FAR.withSeed(Stepper.SEED + 1), new Bot(2));
      stepper.run(4);
      final long awake = p.stats().awakeBodies();
      final long exact = p.stats().exactBodies();
      int same = 0;
      int compared = 0;
      long endNs = stepper.nowNs() + (quick ? 10 : 60) * 1_000_000_000L;
      while (stepper.nowNs() < endNs) {
        stepper.step();
        for (SimulatedClient client : List.of(p, q)) {
          Pools pools = client.view().pools();
          long hash = 0;
          for (int k = 0; k < pools.count(); k++) {
            hash = 31 * hash + pools.get(k).particles().stateHash();
          }
          Long other = hashes.put(pools.tick(), hash);
          compared += other == null ? 0 : 1;
          same += other != null && other == hash ? 1 : 0;
        }
      }
      long bodies = p.stats().awakeBodies() - awake;
      return Figure.atLeast(
              99,
              "pools of water and sand, two clients, 150 ms and 2 % loss: perfect predictions",
              100.0 * (p.stats().exactBodies() - exact) / bodies,
              "%")
          .withNote(
              "%d awake bodies compared, every bit; both had the same particles in %d of %d ticks",
              bodies, same, compared);
    }
  }

  private static Figure corrections(String what, Level level, boolean quick) {
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      SimulatedClient client = play(stepper);
      final long before = client.stats().corrections();
      final long compared = client.stats().compared();
      double seconds = quick ? 10 : 60;
      stepper.run(seconds);
      return Figure.atMost(
              1,
              what + ", ten crates, 150 ms and 2 % loss: corrections of the own body",
              (client.stats().corrections() - before) * 60 / seconds,
              "/min")
          .withNote("of %d states", client.stats().compared() - compared);
    }
  }

  private static SimulatedClient play(Stepper stepper) {
    ClientConfig config = ClientConfig.of("p").with(ClientConfig.PREDICTION, PredictionMode.ALL);
    SimulatedClient client = stepper.add(config, FAR, Scripts.wander(Stepper.SEED));
    stepper.awaitPlaying(client);
    stepper.run(4);
    return client;
  }
}
