package carom.client.bots;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.client.app.NetworkOptions;
import carom.client.app.ProgramVersion;
import carom.client.app.StopSignal;
import carom.client.link.ServerAddress;
import carom.game.GamesOption;
import carom.net.protocol.PlayerName;
import carom.net.seal.KnownServers;
import carom.net.transport.ClientTransport;
import carom.options.BadFlag;
import carom.options.Flags;
import carom.options.Lab;
import carom.options.LabCommand;
import carom.options.Rows;
import carom.options.Setting;
import carom.physics.threads.WorkerThreads;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Scanner;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/**
 * The program {@code carom-bots}: connects headless clients that play. Progress goes to standard
 * error; the last line of standard output is one JSON object, see {@link BotReport}.
 */
@Command(
    name = "carom-bots",
    mixinStandardHelpOptions = true,
    versionProvider = ProgramVersion.class,
    sortOptions = false,
    description = "Connects headless clients that play.",
    footer = "Exit code 0 only if all bots joined and stayed.")
public final class BotsMain implements Callable<Integer> {
  private static final long SECOND = 1_000_000_000L;

  /**
   * Time of a frame, four per tick: the bots should measure the network, not their own slowness.
   */
  private static final long FRAME_NS = SECOND / 240;

  /** Bots above which a frame takes half a tick, because updates cost time, too. */
  private static final int CROWD = 100;

  private static final long CROWD_FRAME_NS = SECOND / 120;

  private static final long JOIN_DEADLINE_NS = 20 * SECOND;

  private static final Rows ROWS = Rows.ofFlags();

  static {
    ROWS.addAll(NetworkOptions.ROWS);
  }

  private static final Setting<Integer> COUNT =
      ROWS.whole("count", "N", 1, 1000, 10).text("How many bots ({default}).");

  private static final Setting<Double> SECONDS =
      ROWS.number("seconds", "S", 0, 1000000, 30)
          .text("How long to play once they have joined ({default}).");

  private static final Setting<String> NAME =
      ROWS.text("name", "NAME", "bot").text("First part of their names ({default}).");

  private static final Setting<PredictionMode> PREDICTION =
      ROWS.choice("prediction", "MODE", PredictionMode.NONE)
          .text(
              "What each predicts: none, island or all; a prediction costs a simulation per bot"
                  + " ({default}).");

  private static final Setting<Integer> INPUT_EVERY =
      ROWS.whole("input-every", "TICKS", 1, 8, 1)
          .text("Ticks of input in each datagram, {range} ({default}).");

  private static final Setting<Integer> THREADS =
      ROWS.whole("threads", "N", 0, WorkerThreads.MAX_COUNT, 0)
          .text(
              "Threads that look after the bots, 1..64; 0 = one for every hundred bots, and all"
                  + " processors but one at most, which the server needs ({default}).");

  private static final Setting<Long> SEED =
      ROWS.seed("seed", 1).text("Seed of what they do ({default}).");

  private static final Setting<Boolean> ROAM =
      ROWS.mark("roam")
          .text("Walk about all over the level instead of playing, which gathers at the balls.");

  /** The doors by which bots can come. */
  private enum Door {
    /** Carom's own client. */
    OWN,
    /** Stock KryoNet and Kryo. */
    PLAIN,
    /** WebSocket, with texts of JSON. */
    WEB,
    /** WebSocket, with snapshots in the binary form. */
    BINARY
  }

  private static final Setting<Door> DOOR =
      ROWS.choice("door", "DOOR", Door.OWN)
          .text(
              "How they come: own is Carom's client; plain is stock KryoNet, at --host"
                  + " HOST:TCP/UDP, without /UDP by TCP alone; web is WebSocket with JSON, binary"
                  + " with the compact form, at --host HOST:PORT. The last three walk about and"
                  + " predict nothing ({default}).");

  private static final Setting<Boolean> ORDERS =
      ROWS.mark("orders")
          .text(
              "Play where lines of standard input say, until it ends: the server's --bots starts"
                  + " the program so.");

  private static final Setting<Double> CHURN =
      ROWS.number("churn", "S", 0, 1000000, 0)
          .text(
              "Seconds each plays on average until it leaves and joins again; 0 = all stay"
                  + " ({default}).");

