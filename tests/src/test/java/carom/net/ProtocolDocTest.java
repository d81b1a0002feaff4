package carom.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.ClientMessageCodec;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.InputDatagram;
import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.snapshot.BaselineReason;
import carom.net.snapshot.DecodeStatus;
import carom.net.snapshot.Deltas;
import carom.net.snapshot.InputFeedback;
import carom.net.snapshot.Interest;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.EventRecord;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.table.RowAudience;
import carom.net.snapshot.table.Table;
import carom.net.snapshot.table.TableInbox;
import carom.net.snapshot.table.TableLayout;
import carom.net.snapshot.table.Tables;
import carom.physics.rows.BodyRow;
import carom.physics.rows.ContactRow;
import carom.physics.rows.RowCounts;
import carom.physics.rows.RowKind;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.MessageKind.Direction;
import carom.sim.message.MessageKinds;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Field;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/**
 * Goal: the pages of {@code docs/protocol} and the code say the same. Method: they are parsed and
 * compared.
 */
class ProtocolDocTest {

  private static final Pattern GOLDEN = Pattern.compile("(?ms)^```golden (\\S+)$(.*?)^```$");

  /** The pages of the protocol. */
  private static final List<String> PAGES =
      List.of(
          "README", "LINK", "SESSIONS", "MESSAGES", "DATAGRAMS", "EXACT", "CODING", "REPLICATION");

  private final String page = read();

