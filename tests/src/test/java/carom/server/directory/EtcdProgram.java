package carom.server.directory;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** An etcd of one member, on free ports and in a folder of its own. */
public final class EtcdProgram implements AutoCloseable {
  private final Path program;
  private final Path folder;
  private final List<String> options;
  private final int clientPort;
  private final int peerPort;
  private final String scheme;
  private Process process;

  /**
   * Starts etcd, or skips the test where it isn't installed.
   *
   * @param scheme of the client URL: http or https
   * @param options more of the command line
   */
  public EtcdProgram(Path folder, String scheme, String... options) throws Exception {
    Optional<Path> found = Programs.find("etcd");
    assumeTrue(found.isPresent(), "etcd isn't installed: apt-get install etcd-server");
    program = found.get();
    this.folder = folder;
    this.scheme = scheme;
    this.options = List.of(options);
    List<Integer> ports = Programs.freePorts(2);
    clientPort = ports.get(0);
    peerPort = ports.get(1);
    start();
  }

  /** Starts it, again with what it had stored. */
  public void start() throws Exception {
    String client = scheme + "://127.0.0.1:" + clientPort;
    String peer = "http://127.0.0.1:" + peerPort;
    List<String> command =
        new ArrayList<>(
            List.of(
                program.toString(),
                "--name=test",
                "--data-dir=" + folder.resolve("data"),
                "--listen-client-urls=" + client,
                "--advertise-client-urls=" + client,
                "--listen-peer-urls=" + peer,
                "--initial-advertise-peer-urls=" + peer,
                "--initial-cluster=test=" + peer,
                "--log-level=warn",
                "--unsafe-no-fsync"));
    command.addAll(options);
    Path log = folder.resolve("etcd.log");
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.environment().put("ETCD_UNSUPPORTED_ARCH", "arm64"); // else it doesn't start there
    process = builder.redirectOutput(ProcessBuilder.Redirect.appendTo(log.toFile())).start();
  }

  /** Waits until it answers. */
  public void await(Directory directory) throws Exception {
    for (int i = 0; ; i++) {
      try {
        directory.get("started");
        return;
      } catch (IOException e) {
        assertTrue(process.isAlive() && i < 300, e.getMessage() + "\n" + log());
        Thread.sleep(100);
      }
    }
  }

  private String log() throws IOException {
    return Files.readString(folder.resolve("etcd.log"));
  }

  int port() {
    return clientPort;
  }

  public URI url() {
    return URI.create(scheme + "://127.0.0.1:" + clientPort);
  }

  /** Ends it. */
  public void stop() {
    Programs.end(process);
  }

  @Override
  public void close() {
    stop();
  }
}
