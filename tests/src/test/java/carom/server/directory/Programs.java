package carom.server.directory;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** What tests of installed programs have in common. */
final class Programs {
  private Programs() {}

  /** Returns a program of the PATH or of other folders. */
  static Optional<Path> find(String name, String... folders) {
    return Stream.concat(
            Stream.of(folders), Stream.of(System.getenv("PATH").split(java.io.File.pathSeparator)))
        .map(folder -> Path.of(folder, name))
        .filter(Files::isExecutable)
        .findFirst();
  }

  /** Returns ports that were free a moment ago. */
  static List<Integer> freePorts(int many) throws IOException {
    List<ServerSocket> sockets = new ArrayList<>();
    try {
      for (int i = 0; i < many; i++) {
        sockets.add(new ServerSocket(0, 1, InetAddress.getLoopbackAddress()));
      }
      return sockets.stream().map(ServerSocket::getLocalPort).toList();
    } finally {
      for (ServerSocket socket : sockets) {
        socket.close();
      }
    }
  }

  /** Ends a process, by force if it doesn't end by itself. */
  static void end(Process process) {
    process.destroy();
    try {
      if (!process.waitFor(10, TimeUnit.SECONDS)) {
        process.destroyForcibly();
        assertTrue(process.waitFor(10, TimeUnit.SECONDS), "it must end");
      }
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }
}
