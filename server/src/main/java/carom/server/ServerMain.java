package carom.server;

import carom.game.Games;
import carom.net.kryo.KryoLimits;
import carom.net.kryo.KryoMessageCodec;
import carom.net.kryo.KryoServerTransport;
import carom.net.kryo.PortUnavailableException;
import carom.net.protocol.Protocol;
import carom.net.transport.ImpairedServerTransport;
import carom.net.transport.ServerTransport;
import carom.options.BadFlag;
import carom.options.NetworkConditions;
import carom.server.bench.BenchCommand;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.recording.RotationLimit;
import carom.sim.Game;
import carom.sim.Level;
import carom.sim.LevelException;
import carom.sim.Suggestion;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneGame;
import carom.sim.scene.SceneRun;
import carom.sim.scene.Scenes;
import ch.qos.logback.classic.LoggerContext;
import java.io.Console;
import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/**
 * Starts the dedicated server.
 *
 * <p>Standard output carries exactly one line for programs, {@code ready tcp=54555 udp=54777}, once
 * players can join, and a few hints when a person reads it. The log goes to standard error. Exit
 * codes: 0 after {@code --help} and {@code --version}, 1 when a port is not available or the server
 * failed, 2 for flags or a level file that can't be used; a signal ends it with the shell's usual
 * number (143 for SIGTERM, 130 for Ctrl-C). Standard input is never read.
 */
@Command(
    name = "carom-server",
    sortOptions = false,
    usageHelpAutoWidth = true,
    versionProvider = ServerMain.Version.class,
    subcommands = BenchCommand.class,
    description = {"Runs a Carom game server: physics worlds that players join.", ""},
    footer = {
      "",
      "When players can join, standard output says so in one line:",
      "    ready tcp=54555 udp=54777",
      "The log goes to standard error. Stop with Ctrl-C or SIGTERM; players are told.",
      "Exit codes: 1 port not available or server failed, 2 bad flag or level file."
    })
public final class ServerMain implements Callable<Integer> {
  private static final String LOG_CONFIG_PROPERTY = "logback.configurationFile";
  private static final String LOG_CONFIG = "carom-server-logback.xml";
  private static final String TERMINAL_PROPERTY = "carom.terminal";
  private static final String DEFAULT_GAME = "arena";
  private static final int DEFAULT_TCP_PORT = 54_555;
  private static final int DEFAULT_UDP_PORT = 54_777;
  private static final int MAX_PORT = 65_535;
  private static final int MAX_SPECTATOR_DELAY_S = 3_600;
  private static final int MAX_GRACE_S = 600;
  private static final int MAX_KEPT = 10_000;

  /**
   * Most bodies of a level that the server warms up with. For a larger one it takes the game's own
   * level.
   */
  private static final int MOST_WARM_UP_BODIES = 1000;

  private static final int FAILED = 1;

  @Spec private CommandSpec spec;

  @Option(
      names = "--tcp-port",
      paramLabel = "N",
      defaultValue = "54555",
      description = "Port for reliable messages, 0..65535, 0 = any free one (${DEFAULT-VALUE}).")
  private int tcpPort;

  @Option(
      names = "--udp-port",
      paramLabel = "N",
      defaultValue = "54777",
      description = "Port for datagrams, 0..65535, 0 = any free one (${DEFAULT-VALUE}).")
  private int udpPort;

  @Option(
      names = "--game",
      paramLabel = "NAME",
      description = "Game to run: ${COMPLETION-CANDIDATES} (that of the level, or arena).",
      completionCandidates = GameNames.class)
  private String game;

  @Option(
      names = "--level",
      paramLabel = "FILE",
      description = "Level file, or the name of one that comes with the program (the game's own).")
  private String level;

  @Option(
      names = "--scene",
      paramLabel = "NAME",
      description = "Scene of the library to watch, instead of a game; players have no bodies.")
  private String scene;

  @Option(
      names = "--tick-rate",
      paramLabel = "HZ",
      defaultValue = "60",
      description = "Simulation steps per second, 10..240 (${DEFAULT-VALUE}).")
  private int tickRate;

  @Option(
      names = "--seed",
      paramLabel = "N",
      description = "Start of the random numbers; the same seed starts the same game (random).")
  private Long seed;

  @Option(
      names = "--name",
      paramLabel = "TEXT",
      defaultValue = "Carom",
      description = "What the log calls this server, 1..40 characters (${DEFAULT-VALUE}).")
  private String name;

  @Option(
      names = "--rooms",
      paramLabel = "N",
      defaultValue = "1",
      description =
          "Games that are played side by side, 1..64, each with a thread of its own;"
              + " a newcomer gets into the fullest that has a place (${DEFAULT-VALUE}).")
  private int rooms;

