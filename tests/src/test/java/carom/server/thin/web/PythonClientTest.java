package carom.server.thin.web;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.outside.Python;
import carom.suite.Needs;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: a client in another language plays by docs/protocol/THIN.md alone. Method: the example of
 * docs/thin, with the Python package websockets as pip installs it, joins a real server's arena.
 */
@Timeout(400)
@Needs("sockets")
final class PythonClientTest {
  private static final Path EXAMPLE = Path.of("../docs/thin/client.py").toAbsolutePath();

  @TempDir private Path folder;

  @Test
  void theExampleJoinsMovesChatsAndLeaves() throws Exception {
    Python python = new Python(folder, "thin-clients", List.of("websockets==15.0.1"));
    try (PlayServer server = new PlayServer("arena");
        WebPlayer other = server.player()) {
      other.say("{\"join\": {\"name\": \"Bob\"}}");
      other.await("match");
      String text = python.run(EXAMPLE, "ws://127.0.0.1:" + server.port.tcpPort() + "/thin", "Ann");
      List<String> lines = text.lines().toList();
      assertTrue(lines.get(0).startsWith("arena in Corner Pocket, room 1, I am "), text);
      assertTrue(lines.contains("Ann: hello from Python"), text);
      Matcher moved =
          Pattern.compile("moved from (-?[0-9.]+) to (-?[0-9.]+)")
              .matcher(lines.get(lines.size() - 1));
      assertTrue(moved.matches(), text);
      assertTrue(Double.parseDouble(moved.group(2)) > Double.parseDouble(moved.group(1)) + 1, text);
      while (!other.await("chat").fields.get("text").text.equals("hello from Python")) {
        // the server says who comes and goes, too
      }
      while (server.server.rooms().get(0).seats().takenCount() > 1) {
        Thread.sleep(10); // it has left, and isn't waited for
      }
    }
  }
}
