package carom.server.thin.plain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.thin.ThinClientMessage;
import carom.server.thin.ThinServerMessage;
import carom.server.thin.ThinSnapshot;
import carom.suite.Needs;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: the bytes of the door are those of Kryo 2.24 with its own serializers. Method: messages of
 * random values, written here and read by the real one in a process of its own, and the other way
 * round.
 */
@Needs("processes")
@Timeout(120)
final class StockKryoTest {
  private static final long SEED = Long.getLong("carom.seed", System.nanoTime());
  private static final int EACH = 40;
  private static final Pattern VALUE =
      Pattern.compile("Value\\{name=(\"[^\"]*\");value=([^;\"]*|\"[^\"]*\");\\}");

  @TempDir Path folder;

  private final Random random = new Random(SEED);
  private final List<byte[]> frames = new ArrayList<>();
  private final List<String> expected = new ArrayList<>();

  @Test
  void kryoReadsWhatTheDoorWrites() throws Exception {
    for (Class<?> type : ThinServerMessage.class.getPermittedSubclasses()) {
      for (int i = 0; i < EACH; i++) {
        ThinServerMessage message = (ThinServerMessage) random(type);
        KryoOutput out = new KryoOutput();
        new PlainEncoder().encode(out, message);
        take(out);
        expected.add(Dump.of(message));
      }
    }
    for (int i = 0; i < EACH; i++) {
      addSnapshot(40 + random.nextInt(2_000), random.nextInt(400), random.nextInt(50));
    }
    KryoOutput out = new KryoOutput();
    PlainEncoder.registerTcp(out, 0x12345678);
    PlainEncoder.registerUdp(out, 300);
    PlainEncoder.ping(out, 5, true);
    take(out);
    expected.add("RegisterTCP{connectionID=305419896;}");
    expected.add("RegisterUDP{connectionID=300;}");
    expected.add("Ping{id=5;isReply=true;}");
    assertEquals(expected, readByKryo(), "seed=" + SEED);
  }

  private void addSnapshot(int maxBytes, int bodies, int gone) {
    ThinSnapshot s = new ThinSnapshot();
    s.clear(whole(), whole());
    for (int i = 0; i < bodies; i++) {
      boolean named = random.nextInt(4) == 0;
      s.add(
          random.nextInt(65_535),
          whole(),
          whole(),
          random.nextInt(ThinSnapshot.STEPS_PER_TURN),
          named ? random.nextInt(4_096) : -1,
          random.nextInt(1_025) - 1);
    }
    for (int i = 0; i < gone; i++) {
      s.addGone(random.nextInt(65_535));
    }
    SnapshotCutter cutter = new SnapshotCutter();
    int match = whole();
    int parts = cutter.cut(s, Math.max(64, maxBytes));
    int body = 0;
    int goneSoFar = 0;
    for (int part = 0; part < parts; part++) {
      KryoOutput out = new KryoOutput();
      cutter.write(out, match, part);
      assertTrue(out.length() <= Math.max(64, maxBytes), "bytes=" + out.length());
      byte[] bytes = bytes(out);
      frames.add(bytes);
      int count = lengthOf(bytes, 1) - 1;
      int bodyEnd = body + count;
      int goneEnd =
          part == parts - 1 ? s.goneCount : bodyEnd < s.count ? goneSoFar : goneSoFar + gone(bytes);
      expected.add(Dump.part(s, match, part, parts, body, bodyEnd, goneSoFar, goneEnd));
      body = bodyEnd;
      goneSoFar = goneEnd;
    }
    assertEquals(s.count, body);
  }

  private static int lengthOf(byte[] bytes, int at) {
    KryoInput in = new KryoInput();
    in.begin(bytes, at, bytes.length);
    return in.count();
  }

  /** Returns how many ids are gone by a part. */
  private static int gone(byte[] bytes) {
    KryoInput in = new KryoInput();
    in.begin(bytes, 1, bytes.length);
    for (int bodies = in.count() - 1; bodies > 0; bodies--) {
      in.flag();
      in.real();
      in.whole();
      in.whole();
      in.whole();
      in.real();
      in.real();
    }
    return in.count() - 1;
  }

