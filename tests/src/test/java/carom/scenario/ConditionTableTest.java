package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.link.ConnectionPhase;
import carom.fixtures.BigWorlds;
import carom.fixtures.Slice;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.level.Level;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Goal: whatever the line does, a client's decoded state is exactly the server's for every tick it
 * received, with interest and budget at work, and it is fresh. Method: one table of lines, one
 * seeded scenario in virtual time; the stepper compares each decoded state with the server's frame.
 */
class ConditionTableTest {
  private static final double PLAY_SECONDS = Slice.of(2, 3);
  private static final Impairment NONE = Impairment.NONE;

  /** The lines; delays are one way. */
  enum Line {
    CLEAN(NONE, NONE, 60),
    LOSS_2(NONE.withLoss(2), NONE.withLoss(2), 100),
    LOSS_10(NONE.withLoss(10), NONE.withLoss(10), 150),
    BURSTS_30(NONE.withBursts(30, 10), NONE.withBursts(30, 10), 700),
    LATENCY_100_JITTER_30(NONE.withLatency(100, 30), NONE.withLatency(100, 30), 200),
    LATENCY_300(NONE.withLatency(300, 0), NONE.withLatency(300, 0), 380),
    REORDER(NONE.withLatency(30, 10).withReorder(20, 0), NONE.withReorder(20, 0), 120),
    DUPLICATES(NONE.withReorder(0, 20), NONE.withLatency(30, 10).withReorder(0, 20), 120),
    BLACKOUT_1_S(NONE.withLatency(20, 0), NONE.withLatency(20, 0), 120),
    BLACKOUT_5_S(NONE.withLatency(20, 0), NONE.withLatency(20, 0), 120),
    ASYMMETRIC(NONE.withLatency(150, 20).withLoss(5), NONE.withLatency(10, 0), 100),
    LINE_64_KBIT(NONE.withBandwidth(64), NONE.withBandwidth(64).withLatency(30, 0), 180);

    final Impairment up;
    final Impairment down;
    private final double freshMs;

    Line(Impairment up, Impairment down, double freshMs) {
      this.up = up;
      this.down = down;
      this.freshMs = freshMs;
    }

    double blackoutSeconds() {
      return this == BLACKOUT_1_S ? 1 : this == BLACKOUT_5_S ? 5 : 0;
    }
  }

  private final Level level = BigWorlds.churn();

  /** Most bodies move; a view of 25 m sees half of them; the budget is below the demand. */
  private static final ServerConfig CONFIG =
      ServerConfig.defaults().with(ServerConfig.VIEW, 25).with(ServerConfig.BUDGET, 200);

  @ParameterizedTest
  @EnumSource(Line.class)
  void whatIsDecodedIsExactAndFresh(Line line) {
    try (Stepper stepper = Stepper.of(level, CONFIG)) {
      for (int i = 0; i < 2; i++) {
        stepper.join("mover" + i, NONE, Scripts.wander(Stepper.SEED + i));
      }
      SimulatedClient client = stepper.join("player", NONE, Scripts.wander(Stepper.SEED + 99));
      client.impair(
          line.up.withSeed(Stepper.SEED + 1_000), line.down.withSeed(Stepper.SEED + 2_000));
      stepper.run(2); // the pace finds itself
      long compared = client.compared();
      double worstMs = 0;
      if (line.blackoutSeconds() > 0) {
        stepper.blackout(client, line.blackoutSeconds());
        stepper.run(line.blackoutSeconds() + 1);
      }
      double end = stepper.nowNs() / 1e9 + PLAY_SECONDS;
      double stale = 0;
      int looks = 0;
      while (stepper.nowNs() / 1e9 < end) {
        stepper.run(0.05);
        double ageMs =
            (stepper.frame().tick() - client.game().decoder().newestTick()) * 1_000.0 / 60;
        worstMs = Math.max(worstMs, ageMs);
        stale += ageMs > line.freshMs ? 1 : 0;
        looks++;
      }
      String about =
          line + " worstMs=" + worstMs + " stale=" + stale / looks + " " + stepper.describe();
      assertEquals(ConnectionPhase.PLAYING, client.view().phase(), about);
      assertTrue(client.compared() - compared > 200, about);
      assertTrue(stale / looks <= 0.05, about);
      assertEquals(0, stepper.count(Counter.DATAGRAMS_UNSENT), about);
      assertEquals(0, client.stats().malformed(), about);
    }
  }
}
