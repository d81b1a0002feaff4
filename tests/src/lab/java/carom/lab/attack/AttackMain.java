package carom.lab.attack;

import carom.net.kryo.KryoClientTransport;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.options.Lab;
import carom.server.ServerMain;
import java.io.BufferedReader;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.TimeUnit;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * Starts a server process, floods it with connections from many addresses of this machine, and lets
 * honest players join meanwhile.
 */
@Command(
    name = "attack",
    mixinStandardHelpOptions = true,
    description = "Floods a server of its own with connections while honest players join.")
public final class AttackMain implements Callable<Integer> {
  private static final double NS_PER_MS = 1e6;

  @Option(
      names = "--rate",
      paramLabel = "N",
      description = "hostile connections per second, default ${DEFAULT-VALUE}")
  private int rate = 2_000;

  @Option(
      names = "--addresses",
      paramLabel = "N",
      description = "hostile addresses, each of another /24 network, default ${DEFAULT-VALUE}")
  private int addresses = 1_000;

  @Option(names = "--register", description = "they also register by UDP, without any work")
  private boolean registers;

  @Option(
      names = "--work",
      description = "they do the work that the server demands, on two threads, and offer keys")
  private boolean works;

  @Option(
      names = "--joins",
      paramLabel = "N",
      description = "honest joins, default ${DEFAULT-VALUE}")
  private int joins = 100;

  @Option(
      names = "--interval",
      paramLabel = "MS",
      description = "ms between two honest joins, default ${DEFAULT-VALUE}")
  private int intervalMs = 200;

  @Option(
      names = "--deadline",
      paramLabel = "MS",
      description = "ms that a join may take, default ${DEFAULT-VALUE}")
  private int deadlineMs = 5_000;

  @Option(
      names = "--server-args",
      paramLabel = "ARGS",
      description = "further flags of the server, in one text")
  private String serverArgs = "";

  private final Map<String, Integer> reasons = new TreeMap<>();
  private int retries;
  private long floodBegan;

  private AttackMain() {}

  /** Runs the command. */
  public static void main(String[] args) {
    System.exit(new CommandLine(new AttackMain()).execute(args));
  }

  @Override
  public Integer call() throws Exception {
    int tcp = freePort();
    int udp = freePort();
    Path data = Files.createTempDirectory("carom-attack");
    Process server = start(tcp, udp, data);
    List<Connectors> attackers = new ArrayList<>();
    try {
      awaitReady(server);
      for (int i = 0; i < 5; i++) {
        join(tcp, udp); // warms up both ends
      }
      floodBegan = System.nanoTime();
      InetSocketAddress target = new InetSocketAddress(InetAddress.getLoopbackAddress(), tcp);
      int threads = rate > 5_000 || works ? 2 : 1;
      Connectors.Effort effort =
          works
              ? Connectors.Effort.WORK
              : registers ? Connectors.Effort.REGISTER : Connectors.Effort.SILENT;
      for (int i = 0; i < threads && rate > 0; i++) {
        int hosts = addresses / threads;
        Connectors some = new Connectors(target, i * hosts, hosts, (double) rate / threads, effort);
        attackers.add(some);
        Thread thread = new Thread(some, "attacker-" + i);
        thread.setDaemon(true);
        thread.start();
      }
      Thread.sleep(2_000);
      reasons.clear();
      retries = 0;
      report(honestJoins(tcp, udp), attackers);
      return 0;
    } finally {
      attackers.forEach(a -> a.stops = true);
      server.destroy();
      server.waitFor(10, TimeUnit.SECONDS);
    }
  }

