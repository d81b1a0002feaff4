package carom.net.kryo;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.ServerMessage.RosterEntry;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class KryoMessageCodecTest {
  private final KryoMessageCodec codec = new KryoMessageCodec();

  static List<Object> everyMessage() {
    List<RosterEntry> full = new ArrayList<>();
    for (int i = 0; i < ProtocolLimits.MAX_ROSTER_ENTRIES; i++) {
      full.add(
          new RosterEntry(
              i,
              "x".repeat(ProtocolLimits.MAX_NAME_BYTES),
              Integer.MIN_VALUE + i,
              Integer.MIN_VALUE + i,
              true,
              true,
              true,
              RosterEntry.MAX_PING_MS,
              RosterEntry.MAX_COLOUR));
    }
    byte[] chunk = new byte[ProtocolLimits.MAX_LEVEL_CHUNK_BYTES];
    Arrays.fill(chunk, (byte) 0xa5);
    return List.of(
        new ServerMessage.Welcome(
            -2,
            4,
            255,
            240,
            "cup",
            9,
            Long.MAX_VALUE,
            -5,
            70,
            77,
            Long.MIN_VALUE,
            "arena",
            "arena.json",
            42,
            12_345,
            678,
            -9,
            -11,
            true,
            List.of("player.ammo count 0..30 to OWNER", "")),
        new ServerMessage.LevelChunk(4_096, chunk),
        new ServerMessage.Refused(RefusalReason.NAME_INVALID, "Ünal is no name"),
        new ServerMessage.Roster(List.of()),
        new ServerMessage.Roster(full),
        new ServerMessage.Notice("x".repeat(ProtocolLimits.MAX_TEXT_BYTES)),
        new ServerMessage.Goodbye(GoodbyeReason.SERVER_STOPPING, ""),
        new ServerMessage.Redirect(
            "x".repeat(ProtocolLimits.MAX_ADDRESS_BYTES),
            "f".repeat(ProtocolLimits.MAX_FINGERPRINT_BYTES),
            "cup",
            "t".repeat(ProtocolLimits.MAX_TOKEN_BYTES)),
        new ServerMessage.Redirect("b.example.org:1", "", "", ""),
        new ServerMessage.Fleet(List.of(), ""),
        new ServerMessage.Fleet(
            Collections.nCopies(
                ProtocolLimits.MAX_FLEET_SERVERS, "x".repeat(ProtocolLimits.MAX_ADDRESS_BYTES)),
            "b.example.org:1"),
        new ServerMessage.Move("b.example.org:1", "f", "cup", "ticket.t"),
        new ServerMessage.Watching(65_535),
        new ServerMessage.RecordingChunk(Long.MAX_VALUE, chunk),
        new ServerMessage.RecordingChunk(0, new byte[0]),
        new ServerMessage.RoomList(0, List.of()),
        new ServerMessage.RoomList(
            48, Collections.nCopies(ProtocolLimits.MAX_LISTED_ROOMS, largestRoom())),
        new ServerMessage.BestLists(List.of()),
        new ServerMessage.BestLists(
            Collections.nCopies(ProtocolLimits.MAX_BEST_LISTS, largestBestList())),
        new ClientMessage.ListBest(),
        new ServerMessage.LevelAnswer(
            ProtocolLimits.MAX_OFFERED_BYTES, ServerMessage.LevelOutcome.NOT_TAKEN, "no"),
        new ServerMessage.LevelList(
            9,
            true,
            Collections.nCopies(
                ProtocolLimits.MAX_LISTED_LEVELS,
                new ServerMessage.LevelEntry(
                    "n".repeat(ProtocolLimits.MAX_NAME_BYTES),
                    "g".repeat(ProtocolLimits.MAX_GAME_NAME_BYTES),
                    "a".repeat(ProtocolLimits.MAX_NAME_BYTES),
                    ProtocolLimits.MAX_PLAYERS,
                    false))),
        new ClientMessage.OfferLevel(1, 1, ProtocolLimits.MAX_OFFERED_BYTES, "Ünal", "token"),
        new ClientMessage.ListLevels(),
        new ClientMessage.ChooseLevel(""),
        new ClientMessage.Watch(1, -5, 255),
        new ClientMessage.RecordingRequest(Long.MAX_VALUE),
        new ClientMessage.Hello(1, -5, "Ünal", 99),
        new ClientMessage.LevelRequest(7, 1_000),
        new ClientMessage.Ready(7, 5, -6),
        new ClientMessage.Standby(1, -5, 99, "cup"),
        new ClientMessage.Leave(),
        new ClientMessage.Look(1.5f, -2, 0, 1e30f, ClientMessage.Look.NOBODY));
  }

  private static ServerMessage.BestList largestBestList() {
    ServerMessage.BestEntry entry =
        new ServerMessage.BestEntry(
            "n".repeat(ProtocolLimits.MAX_NAME_BYTES),
            "v".repeat(ProtocolLimits.MAX_BEST_VALUE_BYTES));
    return new ServerMessage.BestList(
        "f".repeat(ProtocolLimits.MAX_FIELD_NAME_BYTES),
        ProtocolLimits.MAX_BEST_ENTRIES - 1,
        Collections.nCopies(ProtocolLimits.MAX_BEST_ENTRIES, entry));
  }

  private static ServerMessage.RoomEntry largestRoom() {
    Map<String, String> metadata = new LinkedHashMap<>();
    for (int i = 0; i < ProtocolLimits.MAX_ROOM_METADATA; i++) {
      metadata.put("k".repeat(ProtocolLimits.MAX_METADATA_KEY_BYTES - 1) + i, "v".repeat(48));
    }
    return new ServerMessage.RoomEntry(
        "r".repeat(ProtocolLimits.MAX_ROOM_NAME_BYTES),
        "g".repeat(ProtocolLimits.MAX_GAME_NAME_BYTES),
        "l".repeat(ProtocolLimits.MAX_LEVEL_NAME_BYTES),
        "p".repeat(ProtocolLimits.MAX_PHASE_BYTES),
        ProtocolLimits.MAX_PLAYERS,
        ProtocolLimits.MAX_PLAYERS,
        0xffff,
        metadata);
  }

  @Test
  void everyMessageSurvivesTheRoundTripAnywhereInAnArray() {
    for (Object message : everyMessage()) {
      byte[] bytes = codec.encode(message);
      byte[] around = new byte[bytes.length + 20];
      System.arraycopy(bytes, 0, around, 7, bytes.length);
      assertEquals(message, codec.decode(around, 7, bytes.length));
    }
  }

  @Test
  void truncatedOrPaddedMessagesAreNoMessagesAndTheBytesStayAsTheyAre() {
    for (Object message : everyMessage()) {
      byte[] bytes = codec.encode(message);
      byte[] padded = Arrays.copyOf(bytes, bytes.length + 1);
      byte[] before = padded.clone();
      int step = Math.max(1, bytes.length / 500);
      for (int length = 0; length < bytes.length; length += step) {
        assertNull(codec.decode(padded, 0, length), message + " cut to length=" + length);
      }
      assertNull(codec.decode(padded, 0, padded.length), () -> message + " with a byte more");
      assertArrayEquals(before, padded);
    }
  }

  @Test
  void aPieceOfALevelLiesWithinTheLargestOne() {
    int last = ProtocolLimits.MAX_OFFERED_BYTES - ProtocolLimits.MAX_LEVEL_PIECE_BYTES;
    Object piece =
        new ClientMessage.LevelPiece(last, new byte[ProtocolLimits.MAX_LEVEL_PIECE_BYTES]);
    byte[] bytes = codec.encode(piece);
    assertEquals(piece, codec.decode(bytes, 0, bytes.length));
    assertNull(codec.decode(bytes, 0, 5), "no byte");
    assertNull(codec.decode(Arrays.copyOf(bytes, bytes.length + 1), 0, bytes.length + 1));
    bytes[4]++; // the offset's last byte
    assertNull(codec.decode(bytes, 0, bytes.length), "beyond the largest level");
  }

  @Test
  void theBytesOnTheWireAreTheseAndNoOthers() {
    HexFormat hex = HexFormat.of();
    assertEquals(
        "40" // class
            + "feffffffffffffff" // sessionSecret
            + "04" // epoch
            + "ff01" // playerId
            + "f0" // tickRate
            + "03637570" // room
            + "09" // match
            + "ffffffffffffff7f" // claim
            + "fbffffff46000000" // incarnation, course tick
            + "4d000000" // tick
            + "0000000000000080" // seed
            + "056172656e61" // game
            + "0a6172656e612e6a736f6e" // levelName
            + "2a00000000000000" // levelHash
            + "b960" // levelSize
            + "a605" // packedSize
            + "f7ffffffffffffff" // declarationsDigest
            + "f5ffffffffffffff01" // gameDigest, takesAnyCode
            + "0220706c617965722e616d6d6f20636f756e7420302e2e333020746f204f574e455200", // fields
        hex.formatHex(codec.encode(everyMessage().get(0))));
    assertEquals(
        "4180200201ff",
        hex.formatHex(codec.encode(new ServerMessage.LevelChunk(4_096, new byte[] {1, -1}))));
    assertEquals(
        "4203026f6b",
        hex.formatHex(codec.encode(new ServerMessage.Refused(RefusalReason.NAME_INVALID, "ok"))));
    assertEquals(
        "43010502416204020dc801",
        hex.formatHex(
            codec.encode(
                new ServerMessage.Roster(
                    List.of(new RosterEntry(5, "Ab", 1, -7, false, false, true, 200, 0))))));
    assertEquals("440148", hex.formatHex(codec.encode(new ServerMessage.Notice("H"))));
    assertEquals(
        "450000", hex.formatHex(codec.encode(new ServerMessage.Goodbye(GoodbyeReason.LEFT, ""))));
  }

  @Test
  void noTextBringsWhatWouldChangeATerminalOrOtherTexts() {
    String evil = "a\u001b[2Jb\u202ec\u0007\nd";
    String clean = "a[2Jbc d";
    assertEquals(new ServerMessage.Notice(clean), again(new ServerMessage.Notice(evil)));
    assertEquals(
        new ServerMessage.Goodbye(GoodbyeReason.KICKED, clean),
        again(new ServerMessage.Goodbye(GoodbyeReason.KICKED, evil)));
    RosterEntry row = new RosterEntry(5, evil, 1, -7, false, false, true, 200, 0);
    ServerMessage.Roster roster =
        (ServerMessage.Roster) again(new ServerMessage.Roster(List.of(row)));
    assertEquals(clean, roster.entries().get(0).name());
  }

  private Object again(ServerMessage message) {
    byte[] bytes = codec.encode(message);
    return codec.decode(bytes, 0, bytes.length);
  }

  @Test
  void writingAssertsTheLimitsByName() {
    List<Object> wrong =
        List.of(
            new ServerMessage.Notice("x".repeat(ProtocolLimits.MAX_TEXT_BYTES + 1)),
            new ServerMessage.LevelChunk(0, new byte[0]),
            new ServerMessage.Watching(0),
            new ServerMessage.RecordingChunk(-1, new byte[1]),
            new ServerMessage.RecordingChunk(0, new byte[ProtocolLimits.MAX_LEVEL_CHUNK_BYTES + 1]),
            new ClientMessage.Watch(1, 2, 0),
            new ClientMessage.LevelRequest(8, 0),
            new ClientMessage.Ready(-1, 0),
            new ClientMessage.RecordingRequest(-1),
            new ServerMessage.LevelChunk(-1, new byte[1]),
            new ServerMessage.Welcome(
                1,
                1,
                ProtocolLimits.MAX_PLAYERS,
                60,
                "r",
                1,
                0,
                0,
                0,
                0,
                0,
                "g",
                "l",
                0,
                0,
                0,
                0,
                0,
                false,
                List.of()),
            new ServerMessage.Welcome(
                1, 8, 1, 60, "r", 1, 0, 0, 0, 0, 0, "g", "l", 0, 0, 0, 0, 0, false, List.of()),
            new ServerMessage.Welcome(
                1, 1, 1, 0, "r", 1, 0, 0, 0, 0, 0, "g", "l", 0, 0, 0, 0, 0, false, List.of()),
            new ServerMessage.Welcome(
                1,
                1,
                1,
                60,
                "r",
                1,
                0,
                0,
                0,
                0,
                0,
                "g",
                "l",
                0,
                0,
                0,
                0,
                0,
                false,
                List.of("x".repeat(101))),
            "no message");
    for (Object message : wrong) {
      IllegalArgumentException x =
          assertThrows(IllegalArgumentException.class, () -> codec.encode(message));
      assertTrue(x.getMessage().contains("="), x.getMessage());
    }
    Object right = everyMessage().get(0); // works as before after that
    byte[] bytes = codec.encode(right);
    assertEquals(right, codec.decode(bytes, 0, bytes.length));
  }

  @Test
  void hostileBytesNeverThrowAndNeverAllocateMuch() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    SplittableRandom random = new SplittableRandom(seed);
    List<byte[]> samples = new ArrayList<>();
    for (Object message : everyMessage()) {
      samples.add(codec.encode(message));
    }
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    long most = 0;
    for (int i = 0; i < 20_000; i++) {
      byte[] bytes = samples.get(random.nextInt(samples.size())).clone();
      int length = Math.min(bytes.length, 1 + random.nextInt(200));
      int changes = 1 + random.nextInt(6);
      for (int c = 0; c < changes; c++) {
        bytes[random.nextInt(length)] = (byte) random.nextInt(256);
      }
      long before = threads.getCurrentThreadAllocatedBytes();
      try {
        codec.decode(bytes, 0, length);
      } catch (RuntimeException x) {
        throw new AssertionError("seed=" + seed + " i=" + i, x);
      }
      most = Math.max(most, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertTrue(most < 200_000, "allocated=" + most + " seed=" + seed);
  }
}
