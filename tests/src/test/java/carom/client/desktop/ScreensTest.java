package carom.client.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.fixtures.Jvm;
import carom.fixtures.VirtualDisplay;
import carom.net.transport.Impairment;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.suite.Needs;
import carom.testkit.Stepper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: every screen can be read and used, at 720p and 1080p, with large texts, and in the colours
 * for the colour-blind. Method: {@link ScreenTour} goes through them, {@link ScreenCheck} looks at
 * each; pictures of what is wrong are in {@code build/screens}, with {@code -Dcarom.all=true} all.
 */
@Needs("windows")
@Timeout(400)
final class ScreensTest {
  @TempDir private static Path shared;
  private static Path match;

  @TempDir private Path folder;

  /** A window and its settings. */
  private record Look(int width, int height, int textSize, String colours) {
    String name() {
      return width + "-" + textSize + "-" + colours;
    }
  }

  /** Records a match to its end. */
  @BeforeAll
  static void record() throws Exception {
    assumeTrue(VirtualDisplay.available(), "Xvfb is not installed (Debian: apt-get install xvfb)");
    match = shared.resolve("match.carom");
    try (Stepper stepper = Stepper.of("arena")) {
      stepper.server().record(match);
      for (int i = 0; i < 2; i++) {
        ClientConfig config =
            ClientConfig.of(i == 0 ? "Ann" : "Bob")
                .withServer("localhost", stepper.tcpPort(), stepper.udpPort())
                .with(ClientConfig.PREDICTION, PredictionMode.NONE);
        stepper.add(config, Impairment.NONE, new Bot(Stepper.SEED + i));
      }
      stepper.runUntil(
          "the match is over",
          () -> MatchClock.phase(stepper.room().simulation()) == MatchPhase.OVER,
          310);
      stepper.run(2);
    }
  }

  @Test
  void theWidestWindow() throws Exception {
    assertInOrder(new Look(1_920, 1_080, 100, "standard"));
  }

  @Test
  void theTightestWindowAndThenTheLargestTexts() throws Exception {
    assertInOrder(new Look(1_280, 720, 150, "colour-blind"));
    if (Boolean.getBoolean("carom.all")) {
      assertInOrder(new Look(1_280, 720, 100, "standard"));
    }
  }

  private void assertInOrder(Look look) throws Exception {
    Path shots = Files.createDirectories(Path.of("build", "screens", look.name()));
    Path settings = folder.resolve(look.name() + ".conf");
    Files.writeString(
        settings,
        String.format(
            Locale.ROOT,
            "window = %d x %d\ntext-size = %d\ncolours = %s\ncolour = lime\n",
            look.width,
            look.height,
            look.textSize,
            look.colours));
    Path output = folder.resolve("output.txt");
    String pictures = shots.toAbsolutePath().toString();
    List<String> saves = List.of("-Dcarom.all=" + Boolean.getBoolean("carom.all"));
    List<String> command = Jvm.command(saves, ScreenTour.class, pictures, match.toString());
    command.addAll(List.of("--settings", settings.toString(), "--volume", "0", "--bots", "1"));
    try (VirtualDisplay display = VirtualDisplay.open(look.width, look.height)) {
      ProcessBuilder builder =
          new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(output.toFile());
      display.show(builder);
      builder.directory(folder.toFile());
      Process window = builder.start();
      try {
        assertTrue(window.waitFor(300, TimeUnit.SECONDS), () -> "never ends\n" + read(output));
      } finally {
        window.destroyForcibly();
      }
      assertEquals(0, window.exitValue(), () -> read(output));
    }
    List<String> problems =
        read(output)
            .lines()
            .filter(line -> line.startsWith("problem") || line.contains("--snapshot-rate"))
            .toList();
    assertEquals(List.of(), problems, look.name());
    List<String> made = new ArrayList<>(List.of("menus: 8", "ways: 4", "game: 9", "others: 2"));
    made.addAll(List.of("edit: 3", "replay: 2"));
    if (look.textSize > 100) {
      made.add("largest: 8");
    }
    for (String part : made) {
      assertTrue(read(output).contains("pictures of " + part), () -> read(output));
    }
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return "no output: " + e;
    }
  }
}
