package carom.client.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.fixtures.Jvm;
import carom.fixtures.VirtualDisplay;
import carom.game.Games;
import carom.net.kryo.server.KryoServerTransport;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.sim.level.Level;
import carom.suite.Alone;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: what a player does is seen within two frames. Method: keys pressed through a virtual
 * display, and what its screen shows of a body at rest; the server is 100 ms away.
 */
@Alone("measures")
@Timeout(180)
final class InputToPictureTest {
  /** Colour of the first player of the arena. */
  private static final int RED = 0xff5d5d;

  /**
   * Least number of pixels around the body that nine of ten presses change. Two ticks move the body
   * by a fraction of a pixel, which changed 94 to 198 pixels in 98 of 100 presses, and 17 and 22 in
   * two. At rest none changes, so that the tenth press must change one.
   */
  private static final int SEEN = 20;

  @TempDir private Path folder;

  @Test
  void aKeyIsSeenByTheEndOfTheSecondFrameAndEscOpensTheMenu() throws Exception {
    assumeTrue(VirtualDisplay.available(), "Xvfb is not installed (Debian: apt-get install xvfb)");
    Path output = folder.resolve("output.txt");
    try (VirtualDisplay display = VirtualDisplay.open();
        Server server =
            new Server(
                ServerConfig.defaults().with(ServerConfig.GAME, "arena"),
                () -> Games.create("arena"),
                Level.builtIn("arena"),
                new KryoServerTransport(0, 0),
                System::nanoTime)) {
      server.start();
      List<String> command = Jvm.command(KeyWatcher.class, Integer.toString(RED));
      command.addAll(List.of("--settings", folder.resolve("player.conf").toString()));
      command.addAll(List.of("--host", "localhost:" + server.tcpPort(), "--latency", "50"));
      command.addAll(List.of("--seconds", "100"));
      ProcessBuilder builder =
          new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(output.toFile());
      display.show(builder);
      Process window = builder.start();
      try {
        assertTrue(window.waitFor(120, TimeUnit.SECONDS), () -> read(output));
      } finally {
        window.destroyForcibly();
      }
    }
    List<Double> moved = numbers(output, "moved ");
    assertEquals(10, moved.size(), () -> read(output));
    List<Double> rested = numbers(output, "rested ");
    int few = 0;
    for (int i = 0; i < 10; i++) {
      double changed = moved.get(i) - rested.get(i);
      assertTrue(changed >= 1, () -> "moved too late: " + moved + ", at rest: " + rested);
      few += changed < SEEN ? 1 : 0;
    }
    assertTrue(few <= 1, () -> "hardly moved: " + moved + ", while it rested: " + rested);
    List<Double> changed = numbers(output, "changed ");
    assertTrue(changed.get(0) > 0.9, () -> "the menu covers the middle: " + changed);
    assertTrue(changed.get(1) < 0.3, () -> "the game is back: " + changed);
  }

  /** Returns the numbers of the lines that begin with a word. */
  private static List<Double> numbers(Path output, String word) {
    return read(output)
        .lines()
        .filter(line -> line.startsWith(word))
        .map(line -> Double.parseDouble(line.substring(word.length())))
        .toList();
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return "no output: " + e;
    }
  }
}
