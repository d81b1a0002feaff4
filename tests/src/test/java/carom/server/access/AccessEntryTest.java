package carom.server.access;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.AnyText;
import java.time.Instant;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Goal: lines of the lists mean what they say. */
final class AccessEntryTest {
  private static final Instant NOW = Instant.parse("2026-11-23T12:00:00Z");

  private static boolean covers(String line, String name, String remote) {
    byte[] address = AddressRange.addressOf(remote).orElse(null);
    return AccessEntry.parse(line).covers(name, "", address, NOW);
  }

  @Test
  void namesAreComparedAsPlayersSeeThem() {
    assertTrue(covers("name \"Bob B\"", "bob b", "in process"));
    assertTrue(covers("name Bob", "\uff22ob", "1.2.3.4:5"), "wide letters");
    assertFalse(covers("name Bob", "Bobby", "1.2.3.4:5"));
    assertFalse(covers("name Bob", null, "1.2.3.4:5"), "a spectator has no name");
  }

  @Test
  void accountsAreComparedExactly() {
    AccessEntry ban = AccessEntry.parse("account \"4711\" cheats");
    assertTrue(ban.covers("Bob", "4711", null, NOW));
    assertFalse(ban.covers("4711", "", null, NOW), "a name is no account");
    assertFalse(ban.covers("Bob", "47110", null, NOW));
    assertTrue(covers("name Admin", "\u0410dmin", "x"), "a name that looks alike");
  }

  @Test
  void addressesAndTheirNetworksAreCovered() {
    assertTrue(covers("address 203.0.113.7", null, "203.0.113.7:5000"));
    assertFalse(covers("address 203.0.113.7", "x", "203.0.113.8:5000"));
    assertTrue(covers("address 203.0.113.7/24", "x", "203.0.113.200:1"));
    assertFalse(covers("address 203.0.113.7/24", "x", "203.0.112.7:1"));
    assertTrue(covers("address 203.0.113.4/30", "x", "203.0.113.7:1"));
    assertFalse(covers("address 203.0.113.4/30", "x", "203.0.113.8:1"));
    assertTrue(covers("address 2001:db8::/32", "x", "[2001:db8:1:2:3:4:5:6]:9"));
    assertFalse(covers("address 2001:db8::/32", "x", "[2001:db9::1]:9"));
    assertFalse(covers("address 203.0.113.7", "x", "memory"));
    assertEquals("2001:db8:1:2:0:0:0:0/64", household("[2001:db8:1:2:3:4:5:6]:9"));
    assertEquals("203.0.113.7", household("203.0.113.7:1"));
  }

  private static String household(String remote) {
    return AddressRange.household(remote).orElseThrow().toString();
  }

  @Test
  void anEntryEndsAtItsTime() {
    assertTrue(covers("name Bob until 2026-11-23T12:00:01Z", "Bob", "x"));
    assertFalse(covers("name Bob until 2026-11-23T12:00:00Z", "Bob", "x"));
  }

  @Test
  void aQuoteThatIsNeverClosedMakesNoNameOfTheRest() {
    for (String line :
        List.of(
            "name \"Bob until 2026-12-01T00:00:00Z threats",
            "account \"4711 cheats",
            "address 203.0.113.7 of \"Bob until 2026-12-01T00:00:00Z")) {
      Exception e = assertThrows(IllegalArgumentException.class, () -> AccessEntry.parse(line));
      assertTrue(e.getMessage().startsWith("a quote is opened and never closed"), line);
    }
    assertTrue(covers("name Bob a 5\" nail", "Bob", "x"), "a quote in the reason does no harm");
  }

  @Test
  void aMistypedAddressIsKnownAsOne() {
    for (String text :
        List.of("300.1.2.3", "10.0.0.0/99", "1.2.3", "10.0.0.0/x", "2001:db8::/200")) {
      assertTrue(AddressRange.isMeant(text) && AddressRange.parse(text).isEmpty(), text);
    }
    for (String name : List.of("Bob", "7", "v1.2", "a:b", ":)", "a/b", "Bob 1.2", "-.-")) {
      assertFalse(AddressRange.isMeant(name), name);
    }
  }

  @Test
  void linesAreWrittenAsTheyAreRead() {
    for (String line :
        List.of(
            "name \"Bob B\"",
            "name \"Bob\" until 2026-12-01T00:00:00Z threats in chat",
            "address 203.0.113.0/24 flood")) {
      assertEquals(line, AccessEntry.parse(line).line());
      assertEquals(AccessEntry.parse(line), AccessEntry.parse(AccessEntry.parse(line).line()));
    }
  }

  @Test
  void anyNameAccountAndReasonIsReadBackAsItWas() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    Random random = new Random(seed);
    for (int i = 0; i < 20_000; i++) {
      String name = AnyText.of(random);
      String reason = AnyText.of(random).strip();
      Instant until = random.nextBoolean() ? NOW : null;
      AddressRange range = AddressRange.parse("203.0.113.0/24").orElseThrow();
      AccessEntry entry =
          switch (random.nextInt(4)) {
            case 0 -> new AccessEntry(null, name, null, until, reason);
            case 1 -> new AccessEntry(null, null, name, until, reason);
            case 2 -> new AccessEntry(range, null, null, until, reason);
            default -> new AccessEntry(range, name, null, until, reason);
          };
      assertEquals(
          entry, AccessEntry.parse(entry.line()), () -> "seed=" + seed + " " + entry.line());
    }
  }

  @Test
  void anEntryNeverTakesTwoLines() {
    for (String end : List.of("\n", "\r", "\r\n")) {
      String text = "Bob" + end + "name \"Ann\"";
      assertThrows(
          IllegalArgumentException.class, () -> new AccessEntry(null, text, null, null, ""));
      assertThrows(
          IllegalArgumentException.class, () -> new AccessEntry(null, "Bob", null, null, text));
    }
  }

  @Test
  void linesThatMeanNothingSayWhatIsWrong() {
    for (String line :
        List.of(
            "Bob",
            "name",
            "address host.example",
            "address 1.2.3",
            "address 1.2.3.4/33",
            "address 1.2.3.4/0",
            "address 1.2.3.4/x",
            "address 1.2.3.999",
            "name Bob until tomorrow",
            "name Bob until")) {
      IllegalArgumentException e =
          assertThrows(IllegalArgumentException.class, () -> AccessEntry.parse(line), line);
      assertTrue(e.getMessage().contains(" such as ") || e.getMessage().contains("look like"));
    }
  }
}