  @Mixin
  @SuppressWarnings("unused") // picocli gives it the flag
  private GamesOption games;

  private ClientConfig flags;
  private NetworkOptions network;

  @CommandLine.Spec private CommandLine.Model.CommandSpec spec;

  private final BotClock pace;

  private BotsMain(BotClock pace) {
    this.pace = pace;
  }

  /** The clock by which bots play. */
  interface BotClock {
    /** The machine's clock. */
    BotClock REAL =
        new BotClock() {
          @Override
          public long nanoTime() {
            return System.nanoTime();
          }

          @Override
          public void sleep(long ns) throws InterruptedException {
            Thread.sleep(ns / 1_000_000, (int) (ns % 1_000_000));
          }
        };

    /** Returns the time, nanoseconds, like {@link System#nanoTime}. */
    long nanoTime();

    /** Waits for a time, nanoseconds, at least 0. */
    void sleep(long ns) throws InterruptedException;
  }

  /** Runs the program, and exits with 0 if all joined and stayed, 1 if not, 2 on bad flags. */
  public static void main(String[] args) {
    System.exit(run(args));
  }

  /** Runs the program like {@link #main}, but returns the exit code. */
  public static int run(String... args) {
    return run(BotClock.REAL, args);
  }

  static int run(BotClock pace, String... args) {
    CommandLine line = new CommandLine(new BotsMain(pace));
    LabCommand.add(
        line,
        "codec",
        "Measures the laboratory's codec on a recording of moving bodies; see codec --help.",
        "carom.lab.trace.CodecCommand");
    LabCommand.add(
        line,
        "figures",
        "Measures snapshots and prediction, and prints one table; see figures --help.",
        "carom.lab.figures.FiguresMain");
    Flags.add(line.getCommandSpec(), ROWS);
    return BadFlag.explainedBy(line).execute(args);
  }

  @Override
  public Integer call() throws InterruptedException {
    flags = Flags.read(new ClientConfig(), spec.commandLine().getParseResult(), ROWS);
    network = new NetworkOptions(flags);
    String problem = network.problem();
    if (PlayerName.problem(flags.get(NAME) + flags.get(COUNT)) != null) {
      problem =
          "--name="
              + flags.get(NAME)
              + ": "
              + PlayerName.problem(flags.get(NAME) + flags.get(COUNT));
    }
    if (problem != null) {
      throw new BadFlag(spec.commandLine(), problem);
    }
    network.startLogging();
    if (flags.get(DOOR) != Door.OWN) {
      return playThin();
    }
    // Threads that begin later inherit it. A crowd of bots mostly shares a machine with the server
    // that it is to load, and must not take the processor from a tick.
    Thread.currentThread().setPriority(Thread.MIN_PRIORITY);
    ClientConfig config =
        network
            .config(flags.get(NAME))
            .with(ClientConfig.PREDICTION, flags.get(PREDICTION))
            .with(ClientConfig.TICKS_PER_INPUT_DATAGRAM, flags.get(INPUT_EVERY));
    if (flags.get(ORDERS)) {
      return playOrders(config);
    }
    try (StopSignal stop = new StopSignal();
        ClientTransport transport = sockets();
        WorkerThreads workers = new WorkerThreads(threadCount());
        BotFarm farm =
            new BotFarm(
                config,
                transport,
                flags.get(COUNT),
                flags.get(SEED),
                flags.get(ROAM),
                flags.get(CHURN),
                workers)) {
      return play(farm, stop);
    }
  }

  /** Plays as the server orders that has started this process; ends with that server. */
  private int playOrders(ClientConfig config) throws InterruptedException {
    try (StopSignal stop = new StopSignal();
        ClientTransport transport = network.sockets(network.trust(KnownServers.inMemory()));
        OrderedBots bots = new OrderedBots(config, transport, flags.get(SEED))) {
      Thread orders =
          new Thread(
              () -> {
                Scanner in = new Scanner(System.in, StandardCharsets.UTF_8);
                while (in.hasNextLine()) {
                  bots.order(in.nextLine());
                }
              },
              "carom-orders");
      orders.setDaemon(true);
      orders.start();
      while (orders.isAlive() && !stop.asked()) {
        long now = pace.nanoTime();
        bots.update(now);
        pace.sleep(Math.max(0, now + CROWD_FRAME_NS - pace.nanoTime()));
      }
      return 0;
    }
  }

