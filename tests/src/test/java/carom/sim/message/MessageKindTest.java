package carom.sim.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.message.MessageKind.Direction;
import carom.text.Texts;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Goal: a message that a game declared survives the wire, and whatever else a peer sends is
 * refused. Method: values at the ends of their ranges, bytes that are changed one by one, and
 * random ones.
 */
final class MessageKindTest {
  private enum Mood {
    GOOD,
    BAD
  }

  private static final MessageKind ALL =
      MessageKind.named("all")
          .count("wide", Integer.MIN_VALUE, Integer.MAX_VALUE)
          .count("narrow", -3, 300)
          .flag("flag")
          .real("real", -1.5f, 1e9f)
          .choice("mood", Mood.class)
          .text("text", 20);
  private static final MessageKind UP = MessageKind.named("up").fromClient().count("n", 0, 9);
  private static final MessageKind DOWN = MessageKind.named("down").fromServer();

  private final MessageKinds kinds = new MessageKinds();

  MessageKindTest() {
    kinds.add(ALL);
    kinds.add(UP);
    kinds.add(DOWN);
    kinds.close();
  }

  private Message decode(byte[] bytes, Direction from) {
    return kinds.decode(bytes, 0, bytes.length, from);
  }

  @Test
  void valuesAtTheEndsOfTheirRangesArriveAsTheyWereSent() {
    Object[][] rows = {
      {Integer.MIN_VALUE, -3, false, -1.5f, Mood.GOOD, ""},
      {Integer.MAX_VALUE, 300, true, 1e9f, Mood.BAD, "Zoë 愛 \ud83d\ude00 abcdefgh"},
      {0, 0, true, 0.25f, Mood.BAD, "€".repeat(20)},
    };
    for (Object[] row : rows) {
      byte[] bytes = kinds.encode(ALL.of(row), Direction.FROM_SERVER);
      assertTrue(bytes.length <= ALL.maxBytes(), "bytes=" + bytes.length);
      Message m = decode(bytes, Direction.FROM_SERVER);
      assertTrue(m.is(ALL));
      assertEquals(row[0], m.count("wide"));
      assertEquals(row[1], m.count("narrow"));
      assertEquals(row[2], m.flag("flag"));
      assertEquals(row[3], m.real("real"));
      assertEquals(row[4], m.choice("mood", Mood.class));
      assertEquals(row[5], m.text("text"));
    }
  }

  @Test
  void aMessageFromTheWrongSideIsRefused() {
    byte[] up = kinds.encode(UP.of(3), Direction.FROM_CLIENT);
    byte[] down = kinds.encode(DOWN.of(), Direction.FROM_SERVER);
    assertNull(decode(up, Direction.FROM_SERVER));
    assertNull(decode(down, Direction.FROM_CLIENT));
    assertEquals(3, decode(up, Direction.FROM_CLIENT).count("n"));
    assertThrows(
        IllegalArgumentException.class, () -> kinds.encode(UP.of(3), Direction.FROM_SERVER));
  }

  @Test
  void whateverBytesArriveTheMessageIsWithinItsDeclarationOrRefused() {
    long seed = 7;
    Random random = new Random(seed);
    byte[] valid = kinds.encode(ALL.of(5, 6, true, 7f, Mood.BAD, "hello"), Direction.FROM_CLIENT);
    int accepted = 0;
    for (int i = 0; i < 200_000; i++) {
      byte[] bytes =
          random.nextBoolean()
              ? Arrays.copyOf(valid, random.nextInt(valid.length + 3))
              : new byte[random.nextInt(40)];
      for (int n = random.nextInt(4); n >= 0 && bytes.length > 0; n--) {
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
      }
      Message m = decode(bytes, Direction.FROM_CLIENT);
      if (m != null) {
        accepted++;
        // What was accepted is a message that the kind itself would make.
        byte[] again = kinds.encode(m, Direction.FROM_CLIENT);
        assertEquals(m.toString(), decode(again, Direction.FROM_CLIENT).toString());
        if (m.is(ALL)) {
          int narrow = m.count("narrow");
          assertTrue(narrow >= -3 && narrow <= 300, "seed=" + seed + " " + m);
          assertTrue(m.real("real") >= -1.5f && m.real("real") <= 1e9f, "seed=" + seed + " " + m);
          assertTrue(m.text("text").length() <= 20, "seed=" + seed + " " + m);
        }
      }
    }
    assertTrue(accepted > 1_000, "seed=" + seed + " accepted=" + accepted);
  }

