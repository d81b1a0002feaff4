package carom.lab.attack;

import carom.client.bots.BotsMain;
import carom.net.frame.Frame;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeoutException;
import java.util.function.ToDoubleFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Compares what a server that is played on says of its ticks with and without a flood of datagrams.
 * The turns without and with each flood follow each other, so that what slows the machine for a
 * while slows both. A turn is the time between two status lines of the server.
 */
final class FloodTrial {
  private static final Pattern STATUS =
      Pattern.compile(
          "status: (\\d+) of .*tick p50 ([0-9.]+) p99 ([0-9.]+).* ms"
              + ".*inputs missing ([0-9.]+) %");

  /** Least time until the server's code is compiled, s. */
  private static final int WARM_UP_S = 60;

  /** Most turns until all bots have joined. */
  private static final int MOST_WAITS = 30;

  private final FloodOptions options;
  private final List<String> serverFlags;

  /** A status line of the server for one turn: times in ms, missing inputs in percent. */
  private record Turn(int players, double p50, double p99, double missing) {}

  /** The turns without and with one flood. */
  private record Row(Flood flood, List<Turn> without, List<Turn> with) {}

  FloodTrial(FloodOptions options, List<String> serverFlags) {
    this.options = options;
    this.serverFlags = serverFlags;
  }

  /** Measures all floods and prints the table. */
  void run() throws IOException, InterruptedException, TimeoutException {
    List<String> flags = new ArrayList<>();
    flags.add("--status-interval=" + options.turnS());
    flags.add("--max-players=" + (options.bots() + options.players()));
    flags.add("--max-load=0"); // flooding players are newcomers, also on a busy machine
    flags.addAll(serverFlags);
    try (ServerProcess server = new ServerProcess(flags)) {
      List<Row> rows = new ArrayList<>();
      for (Flood flood : floods(server, linkOfAStranger(server))) {
        rows.add(new Row(flood, new ArrayList<>(), new ArrayList<>()));
      }
      Process bots = bots(server);
      try {
        measure(server, rows);
      } finally {
        bots.destroy();
      }
    }
  }

  /** Returns the number of a link that closes at once. Those of players who join then follow it. */
  private static int linkOfAStranger(ServerProcess server) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.tcp());
        DataInputStream in = new DataInputStream(socket.getInputStream())) {
      in.skipNBytes(Frame.LENGTH_BYTES + 1);
      return in.readInt();
    }
  }

  private List<Flood> floods(ServerProcess server, int link) {
    InetSocketAddress udp = new InetSocketAddress(InetAddress.getLoopbackAddress(), server.udp());
    List<Flood> floods = new ArrayList<>();
    if (options.players() > 0) {
      floods.add(new PlayerFlood(server, options.players(), options.budgets()));
    }
    options.rates().forEach(r -> floods.add(new StrangerFlood(udp, r, link, options.bots())));
    return floods;
  }

  private Process bots(ServerProcess server) throws IOException {
    Process bots =
        ServerProcess.start(
            BotsMain.class.getName(),
            List.of(
                "--host=127.0.0.1:" + server.tcp(),
                "--count=" + options.bots(),
                "--seconds=86400"));
    Thread drain = new Thread(() -> tell(bots), "bots-output");
    drain.setDaemon(true);
    drain.start();
    return bots;
  }

  /** Prints what bots say, but for their progress. */
  private static void tell(Process bots) {
    try {
      bots.inputReader()
          .lines()
          .filter(line -> !line.contains(" play, "))
          .forEach(line -> System.out.println("bots: " + line));
    } catch (UncheckedIOException e) {
      System.out.println("bots: end");
    }
  }

  private void measure(ServerProcess server, List<Row> rows)
      throws InterruptedException, TimeoutException {
    Turn last = turn(server);
    for (int i = 0; i < MOST_WAITS && last.players < options.bots(); i++) {
      last = turn(server);
    }
    for (int s = 0; s < WARM_UP_S; s += options.turnS()) {
      turn(server);
    }
    long floodNs = 0;
    for (int pair = 1; pair <= options.pairs(); pair++) {
      for (Row row : rows) {
        row.without.add(playedTurn(server));
        long began = System.nanoTime();
        row.flood.begin();
        try {
          row.with.add(playedTurn(server));
        } finally {
          row.flood.end();
        }
        floodNs += System.nanoTime() - began;
      }
      System.out.printf("%n%d of %d pairs%n", pair, options.pairs());
      print(rows, floodNs / (double) rows.size() * 1e-9);
    }
  }

  private Turn playedTurn(ServerProcess server) throws InterruptedException, TimeoutException {
    Turn turn = turn(server);
    if (turn.players < options.bots()) {
      throw new IllegalStateException(
          "only " + turn.players + " of " + options.bots() + " bots play: " + server.log());
    }
    return turn;
  }

  private Turn turn(ServerProcess server) throws InterruptedException, TimeoutException {
    String line = server.awaitLine("status: ", options.turnS() + 60);
    Matcher status = STATUS.matcher(line);
    if (!status.find()) {
      throw new IllegalStateException("a status line without tick times: " + line);
    }
    return new Turn(
        Integer.parseInt(status.group(1)),
        Double.parseDouble(status.group(2)),
        Double.parseDouble(status.group(3)),
        Double.parseDouble(status.group(4)));
  }

  private static void print(List<Row> rows, double secondsOfEach) {
    System.out.println(
        "| flood | datagrams sent, per second | tick p50 without, with | tick p99 without, with"
            + " | p99 with / without: median, least, most | inputs missing without, with |");
    System.out.println("| --- | --- | --- | --- | --- | --- |");
    for (Row row : rows) {
      double[] ratios = new double[row.with.size()];
      Arrays.setAll(ratios, i -> row.with.get(i).p99 / row.without.get(i).p99);
      Arrays.sort(ratios);
      System.out.printf(
          "| %s | %.0f | %.2f, %.2f ms | %.2f, %.2f ms | %.2f, %.2f, %.2f | %.2f, %.2f %% |%n",
          row.flood.name(),
          row.flood.sent() / secondsOfEach,
          median(row.without, Turn::p50),
          median(row.with, Turn::p50),
          median(row.without, Turn::p99),
          median(row.with, Turn::p99),
          median(ratios),
          ratios[0],
          ratios[ratios.length - 1],
          median(row.without, Turn::missing),
          median(row.with, Turn::missing));
    }
    rows.forEach(row -> System.out.print(row.flood.findings()));
  }

  private static double median(List<Turn> turns, ToDoubleFunction<Turn> value) {
    return median(turns.stream().mapToDouble(value).sorted().toArray());
  }

  private static double median(double[] sorted) {
    return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
  }
}
