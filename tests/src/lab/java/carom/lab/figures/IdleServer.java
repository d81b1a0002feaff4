package carom.lab.figures;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.InputSource;
import carom.client.link.ConnectionPhase;
import carom.net.frame.Trust;
import carom.net.kryo.KryoClientTransport;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Measures what an idle server takes, by thread, and how soon somebody plays who joins it. Linux
 * only. Arguments: the server's process, seconds to measure after a minute of settling (0 for joins
 * alone), and for the joins host, TCP port, UDP port and how many.
 */
public final class IdleServer {
  private static final long SETTLE_MS = 60_000;

  /** Pause between two joins, in which the server is idle again, ms. */
  private static final long PAUSE_MS = 2_000;

  private static final Pattern SWITCHES =
      Pattern.compile("(?m)^voluntary_ctxt_switches:\\s+(\\d+)$");
  private static final Pattern RESIDENT = Pattern.compile("(?m)^VmRSS:\\s+(\\d+) kB$");
  private static final double NS_PER_S = 1e9;

  private IdleServer() {}

  private record ThreadTimes(String name, long cpuNs, long wakes) {}

  private record Row(String name, double percent, double wakes) {}

  /** Measures, and prints a row for each thread, their sum, and the joins. */
  public static void main(String[] args) throws Exception {
    double seconds = Double.parseDouble(args[1]);
    if (seconds > 0) {
      measure(Path.of("/proc", args[0]), seconds);
    }
    if (args.length > 2) {
      joins(
          args[2], Integer.parseInt(args[3]), Integer.parseInt(args[4]), Integer.parseInt(args[5]));
    }
  }

  private static void measure(Path process, double seconds)
      throws IOException, InterruptedException {
    Thread.sleep(SETTLE_MS);
    Map<String, ThreadTimes> before = threads(process);
    long beganNs = System.nanoTime();
    Thread.sleep((long) (seconds * 1_000));
    Map<String, ThreadTimes> after = threads(process);
    show(before, after, (System.nanoTime() - beganNs) / NS_PER_S);
    System.out.printf(
        Locale.ROOT, "resident %.1f MB%n", number(RESIDENT, process.resolve("status")) / 1_024.0);
  }

  private static Map<String, ThreadTimes> threads(Path process) throws IOException {
    Map<String, ThreadTimes> threads = new TreeMap<>();
    try (DirectoryStream<Path> tasks = Files.newDirectoryStream(process.resolve("task"))) {
      for (Path task : tasks) {
        try {
          String name = read(task.resolve("comm")).strip();
          String[] times = read(task.resolve("schedstat")).strip().split(" ");
          long wakes = number(SWITCHES, task.resolve("status"));
          threads.put(
              "" + task.getFileName(), new ThreadTimes(name, Long.parseLong(times[0]), wakes));
        } catch (NoSuchFileException e) {
          // the thread has ended meanwhile
        }
      }
    }
    return threads;
  }

  private static String read(Path file) throws IOException {
    return Files.readString(file, StandardCharsets.ISO_8859_1);
  }

  private static long number(Pattern line, Path file) throws IOException {
    Matcher found = line.matcher(read(file));
    return found.find() ? Long.parseLong(found.group(1)) : 0;
  }

  private static void show(
      Map<String, ThreadTimes> before, Map<String, ThreadTimes> after, double seconds) {
    List<Row> rows = new ArrayList<>();
    after.forEach(
        (task, now) -> {
          ThreadTimes then = before.getOrDefault(task, new ThreadTimes(now.name, 0, 0));
          double percent = (now.cpuNs - then.cpuNs) / NS_PER_S / seconds * 100;
          rows.add(new Row(now.name, percent, (now.wakes - then.wakes) / seconds));
        });
    rows.sort(Comparator.comparingDouble(Row::percent).reversed());
    double percent = rows.stream().mapToDouble(Row::percent).sum();
    double wakes = rows.stream().mapToDouble(Row::wakes).sum();
    rows.add(0, new Row("all threads", percent, wakes));
    for (Row row : rows) {
      if (row.wakes >= 0.01 || row.percent >= 0.001) {
        System.out.printf(
            Locale.ROOT, "%7.3f %%  %7.2f wake-ups/s  %s%n", row.percent, row.wakes, row.name);
      }
    }
  }

  private static void joins(String host, int tcpPort, int udpPort, int count)
      throws InterruptedException {
    double[] ms = new double[count];
    Trust trust = Trust.firstUse();
    for (int i = -3; i < count; i++) { // three to warm up
      Thread.sleep(PAUSE_MS);
      double took = joinMs(ClientConfig.of("idler").withServer(host, tcpPort, udpPort), trust);
      if (i >= 0) {
        ms[i] = took;
      }
    }
    Arrays.sort(ms);
    System.out.printf(
        Locale.ROOT,
        "%d joins of an idle server, until the player plays: median %.0f, least %.0f, most %.0f"
            + " ms%n",
        count,
        ms[count / 2],
        ms[0],
        ms[count - 1]);
  }

  private static double joinMs(ClientConfig config, Trust trust) throws InterruptedException {
    long beganNs = System.nanoTime();
    try (KryoClientTransport transport = new KryoClientTransport(trust);
        GameClient client = new GameClient(config, transport, InputSource.IDLE)) {
      while (client.view().phase() != ConnectionPhase.PLAYING) {
        client.update(System.nanoTime());
        Thread.sleep(0, 500_000);
      }
      return (System.nanoTime() - beganNs) / 1e6;
    }
  }
}