  @Test
  void textThatIsNoUtf8OrTooLongIsRefused() {
    MessageKind note = MessageKind.named("note").text("t", 4);
    MessageKinds of = new MessageKinds();
    of.add(note);
    byte[] bytes = of.encode(note.of("abcd"), Direction.FROM_CLIENT);
    bytes[2] = (byte) 0xc3; // a lead byte without its second
    assertNull(of.decode(bytes, 0, bytes.length, Direction.FROM_CLIENT));
    byte[] five = {bytes[0], 5, 'a', 'b', 'c', 'd', 'e'};
    assertNull(of.decode(five, 0, five.length, Direction.FROM_CLIENT));
    five[1] = 4;
    assertNull(of.decode(five, 0, five.length, Direction.FROM_CLIENT), "bytes are left over");
    assertEquals("abcd", of.decode(five, 0, 6, Direction.FROM_CLIENT).text("t"));
  }

  @Test
  void textsLoseWhatCannotBeShown() {
    assertEquals("ab c", Texts.clean("a\u0000b\nc"));
    assertEquals("evil", Texts.clean("\u202eevil\u200b"));
    assertEquals("\ud83d\ude00", Texts.clean("\ud83d\ude00\ud83d"));
    assertEquals("e\u0301\u0301\u0301", Texts.clean("e" + "\u0301".repeat(30)));
    String plain = "as it was: 愛";
    assertEquals(plain, Texts.clean(plain));
    byte[] hostile = "\u202ex".getBytes(StandardCharsets.UTF_8);
    byte[] bytes = kinds.encode(ALL.of(1, 1, true, 1f, Mood.BAD, "xxxx"), Direction.FROM_CLIENT);
    System.arraycopy(hostile, 0, bytes, bytes.length - 4, 4);
    Message m = decode(bytes, Direction.FROM_CLIENT);
    assertEquals("\u202ex", m.text("text"));
    assertEquals("x", m.cleaned().text("text"));
  }

  @Test
  void mistakesOfTheDeveloperNameTheArgumentAndItsRange() {
    String wrong = assertThrows(IllegalArgumentException.class, () -> UP.of(10)).getMessage();
    assertEquals("message kind up can't take n=10; it is n count 0..9", wrong);
    assertThrows(IllegalArgumentException.class, () -> UP.of());
    assertThrows(IllegalArgumentException.class, () -> UP.of("3"));
    assertThrows(IllegalArgumentException.class, () -> UP.of(3).text("n"));
    assertThrows(IllegalArgumentException.class, () -> UP.of(3).count("m"));
    assertThrows(IllegalArgumentException.class, () -> UP.count("n", 0, 1));
    assertThrows(IllegalArgumentException.class, () -> UP.text("t", 200).text("u", 200));
    assertThrows(IllegalArgumentException.class, () -> UP.text("t", 150).unreliable());
    assertThrows(IllegalStateException.class, () -> kinds.add(MessageKind.named("late")));
    MessageKinds open = new MessageKinds();
    open.add(UP);
    assertThrows(IllegalArgumentException.class, () -> open.add(MessageKind.named("up")));
    assertThrows(IllegalArgumentException.class, () -> open.indexOf(DOWN));
  }

  @Test
  void theDigestNamesKindsArgumentsAndOrder() {
    long all = digest(UP, DOWN);
    assertEquals(all, digest(UP, DOWN));
    assertNotEquals(all, digest(DOWN, UP));
    assertNotEquals(all, digest(UP));
    assertNotEquals(digest(UP), digest(MessageKind.named("up").fromClient().count("n", 0, 8)));
    assertNotEquals(digest(UP), digest(UP.unreliable()));
  }

  private static long digest(MessageKind... all) {
    MessageKinds of = new MessageKinds();
    for (MessageKind kind : all) {
      of.add(kind);
    }
    return of.digest();
  }

  @Test
  void aClientThatKeepsToItsOwnRateIsNeverHeldBackByTheServer() {
    MessageKind quick = MessageKind.named("quick").atMost(10);
    MessageKinds of = new MessageKinds();
    of.add(quick);
    MessageRates client = MessageRates.ofClient(of);
    MessageRates server = MessageRates.ofServer(of);
    int sent = 0;
    for (int ms = 0; ms < 10_000; ms += 10) {
      if (client.take(quick, ms / 1e3)) {
        sent++;
        int deliveries = ms / 500; // the network delivers twice a second
        double late = deliveries * 0.5 + 0.5;
        assertTrue(server.take(quick, late), "ms=" + ms);
      }
    }
    assertTrue(sent >= 100 && sent <= 111, "sent=" + sent);
    MessageRates flooded = MessageRates.ofServer(of);
    int taken = 0;
    for (int ms = 0; ms < 10_000; ms++) {
      taken += flooded.take(quick, ms / 1e3) ? 1 : 0;
    }
    assertTrue(taken >= 100 && taken <= 121, "taken=" + taken);
    assertFalse(flooded.take(quick, 9.999));
  }
}
