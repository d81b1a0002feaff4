package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: a user who starts a server for the first time sees on one screen what to do next. */
class ReadyLineTest {
  @Test
  void theHintsNameEverythingInOneScreen() {
    List<String> lines = ReadyLine.hints(54_555, "http://127.0.0.1:8090", null, true, false);
    String text = String.join("\n", lines);
    assertTrue(lines.size() <= 12, text);
    for (String word : new String[] {"ready", "./gradlew play", "carom-client --host", "-Pn=20"}) {
      assertTrue(text.contains(word), word);
    }
    assertTrue(text.contains("page      http://127.0.0.1:8090"), text);
    assertTrue(text.contains("stop      Ctrl-C"), text);
    assertFalse(text.contains("54555"), "the usual port needn't be named");
  }

  @Test
  void anUnusualPortIsInEachCommand() {
    String text = String.join("\n", ReadyLine.hints(7, null, null, true, false));
    assertEquals(3, text.split("--host localhost:7|--host \\S+:7 ", -1).length - 1, text);
    assertFalse(text.contains("page"), text);
  }

  @Test
  void anInstalledServerNamesTheProgramsBesideIt() {
    String text = String.join("\n", ReadyLine.hints(7, null, null, false, false));
    assertTrue(text.contains("join      carom-client --host localhost:7\n"), text);
    assertTrue(text.contains("add bots  carom-bots --count 20 --host localhost:7\n"), text);
    assertFalse(text.contains("gradlew"), text);
  }

  @Test
  void aServerOnLoopbackOffersNothingToOtherMachines() {
    String text = String.join("\n", ReadyLine.hints(7, null, null, false, true));
    assertFalse(text.contains("another machine"), text);
    assertTrue(text.contains("from this machine only"), text);
  }

  @Test
  void theLineHasThePortsThatAreOpen() {
    assertEquals("ready tcp=1 udp=2", line(0, null));
    assertEquals("ready tcp=1 udp=2 plain=3", line(0, "3"));
    assertEquals("ready tcp=1 udp=2 play=5 plain=3:4", line(5, "3:4"));
  }

  private static String line(int play, String plain) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ReadyLine.print(new PrintStream(out, true, StandardCharsets.UTF_8), 1, 2, play, plain);
    return out.toString(StandardCharsets.UTF_8).strip();
  }
}
