package carom.lab.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.BotsMain;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code carom-bots codec} from its files and flags to its line of JSON. */
final class CodecCommandTest {
  @TempDir private Path folder;

  private String output = "";
  private String errors = "";

  private int run(String... args) {
    PrintStream out = System.out;
    PrintStream err = System.err;
    ByteArrayOutputStream caught = new ByteArrayOutputStream();
    ByteArrayOutputStream told = new ByteArrayOutputStream();
    System.setOut(new PrintStream(caught, true, StandardCharsets.UTF_8));
    System.setErr(new PrintStream(told, true, StandardCharsets.UTF_8));
    try {
      return BotsMain.run(args);
    } finally {
      System.setOut(out);
      System.setErr(err);
      output = caught.toString(StandardCharsets.UTF_8);
      errors = told.toString(StandardCharsets.UTF_8);
    }
  }

  private Path write(int bodies, int ticks, int hz, float... numbers) throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate(12 + 4 * numbers.length).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putInt(bodies).putInt(ticks).putInt(hz);
    for (float number : numbers) {
      bytes.putFloat(number);
    }
    Path file = folder.resolve("some.trace");
    Files.write(file, bytes.array());
    return file;
  }

  @Test
  void aForeignFileIsMeasured() throws IOException {
    float[] numbers = new float[2 * 90 * 6];
    for (int tick = 0; tick < 90; tick++) {
      int at = tick * 12;
      numbers[at] = 0.05f * tick;
      numbers[at + 1] = 3;
      numbers[at + 2] = -0.1f * tick;
      numbers[at + 3] = 3;
      numbers[at + 5] = -6;
      numbers[at + 6] = -7.5f;
    }
    Path file = write(2, 90, 60, numbers);
    for (boolean full : new boolean[] {false, true}) {
      List<String> args =
          new ArrayList<>(
              List.of("codec", "--trace", file.toString(), "--rate", "30", "--lag", "3"));
      if (full) {
        args.add("--full");
      }
      assertEquals(0, run(args.toArray(new String[0])), errors);
      assertTrue(output.strip().matches("\\{[^\\n]*}"), output);
      for (String name :
          new String[] {
            "kbitPerSecond",
            "meanBytes",
            "p99Bytes",
            "maxBytes",
            "encodeNsPerBody",
            "decodeNsPerBody"
          }) {
        assertTrue(output.matches("(?s).*\"" + name + "\":[0-9.]+[,}].*"), name + " in " + output);
      }
      assertTrue(output.contains("\"exact\":true"), output);
      assertTrue(output.contains("\"snapshots\":45"), output);
    }
  }

  @Test
  void aSceneIsRecordedAndMeasured() throws IOException {
    Path file = folder.resolve("bridge.trace");
    assertEquals(
        0,
        run("codec", "--record", "bridge", "--seconds", "2", "--trace", file.toString()),
        errors);
    Trace trace = Trace.read(file);
    assertEquals(120, trace.ticks());
    assertEquals(60, trace.hz());
    assertTrue(output.contains("\"bodies\":" + trace.bodies()), output);
    assertTrue(output.contains("\"exact\":true"), output);
  }

  @Test
  void badFilesAndFlagsAreExplained() throws IOException {
    assertRefused("no such file", "codec", "--trace", folder.resolve("none").toString());
    assertRefused("is a directory", "codec", "--trace", folder.toString());
    assertRefused("--trace", "codec", "--rate", "60");
    String file = write(1, 1, 60, 0, 0, 0, 0, 0, 0).toString();
    assertRefused("rate=61 is outside 1..60", "codec", "--trace", file, "--rate", "61");
    assertRefused("lag=0 is outside 1..64", "codec", "--trace", file, "--lag", "0");
    assertRefused("seconds=0", "codec", "--trace", file, "--record", "bridge", "--seconds", "0");
    assertRefused("did you mean", "codec", "--trace", file, "--record", "brigde");
    write(0, 1, 60);
    assertRefused("bodies=0 is outside", "codec", "--trace", file);
    write(2, 1, 60, 0, 0, 0, 0, 0, 0);
    assertRefused("bodies=2 ticks=1 need 60", "codec", "--trace", file);
    write(1, 1, 60, 0, Float.NaN, 0, 0, 0, 0);
    assertRefused("tick=0 body=0: y=NaN", "codec", "--trace", file);
    write(1, 1, 60, 70_000, 0, 0, 0, 0, 0);
    assertRefused("x=70000.0 is outside +-32767.998", "codec", "--trace", file);
    write(1, 1, 60, 0, 0, 0, 3_000, 0, 0);
    assertEquals(0, run("codec", "--trace", file), "velocities don't count in poses");
    assertRefused("vx=3000.0", "codec", "--trace", file, "--full");
    Files.write(folder.resolve("some.trace"), new byte[5]);
    assertRefused("size=5 bytes", "codec", "--trace", file);
  }

  private void assertRefused(String part, String... args) {
    assertEquals(2, run(args), output + errors);
    assertTrue(errors.contains(part), errors);
    assertEquals("", output);
  }
}
