package carom.lab.figures;

import carom.client.stats.NetStats;
import carom.fixtures.AnchorGaps;
import carom.fixtures.MachineGame;
import carom.lab.measure.Figure;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.ArrayList;
import java.util.List;

/** Measures how machines of bodies and joints are predicted, drawn and sent. Virtual time. */
final class MachineFigures {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);

  private MachineFigures() {}

  /** Measures a car alone, then among ragdolls, under a rope bridge, and under a crane. */
  static List<Figure> measure(boolean quick) {
    List<Figure> figures = new ArrayList<>();
    measure(figures, "car alone", "", quick);
    measure(
        figures,
        "car and three ragdolls",
        spawn("ragdoll", -20, 0.1f, 0)
            + spawn("ragdoll", -15, 0.1f, 0)
            + spawn("ragdoll", -8, 0.1f, 0),
        quick);
    measure(
        figures,
        "car under a rope bridge with crates",
        spawn("bridge", -20, 3.5f, 12) + spawn("crate", -20, 6, 0) + spawn("crate", -19, 8, 0),
        quick);
    measure(
        figures, "car under a crane", spawn("crane", -20, 6, 0) + spawn("crate", -16, 1, 0), quick);
    return figures;
  }

  private static String spawn(String name, float x, float y, int team) {
    return ", {\"name\": \"" + name + "\", \"at\": [" + x + ", " + y + "], \"team\": " + team + "}";
  }

  private static void measure(List<Figure> figures, String machine, String spawns, boolean quick) {
    try (Stepper stepper = Stepper.of(MachineGame.level(spawns), ServerConfig.defaults())) {
      SimulatedClient client = stepper.join("p", FAR, Scripts.wander(Stepper.SEED));
      stepper.run(4);
      NetStats stats = client.stats();
      final long awake = stats.awakeBodies();
      final long exact = stats.exactBodies();
      final long corrections = stats.corrections();
      final long compared = stats.compared();
      final long bytes = stats.playingBytesIn();
      AnchorGaps gaps = new AnchorGaps(stepper.room().simulation(), client);
      int seconds = quick ? 10 : 60;
      gaps.run(stepper, seconds);
      String what = machine + ", 150 ms and 2 % loss: ";
      long bodies = stats.awakeBodies() - awake;
      figures.add(
          Figure.atLeast(
                  99,
                  what + "perfect predictions",
                  100.0 * (stats.exactBodies() - exact) / bodies,
                  "%")
              .withNote("%d awake bodies compared, every bit", bodies));
      figures.add(
          Figure.atMost(
                  0,
                  what + "corrections of the own body",
                  (stats.corrections() - corrections) * 60.0 / seconds,
                  "/min")
              .withNote("of %d states", stats.compared() - compared));
      figures.add(
          Figure.atMost(2, what + "anchors of a joint drawn apart, worst", gaps.worst() * 100, "cm")
              .withNote(
                  "more than in the world; of %d joints in pictures; in the world up to %.1f cm",
                  gaps.seen(), gaps.worstTruth() * 100));
      figures.add(
          Figure.shown(
              what + "received",
              (stats.playingBytesIn() - bytes) * 8 / 1_000.0 / seconds,
              "kbit/s"));
    }
  }
}