  @Option(
      names = "--threads",
      paramLabel = "N",
      defaultValue = "1",
      description =
          "Threads that may step one world together, 1..64: the room's own and helpers that all"
              + " rooms share; for worlds of thousands of bodies (${DEFAULT-VALUE}).")
  private int threads;

  @Option(
      names = "--max-players",
      paramLabel = "N",
      defaultValue = "64",
      description =
          "Places in each room, 1..1024, at most 4096 in all rooms together (${DEFAULT-VALUE}).")
  private int maxPlayers;

  @Option(
      names = "--snapshot-rate",
      paramLabel = "HZ",
      description = "Snapshots per second and player, 1..240, at most one a tick (one a tick).")
  private Integer snapshotRate;

  @Option(
      names = "--budget",
      paramLabel = "KBIT",
      defaultValue = "512",
      description = "Snapshots for one player, kbit/s of payload, 16..80000 (${DEFAULT-VALUE}).")
  private int budget;

  @Option(
      names = "--view",
      paramLabel = "METRES",
      defaultValue = "0",
      description =
          "Largest half width and half height a player is told about, up to 4096;"
              + " 0 = 64, and everything in small worlds (${DEFAULT-VALUE}).")
  private int view;

  @Option(
      names = "--grace",
      paramLabel = "S",
      defaultValue = "30",
      description =
          "Seconds the body of a player who lost the connection waits, 0..600 (${DEFAULT-VALUE}).")
  private int graceS;

  @Option(
      names = "--record",
      paramLabel = "FILE",
      description =
          "Record the game to this new file, or to a new file in this folder; 'carom replay FILE'"
              + " computes it again.")
  private Path record;

  @Option(
      names = "--record-rotate",
      paramLabel = "LIMIT",
      defaultValue = "0",
      description =
          "Begin another file in the folder of --record after so many minutes, 1..1440, or when one"
              + " has reached a size, such as 256M or 2G; each is playable by itself; 0 = never"
              + " (${DEFAULT-VALUE}).")
  private String recordRotate;

  @Option(
      names = "--record-keep",
      paramLabel = "N",
      defaultValue = "0",
      description =
          "With --record-rotate: keep the last N files of this run and each room, 1..10000; 0 = all"
              + " (${DEFAULT-VALUE}).")
  private int recordKeep;

  @Option(
      names = "--spectator-delay",
      paramLabel = "S",
      defaultValue = "0",
      description =
          "Show every game to spectators (carom-client --watch) S seconds late, 1..3600; 0 = don't"
              + " (${DEFAULT-VALUE}).")
  private int spectatorDelayS;

  @Mixin private final NetworkConditions network = new NetworkConditions();

  @Option(
      names = "--status-interval",
      paramLabel = "S",
      defaultValue = "60",
      description = "Seconds between status lines in the log, 0 = none (${DEFAULT-VALUE}).")
  private int statusIntervalS;

  @Option(
      names = "--log-level",
      paramLabel = "L",
      defaultValue = "info",
      description = "How much is logged: ${COMPLETION-CANDIDATES} (${DEFAULT-VALUE}).")
  private LogLevel logLevel;

  @Option(
      names = {"-h", "--help"},
      usageHelp = true,
      description = "Shows this text.")
  @SuppressWarnings("unused") // picocli shows the help
  private boolean help;

  @Option(
      names = {"-V", "--version"},
      versionHelp = true,
      description = "Shows the version.")
  @SuppressWarnings("unused") // picocli shows the version
  private boolean version;

  /** Values of {@code --log-level}. */
  enum LogLevel {
    OFF,
    ERROR,
    WARN,
    INFO,
    DEBUG,
    TRACE;

    static LogLevel of(String text) {
      for (LogLevel level : values()) {
        if (level.toString().equals(text.toLowerCase(Locale.ROOT))) {
          return level;
        }
      }
      throw new TypeConversionException("'" + text + "' is none of " + Arrays.toString(values()));
    }

    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** The games, for the help text. */
  static final class GameNames implements Iterable<String> {
    @Override
    public Iterator<String> iterator() {
      return Games.names().iterator();
    }
  }

  /** The version, for {@code --version}. */
  static final class Version implements CommandLine.IVersionProvider {
    @Override
    public String[] getVersion() {
      return new String[] {
        "Carom server " + version(),
        "protocol " + Protocol.VERSION + ", " + Protocol.PHYSICS_VERSION,
        "Java " + Runtime.version()
      };
    }
  }

