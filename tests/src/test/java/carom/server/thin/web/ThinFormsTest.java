package carom.server.thin.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.Games;
import carom.net.transport.Link;
import carom.net.transport.ServerTransport;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.server.thin.ThinClientMessage;
import carom.server.thin.ThinLink;
import carom.server.thin.ThinNews;
import carom.server.thin.ThinSnapshot;
import carom.sim.Game;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import carom.text.Json;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/**
 * Goal: both forms of a snapshot tell the same, in as many bytes as they may take. Method: a game
 * in virtual time; a client decodes what it is told as docs/protocol/THIN.md says, and the bytes
 * are counted.
 */
final class ThinFormsTest {
  private static final long TICK_NS = 16_666_667;
  private static final int PLAYERS = 20;

  /** A client that writes each snapshot in both forms and reads them again. */
  private static final class Reader extends ThinLink {
    final ThinBooks texts = new ThinBooks();
    final ThinBooks binaries = new ThinBooks();
    final ThinBooks truth = new ThinBooks();
    private final Bytes bytes = new Bytes();
    private final BinaryForm binary = new BinaryForm();
    long newsBytes;
    long textBytes;
    long binaryBytes;
    int snapshots;
    int told;
    private int count;

    Reader(String name) {
      super(name, true);
      receive(new ThinClientMessage.Join(VERSION, name, "", "", "", "", "", 0, ""));
    }

    void press(Input input) {
      receive(new ThinClientMessage.Input(count++, texts.tick, new long[] {input.pack()}));
    }

    @Override
    protected boolean write(List<ThinNews> news) {
      for (ThinNews one : news) {
        byte[] text = JsonWriter.write(one.message());
        WebPlayer.parsed(new String(text, StandardCharsets.UTF_8));
        newsBytes += text.length;
      }
      return true;
    }

    @Override
    public boolean takesSnapshot() {
      return true;
    }

    @Override
    protected int draw(ThinSnapshot snapshot) {
      snapshots++;
      told += snapshot.count;
      bytes.clear();
      JsonWriter.write(snapshot, bytes);
      textBytes += bytes.length();
      String text = StandardCharsets.UTF_8.decode(bytes.view()).toString();
      Json root = WebPlayer.parsed(text);
      texts.text(root.fields.get("snapshot"));
      bytes.clear();
      binary.write(snapshot, bytes);
      int length = bytes.length();
      binaryBytes += length;
      binaries.bytes(bytes.view());
      for (int i = 0; i < snapshot.count; i++) {
        ThinBooks.Body before = truth.bodies.get(snapshot.id[i]);
        boolean isNew = snapshot.archetype[i] >= 0;
        truth.bodies.put(
            snapshot.id[i],
            new ThinBooks.Body(
                snapshot.x[i],
                snapshot.y[i],
                snapshot.angle[i],
                isNew ? snapshot.archetype[i] : before.archetype(),
                isNew ? snapshot.owner[i] : before.owner()));
      }
      for (int i = 0; i < snapshot.goneCount; i++) {
        truth.bodies.remove(snapshot.gone[i]);
      }
      assertEquals(new TreeMap<>(truth.bodies), binaries.bodies);
      assertEquals(new TreeMap<>(truth.bodies), texts.bodies, text);
      assertEquals(snapshot.input, binaries.input);
      return length;
    }

    @Override
    protected void hangUp(String reason) {}
  }

  /** Lets clients in. */
  private static final class Door implements ServerTransport {
    final ArrayDeque<Link> waiting = new ArrayDeque<>();

    @Override
    public Link accept() {
      return waiting.poll();
    }

    @Override
    public int tcpPort() {
      return 0;
    }

    @Override
    public int udpPort() {
      return 0;
    }

    @Override
    public void close() {}
  }

