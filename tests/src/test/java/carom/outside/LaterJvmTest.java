package carom.outside;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.suite.Needs;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: an update of Java stops no program, and no flag is complained of. Method: the installed
 * programs on each other JVM of this machine; skipped if there is none.
 */
@Needs("processes")
@Timeout(120)
final class LaterJvmTest {
  private static final Pattern COMPLAINT =
      Pattern.compile("VM warning|WARNING:|(?i)unrecognized|deprecated");

  @TempDir Path folder;

  @Test
  void laterJvmsRunAllPrograms() throws Exception {
    List<Path> homes = LaterJvms.homes();
    Assumptions.assumeFalse(homes.isEmpty(), "no later JVM in /usr/lib/jvm");
    for (Path home : homes) {
      Map<String, String> java = Map.of("JAVA_HOME", home.toString());
      try (Installation programs =
          new Installation(Files.createDirectory(folder.resolve(home.getFileName())))) {
        Installation.Running server = programs.server(java, "data", "--record=game.carom");
        int port = server.port();
        assertTrue(port > 0, server.output());
        Installation.Running bots =
            programs.start(
                java, "carom-bots", "--host=127.0.0.1:" + port, "--count=2", "--seconds=2");
        assertEquals(0, bots.end(), bots.output());
        server.type("stop");
        assertEquals(0, server.end(), server.output());
        assertTrue(server.output().contains("engine: vector kernels"), server.output());
        Installation.Running replay = programs.start(java, "carom", "replay", "game.carom");
        assertEquals(0, replay.end(), replay.output());
        Installation.Running help = programs.start(java, "carom-client", "--help");
        assertEquals(0, help.end(), help.output());
        for (Installation.Running program : List.of(server, bots, replay, help)) {
          assertFalse(COMPLAINT.matcher(program.output()).find(), program.output());
        }
      }
    }
  }
}