  @Test
  void aLevelThatIsTooLongForAMessageComesInSeveral() throws Exception {
    List<ThinServerMessage.Archetype> kinds = new ArrayList<>();
    List<ThinServerMessage.Ground> ground = new ArrayList<>();
    for (int i = 0; i < 700; i++) {
      kinds.add(kind("kind" + i, 1 + i % 7));
      ground.add(new ThinServerMessage.Ground(i, -i, i % 6, kind("ground" + i, 1 + i % 5)));
    }
    ground.add(new ThinServerMessage.Ground(1, 2, 3, kind("chain", 2_300)));
    ThinServerMessage.Match match =
        new ThinServerMessage.Match(
            1,
            2,
            "cup",
            "game",
            "level",
            List.of(0f, 0f, 1f, 1f),
            List.of(0f, -10f),
            new ThinServerMessage.Theme(1, 2, 3),
            List.of(),
            kinds,
            ground,
            List.of(),
            List.of(),
            List.of(),
            List.of());
    KryoOutput out = new KryoOutput();
    PlainEncoder encoder = new PlainEncoder();
    encoder.encode(new KryoOutput(), match);
    encoder.encode(out, match);
    assertEquals(2, encoder.matches());
    take(out);
    assertTrue(frames.size() > 2, "frames=" + frames.size());
    for (byte[] frame : frames) {
      assertTrue(frame.length <= PlainEncoder.MAX_FRAME_BYTES, "bytes=" + frame.length);
    }
    List<String> read = readByKryo();
    assertTrue(read.get(0).startsWith("Match{archetypes=[Archetype{"), read.get(0));
    assertTrue(read.get(0).contains("number=2;"), "the second on this connection");
    assertTrue(read.get(0).contains("more=" + (frames.size() - 1) + ";"), "one for each");
    String all = String.join("\n", read);
    int last = -1;
    for (int i = 0; i < 700; i++) {
      int at = all.indexOf("name=\"kind" + i + "\"");
      assertTrue(at > last, "kind " + i + " in order");
      last = at;
    }
    last = -1;
    for (int i = 0; i < 700; i++) {
      int at = all.indexOf("name=\"ground" + i + "\"");
      assertTrue(at > last, "ground " + i + " in order");
      last = at;
    }
    String part = Dump.of(kind("chain", 1).parts().get(0));
    int parts = 0;
    for (int at = all.indexOf("chain"); (at = all.indexOf("Part{", at + 1)) >= 0; ) {
      parts++;
    }
    assertTrue(all.contains(part), part);
    assertTrue(parts >= 2_200, "parts=" + parts); // those of the first piece are before its name
  }

  private static ThinServerMessage.Archetype kind(String name, int parts) {
    List<ThinServerMessage.Part> all = new ArrayList<>();
    for (int i = 0; i < parts; i++) {
      all.add(new ThinServerMessage.Part(0.25f, List.of(0f, 1f, 2f, 3f)));
    }
    return new ThinServerMessage.Archetype(name, 1, 2, "SOLID", false, all);
  }

  @Test
  void longListsComeInSeveralMessages() throws Exception {
    List<ThinServerMessage.FieldValue> values = new ArrayList<>();
    for (int i = 0; i < 9_000; i++) {
      values.add(new ThinServerMessage.FieldValue("entity", i, "health", i / 2f));
    }
    KryoOutput out = new KryoOutput();
    new PlainEncoder().encode(out, new ThinServerMessage.Fields(values));
    take(out);
    assertTrue(frames.size() > 2, "frames=" + frames.size());
    String all = String.join(",", readByKryo());
    String expectedAll = Dump.of(values);
    assertEquals(
        expectedAll.substring(1, expectedAll.length() - 1),
        all.replace("Fields{values=[", "").replace("];}", ""));
  }

  @Test
  void theDoorReadsWhatKryoWrites() throws Exception {
    PlainDecoder decoder = new PlainDecoder();
    StockJvm stock = new StockJvm(folder, StockJvm.resource("Echo.java"));
    for (Path home : StockJvm.homes()) {
      Process kryo =
          stock
              .program(home, "Echo", "write", String.valueOf(SEED), String.valueOf(11 * EACH))
              .redirectError(folder.resolve("errors.txt").toFile())
              .start();
      List<String> lines = lines(kryo.getInputStream());
      assertEquals(0, kryo.waitFor(), () -> text(folder.resolve("errors.txt")));
      assertEquals(11 * EACH, lines.size());
      for (String line : lines) {
        String[] both = line.split("\t");
        byte[] bytes = HexFormat.of().parseHex(both[0]);
        Object message = decoder.decode(bytes, 0, bytes.length, null);
        assertNull(decoder.problem(), line + " seed=" + SEED);
        if (message instanceof ThinClientMessage.Custom custom) {
          Map<String, String> values = new TreeMap<>();
          custom.values().forEach((name, value) -> values.put(Dump.of(name), Dump.of(value)));
          assertEquals(valuesIn(both[1]), values, "seed=" + SEED);
        } else {
          String read = Dump.read((ThinClientMessage) message);
          assertEquals(both[1].replaceFirst("player=-?\\d+;", ""), read, "seed=" + SEED);
        }
        assertEveryCutIsRefused(decoder, bytes);
      }
    }
  }

