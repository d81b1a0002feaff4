package carom.net.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class ClientMessageCodecTest {

  private static final List<ClientMessage> MESSAGES =
      List.of(
          new ClientMessage.Hello(1, 0x0123456789abcdefL, "Zoë", -1),
          new ClientMessage.Hello(Integer.MIN_VALUE, 0, "", 0),
          new ClientMessage.Hello(1, 2, "x", 3, "cup", "arena", "trio", "ab.c_d.e-f"),
          new ClientMessage.Password("pässwörd of twelve"),
          new ClientMessage.ListRooms(-9),
          new ClientMessage.ChangeRoom("a-room.with_32_bytes.............".substring(0, 32)),
          new ClientMessage.LevelRequest(7, 0),
          new ClientMessage.LevelRequest(7, ProtocolLimits.MAX_LEVEL_BYTES - 1),
          new ClientMessage.Ready(7, 5),
          new ClientMessage.Leave());

  @Test
  void messagesComeBack() {
    for (ClientMessage message : MESSAGES) {
      byte[] bytes = ClientMessageCodec.encode(message);
      assertEquals(message, ClientMessageCodec.decode(bytes, 0, bytes.length));
      byte[] shifted = new byte[ProtocolLimits.MAX_CLIENT_MESSAGE_BYTES + 3];
      assertEquals(bytes.length, ClientMessageCodec.encode(message, shifted, 3));
      assertEquals(message, ClientMessageCodec.decode(shifted, 3, bytes.length));
    }
  }

  @Test
  void cutOrLengthenedMessagesAreNone() {
    for (ClientMessage message : MESSAGES) {
      byte[] bytes = ClientMessageCodec.encode(message);
      for (int length = 0; length < bytes.length; length++) {
        assertNull(ClientMessageCodec.decode(bytes, 0, length), message + " cut at " + length);
      }
      byte[] longer = Arrays.copyOf(bytes, bytes.length + 1);
      assertNull(ClientMessageCodec.decode(longer, 0, longer.length), message + " lengthened");
    }
  }

  @Test
  void fieldsOutsideTheirLimitsAreRefusedBothWays() {
    String tooLong = "x".repeat(ProtocolLimits.MAX_NAME_BYTES + 1);
    assertThrows(
        IllegalArgumentException.class,
        () -> ClientMessageCodec.encode(new ClientMessage.Hello(1, 2, tooLong, 3)));
    assertThrows(
        IllegalArgumentException.class,
        () -> ClientMessageCodec.encode(new ClientMessage.ChangeRoom(tooLong)));
    assertNull(ClientMessageCodec.decode(new byte[] {13, 0}, 0, 2), "a room without a name");
    byte[] longRoom = new byte[35];
    longRoom[0] = 13;
    longRoom[1] = 33;
    assertNull(ClientMessageCodec.decode(longRoom, 0, 35), "the name of a room with 33 bytes");
    for (int offset : new int[] {-1, ProtocolLimits.MAX_LEVEL_BYTES}) {
      assertThrows(
          IllegalArgumentException.class,
          () -> ClientMessageCodec.encode(new ClientMessage.LevelRequest(7, offset)));
      byte[] bytes = {
        2, (byte) (offset >> 24), (byte) (offset >> 16), (byte) (offset >> 8), (byte) offset
      };
      assertNull(ClientMessageCodec.decode(bytes, 0, 5));
    }
    byte[] hello = ClientMessageCodec.encode(new ClientMessage.Hello(1, 2, "abcd", 3));
    hello[hello.length - 6] = (byte) 0xff;
    assertNull(ClientMessageCodec.decode(hello, 0, hello.length), "a name that is no UTF-8");
    assertNull(ClientMessageCodec.decode(new byte[] {0}, 0, 1), "unknown tag 0");
    assertNull(ClientMessageCodec.decode(new byte[] {5}, 0, 1), "a look at nothing");
    assertNull(ClientMessageCodec.decode(new byte[] {7}, 0, 1), "unknown tag 7");
    byte[] report = new byte[56];
    report[0] = 6;
    assertNull(ClientMessageCodec.decode(report, 0, 56), "equal at the tick that differs");
    report[4] = 1;
    assertNotNull(ClientMessageCodec.decode(report, 0, 56));
    assertNull(ClientMessageCodec.decode(report, 0, 55));
    report[5] = (byte) 0x80;
    assertNull(ClientMessageCodec.decode(report, 0, 56), "a negative tick");
  }

  @Test
  void aReportOfWhatIsNearHasOneToThirtyOneWholeBodies() {
    for (int bodies = 0; bodies <= 32; bodies++) {
      byte[] report = new byte[9 + 32 * bodies];
      report[0] = 9;
      report[4] = 1;
      boolean right = bodies >= 1 && bodies <= 31;
      assertEquals(right, ClientMessageCodec.decode(report, 0, report.length) != null);
      assertNull(ClientMessageCodec.decode(report, 0, report.length - 1), "bodies=" + bodies);
      if (right) {
        ClientMessage message = ClientMessageCodec.decode(report, 0, report.length);
        assertTrue(Arrays.equals(report, ClientMessageCodec.encode(message)));
        report[4] = 0;
        assertNull(ClientMessageCodec.decode(report, 0, report.length), "equal at that tick");
      }
    }
  }

  @Test
  void noBytesThrow() {
    long seed = 5;
    Random random = new Random(seed);
    for (int i = 0; i < 200_000; i++) {
      byte[] bytes = new byte[random.nextInt(70)];
      random.nextBytes(bytes);
      if (bytes.length > 0) {
        bytes[0] = (byte) random.nextInt(10);
      }
      if (bytes.length > 22) {
        bytes[21] = (byte) (bytes.length - 22 + random.nextInt(2));
      }
      ClientMessage message = ClientMessageCodec.decode(bytes, 0, bytes.length);
      if (message != null) {
        byte[] again = ClientMessageCodec.encode(message);
        assertTrue(Arrays.equals(bytes, again), "one form per message, seed=" + seed);
      }
    }
  }

  @Test
  void namesThatCanBeShownAreFine() {
    for (String name : List.of("a", "Zoë", "日本", "two words", "x".repeat(32), "🎱", "e\u0301a")) {
      assertNull(PlayerName.problem(name), name);
    }
    for (String name :
        List.of(
            "",
            " a",
            "a ",
            "a\nb",
            "a\u0000",
            "\u202eabc",
            "\ud800",
            "x".repeat(33),
            "\u2028",
            "\u00a0",
            "Ann\u00a0",
            "\u3164",
            "\u2800",
            "\ufe0f",
            "\u0301",
            "a\u0301\u0301\u0301\u0301")) {
      assertTrue(PlayerName.problem(name) != null, "refused: " + name);
    }
  }

  @Test
  void reasonsSpeakToPlayers() {
    for (RefusalReason reason : RefusalReason.values()) {
      assertTrue(reason.playerText().endsWith(".") || reason.playerText().endsWith("?"));
    }
    for (GoodbyeReason reason : GoodbyeReason.values()) {
      assertTrue(reason.playerText().endsWith("."), reason.name());
    }
    assertTrue(GoodbyeReason.TIMEOUT.retryUseful());
    assertTrue(!GoodbyeReason.KICKED.retryUseful());
  }

  @Test
  void illegalTransitionsAreBugs() {
    assertEquals(SessionState.LOADING, SessionState.CONNECTED.become(SessionState.LOADING));
    assertThrows(
        IllegalStateException.class, () -> SessionState.CLOSED.become(SessionState.PLAYING));
  }
}
