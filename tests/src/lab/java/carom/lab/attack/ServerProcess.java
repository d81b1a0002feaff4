package carom.lab.attack;

import carom.options.Lab;
import carom.server.ServerMain;
import java.io.BufferedReader;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * A server in a process of its own, on free ports of this machine and with an empty data folder.
 * Its log is kept line by line. Closing it ends the process. Any thread may read the log.
 */
final class ServerProcess implements AutoCloseable {
  private final int tcp = freePort();
  private final int udp = freePort();
  private final Process process;
  private final List<String> log = new ArrayList<>(); // guarded by itself
  private final LinkedBlockingQueue<String> unread = new LinkedBlockingQueue<>();

  /**
   * Starts a server and waits until it is ready.
   *
   * @param further flags of the server
   * @throws IOException if it ends before it is ready
   */
  ServerProcess(List<String> further) throws IOException {
    List<String> flags = new ArrayList<>(List.of("--no-console", "--bind=127.0.0.1"));
    flags.add("--data=" + Files.createTempDirectory("carom-attack"));
    flags.addAll(List.of("--log-keep=0", "--tcp-port=" + tcp, "--udp-port=" + udp));
    flags.addAll(further);
    process = start(ServerMain.class.getName(), flags);
    BufferedReader lines = process.inputReader(StandardCharsets.UTF_8);
    for (String line = lines.readLine(); ; line = lines.readLine()) {
      if (line == null) {
        throw new IOException("the server ended before it was ready");
      }
      System.out.println("server: " + line);
      if (line.contains("ready")) {
        break;
      }
    }
    Thread reader = new Thread(() -> read(lines), "server-log");
    reader.setDaemon(true);
    reader.start();
  }

  /**
   * Starts a program of Carom with this process's classes and its script's flags for the JVM; its
   * output is one stream.
   */
  static Process start(String program, List<String> flags) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-Xms192m", "-Xmx512m", "-Xmn8m", "-XX:+UseSerialGC"));
    command.addAll(List.of("-XX:ThreadPriorityPolicy=1", "-XX:CompilerThreadPriority=10"));
    command.addAll(List.of("-XX:-PrintWarnings", "-Dkryo.unsafe=false"));
    command.addAll(List.of("--add-modules", "jdk.incubator.vector", "-cp", Lab.classPath()));
    command.add(program);
    command.addAll(flags);
    return new ProcessBuilder(command).redirectErrorStream(true).start();
  }

  static int freePort() throws IOException {
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return probe.getLocalPort();
    }
  }

  private void read(BufferedReader lines) {
    try {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        add(line);
      }
    } catch (IOException e) {
      add("(the server's output ends: " + e.getMessage() + ")");
    }
  }

  private void add(String line) {
    synchronized (log) {
      log.add(line);
    }
    unread.add(line);
  }

  int tcp() {
    return tcp;
  }

  int udp() {
    return udp;
  }

  /** Returns all lines since the server was ready. */
  List<String> log() {
    synchronized (log) {
      return new ArrayList<>(log);
    }
  }

  /** Waits for the next line that has a text, and forgets those before it. */
  String awaitLine(String text, int seconds) throws InterruptedException, TimeoutException {
    long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
    while (true) {
      String line = unread.poll(deadline - System.nanoTime(), TimeUnit.NANOSECONDS);
      if (line == null) {
        throw new TimeoutException("the server wrote no line with '" + text + "' in time");
      }
      if (line.contains(text)) {
        return line;
      }
    }
  }

  @Override
  public void close() {
    process.destroy();
    try {
      process.waitFor(10, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Returns the flags of one text. */
  static List<String> split(String flags) {
    return Arrays.stream(flags.trim().split(" +", -1)).filter(flag -> !flag.isEmpty()).toList();
  }
}
