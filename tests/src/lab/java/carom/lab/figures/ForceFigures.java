package carom.lab.figures;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.level.Level;
import carom.testkit.ForceGame;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.List;

/** Measures how often clients predict right in wind and water. Virtual time. */
final class ForceFigures {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);

  private ForceFigures() {}

  /** Measures a player among ten crates in wind, then on a raft among them. */
  static List<Figure> measure(boolean quick) {
    return List.of(
        right("wind", ForceGame.wind(), quick),
        corrections("wind", ForceGame.wind(), quick),
        right("water with a raft", ForceGame.water(), quick),
        corrections("water with a raft", ForceGame.water(), quick));
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
    ClientConfig config = ClientConfig.of("p").withPrediction(PredictionMode.ALL);
    SimulatedClient client = stepper.add(config, FAR, Scripts.wander(Stepper.SEED));
    stepper.awaitPlaying(client);
    stepper.run(4);
    return client;
  }
}
