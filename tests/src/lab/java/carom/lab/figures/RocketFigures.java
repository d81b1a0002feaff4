package carom.lab.figures;

import carom.client.InputSource;
import carom.fixtures.SpawnWatch;
import carom.lab.measure.Figure;
import carom.net.transport.Impairment;
import carom.sim.entity.Input;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.List;

/** Measures what a player sees of rockets that its input spawns. Virtual time. */
final class RocketFigures {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);

  private RocketFigures() {}

  /** Measures two players who walk in circles and shoot around themselves. */
  static List<Figure> measure(boolean quick) {
    try (Stepper stepper = Stepper.of("rockets")) {
      SimulatedClient ann = stepper.add("Ann", FAR, shooter(0));
      stepper.awaitPlaying(ann);
      SimulatedClient ben = stepper.add("Ben", FAR.withSeed(7), shooter(250));
      stepper.awaitPlaying(ben);
      stepper.run(4);
      SpawnWatch watch = new SpawnWatch(stepper, ann);
      double seconds = quick ? 10 : 60;
      final long corrections = ann.stats().corrections();
      final long awake = ben.stats().awakeBodies();
      final long exact = ben.stats().exactBodies();
      watch.run(seconds);
      double perMinute = (ann.stats().corrections() - corrections) * 60 / seconds;
      ann.play(InputSource.IDLE);
      watch.run(3);
      long compared = ben.stats().awakeBodies() - awake;
      double right = 100.0 * (ben.stats().exactBodies() - exact) / compared;
      String line = "rocket, two players, 150 ms and 2 % loss: ";
      return List.of(
          Figure.atMost(0, line + "appears after its tick, at most", watch.latestTicks(), "ticks")
              .withNote("%d rockets", watch.spawned()),
          Figure.atLeast(99, line + "perfect predictions of rockets", watch.rightPercent(), "%"),
          Figure.atLeast(99, line + "are the server's, too", watch.matchedPercent(), "%")
              .withNote("%.1f %% retracted", 100 - watch.matchedPercent()),
          Figure.atMost(1, line + "corrections of the own body", perMinute, "/min"),
          Figure.shown(line + "perfect predictions of the other client", right, "%")
              .withNote("%d awake bodies compared, rockets of both among them", compared));
    }
  }

  private static InputSource shooter(int phase) {
    return (view, tick, out) -> {
      float way = (tick + phase) * 0.02f;
      out.move((float) Math.cos(way), (float) Math.sin(way));
      out.aim((float) Math.IEEEremainder((tick + phase) * 0.011f, 2 * Math.PI));
      out.hold(Input.ACTION, true);
    };
  }
}
