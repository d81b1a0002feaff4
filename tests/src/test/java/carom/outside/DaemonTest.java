package carom.outside;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.suite.Needs;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** An installed server that is started as some daemons are, and another one at its folder. */
@Needs("processes")
final class DaemonTest {
  @TempDir Path folder;

  @Test
  void closedStreamsAreNoCommandsAndNoTwoServersShareAFolder() throws Exception {
    Path server = Path.of(System.getProperty("carom.install"), "bin", "carom-server");
    try (Installation programs = new Installation(folder)) {
      Installation.Running daemon =
          programs.start(
              Map.of(),
              "/bin/sh",
              "-c",
              "exec \"$0\" \"$@\" <&-",
              server.toString(),
              "--tcp-port=0",
              "--udp-port=0",
              "--web-port=0",
              "--bind=127.0.0.1",
              "--data=data");
      assertTrue(daemon.port() > 0, daemon.output());
      Installation.Running second = programs.server(Map.of(), "data");
      assertEquals(1, second.end(), second.output());
      assertTrue(second.output().contains("another server uses data=data"), second.output());
      assertTrue(second.output().contains("with --data"), second.output());
      assertFalse(second.output().contains("\tat "), second.output());
      assertTrue(daemon.process.isAlive());
      assertFalse(daemon.output().contains("command"), daemon.output());
    }
  }
}
