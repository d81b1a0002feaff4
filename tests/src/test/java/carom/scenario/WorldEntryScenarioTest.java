package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.client.link.ConnectionPhase;
import carom.fixtures.BigWorlds;
import carom.net.protocol.PackedLevel;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.level.Level;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.api.Test;

/**
 * Goal: a player who joins a world of 10,000 bodies late plays within a second on a line of 2
 * Mbit/s with a round trip of 100 ms, and after a connection breaks while loading, the client
 * fetches only the rest of the level. Method: virtual time, a level in which each body has a line
 * of its own.
 */
class WorldEntryScenarioTest {
  private static final int BODIES = 10_000;
  private static final Impairment LINE =
      Impairment.NONE.withLatency(50, 0).withBandwidth(2_000).withSeed(Stepper.SEED);

  private final Level level = BigWorlds.crates(BODIES, 150, 9);

  @Test
  void aLateJoinerPlaysWithinASecond() {
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      SimulatedClient first =
          stepper.join("first", Impairment.NONE, Scripts.hold(0, 1)); // up, into the crates
      stepper.run(6);
      long moved = countMoved(stepper.frames());
      assertTrue(moved > 2, "moved=" + moved);
      long startNs = stepper.nowNs();
      long bytes = stepper.count(Counter.SNAPSHOT_BYTES);
      SimulatedClient late = stepper.join("late", LINE, InputSource.IDLE);
      double seconds = (stepper.nowNs() - startNs) / 1e9;
      bytes = stepper.count(Counter.SNAPSHOT_BYTES) - bytes;
      String about =
          "seconds="
              + seconds
              + " packed="
              + PackedLevel.pack(level.source()).length
              + " snapshots="
              + bytes;
      assertTrue(seconds <= 1, about);
      stepper.run(0.5);
      FrameState frame = stepper.frame();
      int known = 0;
      for (int slot = 0; slot < BODIES; slot++) {
        EntityHistory history = late.game().decoder().history(slot);
        known += history != null && history.alive() ? 1 : 0;
      }
      assertTrue(known >= BODIES - moved - 200, "known=" + known + " moved=" + moved);
      first.play(InputSource.IDLE);
      stepper.run(4);
      late.requireSame(stepper.frame());
      assertTrue(frame.count() > BODIES);
    }
  }

  private static long countMoved(FrameRing frames) {
    long moved = 0;
    for (int slot = 0; slot < BODIES; slot++) {
      moved += frames.changedTick(slot) > 0 ? 1 : 0;
    }
    return moved;
  }

  @Test
  void aBrokenLineCostsTheRestOfTheLevelOnly() {
    try (Stepper stepper = Stepper.of(BigWorlds.heavy(Stepper.SEED), ServerConfig.defaults())) {
      SimulatedClient client = stepper.add("late", LINE, InputSource.IDLE);
      stepper.runUntil("half is loaded", () -> client.view().loadingProgress() >= 0.5, 5);
      assertEquals(ConnectionPhase.LOADING, client.view().phase());
      double before = client.view().loadingProgress();
      client.cut();
      stepper.runUntil(
          "loads again", () -> client.view().phase() == ConnectionPhase.RECONNECTING, 5);
      double[] least = {1};
      stepper.runUntil(
          "plays",
          () -> {
            least[0] = Math.min(least[0], client.view().loadingProgress());
            return client.view().phase() == ConnectionPhase.PLAYING;
          },
          5);
      assertTrue(least[0] >= before, "least=" + least[0] + " before=" + before);
      assertEquals("crates", client.view().level().name());
    }
  }
}
