package carom.lab.figures;

import carom.client.bots.BotsMain;
import carom.lab.measure.Figure;
import carom.server.ServerMain;
import java.io.File;
import java.io.IOException;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Measures a server process and a process with 500 bots over loopback sockets in real time, with
 * the flags of docs/lab/BENCHMARKS.md, "A crowd", and the JVM flags of the start scripts.
 */
final class CrowdFigures {
  private static final int BOTS = 500;
  private static final int ROOMS = 2;
  private static final List<String> SERVER_FLAGS =
      List.of(
          "-Xms192m",
          "-Xmn8m",
          "-XX:+UseSerialGC",
          "--add-exports",
          "java.base/jdk.internal.module=ALL-UNNAMED");
  private static final List<String> PRIORITIES =
      List.of("-XX:ThreadPriorityPolicy=1", "-XX:CompilerThreadPriority=10", "-XX:-PrintWarnings");
  private static final Pattern TICK = Pattern.compile("tick p50 \\S+ p99 (\\S+) max");
  private static final Pattern JOINED = Pattern.compile("\"joined\":(\\d+)");
  private static final Pattern LOST = Pattern.compile("\"disconnects\":(\\d+)");

  private CrowdFigures() {}

  static List<Figure> measure(boolean quick) throws IOException, InterruptedException {
    int port = freePort();
    File serverLog = Files.createTempFile("carom-figures", ".log").toFile();
    File botLog = Files.createTempFile("carom-figures", ".log").toFile();
    boolean linux = System.getProperty("os.name").equals("Linux");
    List<String> priorities = linux ? PRIORITIES : List.of();
    List<String> serverFlags = new ArrayList<>(SERVER_FLAGS);
    serverFlags.addAll(priorities);
    Process server =
        Children.start(
            serverLog,
            serverFlags,
            ServerMain.class,
            "--tcp-port",
            String.valueOf(port),
            "--udp-port",
            String.valueOf(port),
            "--rooms",
            String.valueOf(ROOMS),
            "--max-players",
            String.valueOf(BOTS / ROOMS),
            "--level",
            "commons",
            "--snapshot-rate",
            "30",
            "--view",
            "24",
            "--status-interval",
            "5");
    try {
      TimeUnit.SECONDS.sleep(5);
      Process bots =
          Children.start(
              botLog,
              priorities,
              BotsMain.class,
              "--host",
              "localhost:" + port,
              "--count",
              String.valueOf(BOTS),
              "--input-every",
              "2",
              "--roam",
              "--seconds",
              quick ? "10" : "30");
      if (!bots.waitFor(300, TimeUnit.SECONDS)) {
        bots.destroyForcibly();
      }
    } finally {
      server.destroy(); // it says goodbye and sums up
      if (!server.waitFor(20, TimeUnit.SECONDS)) {
        server.destroyForcibly();
      }
    }
    String said = Files.readString(serverLog.toPath());
    String told = Files.readString(botLog.toPath());
    Files.delete(serverLog.toPath());
    Files.delete(botLog.toPath());
    double p99 = 0;
    for (Matcher m = TICK.matcher(said); m.find(); ) {
      p99 = Math.max(p99, Double.parseDouble(m.group(1)));
    }
    return List.of(
        Figure.atMost(16, "500 bots on the same cores: p99 tick", p99 == 0 ? Double.NaN : p99, "ms")
            .withNote(
                "the worst of all rooms and of all spells of 5 s, joins included; %d rooms", ROOMS),
        Figure.atLeast(BOTS, "500 bots: joined", last(JOINED, told), ""),
        Figure.atMost(0, "500 bots: disconnects", last(LOST, told), ""));
  }

  private static double last(Pattern pattern, String text) {
    double value = Double.NaN;
    for (Matcher m = pattern.matcher(text); m.find(); ) {
      value = Double.parseDouble(m.group(1));
    }
    return value;
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0)) {
      return socket.getLocalPort();
    }
  }
}