  /** Returns all pages, one after the other. */
  private static String read() {
    StringBuilder text = new StringBuilder();
    for (String name : PAGES) {
      try {
        text.append(Files.readString(Path.of("..", "docs", "protocol", name + ".md")));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
    return text.toString();
  }

  private Map<String, byte[]> goldenOfThePage() {
    Map<String, byte[]> golden = new TreeMap<>();
    Matcher matcher = GOLDEN.matcher(page);
    while (matcher.find()) {
      String[] hex = matcher.group(2).trim().split("\\s+", -1);
      byte[] bytes = new byte[hex.length];
      for (int i = 0; i < hex.length; i++) {
        bytes[i] = (byte) Integer.parseInt(hex[i], 16);
      }
      golden.put(matcher.group(1), bytes);
    }
    return golden;
  }

  /** The rows of the table whose head begins like this, as cells. */
  private List<List<String>> table(String head) {
    int at = page.indexOf("\n" + head);
    assertTrue(at >= 0, "no table " + head);
    List<List<String>> rows = new ArrayList<>();
    for (String line : page.substring(at + 1).split("\n", -1)) {
      if (!line.startsWith("|")) {
        break;
      }
      rows.add(Arrays.stream(line.substring(1).split("\\|")).map(String::trim).toList());
    }
    return rows.subList(2, rows.size());
  }

  private static Map<String, byte[]> goldenOfTheCode() {
    Map<String, byte[]> golden = new TreeMap<>();
    golden.put("list-rooms", ClientMessageCodec.encode(new ClientMessage.ListRooms(9)));
    golden.put("list-best", ClientMessageCodec.encode(new ClientMessage.ListBest()));
    golden.put(
        "offer-level",
        ClientMessageCodec.encode(new ClientMessage.OfferLevel(9, 6421, 1800, "Zoë", "t")));
    golden.put(
        "level-piece",
        ClientMessageCodec.encode(new ClientMessage.LevelPiece(1000, new byte[] {0x7b, 0x7d})));
    golden.put("list-levels", ClientMessageCodec.encode(new ClientMessage.ListLevels()));
    golden.put("choose-level", ClientMessageCodec.encode(new ClientMessage.ChooseLevel("Hill")));
    golden.put("change-room", ClientMessageCodec.encode(new ClientMessage.ChangeRoom("cup")));
    golden.put(
        "hello",
        ClientMessageCodec.encode(
            new ClientMessage.Hello(2, 0x0102030405060708L, "Zoë", 0, "cup", "", "trio", "")));
    golden.put("level-request", ClientMessageCodec.encode(new ClientMessage.LevelRequest(3, 4096)));
    golden.put(
        "ready", ClientMessageCodec.encode(new ClientMessage.Ready(3, 0x0102030405060708L, 9)));
    golden.put("leave", ClientMessageCodec.encode(new ClientMessage.Leave()));
    golden.put(
        "diverged",
        ClientMessageCodec.encode(
            new ClientMessage.Diverged(
                1000,
                998,
                false,
                List.of(65_534 | 255 << 16, 1, 2, 3, 4, 5, 6, 7),
                List.of(8, 9, 10, 11))));
    golden.put(
        "diverged-near",
        ClientMessageCodec.encode(
            new ClientMessage.Diverged(
                1000, 998, true, List.of(65_538, 1, 2, 3, 4, 5, 6, 7), List.of())));
    golden.put("look", ClientMessageCodec.encode(new ClientMessage.Look(-1.5f, 2, 16, 9, 7)));
    golden.put(
        "watch", ClientMessageCodec.encode(new ClientMessage.Watch(2, 0x0102030405060708L, 2)));
    golden.put(
        "recording-request", ClientMessageCodec.encode(new ClientMessage.RecordingRequest(4096)));
    golden.put(
        "game-message",
        ClientMessageCodec.encode(
            new ClientMessage.GameMessage(
                1,
                new MessageKinds()
                    .encode(BuiltInKinds.SAY.of(false, "hi"), Direction.FROM_CLIENT))));
    golden.put("pool-request", ClientMessageCodec.encode(new ClientMessage.PoolRequest(4096)));
    golden.put("heard", ClientMessageCodec.encode(new ClientMessage.Heard(7)));
    serverMessages(golden);
    inputs(golden);
    snapshots(golden);
    events(golden);
    near(golden);
    tables(golden);
    return golden;
  }

  /** An entity's health fell from 100 to 80; its other word is as at the start. */
  private static void tables(Map<String, byte[]> golden) {
    TableLayout layout =
        new TableLayout(
            10,
            8,
            false,
            new int[] {7, 32},
            new int[2],
            new int[] {100, 0},
            new int[] {2, 2},
            false);
    Table table = new Table(layout);
    RowAudience all =
        new RowAudience() {
          @Override
          public long inSight(int place, int block, long keys) {
            return keys;
          }

          @Override
          public int of(int place, int key) {
            return 1;
          }
        };
    FrameRing ring = new FrameRing(10);
    SnapshotEncoder encoder =
        new SnapshotEncoder(
            new Deltas(ring, 60), 7, Interest.EVERYTHING, new Tables(List.of(table)), all);
    SnapshotDecoder decoder = new SnapshotDecoder(10, 7, 90, 60, 0, new TableInbox(layout));
    table.put(5, 255, new int[] {80, 0}, 0, 100);
    ring.begin(100);
    ring.end();
    golden.put("snapshot-table", send(encoder, decoder, new InputFeedback(), null));
    assertEquals(80, decoder.tables().get(0, 5, 255, 0));
  }

  private static void serverMessages(Map<String, byte[]> golden) {
    KryoMessageCodec codec = new KryoMessageCodec();
    golden.put(
        "welcome",
        codec.encode(
            new ServerMessage.Welcome(
                0x0102030405060708L,
                3,
                12,
                60,
                "cup",
                1,
                2,
                0x55667788,
                990,
                1000,
                42,
                "arena",
                "arena.json",
                -1,
                300,
                200,
                5,
                6,
                true,
                List.of("player.ammo count 0..30 to OWNER"))));
    golden.put(
        "level-chunk", codec.encode(new ServerMessage.LevelChunk(4096, new byte[] {0x7b, 0x7d})));
    golden.put("refused", codec.encode(new ServerMessage.Refused(RefusalReason.SERVER_FULL, "")));
    golden.put(
        "roster",
        codec.encode(
            new ServerMessage.Roster(
                List.of(
                    new ServerMessage.RosterEntry(0, "Zoë", 2, -3, false, true, true, 85, 3),
                    ServerMessage.RosterEntry.gone(1000)))));
    golden.put(
        "room-list",
        codec.encode(
            new ServerMessage.RoomList(
                0,
                List.of(
                    new ServerMessage.RoomEntry(
                        "cup", "arena", "Commons", "playing", 3, 16, 1, Map.of("skill", "low"))))));
    golden.put(
        "level-answer",
        codec.encode(new ServerMessage.LevelAnswer(1800, ServerMessage.LevelOutcome.TAKEN, "ok")));
    golden.put(
        "level-list",
        codec.encode(
            new ServerMessage.LevelList(
                0, true, List.of(new ServerMessage.LevelEntry("Hill", "arena", "Zoë", 2, true)))));
    golden.put(
        "best-lists",
        codec.encode(
            new ServerMessage.BestLists(
                List.of(
                    new ServerMessage.BestList(
                        "wins", 0, List.of(new ServerMessage.BestEntry("Zoë", "12")))))));
    golden.put(
        "redirect", codec.encode(new ServerMessage.Redirect("b.example.org:54555", "", "cup", "")));
    String b = "b.example.org:54555";
    golden.put(
        "fleet", codec.encode(new ServerMessage.Fleet(List.of("a.example.org:54555", b), b)));
    golden.put("move", codec.encode(new ServerMessage.Move(b, "", "cup", "ticket.x")));
    golden.put("pace", codec.encode(new ServerMessage.Pace(75, false)));
    golden.put("play-page", codec.encode(new ServerMessage.PlayPage(8080, true)));
    golden.put("notice", codec.encode(new ServerMessage.Notice("hi")));
    golden.put(
        "pool-chunk",
        codec.encode(new ServerMessage.PoolChunk(50_000, 4096, new byte[] {0x43, 0x41})));
    golden.put("watching", codec.encode(new ServerMessage.Watching(10)));
    golden.put(
        "recording-chunk",
        codec.encode(new ServerMessage.RecordingChunk(4096, new byte[] {0x43, 0x41})));
    golden.put(
        "server-game-message",
        codec.encode(
            new ServerMessage.GameMessage(
                300,
                new MessageKinds()
                    .encode(BuiltInKinds.SAID.of(3, false, "hi"), Direction.FROM_SERVER))));
    golden.put("server-heard", codec.encode(new ServerMessage.Heard(7)));
    golden.put("goodbye", codec.encode(new ServerMessage.Goodbye(GoodbyeReason.KICKED, "spam")));
  }

  private static void inputs(Map<String, byte[]> golden) {
    byte[] buffer = new byte[InputDatagram.MAX_BYTES];
    InputDatagram d = new InputDatagram();
    d.epoch = 3;
    d.sequence = 5;
    d.hasAck = true;
    d.ackSequence = 0x0102;
    d.ackBits = 0x8000000000000001L;
    d.count = 3;
    d.newestTick = 1000;
    d.viewDelay = 200;
    d.holdTicks = 30;
    d.inputs[0] = 0x0000_aabb_ccdd_eeffL;
    d.inputs[1] = d.inputs[0];
    d.inputs[2] = 1;
    golden.put("input", Arrays.copyOf(buffer, d.encode(buffer, 0)));
    d.sequence = 6;
    d.hasAck = false;
    d.count = 0;
    golden.put("input-keep-alive", Arrays.copyOf(buffer, d.encode(buffer, 0)));
  }

  private static void snapshots(Map<String, byte[]> golden) {
    FrameRing ring = new FrameRing(10);
    SnapshotEncoder encoder = new SnapshotEncoder(ring, 7, 60);
    SnapshotDecoder decoder = new SnapshotDecoder(10, 7, 90, 60, 4, new TableInbox());
    InputFeedback feedback = new InputFeedback();

    ring.begin(100);
    ring.end();
    golden.put("snapshot-empty", send(encoder, decoder, feedback, null));

    FrameState frame = ring.begin(101);
    frame.putQuantized(0, 1, 2, -1, 512, -1024, 256, true);
    frame.putQuantized(5, 255, 300, 9, 0, 0, 0, false);
    ring.end();
    feedback.present = true;
    feedback.sequence = 500;
    feedback.holdMs = 12;
    feedback.margin = -3;
    golden.put("snapshot-new", send(encoder, decoder, feedback, null));
    encoder.receiveAck(decoder.ackSequence(), decoder.ackBits());

    feedback.present = false;
    for (int tick = 102; tick <= 104; tick++) {
      frame = ring.begin(tick);
      frame.putQuantized(0, 1, 2, -1, 512, -1024, 256, true);
      frame.putQuantized(5, 255, 300, 9, 25, -31, 8, false);
      ring.end();
    }
    golden.put("snapshot-delta", send(encoder, decoder, feedback, null));

    ring.begin(105).putQuantized(5, 255, 300, 9, 25, -31, 8, false);
    ring.end();
    OwnState own = new OwnState(4);
    own.setBody(5, 255, 1.5f, -2, 1, 0, 0, -0f, 0);
    own.setArchetype(300);
    own.setWord(1, 1);
    own.setWord(2, -1);
    golden.put("snapshot-own", send(encoder, decoder, feedback, own));
    assertTrue(decoder.own().sameAs(own));
  }

  /** A player jumps, one tick ago. */
  private static void events(Map<String, byte[]> golden) {
    FrameRing ring = new FrameRing(10);
    SnapshotEncoder encoder = new SnapshotEncoder(ring, 7, 60);
    SnapshotDecoder decoder = new SnapshotDecoder(10, 7, 90, 60);
    EventRecord jump = new EventRecord();
    jump.kind = 2;
    jump.tick = 99;
    jump.player = 3;
    jump.first = 5 | 255 << 16;
    jump.second = EventRecord.NONE;
    jump.place(1, -2);
    jump.strength(4);
    jump.data = 7;
    ring.events().add(jump, 0);
    ring.begin(100);
    ring.end();
    encoder.offer(0);
    golden.put("snapshot-event", send(encoder, decoder, new InputFeedback(), null));
    assertEquals(7, decoder.events().poll().data);
  }

  /** Two bodies near, of which one is told, with its contact with a static; one relayed player. */
  private static void near(Map<String, byte[]> golden) {
    FrameRing ring = new FrameRing(10);
    SnapshotEncoder encoder = new SnapshotEncoder(ring, 7, 60);
    SnapshotDecoder decoder = new SnapshotDecoder(10, 7, 190, 60);
    ring.begin(200).putInput(9, 1 | 127 << 16);
    ring.waiting().add(9, 1 | 127 << 16);
    ring.waiting().add(9, 127 << 16);
    ring.end();
    OwnState own = new OwnState();
    own.setBody(5, 255, 1, 2, 1, 0, 0, 0, 0);
    own.relay(9, 200);
    NearState near = own.near();
    near.begin(0x0123_4567_89ab_cdefL);
    near.add(5 | 255 << 16);
    near.add(6 | 255 << 16);
    RowCounts counts = new RowCounts();
    counts.set(RowKind.CONTACT, 1);
    near.beginPart(2, counts, 0);
    near.tell(1);
    near.addRow(entity(6 | 255 << 16, 1.5f, 2.5f, 1, 0, -1, 0, 0), 0);
    near.addRow(contact(1, ~7, 0, 1), 0);
    golden.put("snapshot-near", send(encoder, decoder, new InputFeedback(), own));
    assertEquals(2, decoder.own().near().partRows());
  }

  private static int[] entity(int key, float... body) {
    int[] row = new int[BodyRow.INTS];
    row[BodyRow.KEY] = key;
    for (int i = 0; i < body.length; i++) {
      row[BodyRow.MOTION + i] = Float.floatToRawIntBits(body[i]);
    }
    return row;
  }

  /** One point, pressed with 0.25 N s in the last substep and 1 N s in the step. */
  private static int[] contact(int one, int other, float normalX, float normalY) {
    int[] row = new int[ContactRow.INTS];
    row[ContactRow.END_A] = one;
    row[ContactRow.END_B] = other;
    row[ContactRow.POINTS_AND_FLAGS] = 1;
    row[ContactRow.ID_0] = 0x0002;
    row[ContactRow.NORMAL_X] = Float.floatToRawIntBits(normalX);
    row[ContactRow.NORMAL_Y] = Float.floatToRawIntBits(normalY);
    row[ContactRow.NORMAL_IMPULSE_0] = Float.floatToRawIntBits(0.25f);
    row[ContactRow.TOTAL_IMPULSE_0] = Float.floatToRawIntBits(1);
    return row;
  }

  private static byte[] send(
      SnapshotEncoder encoder, SnapshotDecoder decoder, InputFeedback feedback, OwnState own) {
    byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
    encoder.begin(feedback, own, 10_000);
    byte[] bytes = Arrays.copyOf(buffer, encoder.next(buffer));
    assertEquals(DecodeStatus.OK, decoder.decode(bytes, 0, bytes.length));
    return bytes;
  }

  private static String hex(byte[] bytes) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < bytes.length; i++) {
      text.append(i == 0 ? "" : i % 24 == 0 ? "\n" : " ")
          .append(String.format(Locale.ROOT, "%02x", bytes[i]));
    }
    return text.toString();
  }

