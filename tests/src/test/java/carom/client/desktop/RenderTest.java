package carom.client.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.client.bots.Bot;
import carom.client.look.GameViews;
import carom.client.look.RandomView;
import carom.fixtures.Jvm;
import carom.fixtures.VirtualDisplay;
import carom.net.transport.Impairment;
import carom.server.CaromMain;
import carom.suite.Needs;
import carom.testkit.Stepper;
import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Goal: a clip of a recorded game is one command. Method: a real game, drawn on a display. */
@Needs("windows")
@Timeout(180)
final class RenderTest {
  @TempDir private Path folder;
  private Path recorded;

  @BeforeEach
  void record() throws Exception {
    record("arena");
  }

  private void record(String game) throws Exception {
    recorded = folder.resolve(game + ".carom");
    try (Stepper stepper = Stepper.of(game)) {
      stepper.server().record(recorded);
      stepper.join("Ann", Impairment.NONE, new Bot(1));
      stepper.run(6);
    }
  }

  private String render(int status, String... flags) throws Exception {
    return render(CaromMain.class, List.of("render"), status, flags);
  }

  private String render(Class<?> main, List<String> first, int status, String... flags)
      throws Exception {
    List<String> command = Jvm.command(main, first.toArray(new String[0]));
    command.add(recorded.toString());
    command.addAll(List.of(flags));
    Path output = folder.resolve("output.txt");
    try (VirtualDisplay display = VirtualDisplay.open()) {
      ProcessBuilder builder =
          new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(output.toFile());
      display.show(builder);
      Process program = builder.start();
      assertTrue(program.waitFor(120, TimeUnit.SECONDS));
      String text = Files.readString(output);
      assertEquals(status, program.exitValue(), text);
      return text;
    }
  }

  @Test
  void aClipHasItsPicturesAndThingsMoveInThem() throws Exception {
    assumeTrue(VirtualDisplay.available(), "Xvfb is not installed (Debian: apt-get install xvfb)");
    Path frames = folder.resolve("clip");
    String text =
        render(
            0,
            "--frames",
            frames.toString(),
            "--from",
            "3",
            "--seconds",
            "1",
            "--fps",
            "8",
            "--size",
            "640x360",
            "--speed",
            "0.5",
            "--follow",
            "ann");
    assertTrue(text.contains("8 pictures in "), text);
    List<Path> files;
    try (Stream<Path> found = Files.list(frames)) {
      files = found.sorted().toList();
    }
    assertEquals(8, files.size());
    assertEquals("frame-00000.png", files.get(0).getFileName().toString());
    BufferedImage first = ImageIO.read(files.get(0).toFile());
    BufferedImage last = ImageIO.read(files.get(7).toFile());
    assertEquals(640, first.getWidth());
    assertEquals(360, first.getHeight());
    int changed = 0;
    int drawn = 0;
    for (int y = 0; y < 360; y++) {
      for (int x = 0; x < 640; x++) {
        changed += first.getRGB(x, y) == last.getRGB(x, y) ? 0 : 1;
        drawn += (first.getRGB(x, y) & 0xff) > 0x60 ? 1 : 0;
      }
    }
    assertTrue(changed > 500, "pixels that changed: " + changed);
    assertTrue(drawn > 5_000, "bright pixels: " + drawn);
    assertTrue(
        render(2, "--frames", frames.toString()).contains("isn't empty"), "nothing is overwritten");
    String unknown =
        render(1, "--frames", folder.resolve("b").toString(), "--from", "2", "--follow", "Bob");
    assertTrue(unknown.contains("nobody is called Bob") && unknown.contains("[Ann]"), unknown);
  }

  /**
   * Draws the clip with the view of a seed; its first argument is the seed, its second if faulty.
   */
  static final class WithRandomView {
    public static void main(String[] args) {
      long seed = Long.parseLong(args[0]);
      GameViews.add(() -> new RandomView(seed, Boolean.parseBoolean(args[1])));
      CaromMain.main(Arrays.copyOfRange(args, 2, args.length));
    }
  }

  /** Goal: no look that can be declared breaks the picture; what isn't there is told by name. */
  @Test
  void anyLookIsDrawn() throws Exception {
    assumeTrue(VirtualDisplay.available(), "Xvfb is not installed (Debian: apt-get install xvfb)");
    record("rockets");
    long seed = Long.getLong("carom.seed", System.nanoTime());
    for (int i = 0; i < 2; i++) {
      boolean faulty = i % 2 == 1;
      Path frames = folder.resolve("look" + i);
      List<String> first = List.of(Long.toString(seed + i), Boolean.toString(faulty), "render");
      String text =
          render(
              WithRandomView.class,
              first,
              0,
              "--frames",
              frames.toString(),
              "--from",
              "3",
              "--seconds",
              "1",
              "--fps",
              "5",
              "--size",
              "320x180",
              "--follow",
              "ann");
      String what = "-Dcarom.seed=" + seed + " case " + i + ": " + text;
      assertTrue(text.contains("5 pictures in "), what);
      assertFalse(text.contains("is left out"), what);
      assertFalse(!faulty && text.contains("can't be"), what);
      assertFalse(text.contains("own look failed"), what);
    }
  }

  @Test
  void badFlagsAreNamed() {
    assertTrue(problem("--speed", "0.3").contains("--speed=0.3 is no power of 2"));
    assertTrue(problem("--size", "10x10").contains("--size=10x10 is not within"));
    assertTrue(problem("--fps", "0").contains("--fps=0 is outside 1..240"));
    assertTrue(problem("--from", "-1").contains("--from=-1.0 is outside"));
  }

  private String problem(String... flags) {
    List<String> args = new ArrayList<>(List.of("render", recorded.toString()));
    args.addAll(List.of("--frames", folder.resolve("none").toString()));
    args.addAll(List.of(flags));
    StringWriter text = new StringWriter();
    PrintWriter out = new PrintWriter(text);
    assertEquals(2, CaromMain.run(out, out, args.toArray(new String[0])), text.toString());
    return text.toString();
  }
}