  /** Logging, as soon as its configuration is read; before that nothing may ask for a logger. */
  private final CompletableFuture<LoggerContext> loggingSoon;

  private ServerMain(CompletableFuture<LoggerContext> loggingSoon) {
    this.loggingSoon = loggingSoon;
  }

  /** Runs the server until it is stopped; see {@code --help}. */
  public static void main(String[] args) {
    if (System.getProperty(LOG_CONFIG_PROPERTY) == null) {
      System.setProperty(LOG_CONFIG_PROPERTY, LOG_CONFIG); // before the first logger
    }
    // Reading the flags takes as long as logging takes to start, and one needs nothing of the
    // other.
    CompletableFuture<LoggerContext> loggingSoon =
        CompletableFuture.supplyAsync(
            () -> (LoggerContext) LoggerFactory.getILoggerFactory(),
            task -> new Thread(task, "carom-logging").start());
    CommandLine commandLine = BadFlag.explainedBy(new CommandLine(new ServerMain(loggingSoon)));
    commandLine.registerConverter(int.class, ServerMain::wholeNumber);
    commandLine.registerConverter(Long.class, ServerMain::longNumber);
    commandLine.registerConverter(LogLevel.class, LogLevel::of);
    commandLine.setCaseInsensitiveEnumValuesAllowed(true);
    // After a signal this waits for the end of the shutdown hook, and the signal's exit code wins.
    System.exit(commandLine.execute(args));
  }

  private static int wholeNumber(String text) {
    long number = longNumber(text);
    if (number != (int) number) {
      throw new TypeConversionException("'" + text + "' is too large");
    }
    return (int) number;
  }

  private static long longNumber(String text) {
    try {
      return Long.parseLong(text);
    } catch (NumberFormatException e) {
      throw new TypeConversionException("'" + text + "' is not a whole number");
    }
  }

  @Override
  public Integer call() throws InterruptedException {
    LoggerContext logging = loggingSoon.join();
    Level chosenLevel = scene == null ? chooseLevel() : SceneGame.level(chooseScene());
    String chosenGame = chooseGame(chosenLevel);
    Supplier<Game> games = () -> Games.create(chosenGame);
    requireRange("--tcp-port", tcpPort, MAX_PORT);
    requireRange("--udp-port", udpPort, MAX_PORT);
    requireRange("--grace", graceS, MAX_GRACE_S);
    if (record != null && rooms > 1 && !Files.isDirectory(record)) {
      throw bad("--record=" + record + " is no folder; --rooms=" + rooms + " need one");
    }
    requireRange("--spectator-delay", spectatorDelayS, MAX_SPECTATOR_DELAY_S);
    RotationLimit rotation;
    try {
      rotation = RotationLimit.parse(recordRotate);
    } catch (IllegalArgumentException e) {
      throw bad("--record-rotate=" + e.getMessage());
    }
    requireRange("--record-keep", recordKeep, MAX_KEPT);
    if (rotation.rotates() && (record == null || !Files.isDirectory(record))) {
      throw bad("--record-rotate=" + recordRotate + " needs a folder; give one by --record");
    }
    if (rotation.rotates() && spectatorDelayS > 0) {
      throw bad(
          "--record-rotate="
              + recordRotate
              + " can't be combined with --spectator-delay="
              + spectatorDelayS
              + ": spectators see one file; leave one of them out");
    }
    if (recordKeep > 0 && !rotation.rotates()) {
      throw bad("--record-keep=" + recordKeep + " needs --record-rotate");
    }
    if (network.problem() != null) {
      throw bad(network.problem());
    }
    ServerConfig config = config(chosenGame);
    ch.qos.logback.classic.Logger root = logging.getLogger(Logger.ROOT_LOGGER_NAME);
    root.setLevel(ch.qos.logback.classic.Level.ERROR);
    try {
      GameWarmup.play(config, games, warmUpLevel(chosenLevel), new KryoMessageCodec());
    } catch (IllegalArgumentException e) {
      logging.stop();
      throw bad("--level: " + e.getMessage());
    }
    root.setLevel(ch.qos.logback.classic.Level.toLevel(logLevel.name()));
    Logger log = LoggerFactory.getLogger(ServerMain.class);
    log.info(
        "start: {} {}, game {}, level {} ({}), {} Hz, seed {}, {}{} places, Java {}",
        config.serverName(),
        version(),
        config.gameName(),
        chosenLevel.name(),
        level == null ? "default" : level,
        config.tickRateHz(),
        config.seed(),
        config.rooms() == 1 ? "" : config.rooms() + " rooms of ",
        config.maxPlayers(),
        Runtime.version().feature());
    if (scene != null) {
      SceneRun run = Scenes.get(scene).start();
      log.info(
          "scene: players watch {} bodies; {} joints and {} kinds of particles aren't sent",
          run.world().bodyCount(),
          run.world().jointCount(),
          run.particles().size());
    }
    ServerTransport transport;
    try {
      transport = new KryoServerTransport(tcpPort, udpPort, limits());
    } catch (PortUnavailableException e) {
      logging.stop();
      return refuse(e.getMessage(), FAILED);
    }
    if (network.isBad()) {
      log.warn("network: made bad on purpose, each way: {}", network.impairment());
      transport =
          new ImpairedServerTransport(
              transport, network.impairment(), new KryoMessageCodec(), System::nanoTime);
    }
    Server server;
    try {
      server = new Server(config, games, chosenLevel, transport, System::nanoTime);
    } catch (IllegalArgumentException e) {
      transport.close();
      logging.stop();
      throw bad("--level: " + e.getMessage());
    }
    if (record != null) {
      try {
        if (rotation.rotates()) {
          server.recordRotating(record, rotation, recordKeep);
          log.info("recording: {}, another file every {}", record, rotation);
        } else {
          server.record(record).forEach(file -> log.info("recording: {}", file));
        }
      } catch (FileAlreadyExistsException e) {
        server.close();
        logging.stop();
        throw bad("--record=" + record + " is there already; name a new file or a folder");
      } catch (IOException e) {
        server.close();
        logging.stop();
        return refuse("--record=" + record + " can't be written: " + e, FAILED);
      } catch (IllegalArgumentException e) {
        server.close();
        logging.stop();
        throw bad("--record-rotate: " + e.getMessage());
      }
    }
    if (spectatorDelayS > 0) {
      try {
        server.show(spectatorDelayS);
        log.info("spectators: let in, {} s late", spectatorDelayS);
      } catch (IOException e) {
        server.close();
        logging.stop();
        return refuse("--spectator-delay: no file for the recording: " + e, FAILED);
      }
    }
    return run(server, logging);
  }