  private int playThin() throws InterruptedException {
    if (network.isBad() || flags.get(CHURN) > 0) {
      throw new BadFlag(spec.commandLine(), "--door takes neither --churn nor a simulated network");
    }
    try (StopSignal stop = new StopSignal();
        ThinFarm farm =
            new ThinFarm(
                opener(),
                flags.get(NAME),
                flags.get(ClientConfig.ROOM),
                flags.get(COUNT),
                flags.get(SEED))) {
      return play(farm, stop);
    }
  }

  private ThinDoor.Opener opener() {
    ServerAddress to = network.address();
    if (flags.get(DOOR) != Door.PLAIN) {
      return WebDoor.opener(
          "ws://" + to.host() + ":" + to.tcpPort() + "/thin", flags.get(DOOR) == Door.BINARY);
    }
    try {
      return PlainDoor.opener(to.host(), to.tcpPort(), to.udpPort());
    } catch (IOException e) {
      throw new BadFlag(spec.commandLine(), "--door=plain: " + e.getMessage());
    }
  }

  /**
   * Returns a transport whose links share one thread, or the players' own, over a bad network or
   * without encryption.
   */
  private ClientTransport sockets() {
    boolean asPlayers = !network.isEncrypted() || network.isBad();
    System.err.println(
        asPlayers
            ? "sockets: KryoNet's client, as players have it"
            : "sockets: the bots' own, one thread for all; players have KryoNet's client");
    if (asPlayers) {
      return network.sockets(network.trust(KnownServers.inMemory()));
    }
    try {
      return Lab.create(ClientTransport.class, "carom.lab.crowd.CrowdTransport");
    } catch (IllegalStateException e) {
      throw new BadFlag(spec.commandLine(), e.getMessage());
    }
  }

  private int threadCount() {
    return flags.get(THREADS) > 0
        ? flags.get(THREADS)
        : threadsFor(flags.get(COUNT), Runtime.getRuntime().availableProcessors());
  }

  /**
   * Returns the number of threads that helps. One processor is left to the server, which mostly
   * runs on the same machine: 500 bots on both of two processors raise the p99 of its tick from 16
   * to 23 ms.
   */
  static int threadsFor(int bots, int processors) {
    int wanted = (bots + CROWD - 1) / CROWD;
    return Math.max(1, Math.min(Math.min(wanted, processors - 1), WorkerThreads.MAX_COUNT));
  }

  private int play(Crowd farm, StopSignal stop) throws InterruptedException {
    int count = flags.get(COUNT);
    long start = pace.nanoTime();
    long now = start;
    long end = Long.MAX_VALUE;
    long nextLine = start + SECOND;
    while (now < end && !farm.over() && !stop.asked()) {
      farm.update(now);
      if (end == Long.MAX_VALUE
          && (farm.settled() == count || now - start > JOIN_DEADLINE_NS + count * (SECOND / 20))) {
        end = now + (long) (flags.get(SECONDS) * SECOND);
      }
      if (now >= nextLine) {
        nextLine = now + SECOND;
        System.err.printf(Locale.ROOT, "%4.0f s: %s%n", (now - start) / 1e9, farm.progress());
      }
      long frameNs = count > CROWD ? CROWD_FRAME_NS : FRAME_NS;
      pace.sleep(Math.max(0, now + frameNs - pace.nanoTime()));
      now = pace.nanoTime();
    }
    BotReport report = farm.report(now);
    boolean good = report.joined() == count && report.disconnects() == 0 && report.rejected() == 0;
    good &= flags.get(CHURN) > 0 || farm.playing() == count;
    if (!good) {
      System.err.println(report.joined() + " of " + count + " bots joined. " + farm.problem());
    }
    System.out.println(report.toJson());
    return good ? 0 : 1;
  }
}
