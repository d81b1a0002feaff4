package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.replay.RecordingReader;
import carom.server.metrics.Counter;
import carom.sim.SimState;
import carom.testkit.Folders;
import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.LoggerFactory;

/**
 * Goal: no damage to a slot's files starts a wrong world or stops the start. Method: two slots of a
 * small world, whose hashes at every tick are known; the newer one is cut at each offset, and bits
 * of it are flipped. A server must begin from it at a proven tick, or from the older one.
 */
@Timeout(180)
class HostileSlotTest {
  private static final String LEVEL =
      """
      {
        "name": "tiny", "game": "test", "gravity": [0, -10],
        "bounds": { "min": [-50, -50], "max": [50, 50] },
        "spawns": [ { "name": "player", "at": [0, 0] } ]
      }
      """;

  private static final int SUM_AT = 12;
  private static final int BODY_AT = 20;
  private static final int LAYOUT_AT = 28;

  @TempDir Path folder;

  /** The hash of each tick of both logs. */
  private final Map<Integer, Long> hashes = new HashMap<>();

  private Path original;
  private int older;
  private int newer;
  private int newerTick;
  private int runs;

  @BeforeEach
  void makeTwoSlots() throws Exception {
    Path kept = folder.resolve("kept");
    try (KeptServer server = start(kept)) {
      server.join("Ann", 0);
      server.runTo(70);
      server.runTo(90);
      original = Folders.copy(kept, folder.resolve("original")).resolve("cup");
    }
    try (Stream<Path> files = Files.list(original)) {
      List<Integer> logs =
          files
              .map(file -> file.getFileName().toString())
              .filter(name -> name.endsWith(".log"))
              .map(name -> Integer.valueOf(name.replace(".log", "")))
              .sorted()
              .toList();
      older = logs.get(0);
      newer = logs.get(1);
    }
    replay(older);
    newerTick = replay(newer);
    assertTrue(newerTick >= 60 && newerTick < 90, "tick=" + newerTick);
  }

  private static KeptServer start(Path kept) {
    return new KeptServer(KeptServer.library(LEVEL, 2), List.of("tiny"), kept, 1_000_000_000L);
  }

  /** Notes the hashes of a log; returns the tick of its checkpoint. */
  private int replay(int slot) throws IOException {
    int first = -1;
    int tick = -1;
    try (RecordingReader reader = RecordingReader.open(original.resolve(slot + ".log"))) {
      for (RecordingReader.Entry e = reader.next();
          e != RecordingReader.Entry.WAIT && e != RecordingReader.Entry.END;
          e = reader.next()) {
        if (e == RecordingReader.Entry.STATE) {
          first = reader.stateTick();
          tick = first;
          hashes.put(tick, reader.hash());
        } else if (e == RecordingReader.Entry.STEPPED) {
          hashes.put(++tick, reader.hash());
        }
      }
    }
    return first;
  }

  /** Starts a server from damaged files, and checks where it begins. Returns the tick. */
  private int begin(String name, byte[] bytes, String what) throws IOException {
    Path run = folder.resolve("run" + runs++);
    Path room = Files.createDirectories(run.resolve("cup"));
    for (int slot : new int[] {older, newer}) {
      for (String end : new String[] {".log", ".seats", ".latest"}) {
        Path file = original.resolve(slot + end);
        if (Files.exists(file)) {
          Files.copy(file, room.resolve(slot + end));
        }
      }
    }
    Files.write(room.resolve(name), bytes);
    KeptServer server = start(run);
    try {
      assertEquals(1, server.server.count(Counter.ROOMS_RESUMED), what);
      int tick = server.resumedTick;
      assertTrue(hashes.containsKey(tick), what + ": tick=" + tick);
      assertEquals(hashes.get(tick), server.resumedHash, what + ": tick=" + tick);
      return tick;
    } finally {
      server.close();
      Folders.delete(run);
    }
  }