  @Test
  void goldenBytesAreThoseOfThePage() {
    Map<String, byte[]> ofPage = goldenOfThePage();
    Map<String, byte[]> ofCode = goldenOfTheCode();
    assertEquals(ofCode.keySet(), ofPage.keySet());
    StringBuilder moved = new StringBuilder();
    for (Map.Entry<String, byte[]> entry : ofCode.entrySet()) {
      if (!Arrays.equals(ofPage.get(entry.getKey()), entry.getValue())) {
        moved.append("\n```golden ").append(entry.getKey()).append('\n');
        moved.append(hex(entry.getValue())).append("\n```\n");
      }
    }
    assertEquals("", moved.toString(), "the code writes these; raise Protocol.VERSION with them");
  }

  @Test
  void transitionsAreThoseOfThePage() {
    Set<String> legal = new HashSet<>();
    for (List<String> row : table("| from | to |")) {
      assertTrue(legal.add(row.get(0) + " -> " + row.get(1)), "twice: " + row);
    }
    for (SessionState from : SessionState.values()) {
      for (SessionState to : SessionState.values()) {
        String transition = from + " -> " + to;
        assertEquals(legal.remove(transition), from.canBecome(to), transition);
      }
    }
    assertEquals(Set.of(), legal, "on the page, but no such states");
  }