  private static void assertEveryCutIsRefused(PlainDecoder decoder, byte[] bytes) {
    for (int length = 0; length < bytes.length; length++) {
      assertNull(decoder.decode(bytes, 0, length, null), "length=" + length);
      assertTrue(decoder.problem() != null, "length=" + length);
    }
  }

  private static Map<String, String> valuesIn(String dump) {
    Map<String, String> values = new TreeMap<>();
    Matcher each = VALUE.matcher(dump);
    while (each.find()) {
      if (!each.group(2).equals("null")) {
        values.put(each.group(1), each.group(2));
      }
    }
    return values;
  }

  private void take(KryoOutput out) {
    ByteBuffer all = ByteBuffer.wrap(out.bytes(), 0, out.length());
    while (all.hasRemaining()) {
      byte[] frame = new byte[all.getInt()];
      all.get(frame);
      frames.add(frame);
    }
  }

  private static byte[] bytes(KryoOutput out) {
    byte[] bytes = new byte[out.length()];
    System.arraycopy(out.bytes(), 0, bytes, 0, bytes.length);
    return bytes;
  }

  private List<String> readByKryo() throws Exception {
    StockJvm stock = new StockJvm(folder, StockJvm.resource("Echo.java"));
    Path in = folder.resolve("frames");
    try (DataOutputStream to = new DataOutputStream(Files.newOutputStream(in))) {
      for (byte[] frame : frames) {
        to.writeInt(frame.length);
        to.write(frame);
      }
    }
    Path errors = folder.resolve("errors.txt");
    Process kryo =
        stock
            .program(Path.of(System.getProperty("java.home")), "Echo", "read")
            .redirectInput(in.toFile())
            .redirectError(errors.toFile())
            .start();
    List<String> lines = lines(kryo.getInputStream());
    assertEquals(0, kryo.waitFor(), () -> text(errors));
    return lines;
  }

  private static List<String> lines(InputStream in) throws IOException {
    return new String(in.readAllBytes(), StandardCharsets.US_ASCII).lines().toList();
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return e.toString();
    }
  }

  private Object random(Class<?> type) throws Exception {
    RecordComponent[] components = type.getRecordComponents();
    Object[] values = new Object[components.length];
    Class<?>[] types = new Class<?>[components.length];
    for (int i = 0; i < values.length; i++) {
      types[i] = components[i].getType();
      values[i] = value(components[i].getGenericType());
    }
    var constructor = type.getDeclaredConstructor(types);
    constructor.setAccessible(true);
    return constructor.newInstance(values);
  }

  private Object value(Type type) throws Exception {
    if (type == int.class || type == Integer.class) {
      return whole();
    } else if (type == long.class) {
      return random.nextLong() >> random.nextInt(64);
    } else if (type == float.class || type == Float.class) {
      return Float.intBitsToFloat(random.nextInt() & 0x7f7fffff);
    } else if (type == boolean.class) {
      return random.nextBoolean();
    } else if (type == String.class) {
      return words();
    } else if (type == Object.class) {
      return anything();
    } else if (type instanceof ParameterizedType generic) {
      Type last = generic.getActualTypeArguments()[generic.getActualTypeArguments().length - 1];
      if (generic.getRawType() == Map.class) {
        Map<String, Object> map = new LinkedHashMap<>();
        for (int i = random.nextInt(4); i > 0; i--) {
          map.put(words() + i, last == String.class ? words() : anything());
        }
        return map;
      }
      List<Object> list = new ArrayList<>();
      for (int i = random.nextInt(4); i > 0; i--) {
        list.add(value(last));
      }
      return list;
    }
    return random((Class<?>) type);
  }

  private Object anything() {
    return switch (random.nextInt(5)) {
      case 0 -> null;
      case 1 -> random.nextBoolean();
      case 2 -> whole();
      case 3 -> random.nextFloat();
      default -> words();
    };
  }

  private int whole() {
    return random.nextInt() >> random.nextInt(32);
  }

  private String words() {
    StringBuilder text = new StringBuilder();
    int highest = random.nextBoolean() ? 0x7f : 0xffff;
    int most = random.nextInt(10) == 0 ? 900 : 70;
    for (int i = random.nextInt(most); i > 0; i--) {
      text.append((char) random.nextInt(highest + 1));
    }
    return text.toString();
  }
}
