package carom.lab.figures.wire;

import carom.fixtures.BigWorlds;
import carom.lab.measure.Figure;
import carom.net.snapshot.SnapshotEncoder;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.List;

/** Measures whether a session keeps to its budget and to its line when more moves than fits. */
public final class BudgetFigures {
  private static final int BUDGET_KBIT = 200;
  private static final int LINE_KBIT = 64;

  private BudgetFigures() {}

  /** Measures the figures, roughly if {@code quick}. */
  public static List<Figure> measure(boolean quick) {
    double seconds = quick ? 3 : 10;
    ServerConfig config =
        ServerConfig.defaults().with(ServerConfig.VIEW, 25).with(ServerConfig.BUDGET, BUDGET_KBIT);
    return List.of(onFastLine(config, seconds), onSlowLine(config, seconds));
  }

  private static Figure onFastLine(ServerConfig config, double seconds) {
    try (Stepper stepper = Stepper.of(BigWorlds.churn(), config)) {
      stepper.join("player", Impairment.NONE.withLatency(30, 0), Scripts.wander(Stepper.SEED));
      stepper.run(2);
      long bytes = stepper.count(Counter.SNAPSHOT_BYTES);
      stepper.run(seconds);
      bytes = stepper.count(Counter.SNAPSHOT_BYTES) - bytes;
      // The initial content of the bucket may leave in addition.
      double most = BUDGET_KBIT + 8e-3 * 4 * SnapshotEncoder.MAX_DATAGRAM_BYTES / seconds;
      return Figure.atMost(
              most,
              "322 bodies churned, budget of 200 kbit/s: sent",
              kbit(bytes, seconds),
              "kbit/s")
          .withNote("the limit includes the bucket's depth of four datagrams");
    }
  }

  private static Figure onSlowLine(ServerConfig config, double seconds) {
    Impairment line = Impairment.NONE.withLatency(30, 0).withBandwidth(LINE_KBIT);
    try (Stepper stepper = Stepper.of(BigWorlds.churn(), config)) {
      SimulatedClient client =
          stepper.join("player", Impairment.NONE, Scripts.wander(Stepper.SEED));
      client.impair(Impairment.NONE, line.withSeed(Stepper.SEED));
      stepper.run(4); // the pace finds itself
      double stale = 0;
      int looks = 0;
      for (double t = 0; t < seconds; t += 0.05) {
        stepper.run(0.05);
        int age = stepper.frame().tick() - client.game().decoder().newestTick();
        stale += age * 1_000.0 / 60;
        looks++;
      }
      return Figure.atMost(
              180, "the same on a line of 64 kbit/s: age of the newest", stale / looks, "ms")
          .withNote("mean; 30 ms of it is the line's delay");
    }
  }

  private static double kbit(long bytes, double seconds) {
    return bytes * 8 / seconds / 1_000;
  }
}
