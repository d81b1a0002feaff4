package carom.client.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

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
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: every screen can be read and used, at 720p and 1080p, with large texts, and in the colours
 * for the colour-blind. Method: {@link ScreenTour} goes through them, {@link ScreenCheck} looks at
 * each; the pictures stay in {@code build/screens}.
 */
@Needs("windows")
@Timeout(400)
final class ScreensTest {
  @TempDir private Path folder;

  /** A window and its settings. */
  private record Look(int width, int height, int textSize, String colours) {
    String name() {
      return width + "-" + textSize + "-" + colours;
    }
  }

  private static final Look USUAL = new Look(1_280, 720, 100, "standard");

  /** The widest one and the tightest; {@code -Dcarom.all=true} adds the usual one. */
  private static final List<Look> LOOKS =
      Stream.of(
              new Look(1_920, 1_080, 100, "standard"),
              new Look(1_280, 720, 150, "colour-blind"),
              Boolean.getBoolean("carom.all") ? USUAL : null)
          .filter(Objects::nonNull)
          .toList();

  @BeforeEach
  void needsXvfb() {
    assumeTrue(VirtualDisplay.available(), "Xvfb is not installed (Debian: apt-get install xvfb)");
  }

  @Test
  void thePagesOfTheStartScreen() throws Exception {
    for (Look look : LOOKS) {
      assertInOrder("menus", look, 8);
    }
    assertInOrder("menus", new Look(1_280, 720, 200, "colour-blind"), 8);
  }

  @Test
  void aGameWithChatTableAndMenu() throws Exception {
    for (Look look : LOOKS) {
      assertInOrder("game", look, 9);
    }
  }

  @Test
  void aLargeLevelAloneAndPlayersWithHealth() throws Exception {
    for (Look look : LOOKS) {
      assertInOrder("others", look, 2);
    }
  }

  @Test
  void theEditorPlacesUndoesSavesAndPlays() throws Exception {
    for (Look look : LOOKS) {
      Files.deleteIfExists(folder.resolve("edited.json"));
      assertInOrder("edit", look, 3, "--edit", "edited.json", "--bots", "1");
    }
  }

  @Test
  void waysInAndOut() throws Exception {
    assertInOrder("ways", USUAL, 3);
  }

  @Test
  void aReplayAndTheEndOfItsMatch() throws Exception {
    Path recorded = folder.resolve("match.carom");
    try (Stepper stepper = Stepper.of("arena")) {
      stepper.server().record(recorded);
      stepper.join("Ann", Impairment.NONE, new Bot(Stepper.SEED));
      stepper.join("Bob", Impairment.NONE, new Bot(Stepper.SEED + 1));
      stepper.runUntil(
          "the match is over",
          () -> MatchClock.phase(stepper.room().simulation()) == MatchPhase.OVER,
          310);
      stepper.run(2);
    }
    for (Look look : LOOKS) {
      assertInOrder("replay", look, 2, "--replay", recorded.toString());
    }
  }

  private void assertInOrder(String tour, Look look, int pictures, String... flags)
      throws Exception {
    Path shots = Files.createDirectories(Path.of("build", "screens", tour + "-" + look.name()));
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
    List<String> command = Jvm.command(ScreenTour.class, tour, shots.toAbsolutePath().toString());
    command.addAll(List.of("--settings", settings.toString(), "--volume", "0"));
    command.addAll(List.of(flags));
    try (VirtualDisplay display = VirtualDisplay.open(look.width, look.height)) {
      ProcessBuilder builder =
          new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(output.toFile());
      display.show(builder);
      builder.directory(folder.toFile());
      Process window = builder.start();
      try {
        assertTrue(window.waitFor(120, TimeUnit.SECONDS), () -> "never ends\n" + read(output));
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
    assertEquals(List.of(), problems, tour + " " + look);
    assertTrue(read(output).contains("pictures " + pictures), () -> read(output));
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return "no output: " + e;
    }
  }
}
