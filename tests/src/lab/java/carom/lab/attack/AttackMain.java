package carom.lab.attack;

import carom.client.bots.ThinDoor;
import carom.client.bots.ThinPicture;
import carom.net.kryo.KryoClientTransport;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * Starts a server process, floods it with connections from many addresses of this machine, and lets
 * honest players join meanwhile. With {@code --flood} it floods a server that is played on with
 * datagrams instead, see {@link FloodTrial}.
 */
@Command(
    name = "attack",
    mixinStandardHelpOptions = true,
    description = "Floods a server of its own while honest players join or play.")
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

  @Option(
      names = "--door",
      paramLabel = "DOOR",
      description =
          "port that is flooded and joined: own (Carom's clients), plain (stock KryoNet) or web"
              + " (WebSocket), default ${DEFAULT-VALUE}")
  private AttackedDoor door = AttackedDoor.own;

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
      names = "--flood",
      description =
          "instead, floods of datagrams: table of the tick times with and without, in turns")
  private boolean flood;

  @Mixin private final FloodOptions flooding = new FloodOptions();

  @Option(
      names = "--server-args",
      paramLabel = "ARGS",
      description = "further flags of the server, in one text")
  private String serverArgs = "";

  private final Map<String, Integer> reasons = new TreeMap<>();
  private ThinDoor.Opener opener; // null: Carom's own client
  private int retries;
  private long floodBegan;

  private AttackMain() {}

  /** Runs the command. */
  public static void main(String[] args) {
    System.exit(new CommandLine(new AttackMain()).execute(args));
  }

  @Override
  public Integer call() throws Exception {
    if (flood) {
      new FloodTrial(flooding, ServerProcess.split(serverArgs)).run();
      return 0;
    }
    if (door != AttackedDoor.own && (registers || works)) {
      throw new IllegalArgumentException("--register and --work are for --door own");
    }
    List<Connectors> attackers = new ArrayList<>();
    List<String> flags = new ArrayList<>(ServerProcess.split(serverArgs));
    int port = door.open(flags);
    try (ServerProcess server = new ServerProcess(flags)) {
      opener = door == AttackedDoor.own ? null : door.opener(port);
      for (int i = 0; i < 5; i++) {
        if (opener == null) { // warms up both ends
          join(server);
        } else {
          joinThin();
        }
      }
      floodBegan = System.nanoTime();
      InetSocketAddress target =
          new InetSocketAddress(
              InetAddress.getLoopbackAddress(), opener == null ? server.tcp() : port);
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
      report(honestJoins(server), attackers, server.log());
      return 0;
    } finally {
      attackers.forEach(a -> a.stops = true);
    }
  }

  private List<Double> honestJoins(ServerProcess server) throws InterruptedException {
    List<Double> tookMs = new ArrayList<>();
    List<Thread> players = new ArrayList<>();
    for (int i = 0; i < joins; i++) {
      Thread player =
          new Thread(
              () -> {
                double took = opener == null ? join(server) : joinThin();
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
  private double join(ServerProcess server) {
    long start = System.nanoTime();
    long deadline = start + (long) (deadlineMs * NS_PER_MS);
    try (KryoClientTransport transport = new KryoClientTransport()) {
      while (System.nanoTime() - deadline < 0) {
        Link link = transport.connect("127.0.0.1", server.tcp(), server.udp());
        Outcome outcome = new Outcome();
        boolean greeted = false;
        while (link.state() != Link.State.CLOSED && System.nanoTime() - deadline < 0) {
          if (!greeted && link.state() == Link.State.OPEN) {
            greeted = true;
            link.send(
                new ClientMessage.Hello(
                    Protocol.VERSION, Protocol.physicsDigest(), "Ann", 0, "", "", "", ""));
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

  /** Joins by a door for thin clients until the match is told; see {@link #join}. */
  @SuppressWarnings("try") // the link is open for as long as this waits
  private double joinThin() {
    long start = System.nanoTime();
    long deadline = start + (long) (deadlineMs * NS_PER_MS);
    while (System.nanoTime() - deadline < 0) {
      ThinPicture picture = new ThinPicture();
      String failed = "";
      try (ThinDoor link = opener.open("Ann", new ThinDoor.Goal("", "", "", ""), picture)) {
        while (picture.ended() == null && System.nanoTime() - deadline < 0) {
          if (picture.player() >= 0) {
            return (System.nanoTime() - start) / NS_PER_MS;
          }
          pause();
        }
        failed = String.valueOf(picture.ended());
      } catch (IOException e) {
        failed = String.valueOf(e.getMessage());
      }
      synchronized (reasons) {
        reasons.merge(failed, 1, Integer::sum);
        retries++;
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

  private void report(List<Double> tookMs, List<Connectors> attackers, List<String> log) {
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
    System.out.println("server wrote " + log.size() + " lines; the last:");
    log.stream().skip(Math.max(0, log.size() - 5)).forEach(l -> System.out.println("  " + l));
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
