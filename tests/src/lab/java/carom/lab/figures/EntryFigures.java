package carom.lab.figures;

import carom.client.InputSource;
import carom.fixtures.BigWorlds;
import carom.lab.measure.Figure;
import carom.net.protocol.PackedLevel;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.level.Level;
import carom.testkit.Scripts;
import carom.testkit.Stepper;
import java.util.List;

/** Measures how long a late joiner waits for a large world, on a slow line in virtual time. */
final class EntryFigures {
  private static final int BODIES = 10_000;
  private static final Impairment LINE =
      Impairment.NONE.withLatency(50, 0).withBandwidth(2_000).withSeed(Stepper.SEED);

  private EntryFigures() {}

  static List<Figure> measure(boolean quick) {
    Level level = BigWorlds.crates(BODIES, 150, 9);
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      stepper.join("first", Impairment.NONE, Scripts.hold(0, 1)); // up, into the crates
      stepper.run(quick ? 2 : 6);
      long beginNs = stepper.nowNs();
      stepper.join("late", LINE, InputSource.IDLE);
      double seconds = (stepper.nowNs() - beginNs) / 1e9;
      return List.of(
          Figure.atMost(
                  1,
                  "late joiner of a world of 10,000 bodies plays, 2 Mbit/s, 100 ms",
                  seconds,
                  "s")
              .withNote("level %d bytes packed", PackedLevel.pack(level.source()).length));
    }
  }
}
