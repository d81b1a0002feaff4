package carom.server.directory;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * A PostgreSQL on a free port and in a folder of its own. It refuses to run as root: then it runs
 * as the user postgres of its Debian package.
 */
public final class PostgresProgram implements AutoCloseable {
  /** Needs to be encoded in an address. */
  static final String PASSWORD = "ge:h/e@i%m";

  /** The same, encoded. */
  public static final String ENCODED = "ge%3Ah%2Fe%40i%25m";

  private final Path bin;
  private final Path folder;
  private final boolean isRoot = System.getProperty("user.name").equals("root");
  private final int port;
  private Process process;

  /** Starts PostgreSQL, or skips the test where that isn't possible. */
  public PostgresProgram() throws Exception {
    Optional<Path> initdb = Programs.find("initdb", installed());
    assumeTrue(initdb.isPresent(), "PostgreSQL isn't installed: apt-get install postgresql");
    bin = initdb.get().getParent();
    assumeTrue(
        !isRoot || Programs.find("setpriv").isPresent() && succeeds("id", "postgres"),
        "PostgreSQL doesn't run as root, and there is no user postgres, or no setpriv");
    folder = Files.createTempDirectory("carom-postgres");
    Path password = Files.writeString(folder.resolve("password"), PASSWORD);
    if (isRoot) {
      assertTrue(succeeds("chown", "-R", "postgres:", folder.toString()));
    }
    Process made =
        start(
            "initdb",
            "--pgdata=" + folder.resolve("data"),
            "--username=carom",
            "--auth=scram-sha-256",
            "--pwfile=" + password,
            "--encoding=UTF8",
            "--locale=C",
            "--no-sync");
    assertTrue(made.waitFor(60, TimeUnit.SECONDS), "initdb must end");
    assumeTrue(made.exitValue() == 0, "initdb fails: " + log());
    port = Programs.freePorts(1).get(0);
    start();
  }

  /** Returns the folders in which Debian has PostgreSQL's programs, the newest first. */
  private static String[] installed() {
    File[] versions = new File("/usr/lib/postgresql").listFiles();
    return versions == null
        ? new String[0]
        : Stream.of(versions)
            .sorted(Comparator.comparing(File::getName).reversed())
            .map(version -> version + "/bin")
            .toArray(String[]::new);
  }

  private static boolean succeeds(String... command) throws Exception {
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    return process.waitFor() == 0;
  }

  private Process start(String program, String... arguments) throws IOException {
    List<String> command = new ArrayList<>();
    if (isRoot) {
      command.addAll(List.of("setpriv", "--reuid=postgres", "--regid=postgres", "--clear-groups"));
    }
    command.add(bin.resolve(program).toString());
    command.addAll(List.of(arguments));
    return new ProcessBuilder(command)
        .directory(folder.toFile())
        .redirectErrorStream(true)
        .redirectOutput(ProcessBuilder.Redirect.appendTo(log().toFile()))
        .start();
  }

  private Path log() {
    return folder.resolveSibling(folder.getFileName() + ".log");
  }

  /** Starts it, again with what it had stored. */
  public void start() throws IOException {
    process =
        start(
            "postgres",
            "-D",
            folder.resolve("data").toString(),
            "-p",
            "" + port,
            "-c",
            "listen_addresses=127.0.0.1",
            "-c",
            "unix_socket_directories=",
            "-c",
            "fsync=off");
  }

  /** Waits until it answers. */
  public void await() throws Exception {
    try (Directory directory = Directories.open(address(List.of(port)), DirectoryTls.NONE)) {
      await(directory);
    }
  }

  /** Waits until it answers. */
  void await(Directory directory) throws Exception {
    for (int i = 0; ; i++) {
      try {
        directory.get("started");
        return;
      } catch (DirectoryException e) {
        assertTrue(process.isAlive() && i < 300, e.getMessage() + "\n" + Files.readString(log()));
        Thread.sleep(100);
      }
    }
  }

  /** Returns its port. */
  public int port() {
    return port;
  }

  /** Returns its address behind ports of this machine. */
  public static String address(List<Integer> ports) {
    String hosts = String.join(",", ports.stream().map(port -> "127.0.0.1:" + port).toList());
    return "postgresql://carom:" + ENCODED + "@" + hosts + "/postgres";
  }

  /** Ends it at once, as a crash does. */
  public void kill() throws Exception {
    signal("-QUIT");
  }

  private void signal(String signal) throws Exception {
    assertEquals(0, new ProcessBuilder("kill", signal, "" + process.pid()).start().waitFor());
    assertTrue(process.waitFor(30, TimeUnit.SECONDS), "it must end");
  }

  @Override
  public void close() throws IOException {
    try {
      if (process.isAlive()) {
        signal("-INT"); // without waiting for its clients
      }
    } catch (Exception e) {
      throw new AssertionError(e);
    }
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    }
    Files.delete(log());
  }
}
