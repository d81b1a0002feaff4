package carom.server.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import carom.server.config.ServerConfig;
import carom.server.thin.web.PlayFlags;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: what an operator says about the fleet fits together, or is refused by name. */
class FleetFlagsTest {
  private static final ServerConfig FLEET =
      ServerConfig.defaults()
          .with(ServerConfig.FLEET, "etcd:http://a:2379")
          .with(ServerConfig.FLEET_KEY, Path.of("fleet.key"))
          .with(ServerConfig.ADVERTISE, "a.example.org");

  @Test
  void aFleetNeedsAKeyAndAnAddress() {
    assertNull(FleetFlags.problem(ServerConfig.defaults(), false));
    assertNull(FleetFlags.problem(FLEET, false));
    assertEquals(
        "--fleet needs --fleet-key FILE, the same key on every server of the fleet",
        FleetFlags.problem(FLEET.with(ServerConfig.FLEET_KEY, null), false));
    assertEquals(
        "--fleet needs --advertise HOST, by which players and other servers reach this server",
        FleetFlags.problem(FLEET.with(ServerConfig.ADVERTISE, null), false));
    assertEquals(
        "--fleet-key needs --fleet",
        FleetFlags.problem(FLEET.with(ServerConfig.FLEET, FleetFlags.NONE), false));
    assertEquals(
        "--advertise=a b must be HOST, HOST:TCP or HOST:TCP:UDP, such as a.example.org:54555",
        FleetFlags.problem(FLEET.with(ServerConfig.ADVERTISE, "a b"), false));
  }

  @Test
  void aProxyBeforeThePlayPortHasAnAddress() {
    ServerConfig given =
        FLEET.with(ServerConfig.PLAY_PORT, 8080).with(ServerConfig.PLAY_ADVERTISE, "a.example:443");
    assertNull(FleetFlags.problem(given, false));
    assertNull(PlayFlags.problem(given));
    assertEquals(
        "--play-advertise needs --fleet",
        FleetFlags.problem(
            ServerConfig.defaults().with(ServerConfig.PLAY_ADVERTISE, "a.example:443"), false));
    assertEquals(
        "--play-advertise needs --play-port",
        PlayFlags.problem(given.with(ServerConfig.PLAY_PORT, null)));
    assertEquals(
        "--play-advertise=a.example must be HOST:PORT, such as a.example.org:443",
        PlayFlags.problem(given.with(ServerConfig.PLAY_ADVERTISE, "a.example")));
    for (String port : List.of("0", "65536", "99999")) {
      String play = "a.example:" + port;
      assertNotNull(PlayFlags.problem(given.with(ServerConfig.PLAY_ADVERTISE, play)), play);
      for (String own : List.of(play, "a.example:1:" + port)) {
        assertNotNull(FleetFlags.problem(FLEET.with(ServerConfig.ADVERTISE, own), false), own);
      }
    }
    assertNull(FleetFlags.problem(FLEET.with(ServerConfig.ADVERTISE, "[::1]:65535:1"), false));
  }

  @Test
  void anAddressGetsThePortsThatItLacks() {
    assertEquals("a.example.org:54555", FleetFlags.address("a.example.org", 54555));
    assertEquals("a.example.org:1", FleetFlags.address("a.example.org:1", 54555));
    assertEquals("a.example.org:1/2", FleetFlags.address("a.example.org:1:2", 54555));
    assertEquals("[2001:db8::1]:7", FleetFlags.address("[2001:db8::1]:7", 54555));
    assertEquals("[2001:db8::1]:54555", FleetFlags.address("[2001:db8::1]", 54555));
  }
}
