package carom.server.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import org.junit.jupiter.api.Test;

class ServerConfigTest {
  @Test
  void errorNamesSettingValueLimitsAndFlag() {
    Exception e =
        assertThrows(
            IllegalArgumentException.class, () -> ServerConfig.defaults().withTickRateHz(0));
    assertEquals("tickRateHz=0 is outside 10..240; set it with --tick-rate", e.getMessage());
  }

  @Test
  void everySettingHasLimits() {
    ServerConfig c = ServerConfig.defaults();
    assertThrows(IllegalArgumentException.class, () -> c.withGameName(" "));
    assertThrows(IllegalArgumentException.class, () -> c.withServerName("x".repeat(41)));
    assertThrows(IllegalArgumentException.class, () -> c.withRooms(0));
    assertThrows(IllegalArgumentException.class, () -> c.withRooms(65));
    assertThrows(IllegalArgumentException.class, () -> c.withRooms(64).withMaxPlayers(65));
    assertThrows(IllegalArgumentException.class, () -> c.withThreads(0));
    assertThrows(IllegalArgumentException.class, () -> c.withThreads(65));
    assertThrows(IllegalArgumentException.class, () -> c.withMaxPlayers(1025));
    assertThrows(IllegalArgumentException.class, () -> c.withHandshakeTimeoutMs(0));
    assertThrows(IllegalArgumentException.class, () -> c.withLoadTimeoutMs(0));
    assertThrows(IllegalArgumentException.class, () -> c.withSilenceTimeoutMs(0));
    assertThrows(IllegalArgumentException.class, () -> c.withGraceMs(-1));
    assertThrows(IllegalArgumentException.class, () -> c.withCatchUpTicks(0));
    assertThrows(IllegalArgumentException.class, () -> c.withInputWindowTicks(65));
    assertThrows(IllegalArgumentException.class, () -> c.withInputHoldTicks(-1));
    assertThrows(IllegalArgumentException.class, () -> c.withSnapshotRateHz(0));
    assertThrows(IllegalArgumentException.class, () -> c.withKeepAliveRateHz(0));
    assertThrows(IllegalArgumentException.class, () -> c.withSnapshotBitsPerSecond(8));
    assertThrows(IllegalArgumentException.class, () -> c.withRosterIntervalMs(-1));
    assertThrows(IllegalArgumentException.class, () -> c.withStatusIntervalS(-1));
  }

  @Test
  void withersChangeOneSettingEach() {
    ServerConfig c = ServerConfig.defaults().withSeed(9).withGraceMs(7).withServerName("x");
    assertEquals(9, c.seed());
    assertEquals(7, c.graceMs());
    assertEquals("x", c.serverName());
    assertEquals(
        ServerConfig.defaults(), c.withSeed(1).withGraceMs(30_000).withServerName("Carom"));
    assertTrue(c.tickNs() > 16_000_000);
  }

  @Test
  void withersChangeTheirOwnSettingAndNoOther() throws Exception {
    ServerConfig c = ServerConfig.defaults();
    for (RecordComponent component : ServerConfig.class.getRecordComponents()) {
      String name = component.getName();
      Class<?> type = component.getType();
      Object old = component.getAccessor().invoke(c);
      Object other = other(old);
      Method with =
          ServerConfig.class.getMethod(
              "with" + Character.toUpperCase(name.charAt(0)) + name.substring(1), type);
      ServerConfig changed = (ServerConfig) with.invoke(c, other);
      assertEquals(other, component.getAccessor().invoke(changed), name);
      assertEquals(c, with.invoke(changed, old), name);
    }
  }

  private static Object other(Object value) {
    if (value instanceof String text) {
      return text + "x";
    } else if (value instanceof Boolean on) {
      return !on;
    }
    return value instanceof Long number ? (Object) (number + 1) : (Object) ((int) value + 1);
  }
}