  private int run(Server server, LoggerContext logging) throws InterruptedException {
    Logger log = LoggerFactory.getLogger(ServerMain.class);
    Thread hook =
        new Thread(
            () -> {
              log.info("stop: asked to");
              server.close();
              server.status().forEach(line -> log.info("stopped: {}", line));
              logging.stop(); // writes what still waits in the queue
            },
            "carom-stop");
    Runtime.getRuntime().addShutdownHook(hook);
    server.start();
    server.rooms().forEach(RoomInspector::show);
    while (server.count(Counter.TICKS) == 0 && !server.hasFailed()) {
      Thread.sleep(1); // a large level's first tick takes as long as many others
    }
    PrintStream out = System.out;
    out.println("ready tcp=" + server.tcpPort() + " udp=" + server.udpPort());
    if (onTerminal()) {
      hints(out, server.tcpPort(), server.udpPort());
    }
    out.flush();
    log.info("ready: tcp {} udp {}", server.tcpPort(), server.udpPort());
    server.awaitStop();
    if (server.hasFailed()) {
      log.error("the server ended because of the errors above");
    }
    return FAILED; // reached without a signal only when something failed
  }

  private static void hints(PrintStream out, int tcp, int udp) {
    boolean defaults = tcp == DEFAULT_TCP_PORT && udp == DEFAULT_UDP_PORT;
    String ports = defaults ? "" : " --tcp-port " + tcp + " --udp-port " + udp;
    String playArgs = defaults ? "" : " -Pargs='--host localhost" + ports + "'";
    String botArgs = defaults ? "" : " -Pargs='" + ports.strip() + "'";
    out.println();
    out.println("  join      ./gradlew play" + playArgs);
    out.println("  add bots  ./gradlew bots -Pn=20" + botArgs);
    out.println("  stop      Ctrl-C");
    out.println();
    out.println("  On another machine, with Carom installed:");
    out.println("  join      carom-client --host " + hostName() + ports);
    out.println();
  }

  private static String hostName() {
    try {
      return InetAddress.getLocalHost().getHostName();
    } catch (UnknownHostException e) {
      return "HOST";
    }
  }

  /**
   * Whether a person reads standard output. Behind Gradle the terminal can't be seen from here;
   * gradlew says so by a property. From Java 22 on there is a console object without a terminal,
   * which says so itself.
   */
  private static boolean onTerminal() {
    if (Boolean.getBoolean(TERMINAL_PROPERTY)) {
      return true;
    }
    Console console = System.console();
    if (console == null) {
      return false;
    }
    try {
      return (Boolean) Console.class.getMethod("isTerminal").invoke(console);
    } catch (NoSuchMethodException e) {
      return true;
    } catch (ReflectiveOperationException e) {
      return false;
    }
  }