  private Process start(int tcp, int udp, Path data) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(
        List.of("-Xmx512m", "-XX:+UseSerialGC", "--add-modules", "jdk.incubator.vector"));
    command.addAll(
        List.of("-Dkryo.unsafe=false", "-cp", Lab.classPath(), ServerMain.class.getName()));
    command.addAll(
        List.of("--data", data.toString(), "--no-console", "--bind", "127.0.0.1", "--log-keep=0"));
    command.addAll(List.of("--tcp-port=" + tcp, "--udp-port=" + udp));
    Arrays.stream(serverArgs.trim().split(" +", -1))
        .filter(a -> !a.isEmpty())
        .forEach(command::add);
    return new ProcessBuilder(command).redirectErrorStream(true).start();
  }

  private static int freePort() throws IOException {
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return probe.getLocalPort();
    }
  }

  /** Waits until the server is ready, and lets a thread count its further lines. */
  private static void awaitReady(Process server) throws IOException {
    BufferedReader lines =
        new BufferedReader(
            new java.io.InputStreamReader(server.getInputStream(), StandardCharsets.UTF_8));
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      if (line.contains("ready")) {
        Thread reader = new Thread(() -> drain(lines), "server-log");
        reader.setDaemon(true);
        reader.start();
        return;
      }
      System.out.println(line);
    }
    throw new IOException("the server ended before it was ready");
  }

  private static final ConcurrentLinkedQueue<String> LOG = new ConcurrentLinkedQueue<>();

  private static void drain(BufferedReader lines) {
    try {
      lines.lines().forEach(LOG::add);
    } catch (java.io.UncheckedIOException e) {
      LOG.add("(the server's output ends)");
    }
  }

  private List<Double> honestJoins(int tcp, int udp) throws InterruptedException {
    List<Double> tookMs = new ArrayList<>();
    List<Thread> players = new ArrayList<>();
    for (int i = 0; i < joins; i++) {
      Thread player =
          new Thread(
              () -> {
                double took = join(tcp, udp);
                synchronized (tookMs) {
                  tookMs.add(took);
                }
              });
      player.start();
      players.add(player);
      Thread.sleep(intervalMs);
    }
    for (Thread player : players) {
      player.join();
    }
    return tookMs;
  }

  /** Joins until the server has promised a seat. Returns how long that took in ms, or infinity. */
  private double join(int tcp, int udp) {
    long start = System.nanoTime();
    long deadline = start + (long) (deadlineMs * NS_PER_MS);
    try (KryoClientTransport transport = new KryoClientTransport()) {
      while (System.nanoTime() - deadline < 0) {
        Link link = transport.connect("127.0.0.1", tcp, udp);
        Outcome outcome = new Outcome();
        boolean greeted = false;
        while (link.state() != Link.State.CLOSED && System.nanoTime() - deadline < 0) {
          if (!greeted && link.state() == Link.State.OPEN) {
            greeted = true;
            link.send(
                new ClientMessage.Hello(
                    Protocol.VERSION, Protocol.physicsDigest(), "Ann", 0, "", "", ""));
          }
          link.poll(outcome, 100);
          if (outcome.welcomed) {
            double took = (System.nanoTime() - start) / NS_PER_MS;
            link.send(new ClientMessage.Leave());
            return took;
          }
          pause();
        }
        synchronized (reasons) {
          reasons.merge(String.valueOf(link.closeReason()) + outcome.refused, 1, Integer::sum);
          retries++;
        }
      }
    }
    return Double.POSITIVE_INFINITY;
  }

  private static void pause() {
    try {
      Thread.sleep(2);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void report(List<Double> tookMs, List<Connectors> attackers) {
    tookMs.sort(null);
    long inTime = tookMs.stream().filter(t -> t <= deadlineMs).count();
    System.out.printf(
        "%d of %d honest joins within %d ms; ms: median %.0f, 95th of 100 %.0f, worst %.0f;"
            + " attempts that were sent away: %d%n",
        inTime,
        joins,
        deadlineMs,
        tookMs.get(tookMs.size() / 2),
        tookMs.get(Math.min(tookMs.size() - 1, tookMs.size() * 95 / 100)),
        tookMs.get(tookMs.size() - 1),
        retries);
    long tried = attackers.stream().mapToLong(a -> a.tried.get()).sum();
    long greeted = attackers.stream().mapToLong(a -> a.greeted.get()).sum();
    double seconds = (System.nanoTime() - floodBegan) * 1e-9;
    System.out.printf(
        "hostile: %d connects of %d addresses (%.0f/s), %d greeted (%.0f/s)%n",
        tried, addresses, tried / seconds, greeted, greeted / seconds);
    if (works) {
      long solved = attackers.stream().mapToLong(a -> a.solved.get()).sum();
      long bits = attackers.stream().mapToLong(a -> a.mostBits.get()).max().orElse(0);
      System.out.printf(
          "work: %d solved (%.0f/s), at most %d bits; %d offered keys%n",
          solved, solved / seconds, bits, attackers.stream().mapToLong(a -> a.offered.get()).sum());
    }
    reasons.forEach((reason, count) -> System.out.println("  " + count + " x " + reason));
    System.out.println("server wrote " + LOG.size() + " lines; the last:");
    LOG.stream().skip(Math.max(0, LOG.size() - 5)).forEach(l -> System.out.println("  " + l));
  }

  /** The server's answer to a player. */
  private static final class Outcome implements LinkHandler {
    private boolean welcomed;
    private String refused = "";

    @Override
    public void message(Link from, Object message) {
      welcomed |= message instanceof ServerMessage.Welcome;
      if (message instanceof ServerMessage.Refused r) {
        refused = " " + r.reason() + " " + r.text();
      }
    }

    @Override
    public void datagram(Link from, byte[] bytes, int length) {
      // none comes before a player has a body
    }

    @Override
    public void closed(Link from, String reason) {
      // the loop sees it
    }
  }
}
