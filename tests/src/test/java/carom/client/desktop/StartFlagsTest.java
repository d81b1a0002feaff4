package carom.client.desktop;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.client.app.ClientMain;
import carom.client.bots.Bot;
import carom.fixtures.Jvm;
import carom.fixtures.VirtualDisplay;
import carom.game.Games;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.transport.Impairment;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.sim.level.Level;
import carom.suite.Needs;
import carom.testkit.Stepper;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: each way to start the window shows a picture. Method: a window on a virtual display for
 * each flag, which ends by itself and says nothing on standard error.
 */
@Needs("windows")
@Timeout(300)
final class StartFlagsTest {
  @TempDir private Path folder;

  @BeforeEach
  void needsXvfb() {
    assumeTrue(VirtualDisplay.available(), "Xvfb is not installed (Debian: apt-get install xvfb)");
  }

  @Test
  void withoutFlagsTheStartScreenShows() throws Exception {
    assertShows();
  }

  @Test
  void aSceneShows() throws Exception {
    assertShows("--scene", "pyramid");
  }

  @Test
  void aNewLevelShowsInTheEditor() throws Exception {
    assertShows("--edit", folder.resolve("new.json").toString(), "--bots", "1");
  }

  @Test
  void aRecordingShows() throws Exception {
    Path recorded = folder.resolve("match.carom");
    try (Stepper stepper = Stepper.of("arena")) {
      stepper.server().record(recorded);
      stepper.join("Ann", Impairment.NONE, new Bot(1));
      stepper.run(6);
    }
    assertShows("--replay", recorded.toString());
  }

  @Test
  void aServersGameShowsPlayedAndWatched() throws Exception {
    try (Server server =
        new Server(
            ServerConfig.defaults().with(ServerConfig.GAME, "arena"),
            () -> Games.create("arena"),
            Level.builtIn("arena"),
            new KryoServerTransport(0, 0),
            System::nanoTime)) {
      server.allowSpectators(1);
      server.start();
      String address = "localhost:" + server.tcpPort();
      assertShows("--host", address);
      assertShows("--watch", "--host", address);
    }
  }

  @Test
  void aLevelThatCanNotBeEditedIsNamedWithItsLineBeforeAWindowOpens() throws Exception {
    Path broken = folder.resolve("broken.json");
    Files.writeString(broken, "{\n  \"name\" \"x\"\n}\n");
    PrintStream out = System.err;
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    System.setErr(new PrintStream(said, true, UTF_8));
    try {
      assertEquals(2, ClientMain.run("--edit", broken.toString()));
      assertEquals(2, ClientMain.run("--edit", "new.json", "--headless"));
    } finally {
      System.setErr(out);
    }
    assertTrue(said.toString(UTF_8).contains(broken + ":2:"), said.toString(UTF_8));
    assertTrue(said.toString(UTF_8).contains("--edit excludes"), said.toString(UTF_8));
  }

  /** Starts a window with flags, and asserts that it shows more than a bare ground. */
  private void assertShows(String... flags) throws Exception {
    Path picture = folder.resolve("window.png");
    Path output = folder.resolve("window.txt");
    String settings = folder.resolve("player.conf").toString();
    List<String> command = Jvm.command(CalmWindow.class, "--settings", settings);
    command.addAll(List.of("--volume", "0", "--seconds", "3", "--screenshot", picture.toString()));
    command.addAll(List.of(flags));
    try (VirtualDisplay display = VirtualDisplay.open()) {
      ProcessBuilder builder =
          new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(output.toFile());
      display.show(builder);
      Process window = builder.start();
      try {
        assertTrue(window.waitFor(100, TimeUnit.SECONDS), () -> "never ends\n" + read(output));
      } finally {
        window.destroyForcibly();
      }
      assertEquals(0, window.exitValue(), () -> read(output));
    }
    assertTrue(!read(output).contains("Exception"), () -> read(output));
    BufferedImage image = ImageIO.read(picture.toFile());
    Set<Integer> colours = new HashSet<>();
    for (int y = 0; y < image.getHeight(); y += 2) {
      for (int x = 0; x < image.getWidth(); x += 2) {
        colours.add(image.getRGB(x, y));
      }
    }
    assertTrue(colours.size() > 60, List.of(flags) + " shows colours: " + colours.size());
    Files.delete(picture);
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return "no output: " + e;
    }
  }
}
