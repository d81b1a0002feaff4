package carom.lab.figures;

import carom.client.ClientConfig;
import carom.client.InputSource;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.fixtures.Levels;
import carom.lab.measure.Figure;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.testkit.Condition;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.List;

/** Measures how often clients predict right, and how soon a correction is over. Virtual time. */
final class PredictionFigures {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);

  private PredictionFigures() {}

  /** Measures a bot alone among the platformer's crates. */
  static List<Figure> perfect(boolean quick) {
    return List.of(
        perfect(PredictionMode.ISLAND, "what the own body touches", quick),
        perfect(PredictionMode.ALL, "all it sees", quick));
  }

  private static Figure perfect(PredictionMode mode, String scope, boolean quick) {
    try (Stepper stepper = Stepper.of("platformer")) {
      SimulatedClient client =
          stepper.add(ClientConfig.of("p").with(ClientConfig.PREDICTION, mode), FAR, new Bot(0));
      stepper.run(6);
      long awake = client.stats().awakeBodies();
      long exact = client.stats().exactBodies();
      stepper.run(quick ? 10 : 60);
      awake = client.stats().awakeBodies() - awake;
      exact = client.stats().exactBodies() - exact;
      return Figure.atLeast(
              99, "perfect predictions, 150 ms and 2 % loss, " + scope, 100.0 * exact / awake, "%")
          .withNote("%d awake bodies compared, every bit", awake);
    }
  }

  /**
   * Measures the corrections of a wandering player in an empty arena, on every network of the
   * table. An input of which all copies were lost or late excuses a correction, because no client
   * can predict that.
   */
  static List<Figure> alone(boolean quick) {
    long unexcused = 0;
    long corrections = 0;
    long missing = 0;
    long compared = 0;
    for (Condition condition : Condition.values()) {
      try (Stepper stepper = Stepper.of(Levels.emptyArena(), ServerConfig.defaults())) {
        SimulatedClient client =
            stepper.join("p", condition.impairment(Stepper.SEED), Scripts.wander(Stepper.SEED));
        stepper.run(6);
        final long correctionsBefore = client.stats().corrections();
        final long comparedBefore = client.stats().compared();
        final long missingBefore = stepper.count(Counter.INPUTS_MISSING);
        stepper.run(quick ? 3 : 15);
        long corrected = client.stats().corrections() - correctionsBefore;
        long missed = stepper.count(Counter.INPUTS_MISSING) - missingBefore;
        unexcused += Math.max(0, corrected - missed);
        corrections += corrected;
        missing += missed;
        compared += client.stats().compared() - comparedBefore;
      }
    }
    return List.of(
        Figure.atMost(
                0, "own body alone in a static level, ten networks: corrections", unexcused, "")
            .withNote(
                "of %d states; besides %d where the server had to do without %d inputs, lost with"
                    + " all their copies",
                compared, corrections - unexcused, missing));
  }

  /** Measures the visual error after the server pushes an idle player. */
  static List<Figure> push(boolean quick) {
    double worst = 0;
    int pushes = 0;
    for (Condition condition : Condition.values()) {
      try (Stepper stepper = Stepper.of(Levels.emptyArena(), ServerConfig.defaults())) {
        SimulatedClient client =
            stepper.join("p", condition.impairment(Stepper.SEED), InputSource.IDLE);
        stepper.run(4);
        for (int i = 0; i < (quick ? 2 : 6); i++) {
          long before = client.stats().corrections();
          float direction = i % 2 == 0 ? 1 : -1;
          stepper.body(client).body().setVelocity(8 * direction, 3 * direction);
          stepper.runUntil("a correction", () -> client.stats().corrections() > before, 3);
          stepper.run(0.25);
          worst = Math.max(worst, client.game().visualErrorMetres());
          pushes++;
          stepper.run(1);
        }
      }
    }
    return List.of(
        Figure.atMost(1, "after a foreign push: visual error 250 ms later", 100 * worst, "cm")
            .withNote("the worst of %d pushes by 8.5 m/s on ten networks", pushes));
  }
}
