package carom.lab.figures.wire;

import carom.client.ClientConfig;
import carom.client.InputSource;
import carom.client.PredictionMode;
import carom.client.link.ConnectionPhase;
import carom.lab.measure.Figure;
import carom.net.protocol.ProtocolLimits;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.level.Level;
import carom.sim.scene.SceneGame;
import carom.sim.scene.Scenes;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.ArrayList;
import java.util.List;

/**
 * Measures the size of the snapshots that servers send: poses and velocities of all moving bodies,
 * for one client that only watches and sees everything. The round trip takes 100 ms, so baselines
 * are that old. The client decodes, and its states are compared with the server's. Virtual time.
 */
public final class SnapshotFigures {
  private static final int ONE_WAY_MS = 50;
  private static final int NO_LIMIT_KBIT = 80_000;
  private static final int FAR_METRES = 4_096;

  /** Time until the client plays and its acks have come back, s. */
  private static final double RUN_IN_SECONDS = 2;

  private SnapshotFigures() {}

  /** Measures the figures, roughly if {@code quick}. */
  public static List<Figure> measure(boolean quick) {
    double seconds = quick ? 1 : 20;
    List<Figure> figures = new ArrayList<>();
    add(figures, "plough_above", "901 bodies ploughed through on a table", seconds);
    add(figures, "plough", "901 bodies ploughed through under gravity", seconds);
    add(figures, "pile_2k", "2,000 bodies that fall into a pile", seconds);
    add(figures, "churn", "600 bodies in churning contact", seconds);
    return figures;
  }

  private static void add(List<Figure> figures, String scene, String what, double seconds) {
    for (int rate : new int[] {60, 30}) {
      figures.addAll(measure(scene, what, rate, seconds));
    }
  }

  private static List<Figure> measure(String scene, String what, int rate, double seconds) {
    Level level = SceneGame.level(Scenes.get(scene));
    ServerConfig config =
        ServerConfig.defaults()
            .with(ServerConfig.SNAPSHOT_RATE, rate)
            .with(ServerConfig.BUDGET, NO_LIMIT_KBIT)
            .with(ServerConfig.VIEW, FAR_METRES);
    try (Stepper stepper = Stepper.of(level, config)) {
      SimulatedClient client =
          stepper.add(
              ClientConfig.of("watcher").with(ClientConfig.PREDICTION, PredictionMode.NONE),
              Impairment.NONE.withLatency(ONE_WAY_MS, 0),
              InputSource.IDLE);
      stepper.runUntil(
          "the client plays",
          () -> client.view().phase() == ConnectionPhase.PLAYING,
          RUN_IN_SECONDS);
      stepper.run(RUN_IN_SECONDS - stepper.room().simulation().tick() / 60.0);
      long bytes = stepper.count(Counter.SNAPSHOT_BYTES);
      long datagrams = stepper.count(Counter.DATAGRAMS_OUT);
      stepper.run(seconds);
      bytes = stepper.count(Counter.SNAPSHOT_BYTES) - bytes;
      datagrams = stepper.count(Counter.DATAGRAMS_OUT) - datagrams;
      String label = "snapshots of " + what + ", " + rate + " Hz: ";
      return List.of(
          Figure.shown(label + "payload", kbit(bytes, seconds), "kbit/s")
              .withNote(
                  "scene %s; %.1f datagrams a second, %.0f B each",
                  scene, datagrams / seconds, 1.0 * bytes / datagrams),
          Figure.shown(
                  label + "whole datagrams",
                  kbit(bytes + ProtocolLimits.DATAGRAM_OVERHEAD_BYTES * datagrams, seconds),
                  "kbit/s")
              .withNote("IP, UDP and frame included"));
    }
  }

  private static double kbit(long bytes, double seconds) {
    return bytes * 8 / seconds / 1_000;
  }
}
