package carom.server.http;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.access.AddressRange;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Goal: nobody chooses the address it is known by. Method: headers as proxies and cheats write. */
final class OriginsTest {
  private final Origins origins =
      new Origins(
          Stream.of("127.0.0.1", "10.0.0.0/8", "2001:db8:1::/48")
              .map(network -> AddressRange.parse(network).orElseThrow())
              .toList());

  private String from(String peer, String... forwarded) throws UnknownHostException {
    InetAddress address = InetAddress.getByName(peer);
    return origins.from(address, List.of(forwarded), true).address().getHostAddress();
  }

  @Test
  void theLastAddressThatIsNoProxysCounts() throws UnknownHostException {
    assertEquals("203.0.113.5", from("127.0.0.1", "203.0.113.5"));
    assertEquals("203.0.113.5", from("127.0.0.1", "127.0.0.1, 203.0.113.5"));
    assertEquals("203.0.113.5", from("127.0.0.1", "198.51.100.1", "203.0.113.5, 10.1.2.3"));
    assertEquals("203.0.113.5", from("10.9.9.9", " 203.0.113.5:4711 "));
    assertEquals("2001:db8:9:0:0:0:0:1", from("2001:db8:1::7", "[2001:db8:9::1]:5000"));
    assertEquals("2001:db8:9:0:0:0:0:1", from("127.0.0.1", "2001:db8:9::1"));
  }

  @Test
  void whatIsNoAddressEndsTheWay() throws UnknownHostException {
    for (String text : List.of("", "unknown", "_hidden", "1.2.3", "host.example", "[::1", ",")) {
      assertEquals("127.0.0.1", from("127.0.0.1", "203.0.113.5, " + text), text);
      assertEquals("10.0.0.2", from("127.0.0.1", "203.0.113.5, " + text + ", 10.0.0.2"), text);
    }
    assertEquals("127.0.0.1", from("127.0.0.1"));
  }

  @Test
  void whoIsNoProxyIsNotBelieved() throws UnknownHostException {
    Random random = new Random(1);
    for (int i = 0; i < 100; i++) {
      String peer = "192.0.2." + i;
      assertEquals(peer, from(peer, "127.0.0.1, 10.0.0." + random.nextInt(256)));
    }
  }

  @Test
  void onlyAVisitorWithoutAnyProxyIsHere() throws UnknownHostException {
    Origins none = new Origins(List.of());
    InetAddress here = InetAddress.getByName("127.0.0.2");
    assertTrue(none.from(here, List.of(), false).isHere());
    assertTrue(none.from(InetAddress.getByName("::1"), List.of(), false).isHere());
    assertFalse(none.from(InetAddress.getByName("192.0.2.1"), List.of(), false).isHere());
    assertFalse(none.from(here, List.of(), true).isHere());
    assertFalse(origins.from(InetAddress.getByName("127.0.0.1"), List.of(), false).isHere());
  }
}
