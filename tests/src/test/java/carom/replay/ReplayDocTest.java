package carom.replay;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import carom.game.arena.ArenaGame;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.CRC32;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.junit.jupiter.api.Test;

/**
 * Goal: the bytes in {@code docs/protocol/RECORDING.md} are those of a recording. Method: the
 * page's blocks marked {@code golden} are compared with what a {@link Recorder} makes of the page's
 * level and two ticks, and the whole block of the page is taken apart.
 */
final class ReplayDocTest {
  private static final Pattern GOLDEN = Pattern.compile("(?ms)^```golden (\\S+)$(.*?)^```$");

  private final String page = read();

  private static String read() {
    Path directory = Path.of("").toAbsolutePath();
    while (directory != null && !Files.exists(directory.resolve("docs/protocol/RECORDING.md"))) {
      directory = directory.getParent();
    }
    assertNotNull(directory, "docs/protocol/RECORDING.md not found above the working directory");
    try {
      return Files.readString(directory.resolve("docs/protocol/RECORDING.md"));
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  private Map<String, String> goldenOfThePage() {
    Map<String, String> golden = new TreeMap<>();
    Matcher matcher = GOLDEN.matcher(page);
    while (matcher.find()) {
      golden.put(matcher.group(1), matcher.group(2).trim());
    }
    return golden;
  }

  private static String hex(byte[] bytes, int length) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < length; i++) {
      text.append(i == 0 ? "" : i % 24 == 0 ? "\n" : " ")
          .append(String.format(Locale.ROOT, "%02x", bytes[i]));
    }
    return text.toString();
  }

  private static byte[] bytes(String hex) {
    String[] parts = hex.split("\\s+", -1);
    byte[] bytes = new byte[parts.length];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) Integer.parseInt(parts[i], 16);
    }
    return bytes;
  }

  private String level() {
    int start = page.indexOf("```json\n") + 8;
    return page.substring(start, page.indexOf("```", start));
  }

  /** Blocks of a game in which Ann joins, does nothing in one tick and goes right in the next. */
  private List<Blocks.Raw> record() throws Exception {
    Level level = Level.parse("tiny.json", level().getBytes(StandardCharsets.UTF_8));
    SimulationHost s = new SimulationHost(new ArenaGame(), level, 42, 60, Role.AUTHORITY);
    Blocks blocks = new Blocks();
    Recorder recorder = new Recorder(s, RecordingHeader.of(s, 42, 0x0102030405060708L), blocks);
    s.addJournal(recorder);
    HostPlayer ann = s.join("Ann");
    s.step();
    ann.input().move(1, 0);
    ann.viewDelay(200);
    s.step();
    recorder.end("STOPPED");
    return blocks.blocks;
  }

  private int beginOfLevel(byte[] header) {
    return new String(header, StandardCharsets.ISO_8859_1).indexOf(level());
  }

  @Test
  void goldenBytesAreThoseOfARecording() throws Exception {
    Map<String, String> ofCode = new TreeMap<>();
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    new BlockWriter(file).close();
    ofCode.put("preamble", hex(file.toByteArray(), file.size()));
    for (Blocks.Raw block : record()) {
      byte[] content = block.bytes();
      switch (block.type()) {
        case HEADER -> ofCode.put("header", hex(content, beginOfLevel(content)));
        case KEYFRAME -> ofCode.put("keyframe", hex(content, content.length));
        case TICKS -> ofCode.put("ticks", hex(content, content.length));
        case END -> ofCode.put("end", hex(content, content.length));
        default -> throw new AssertionError(block.type());
      }
    }
    Map<String, String> ofPage = goldenOfThePage();
    ofPage.remove("end-block");
    StringBuilder moved = new StringBuilder();
    ofCode.forEach(
        (name, text) -> {
          if (!text.equals(ofPage.get(name))) {
            moved.append("\n```golden ").append(name).append('\n').append(text).append("\n```\n");
          }
        });
    assertEquals("", moved.toString(), "the recorder makes these");
    assertEquals(ofCode.keySet(), ofPage.keySet());
  }

  /** Deflaters may differ, so the block is read instead of compared. */
  @Test
  void theWholeBlockOfThePageIsTheEndBlock() throws DataFormatException {
    Map<String, String> golden = goldenOfThePage();
    ByteBuffer block = ByteBuffer.wrap(bytes(golden.get("end-block")));
    assertEquals(Block.END, Block.of(block.get(0)));
    byte[] content = new byte[block.getInt(1)];
    int stored = block.getInt(5);
    assertEquals(block.capacity(), Block.HEAD_BYTES + stored);
    CRC32 crc = new CRC32();
    crc.update(block.array(), 0, Block.HEAD_BYTES - 4);
    crc.update(block.array(), Block.HEAD_BYTES, stored);
    assertEquals((int) crc.getValue(), block.getInt(9));
    Inflater inflater = new Inflater();
    inflater.setInput(block.array(), Block.HEAD_BYTES, stored);
    assertEquals(content.length, inflater.inflate(content));
    inflater.end();
    assertArrayEquals(bytes(golden.get("end")), content);
  }

  @Test
  void theTableOfBlocksIsThatOfTheCode() {
    List<String> ofPage = new ArrayList<>();
    for (String line : page.substring(page.indexOf("\n| block |") + 1).split("\n", -1)) {
      if (!line.startsWith("|")) {
        break;
      }
      ofPage.add(line.split("\\|", -1)[1].trim());
    }
    List<String> ofCode = new ArrayList<>(List.of("block", "---"));
    Arrays.stream(Block.values()).forEach(b -> ofCode.add(b.ordinal() + " " + b));
    assertEquals(ofCode, ofPage);
  }
}