  @Test
  void aLogCutAnywhereBeginsAtItsLastWholeBlockOrInTheSlotBefore() throws IOException {
    byte[] whole = Files.readAllBytes(original.resolve(newer + ".log"));
    int last = 0;
    int step = Math.max(1, whole.length / 80);
    for (int length = 0; length <= whole.length; length += step) {
      int tick = begin(newer + ".log", Arrays.copyOf(whole, length), "length=" + length);
      assertTrue(tick >= last, "length=" + length + ": tick=" + tick + " after " + last);
      last = tick;
    }
    last = begin(newer + ".log", whole, "whole");
    assertTrue(last > newerTick, "the whole log goes beyond its checkpoint");
  }

  @Test
  void seatsCutAnywhereMeanTheSlotBefore() throws IOException {
    byte[] whole = Files.readAllBytes(original.resolve(newer + ".seats"));
    for (int length = 0; length < whole.length; length += 16) {
      int tick = begin(newer + ".seats", Arrays.copyOf(whole, length), "length=" + length);
      assertTrue(tick <= newerTick, "length=" + length + ": tick=" + tick);
    }
  }

  @Test
  void latestSeatsCutAnywhereLoseNoTick() throws IOException {
    int whole = begin(newer + ".log", Files.readAllBytes(original.resolve(newer + ".log")), "");
    byte[] latest = Files.readAllBytes(original.resolve(newer + ".seats"));
    for (int length = 0; length <= latest.length; length += 16) {
      byte[] cut = Arrays.copyOf(latest, length);
      assertEquals(whole, begin(newer + ".latest", cut, "length=" + length), "length=" + length);
    }
  }

  @Test
  void flippedBitsNeverStartAWrongWorld() throws IOException {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    Random random = new Random(seed);
    for (int i = 0; i < 60; i++) {
      String name = newer + (i % 4 == 0 ? ".seats" : ".log");
      byte[] bytes = Files.readAllBytes(original.resolve(name));
      int bit = random.nextInt(8 * bytes.length);
      bytes[bit / 8] ^= (byte) (1 << bit % 8);
      begin(name, bytes, "bit=" + bit + " of " + name + ", seed=" + seed);
    }
  }

  @Test
  void filesOfTwoSlotsDoNotGoTogether() throws IOException {
    byte[] log = Files.readAllBytes(original.resolve(older + ".log"));
    assertTrue(begin(newer + ".log", log, "older log") <= newerTick);
    byte[] seats = Files.readAllBytes(original.resolve(older + ".seats"));
    assertTrue(begin(newer + ".seats", seats, "older seats") <= newerTick);
  }

  /** Returns a file of seats with another number of the state's layout, under a right checksum. */
  private static byte[] withLayout(byte[] seats, int layout) {
    byte[] bytes = seats.clone();
    ByteBuffer file = ByteBuffer.wrap(bytes);
    assertEquals(SimState.LAYOUT, file.getInt(LAYOUT_AT));
    file.putInt(LAYOUT_AT, layout);
    CRC32 sum = new CRC32();
    sum.update(bytes, BODY_AT, bytes.length - BODY_AT);
    file.putLong(SUM_AT, sum.getValue());
    return bytes;
  }

  @Test
  void aNewestSlotOfAnotherLayoutMeansTheSlotBefore() throws IOException {
    String name = newer + ".seats";
    byte[] whole = Files.readAllBytes(original.resolve(name));
    int unchanged = begin(name, withLayout(whole, SimState.LAYOUT), "the present layout");
    assertTrue(unchanged > newerTick, "tick=" + unchanged);
    for (int layout : new int[] {SimState.LAYOUT - 1, SimState.LAYOUT + 1}) {
      ListAppender<ILoggingEvent> lines = new ListAppender<>();
      lines.start();
      Logger log = (Logger) LoggerFactory.getLogger("carom.server.checkpoint");
      log.addAppender(lines);
      log.setLevel(Level.WARN); // other tests of this process make the log quieter
      int tick;
      try {
        tick = begin(name, withLayout(whole, layout), "layout=" + layout);
      } finally {
        log.setLevel(null);
        log.detachAppender(lines);
      }
      assertTrue(tick <= newerTick, "layout=" + layout + ": tick=" + tick);
      String refused = "checkpoint " + newer + " is refused: its state has layout=" + layout;
      assertTrue(
          lines.list.stream().anyMatch(line -> line.getFormattedMessage().contains(refused)),
          () -> refused + " is not in " + lines.list);
    }
  }
}
