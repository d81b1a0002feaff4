package carom.client.link;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Goal: a player types an address as people write it, and reads what is wrong with it. */
class ServerAddressTest {
  @Test
  void anAddressIsReadAsPeopleWriteIt() {
    assertEquals(new ServerAddress("localhost", 54_555, 0), ServerAddress.parse("localhost"));
    assertEquals(new ServerAddress("a.b", 27_960, 0), ServerAddress.parse(" a.b:27960 "));
    assertEquals(new ServerAddress("10.0.0.1", 1, 2), ServerAddress.parse("10.0.0.1:1/2"));
    assertEquals(new ServerAddress("::1", 54_555, 0), ServerAddress.parse("::1"));
    assertEquals(new ServerAddress("fe80::1", 7, 0), ServerAddress.parse("[fe80::1]:7"));
    assertEquals(new ServerAddress("::1", 54_555, 0), ServerAddress.parse("[::1]"));
  }

  @Test
  void theShortestTextGivesTheAddressBack() {
    for (String text : new String[] {"localhost", "a.b:7", "a:1/2", "[::1]", "[::1]:5/6"}) {
      ServerAddress address = ServerAddress.parse(text);
      assertEquals(text, address.toText());
      assertEquals(address, ServerAddress.parse(address.toText()));
    }
  }

  @Test
  void whatIsNoAddressIsExplained() {
    for (String text : new String[] {"", "  ", ":5", "two words", "http://a", "a,b"}) {
      assertTrue(problem(text).startsWith("Enter the server's name"), text + problem(text));
    }
    for (String text : new String[] {"a:", "a:x", "a:0", "a:65536", "a:1/", "a:1/2/3", "a:-1"}) {
      assertTrue(problem(text).contains("is no port"), text + problem(text));
    }
  }

  @Test
  void anAddressWithColonsAndAPortGetsTheHintOfBrackets() {
    for (String text : new String[] {"::1:22980", "fe80::1:54555", "1:2:3:4:5:6:7:8:99"}) {
      int colon = text.lastIndexOf(':');
      String hint = "[" + text.substring(0, colon) + "]" + text.substring(colon);
      assertTrue(problem(text).contains(hint), text + problem(text));
    }
    assertEquals(new ServerAddress("fe80::1:5", 54_555, 0), ServerAddress.parse("fe80::1:5"));
  }

  private static String problem(String text) {
    return assertThrows(IllegalArgumentException.class, () -> ServerAddress.parse(text), text)
        .getMessage();
  }
}
