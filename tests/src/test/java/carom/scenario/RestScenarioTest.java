package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.InputSource;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.testkit.BigWorlds;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import org.junit.jupiter.api.Test;

/**
 * Goal: a world at rest costs nothing but keep-alives. Method: a thousand crates, one player who
 * does nothing, ten seconds of virtual time; payload counts. IP and UDP add 28 bytes a datagram.
 */
class RestScenarioTest {
  private static final double SECONDS = 10;

  @Test
  void aThousandRestingBodiesCostKeepAlivesOnly() {
    try (Stepper stepper = Stepper.of(BigWorlds.crates(1_000, 60, 5), ServerConfig.defaults())) {
      SimulatedClient client =
          stepper.join("idle", Impairment.NONE.withLatency(30, 0), InputSource.IDLE);
      stepper.run(3);
      long bytes = stepper.count(Counter.SNAPSHOT_BYTES);
      long datagrams = stepper.count(Counter.DATAGRAMS_OUT);
      stepper.run(SECONDS);
      bytes = stepper.count(Counter.SNAPSHOT_BYTES) - bytes;
      datagrams = stepper.count(Counter.DATAGRAMS_OUT) - datagrams;
      double kbit = bytes * 8 / SECONDS / 1_000;
      assertTrue(kbit <= 1.5, "kbit/s=" + kbit + " bytes=" + bytes + " datagrams=" + datagrams);
      assertTrue(datagrams <= 10 * SECONDS + 1, "datagrams=" + datagrams);
      stepper.requireAllSame();
      assertEquals(0, client.unverified());
    }
  }
}
