package carom.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class ClientConfigTest {
  @Test
  void eachCopyHasItsChangesAndEverythingElse() {
    ClientConfig other =
        ClientConfig.of("a")
            .withServer("host", 1, 2)
            .withName("b")
            .withPrediction(PredictionMode.NONE)
            .withRollback(3, 4)
            .withSyncTest(true)
            .withTicksPerInputDatagram(5)
            .withReconnect(false)
            .withRoom("cup")
            .withGame("arena")
            .withMinInterpolationMs(6)
            .withToken("t")
            .withPassword("p")
            .withTakesAnyCode(true);
    assertEquals(
        new ClientConfig(
            "host",
            1,
            2,
            "b",
            PredictionMode.NONE,
            3,
            4,
            true,
            5,
            false,
            "cup",
            "arena",
            6,
            "t",
            "p",
            true),
        other);
  }

  @Test
  void valuesOutOfRangeAreRefusedByName() {
    ClientConfig config = ClientConfig.of("a");
    refused("tcpPort=65536.0 is outside 0.0..65535.0", () -> config.withServer("", 65_536, 1));
    refused("udpPort=-1.0 is outside 0.0..65535.0", () -> config.withServer("", 1, -1));
    refused("maxRollbackTicks=0.0 is outside 1.0..120.0", () -> config.withRollback(0, 1));
    refused("maxReplayMs=0.0 is outside 1.0..1000.0", () -> config.withRollback(1, 0));
    refused(
        "name=a b must be 1..32 letters, digits, dots, dashes and underlines, and begin with a"
            + " letter or a digit",
        () -> config.withRoom("a b"));
    refused("token.length=769.0 is outside 0.0..768.0", () -> config.withToken("t".repeat(769)));
    refused("game.length=65.0 is outside 0.0..64.0", () -> config.withGame("g".repeat(65)));
    refused(
        "ticksPerInputDatagram=9.0 is outside 1.0..8.0", () -> config.withTicksPerInputDatagram(9));
  }

  private static void refused(String message, Runnable change) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, change::run).getMessage());
  }
}