  @Test
  void bothFormsTellTheSameWithinTheirBudgets() throws Exception {
    Door door = new Door();
    long[] nowNs = {1_000_000_000L};
    Game arena = Games.create("arena");
    Server server =
        new Server(
            ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0),
            () -> arena,
            Level.builtIn(arena.defaultLevel()),
            door,
            () -> nowNs[0]);
    List<Reader> players = new ArrayList<>();
    for (int i = 0; i < PLAYERS; i++) {
      Reader player = new Reader("Player " + i);
      players.add(player);
      door.waiting.add(player);
    }
    Random random = new Random(1);
    int begin = 120;
    int end = begin + 600;
    long[] before = new long[3];
    for (int tick = 0; tick < end; tick++) {
      nowNs[0] += TICK_NS;
      for (Reader player : players) {
        if (random.nextInt(15) == 0) {
          player.press(
              new Input()
                  .move(random.nextFloat() * 2 - 1, random.nextFloat() * 2 - 1)
                  .hold(Input.ACTION, random.nextInt(4) == 0));
        }
      }
      server.tick(nowNs[0]);
      if (tick == begin) {
        before =
            new long[] {
              players.get(0).textBytes, players.get(0).binaryBytes, players.get(0).newsBytes
            };
      }
    }
    Reader ann = players.get(0);
    double seconds = (end - begin) / 60.0;
    double news = (ann.newsBytes - before[2]) * 8 / seconds / 1_000;
    double text = news + (ann.textBytes - before[0]) * 8 / seconds / 1_000;
    double binary = news + (ann.binaryBytes - before[1]) * 8 / seconds / 1_000;
    System.out.printf(
        Locale.ROOT,
        "bodies=%d told=%.1f json=%.0f kbit/s binary=%.0f kbit/s, of which news %.0f%n",
        ann.truth.bodies.size(),
        (double) ann.told / ann.snapshots,
        text,
        binary,
        news);
    assertTrue(ann.truth.bodies.size() >= 40, "bodies=" + ann.truth.bodies.size());
    assertTrue(ann.snapshots >= 300, "snapshots=" + ann.snapshots);
    assertTrue(text <= 500, "JSON takes kbit/s=" + text);
    assertTrue(binary <= 120, "the binary form takes kbit/s=" + binary);
    server.close();
  }

  @Test
  void bodiesOfAnyKindAndPlaceComeThrough() {
    Random random = new Random(7);
    Reader reader = new Reader("any");
    for (int n = 0; n < 300; n++) {
      ThinSnapshot s = new ThinSnapshot();
      s.tick = n;
      s.input = n - 1;
      int most = 40;
      s.id = new int[most];
      s.x = new int[most];
      s.y = new int[most];
      s.angle = new int[most];
      s.archetype = new int[most];
      s.owner = new int[most];
      s.gone = new int[most];
      int id = 0;
      while (s.count + s.goneCount < most && id < 60_000) {
        id += 1 + random.nextInt(n % 10 == 0 ? 4_000 : 3);
        boolean known = reader.truth.bodies.containsKey(id);
        if (known && random.nextInt(4) == 0) {
          s.gone[s.goneCount++] = id;
          continue;
        }
        boolean named = !known || random.nextInt(6) == 0;
        s.id[s.count] = id;
        s.x[s.count] = random.nextInt() >> 4 + random.nextInt(24);
        s.y[s.count] = random.nextInt() >> 4 + random.nextInt(24);
        s.angle[s.count] = random.nextInt(1_024);
        s.archetype[s.count] = named ? random.nextInt(300) : -1;
        s.owner[s.count] = random.nextInt(1_025) - 1;
        s.count++;
      }
      reader.show(s);
    }
  }

  @Test
  void numbersAreWrittenAsPeopleWriteThem() {
    Bytes bytes = new Bytes();
    for (long value : new long[] {0, 1, -1, 10, 500, -500, 1_000, 1_050, -12_345, 999, 100_001}) {
      bytes.thousandths(value).ascii(" ");
    }
    assertEquals(
        "0 0.001 -0.001 0.01 0.5 -0.5 1 1.05 -12.345 0.999 100.001 ",
        StandardCharsets.UTF_8.decode(bytes.view()).toString());
    bytes.clear();
    bytes.number(Long.MAX_VALUE).varint(-1).signed(Integer.MIN_VALUE);
    ByteBuffer view = bytes.view();
    assertEquals(19 + 5 + 5, view.remaining());
  }

  @Test
  void binaryInputsAreReadOrRefusedByName() throws BadMessage {
    Input input = new Input().buttons(0x8003).move(-1, 0.5f).aim(3);
    ByteBuffer bytes = ByteBuffer.allocate(10).order(ByteOrder.LITTLE_ENDIAN);
    bytes.put((byte) 2).put((byte) 0x85).put((byte) 1).put((byte) 0);
    long packed = input.pack();
    bytes.putShort((short) packed).put((byte) (packed >> 16)).put((byte) (packed >> 24));
    bytes.putShort((short) (packed >> 32));
    ThinClientMessage.Input read = BinaryForm.readInput(bytes.array());
    assertEquals(133, read.count());
    assertEquals(-1, read.seenTick());
    assertEquals(input.pack(), read.inputs()[0]);
    for (byte[] wrong :
        new byte[][] {{}, {1, 2, 3}, {2}, {2, -1, -1, -1, -1, -1, 0}, {2, 1, 1}, {2, 1, 1, 5, 5}}) {
      BadMessage refused = assertThrows(BadMessage.class, () -> BinaryForm.readInput(wrong));
      assertTrue(
          refused
              .getMessage()
              .startsWith(wrong.length > 0 && wrong[0] == 2 ? "binary input" : "a binary message"),
          refused.getMessage());
    }
  }

  /** Returns the bytes of an example in the page, which begins with a byte. */
  private static byte[] example(String begin) throws Exception {
    String page = Files.readString(Path.of("../docs/protocol/THIN.md"));
    Matcher matcher = Pattern.compile("`(" + begin + "( [0-9a-f]{2})+)`").matcher(page);
    assertTrue(matcher.find(), begin);
    return HexFormat.ofDelimiter(" ").parseHex(matcher.group(1));
  }

  @Test
  void thePagesExamplesSayWhatTheyAreSaidToSay() throws Exception {
    ThinClientMessage.Input input = BinaryForm.readInput(example("02"));
    assertEquals(5, input.count());
    assertEquals(914, input.seenTick());
    assertEquals(
        new Input().hold(Input.ACTION, true).move(1, 0).aim((float) Math.PI / 2).pack(),
        input.inputs()[0]);
    ThinBooks books = new ThinBooks();
    books.bodies.put(7, new ThinBooks.Body(100, 200, 1_023, 4, -1));
    books.bytes(ByteBuffer.wrap(example("01")));
    assertEquals(914, books.tick);
    assertEquals(1, books.input);
    assertEquals(new ThinBooks.Body(-6_272, 2_304, 0, 3, 0), books.bodies.get(0));
    assertEquals(new ThinBooks.Body(103, 199, 1, 4, -1), books.bodies.get(7));
  }
}
