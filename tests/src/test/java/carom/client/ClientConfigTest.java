package carom.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class ClientConfigTest {
  @Test
  void valuesOutOfRangeAreRefusedByName() {
    ClientConfig config = ClientConfig.of("a");
    refused("--host: tcpPort=65536 is outside 0..65535", () -> config.withServer("", 65_536, 1));
    refused("--host: udpPort=-1 is outside 0..65535", () -> config.withServer("", 1, -1));
    refused(
        "maxRollbackTicks=0 is outside 1..120",
        () -> config.with(ClientConfig.MAX_ROLLBACK_TICKS, 0));
    refused(
        "--room: name=a b must be 1..32 letters, digits, dots, dashes and underlines, and begin"
            + " with a letter or a digit",
        () -> config.with(ClientConfig.ROOM, "a b"));
    refused(
        "--token: length=769 is outside 0..768",
        () -> config.with(ClientConfig.TOKEN, "t".repeat(769)));
  }

  @Test
  void secretsAreNotTold() {
    ClientConfig config =
        ClientConfig.of("a").with(ClientConfig.TOKEN, "t").with(ClientConfig.PASSWORD, "p");
    assertEquals("ClientConfig[server=localhost:54555, name=a]", config.toString());
  }

  private static void refused(String message, Runnable change) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, change::run).getMessage());
  }
}
