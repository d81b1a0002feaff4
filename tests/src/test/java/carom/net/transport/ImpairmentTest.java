package carom.net.transport;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class ImpairmentTest {
  @Test
  void eachCopyHasItsChangesAndEverythingElse() {
    Impairment all =
        Impairment.NONE
            .withSeed(9)
            .withBursts(2, 3)
            .withLatency(40, 5)
            .withJitterReorders(false)
            .withReorder(6, 7)
            .withBandwidth(64);
    assertEquals(
        "Impairment[seed=9, lossPercent=2.0, burst=3.0, latencyMs=40.0, jitterMs=5.0, "
            + "jitterReorders=false, reorderPercent=6.0, duplicatePercent=7.0, bandwidthKbit=64.0]",
        all.toString());
    assertEquals(all.withBursts(4, 1), all.withLoss(4));
    assertEquals(
        Impairment.NONE,
        all.withSeed(1)
            .withLoss(0)
            .withLatency(0, 0)
            .withJitterReorders(true)
            .withReorder(0, 0)
            .withBandwidth(0));
  }

  @Test
  void valuesOutOfRangeAreRefusedByName() {
    Impairment none = Impairment.NONE;
    refused("lossPercent=101.0 is outside 0.0..100.0", () -> none.withLoss(101));
    refused("burst=0.5 is outside 1.0..10000.0", () -> none.withBursts(1, 0.5));
    refused("latencyMs=-1.0 is outside 0.0..60000.0", () -> none.withLatency(-1, 0));
    refused("jitterMs=NaN is outside 0.0..60000.0", () -> none.withLatency(0, Double.NaN));
    refused("reorderPercent=101.0 is outside 0.0..100.0", () -> none.withReorder(101, 0));
    refused("duplicatePercent=-1.0 is outside 0.0..100.0", () -> none.withReorder(0, -1));
    refused("bandwidthKbit=0.5 is outside 1.0..1000000.0", () -> none.withBandwidth(0.5));
  }

  private static void refused(String message, Runnable change) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, change::run).getMessage());
  }
}
