package carom.server.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ServerConfigTest {
  @Test
  void errorNamesSettingValueAndLimits() {
    ServerConfig c = ServerConfig.defaults();
    Exception e =
        assertThrows(IllegalArgumentException.class, () -> c.with(ServerConfig.TICK_RATE, 0));
    assertEquals("--tick-rate=0 is outside 10..240 Hz", e.getMessage());
    e = assertThrows(IllegalArgumentException.class, () -> c.with(ServerConfig.NAME, " "));
    assertEquals("--name: length=0 is outside 1..40", e.getMessage());
    e = assertThrows(IllegalArgumentException.class, () -> c.with(ServerConfig.CATCH_UP_TICKS, 0));
    assertEquals("catchUpTicks=0 is outside 1..60", e.getMessage());
  }

  @Test
  void aCopyDiffersInOneSetting() {
    ServerConfig before = ServerConfig.defaults();
    ServerConfig c = before.with(ServerConfig.SEED, 9).with(ServerConfig.GRACE, 7);
    assertEquals(9, c.get(ServerConfig.SEED));
    assertEquals(7_000, c.graceMs());
    assertEquals(64_000, c.bytesPerSecond());
    assertEquals("Carom", c.get(ServerConfig.NAME));
    assertEquals(before, c.with(ServerConfig.SEED, 1).with(ServerConfig.GRACE, null));
    assertTrue(c.tickNs() > 16_000_000);
    assertEquals(30, c.with(ServerConfig.TICK_RATE, 30).snapshotRateHz());
  }
}
