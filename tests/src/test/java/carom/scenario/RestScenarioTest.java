package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.fixtures.BigWorlds;
import carom.fixtures.Levels;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.api.Test;

/**
 * Goal: a world at rest costs nothing but keep-alives. Method: a thousand crates, one player who
 * does nothing, ten seconds of virtual time; payload counts. IP and UDP add 28 bytes a datagram.
 */
class RestScenarioTest {
  private static final double SECONDS = 10;

  /** IPv4, UDP and the frame's tag around a datagram's payload, bytes. */
  private static final int HEADER = 29;

  @Test
  void aThousandRestingBodiesCostKeepAlivesOnly() {
    try (Stepper stepper = Stepper.of(BigWorlds.crates(1_000, 60, 5), ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("idle", Impairment.NONE.withLatency(30, 0), InputSource.IDLE);
      stepper.run(3);
      long bytes = stepper.count(Counter.SNAPSHOT_BYTES);
      long datagrams = stepper.count(Counter.DATAGRAMS_OUT);
      long up = stepper.count(Counter.BYTES_IN);
      long upDatagrams = stepper.count(Counter.DATAGRAMS_IN);
      stepper.run(SECONDS);
      up =
          stepper.count(Counter.BYTES_IN)
              - up
              + HEADER * (stepper.count(Counter.DATAGRAMS_IN) - upDatagrams);
      bytes = stepper.count(Counter.SNAPSHOT_BYTES) - bytes;
      datagrams = stepper.count(Counter.DATAGRAMS_OUT) - datagrams;
      double kbit = bytes * 8 / SECONDS / 1_000;
      assertTrue(kbit <= 1.5, "kbit/s=" + kbit + " bytes=" + bytes + " datagrams=" + datagrams);
      assertTrue(datagrams <= 10 * SECONDS + 1, "datagrams=" + datagrams);
      double wire = (bytes + HEADER * datagrams) * 8 / SECONDS / 1_000;
      assertTrue(wire <= 3, "down with headers, kbit/s=" + wire);
      assertTrue(up * 8 / SECONDS / 1_000 <= 3, "up with headers, bytes=" + up);
      stepper.requireAllSame();
      assertEquals(0, client.unverified());
    }
  }

  @Test
  void whoHoldsAKeyIsHeardRarelyAndObeyedAllTheTime() {
    // Goal: an input that stays the same costs as little as none, is never taken for a missing one,
    // and its end comes as soon as ever. Method: a key held against a wall, then let go.
    try (Stepper stepper = Stepper.of(Levels.emptyArena(), ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("p", Impairment.NONE.withLatency(30, 0), Scripts.hold(1, 0));
      stepper.run(5);
      long datagrams = stepper.count(Counter.DATAGRAMS_IN);
      long missing = stepper.count(Counter.INPUTS_MISSING);
      long corrections = client.stats().corrections();
      double margin = client.stats().inputMargin();
      for (int i = 0; i < 50; i++) {
        stepper.run(SECONDS / 50);
        assertEquals(1, stepper.player(client).input().moveX(), 0.01);
      }
      datagrams = stepper.count(Counter.DATAGRAMS_IN) - datagrams;
      assertTrue(datagrams <= 8 * SECONDS, "datagrams=" + datagrams);
      assertEquals(margin, client.stats().inputMargin(), 1, "the clock stands where it stood");
      client.play(InputSource.IDLE);
      int before = stepper.frame().tick();
      stepper.runUntil("the key is up", () -> stepper.player(client).input().moveX() == 0, 0.2);
      int took = stepper.frame().tick() - before;
      assertTrue(took <= 12, "ticks=" + took);
      stepper.run(1);
      assertEquals(missing, stepper.count(Counter.INPUTS_MISSING));
      assertEquals(corrections, client.stats().corrections());
    }
  }
}
