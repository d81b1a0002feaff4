package carom.client.link;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ServerMessage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which redirects a client follows. */
final class RedirectsTest {
  private static final ServerAddress PUBLIC = new ServerAddress("play.example.org", 54_555, 0);
  private final Redirects redirects = new Redirects();

  private ServerAddress follow(String to, ServerAddress from, long nowNs) {
    return redirects.follow(new ServerMessage.Redirect(to, "", "", ""), from, nowNs);
  }

  @Test
  void aMoveWithinAFleetMayLeadAnywhereAndOneToAnotherKeyIsARedirect() {
    ServerAddress near = redirects.followMove("10.0.0.7:1", true, PUBLIC, 0);
    assertEquals("10.0.0.7", near.host());
    assertThrows(
        IllegalArgumentException.class, () -> redirects.followMove("10.0.0.7:1", false, PUBLIC, 0));
    for (int i = 1; i < Redirects.MOST_MOVES; i++) {
      redirects.followMove("b.example.org:1", true, PUBLIC, i);
    }
    String text =
        assertThrows(
                IllegalArgumentException.class,
                () -> redirects.followMove("b.example.org:1", true, PUBLIC, 99))
            .getMessage();
    assertTrue(text.contains("31 times within a minute"), text);
    redirects.followMove("b.example.org:1", true, PUBLIC, Redirects.PERIOD_NS + 50);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "localhost",
        "nas",
        "2130706433",
        "0x7f000001",
        "0x7f.1",
        "0.0.0.0",
        "10.1.2.3",
        "127.0.0.1",
        "127.1",
        "169.254.1.1",
        "172.16.0.1",
        "172.31.255.1",
        "192.168.1.1",
        "224.0.0.1",
        "255.255.255.255",
        "::1",
        "::",
        "::ffff:10.0.0.1",
        "fe80:0:0:0:1:2:3:4",
        "fd00:1::2",
        "FC12:1::2",
        "ff02::1",
        "printer.local",
        "Box.LAN"
      })
  void aServerOnTheInternetCantSendAPlayerIntoItsOwnNetwork(String host) {
    assertTrue(Redirects.isLocal(host));
    String to = host.contains(":") ? "[" + host + "]:1" : host + ":1";
    String text =
        assertThrows(IllegalArgumentException.class, () -> follow(to, PUBLIC, 0)).getMessage();
    assertTrue(text.contains("your own network"), text);
    ServerAddress near = new ServerAddress("192.168.1.7", 54_555, 0);
    assertEquals(host, follow(to, near, 0).host(), "within the network it may");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "other.example.org",
        "1.2.3.4",
        "172.32.0.1",
        "192.169.1.1",
        "11.0.0.1",
        "2001:db8::1",
        "localhost.example.org",
        "223.255.255.1"
      })
  void othersAreFollowed(String host) {
    assertFalse(Redirects.isLocal(host));
    String to = host.contains(":") ? "[" + host + "]:7" : host + ":7";
    assertEquals(new ServerAddress(host, 7, 0), follow(to, PUBLIC, 0));
  }

  @Test
  void nobodyIsSentAroundForLong() {
    long now = 5;
    for (int i = 0; i < Redirects.MOST; i++) {
      follow("s" + i + ".example.org:1", PUBLIC, now);
    }
    String text =
        assertThrows(IllegalArgumentException.class, () -> follow("x.example.org:1", PUBLIC, 6))
            .getMessage();
    assertTrue(text.contains("4 times within a minute"), text);
    assertEquals(1, follow("x.example.org:1", PUBLIC, now + Redirects.PERIOD_NS + 1).tcpPort());
  }

  @Test
  void anAddressThatIsNoneOrTheSameIsRefused() {
    for (String bad : new String[] {"", ":1", "http://x", "a b:1", "x.example.org:0"}) {
      assertThrows(IllegalArgumentException.class, () -> follow(bad, PUBLIC, 0), bad);
    }
    assertThrows(IllegalArgumentException.class, () -> follow("PLAY.example.org:54555", PUBLIC, 0));
  }
}
