package carom.client.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.client.app.ClientMain;
import carom.client.desktop.paint.ViewCamera;
import carom.fixtures.Jvm;
import carom.fixtures.VirtualDisplay;
import carom.game.Games;
import carom.net.kryo.server.KryoServerTransport;
import carom.physics.math.Aabb;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import carom.suite.Needs;
import com.badlogic.gdx.utils.GdxNativesLoader;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a player sees the server's world. Method: a real window on a virtual display joins a real
 * server over sockets; the picture it saves is compared with where the server has things.
 */
@Needs("windows")
final class WindowTest {
  private static final int COLOUR_TOLERANCE = 14;
  private static final float METRES_ASIDE =
      0.62f; // of a body's radius: beside the eyes, inside the edge

  @TempDir Path folder;

  @Test
  void showsTheServersWorldWhereTheServerHasIt() throws Exception {
    assumeTrue(VirtualDisplay.available(), "Xvfb is not installed (Debian: apt-get install xvfb)");
    Level level = Level.builtIn("arena");
    Path picture = folder.resolve("window.png");
    List<float[]> crates = new ArrayList<>();
    float[] player = new float[2];
    int playerColour;
    int crateColour = 0;
    try (VirtualDisplay display = VirtualDisplay.open();
        Server server =
            new Server(
                ServerConfig.defaults().with(ServerConfig.GAME, "arena"),
                () -> Games.create("arena"),
                level,
                new KryoServerTransport(0, 0),
                System::nanoTime)) {
      server.start();
      Process window = openWindow(display, server, picture);
      SimulationHost world = server.rooms().get(0).simulation();
      HostPlayer joined = awaitPlayer(world, window);
      // Nobody plays: everything rests, so that the server's state now is what the picture shows.
      assertTrue(window.waitFor(60, TimeUnit.SECONDS), "the window did not close by itself");
      assertEquals(0, window.exitValue(), () -> output(folder));
      playerColour =
          joined.entity() == null ? lastColour : joined.entity().archetype().appearance().rgb();
      player[0] = lastX;
      player[1] = lastY;
      for (int id = 0; id < world.entityCapacity(); id++) {
        HostEntity e = world.entity(id);
        if (e != null && e.archetype().name().contains("crate")) {
          crates.add(new float[] {e.body().x(), e.body().y()});
          crateColour = e.archetype().appearance().rgb();
        }
      }
    }
    BufferedImage image = ImageIO.read(picture.toFile());
    assertEquals(1_280, image.getWidth());
    assertEquals(720, image.getHeight());
    GdxNativesLoader.load(); // the camera's matrices
    ViewCamera camera = new ViewCamera();
    Aabb subject = new Aabb(player[0], player[1], player[0], player[1]);
    camera.update(level.bounds(), subject, 0, 1_280, 720, 1);

    assertColour(
        playerColour, image, camera, player[0] - METRES_ASIDE * 0.5f, player[1] - 0.3f, "player");
    assertTrue(!crates.isEmpty(), "the arena has crates");
    int shown = 0;
    for (float[] crate : crates) {
      // Off the diagonals, which are the planks' lines.
      shown += near(crateColour, pixel(image, camera, crate[0] + 0.3f, crate[1])) ? 1 : 0;
    }
    // Some stand below the list of players.
    assertTrue(
        shown >= crates.size() / 2,
        shown + " of " + crates.size() + " crates are where the server has them");
    assertTrue(colours(image) > 200, "the picture has " + colours(image) + " colours");
  }

  @Test
  void saysWhatToDoWhereThereIsNoDisplay() throws Exception {
    assumeTrue(System.getProperty("os.name").startsWith("Linux"), "elsewhere there always is one");
    ProcessBuilder builder = client("--host", "localhost", "--seconds", "1");
    builder.environment().remove("DISPLAY");
    builder.environment().remove("WAYLAND_DISPLAY");
    Process process = builder.start();
    assertTrue(process.waitFor(30, TimeUnit.SECONDS));
    assertEquals(1, process.exitValue());
    assertTrue(output(folder).contains("--headless"), () -> output(folder));
    assertEquals(2, output(folder).lines().count(), () -> output(folder));
  }

  private volatile float lastX;
  private volatile float lastY;
  private volatile int lastColour;

  private HostPlayer awaitPlayer(SimulationHost world, Process window) throws InterruptedException {
    long deadline = System.nanoTime() + 50_000_000_000L;
    HostPlayer found = null;
    while (window.isAlive() && System.nanoTime() < deadline) {
      HostPlayer player;
      try {
        player = world.player(0);
      } catch (IllegalStateException inTheMiddleOfAStep) {
        continue; // of the room's thread
      }
      if (player != null && player.entity() != null) {
        found = player;
        lastX = player.entity().body().x();
        lastY = player.entity().body().y();
        lastColour = player.entity().archetype().appearance().rgb();
      }
      Thread.sleep(20);
    }
    assertTrue(found != null, () -> "nobody joined\n" + output(folder));
    return found;
  }

  private Process openWindow(VirtualDisplay display, Server server, Path picture) throws Exception {
    ProcessBuilder builder =
        client(
            "--host",
            "localhost:" + server.tcpPort(),
            "--name",
            "Viewer",
            "--seconds",
            "6",
            "--screenshot",
            picture.toString());
    display.show(builder);
    return builder.start();
  }

  private ProcessBuilder client(String... flags) {
    String settings = folder.resolve("player.conf").toString();
    List<String> command = Jvm.command(ClientMain.class, "--settings", settings);
    command.addAll(List.of(flags));
    return new ProcessBuilder(command)
        .redirectErrorStream(true)
        .redirectOutput(folder.resolve("window.txt").toFile());
  }

  private static String output(Path folder) {
    try {
      return Files.readString(folder.resolve("window.txt"));
    } catch (IOException e) {
      return "no output: " + e;
    }
  }

  private static void assertColour(
      int rgb, BufferedImage image, ViewCamera camera, float x, float y, String what) {
    int seen = pixel(image, camera, x, y);
    assertTrue(
        near(rgb, seen),
        () ->
            String.format(
                Locale.ROOT,
                "%s at %.2f, %.2f: expected %06x, seen %06x",
                what,
                x,
                y,
                rgb,
                seen & 0xffffff));
  }

  private static int pixel(BufferedImage image, ViewCamera camera, float x, float y) {
    float scale = camera.pixelsPerMetre(image.getHeight());
    int px = Math.round((x - camera.gdx().position.x) * scale + image.getWidth() / 2f);
    int py = Math.round(image.getHeight() / 2f - (y - camera.gdx().position.y) * scale);
    return image.getRGB(px, py);
  }

  private static boolean near(int a, int b) {
    for (int shift = 0; shift < 24; shift += 8) {
      if (Math.abs((a >> shift & 0xff) - (b >> shift & 0xff)) > COLOUR_TOLERANCE) {
        return false;
      }
    }
    return true;
  }

  private static int colours(BufferedImage image) {
    Set<Integer> seen = new HashSet<>();
    for (int y = 0; y < image.getHeight(); y += 2) {
      for (int x = 0; x < image.getWidth(); x += 2) {
        seen.add(image.getRGB(x, y));
      }
    }
    return seen.size();
  }
}