  /** Its actions are made for its own tick rate. */
  private Scene chooseScene() {
    if (game != null || level != null) {
      throw bad(
          "--scene and %s exclude each other: a scene is a world of its own"
              .formatted(game != null ? "--game" : "--level"));
    }
    if (!Scenes.names().contains(scene)) {
      throw bad(
          "--scene: unknown scene=%s%s; carom-client --scene list shows all"
              .formatted(scene, Suggestion.didYouMean(scene, Scenes.names())));
    }
    Scene chosen = Scenes.get(scene);
    if (tickRate != chosen.tickRate()) {
      throw bad(
          "--tick-rate=%d doesn't fit --scene=%s, which runs at %d Hz"
              .formatted(tickRate, scene, chosen.tickRate()));
    }
    return chosen;
  }

  private Level chooseLevel() {
    try {
      if (level == null) {
        return Level.builtIn(createGame(game == null ? DEFAULT_GAME : game).defaultLevel());
      }
      Path file = Path.of(level);
      if (Files.exists(file)) {
        return Level.load(file);
      }
      if (builtInLevels().contains(level)) {
        return Level.builtIn(level);
      }
    } catch (LevelException | InvalidPathException e) {
      throw bad("--level: " + e.getMessage());
    }
    throw bad(
        "--level=%s: there is no such file, and the levels that come with the program are %s"
            .formatted(level, String.join(", ", builtInLevels())));
  }

  private static List<String> builtInLevels() {
    return Stream.concat(
            Games.names().stream().map(name -> Games.create(name).defaultLevel()),
            Stream.of("commons"))
        .toList();
  }

  /**
   * Returns the level to warm up with: a large one would take longer to build and step than the
   * warm-up may last.
   */
  private Level warmUpLevel(Level chosen) {
    if (chosen.bodies().size() <= MOST_WARM_UP_BODIES || scene != null) {
      return chosen;
    }
    try {
      return Level.builtIn(createGame(chosen.gameName()).defaultLevel());
    } catch (LevelException e) {
      throw new IllegalStateException(e); // it comes with the program
    }
  }

  private String chooseGame(Level chosenLevel) {
    Game chosen = createGame(game == null ? chosenLevel.gameName() : game);
    if (!chosen.name().equals(chosenLevel.gameName())) {
      throw bad(
          ("--game=%s doesn't fit level %s, which is made for game %s; "
                  + "leave --game out or choose another level")
              .formatted(chosen.name(), chosenLevel.name(), chosenLevel.gameName()));
    }
    return chosen.name();
  }

  private Game createGame(String wanted) {
    try {
      return Games.create(wanted);
    } catch (IllegalArgumentException e) {
      throw bad("--game: " + e.getMessage());
    }
  }

  private ServerConfig config(String gameName) {
    try {
      return ServerConfig.defaults()
          .withGameName(gameName)
          .withServerName(name)
          .withTickRateHz(tickRate)
          .withSeed(seed == null ? new SecureRandom().nextLong() : seed)
          .withMaxPlayers(maxPlayers)
          .withSnapshotBitsPerSecond(1_000 * Math.max(0, Math.min(1_000_000, budget)))
          .withViewMetres(view)
          .withRooms(rooms)
          .withThreads(threads)
          .withGraceMs(graceS * 1_000)
          .withInputHoldTicks(tickRate / 2)
          .withSnapshotRateHz(snapshotRate == null ? tickRate : snapshotRate)
          .withStatusIntervalS(statusIntervalS);
    } catch (IllegalArgumentException e) {
      throw bad(e.getMessage());
    }
  }

  /** Half-open links count too; one address may hold all places, as behind a school's router. */
  private KryoLimits limits() {
    int places = rooms * maxPlayers;
    return KryoLimits.DEFAULT.withConnections(2 * places + 64, places + 32);
  }

  private void requireRange(String flag, int value, int max) {
    if (value < 0 || value > max) {
      throw bad(flag + "=" + value + " is outside 0.." + max);
    }
  }

  private BadFlag bad(String message) {
    return new BadFlag(spec.commandLine(), message);
  }

  private int refuse(String message, int exitCode) {
    PrintWriter err = spec.commandLine().getErr();
    err.println("carom-server: " + message);
    err.flush();
    return exitCode;
  }

  private static String version() {
    String version = ServerMain.class.getPackage().getImplementationVersion();
    return version == null ? "(development build)" : version;
  }
}
