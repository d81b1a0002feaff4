package carom.server.thin.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.server.web.Chromium;
import carom.suite.Needs;
import com.sun.net.httpserver.HttpServer;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: the example in JavaScript plays in a browser, as somebody's own page. Method: headless
 * Chromium opens docs/thin/client.html from another port, presses a key, and its pixels are looked
 * at.
 */
@Timeout(240)
@Needs("processes")
final class JavaScriptClientTest {
  private static final Path EXAMPLE = Path.of("../docs/thin/client.html");

  @TempDir private Path folder;

  private static int colours(BufferedImage image) {
    Set<Integer> colours = new HashSet<>();
    for (int y = 0; y < image.getHeight(); y += 2) {
      for (int x = 0; x < image.getWidth(); x += 2) {
        colours.add(image.getRGB(x, y));
      }
    }
    return colours.size();
  }

  @Test
  void theExampleShowsTheArenaAndSteers() throws Exception {
    Path program = Chromium.find();
    if (program == null) {
      assertFalse(System.getenv("CI") != null, "CI has no Chromium: .ci/run installs it");
    }
    assumeTrue(program != null, "no Chromium");
    InetAddress here = InetAddress.getLoopbackAddress();
    byte[] example = Files.readAllBytes(EXAMPLE);
    HttpServer site = HttpServer.create(new InetSocketAddress(here, 0), 0);
    site.createContext(
        "/",
        exchange -> {
          exchange.getResponseHeaders().add("Content-Type", "text/html");
          exchange.sendResponseHeaders(200, example.length);
          exchange.getResponseBody().write(example);
          exchange.close();
        });
    site.start();
    PlayPort.Settings settings =
        new PlayPort.Settings(List.of(here), 0, Set.of("localhost"), List.of(), 9, 9, null);
    try (PlayServer server = new PlayServer("arena", settings);
        Chromium browser = Chromium.start(program, folder)) {
      browser.look(900, 600, true);
      browser.open(
          "http://localhost:"
              + site.getAddress().getPort()
              + "/?ws://localhost:"
              + server.port.tcpPort()
              + "/thin");
      String own = "[...bodies.values()].find(b => b.owner === match.player)";
      browser.await("match && " + own);
      String x = "String(" + own + ".poses.at(-1).x)";
      double before = Double.parseDouble(browser.evaluate(x));
      browser.evaluate("onkeydown({key: 'ArrowRight'})");
      browser.await(own + ".poses.at(-1).x > " + (before + 1));
      browser.await("clock > 0 && newest - clock < 30 && clock <= newest");
      BufferedImage picture = ImageIO.read(new ByteArrayInputStream(browser.screenshot()));
      Path kept = Path.of("build/thin-client.png");
      Files.createDirectories(kept.getParent());
      ImageIO.write(picture, "png", kept.toFile());
      assertTrue(colours(picture) > 8, "the arena has more colours");
      assertEquals(List.of(), browser.errors());
    } finally {
      site.stop(0);
    }
  }
}
