package carom.client.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.client.app.ClientMain;
import carom.fixtures.Jvm;
import carom.fixtures.VirtualDisplay;
import carom.sim.scene.Scenes;
import carom.suite.Needs;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code carom-client --scene}: the flag, and a real window on a virtual display. */
@Needs("windows")
final class SceneWindowTest {
  @TempDir Path folder;

  @Test
  void theWindowShowsTheScene() throws Exception {
    assumeTrue(VirtualDisplay.available(), "Xvfb is not installed (Debian: apt-get install xvfb)");
    File picture = folder.resolve("scene.png").toFile();
    try (VirtualDisplay display = VirtualDisplay.open()) {
      ProcessBuilder builder =
          new ProcessBuilder(
                  Jvm.command(
                      CalmWindow.class,
                      "--settings=" + folder.resolve("player.conf"),
                      "--scene=pyramid",
                      "--debug",
                      "--seconds=1",
                      "--screenshot=" + picture))
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD);
      display.show(builder);
      Process window = builder.start();
      assertTrue(window.waitFor(90, TimeUnit.SECONDS), "the window did not close by itself");
      assertEquals(0, window.exitValue());
    }
    BufferedImage image = ImageIO.read(picture);
    int orange = 0;
    for (int y = 0; y < image.getHeight(); y += 4) {
      for (int x = 0; x < image.getWidth(); x += 4) {
        int rgb = image.getRGB(x, y);
        orange += (rgb >> 16 & 0xff) > 200 && (rgb & 0xff) < 130 ? 1 : 0;
      }
    }
    assertTrue(orange > 2_000, "of the pyramid " + orange + " samples are seen");
  }

  @Test
  void anUnknownSceneIsAFlagErrorThatNamesTheNearest() {
    String text = errors(2, "--scene", "piramid");
    assertTrue(text.contains("unknown scene=piramid; did you mean \"pyramid\"?"), text);
    assertTrue(text.contains("--scene list"), text);
    errors(2, "--scene", "pyramid", "--headless");
  }

  @Test
  void theListNamesEveryScene() {
    PrintStream before = System.out;
    ByteArrayOutputStream printed = new ByteArrayOutputStream();
    System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
    try {
      assertEquals(0, ClientMain.run("--scene", "list"));
    } finally {
      System.setOut(before);
    }
    List<String> lines = printed.toString(StandardCharsets.UTF_8).lines().toList();
    assertEquals(Scenes.names(), lines.stream().map(l -> l.substring(0, l.indexOf(' '))).toList());
  }

  private static String errors(int exitCode, String... flags) {
    PrintStream before = System.err;
    ByteArrayOutputStream printed = new ByteArrayOutputStream();
    System.setErr(new PrintStream(printed, true, StandardCharsets.UTF_8));
    try {
      assertEquals(exitCode, ClientMain.run(flags));
    } finally {
      System.setErr(before);
    }
    return printed.toString(StandardCharsets.UTF_8);
  }
}