  @Test
  void limitsAreThoseOfThePage() throws IllegalAccessException {
    Map<String, String> ofCode = new TreeMap<>();
    for (Field field : ProtocolLimits.class.getFields()) {
      ofCode.put(field.getName(), String.valueOf(field.getInt(null)));
    }
    Map<String, String> ofPage = new TreeMap<>();
    for (List<String> row : table("| limit |")) {
      ofPage.put(row.get(0), row.get(1));
    }
    assertEquals(ofCode, ofPage);
  }

  @Test
  void reasonsAreThoseOfThePageInOrder() {
    List<List<String>> rows = table("| Refused | Goodbye |");
    assertEquals(
        Arrays.stream(RefusalReason.values()).map(Enum::name).toList(),
        rows.stream().map(row -> row.get(0)).toList());
    assertEquals(
        Arrays.stream(GoodbyeReason.values()).map(Enum::name).toList(),
        rows.stream().map(row -> row.get(1)).filter(name -> !name.isEmpty()).toList());
  }

  @Test
  void baselineReasonsAreThoseOfThePage() {
    assertEquals(
        Arrays.stream(BaselineReason.values()).map(Enum::name).toList(),
        table("| reason |").stream().map(row -> row.get(0)).toList());
  }

  @Test
  void theVersionIsThatOfThePage() {
    assertTrue(page.startsWith("# Protocol, version " + Protocol.VERSION + "\n"));
    assertTrue(Protocol.physicsDigest() != 0);
  }
}
