package carom.server;

import carom.game.GamesOption;
import carom.game.GuardedGame;
import carom.net.protocol.Protocol;
import carom.options.BadFlag;
import carom.options.Flags;
import carom.options.VectorApi;
import carom.physics.simd.VectorModule;
import carom.server.access.AccessCommands;
import carom.server.access.AccessLists;
import carom.server.access.AdminChat;
import carom.server.access.Logins;
import carom.server.command.AccountCommands;
import carom.server.command.Caller;
import carom.server.command.CommandRegistry;
import carom.server.command.RedirectCommands;
import carom.server.command.ReloadCommand;
import carom.server.command.RoomChangeCommands;
import carom.server.command.RoomCommands;
import carom.server.command.SaveSource;
import carom.server.command.ServerCommands;
import carom.server.command.UploadCommands;
import carom.server.config.BadSettingException;
import carom.server.config.DataFolder;
import carom.server.config.EffectiveSettings;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.config.SettingsLayers;
import carom.server.fleet.FleetConsole;
import carom.server.fleet.FleetService;
import carom.server.metrics.Counter;
import carom.server.query.ProtocolFlags;
import carom.server.query.StatusFacts;
import carom.server.room.Room;
import carom.server.thin.plain.PlainDoor;
import carom.server.thin.web.PlayPort;
import carom.server.threads.StartWatch;
import carom.server.threads.ThreadStack;
import carom.server.web.LogTail;
import carom.server.web.WebFlags;
import carom.server.web.WebServer;
import carom.server.web.WebSubject;
import carom.sim.scene.SceneRun;
import carom.sim.scene.Scenes;
import ch.qos.logback.classic.LoggerContext;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jline.utils.Signals;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;

/**
 * Starts the dedicated server.
 *
 * <p>When players can join, the program writes one line for other programs to standard output,
 * {@code ready tcp=54555 udp=54777}, with {@code play=8080} behind it if browsers can, too, and on
 * a terminal a few hints. The log goes to standard error. Commands are read from standard input,
 * see {@link Console}; when it ends, the server goes on.
 *
 * <p>Exit codes: 0 after {@code --help}, {@code --version} and the command {@code stop}; 1 when a
 * port is not available or the server failed; 2 for flags or a level file that can't be used; 143
 * after SIGTERM and 130 after Ctrl-C, as is usual in shells, but 0 if gradlew started the server.
 */
@Command(
    name = "carom-server",
    sortOptions = false,
    usageHelpAutoWidth = true,
    versionProvider = ServerMain.Version.class,
    description = {"Runs a Carom game server: physics worlds that players join.", ""},
    footer = {
      "",
      "When players can join, standard output says so in one line:",
      "    ready tcp=54555 udp=54777",
      "The log goes to standard error. Standard input takes commands; 'help' shows them.",
      "Stop with 'stop', Ctrl-C or SIGTERM; players are told.",
      "Exit codes: 1 port not available or server failed, 2 bad flag or level file."
    })
public final class ServerMain implements Callable<Integer> {
  private static final String LOG_CONFIG_PROPERTY = "logback.configurationFile";
  private static final String LOG_CONFIG = "carom-server-logback.xml";
  private static final int FAILED = 1;

  /** Longest time that a server which stops waits for the next of its rooms to move away, ms. */
  private static final int DRAIN_MS = 8_000;

  @Spec private CommandSpec spec;

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

  @Mixin
  @SuppressWarnings("unused") // picocli gives it the flag
  private GamesOption games;

  private SettingsLayers layers;
  private ServerFlags flags;
  private AccessLists access;
  private LogTail logTail;
  private KernelWarmupThread kernels;

  /** Keeps other servers from the data folder as long as the process runs; null without one. */
  private FolderLock dataLock;

  private PlayPort play; // or null
  private PlainDoor plain; // or null
  private FleetService fleet; // or null
  private AgonesService agones; // or null

  /** Provides the text of {@code --version}. */
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

  /** Completes when logback has read its configuration. No code may ask for a logger before. */
  private final CompletableFuture<LoggerContext> loggingSoon;

  private ServerMain(CompletableFuture<LoggerContext> loggingSoon) {
    this.loggingSoon = loggingSoon;
  }

  /** Runs the server until it is stopped; see {@code --help}. */
  public static void main(String[] args) {
    // After a signal, exit() waits for the shutdown hook, and the process ends with the signal's
    // exit code.
    System.exit(run(args));
  }

  /** Runs the server as {@link #main} does, and returns the exit code. */
  static int run(String... args) {
    VectorApi.load();
    if (System.getProperty(LOG_CONFIG_PROPERTY) == null) {
      System.setProperty(LOG_CONFIG_PROPERTY, LOG_CONFIG); // before the first logger
    }
    // Reading the flags takes as long as starting the log, and neither needs the other, so they run
    // at the same time.
    CompletableFuture<LoggerContext> loggingSoon =
        CompletableFuture.supplyAsync(
            () -> (LoggerContext) LoggerFactory.getILoggerFactory(),
            task -> new Thread(task, "carom-logging").start());
    ServerMain program = new ServerMain(loggingSoon);
    return program.execute(commandLine(program), args);
  }

  private static CommandLine commandLine(ServerMain program) {
    CommandLine commandLine = new CommandLine(program);
    Flags.add(commandLine.getCommandSpec(), ServerConfig.ROWS);
    Flags.add(commandLine.getCommandSpec(), ServerConfig.ONLY_FLAGS);
    return BadFlag.explainedBy(CaromMain.withBench(commandLine));
  }

  private int execute(CommandLine commandLine, String[] args) {
    CommandLine.IParameterExceptionHandler usual = commandLine.getParameterExceptionHandler();
    commandLine.setParameterExceptionHandler(
        (e, all) -> {
          int status = usual.handleParseException(e, all);
          String origins = layers == null ? "" : layers.origins(e.getMessage());
          if (!origins.isEmpty()) {
            commandLine.getErr().println("carom-server: " + origins);
          }
          return status;
        });
    return commandLine.execute(args);
  }

  private static SettingsLayers read(ParseResult parsed, Map<String, String> set)
      throws BadSettingException {
    Map<String, List<String>> given = Flags.given(parsed, ServerConfig.ROWS);
    given.putAll(Flags.given(parsed, ServerConfig.ONLY_FLAGS));
    return new SettingsLayers(given, System.getenv(), set);
  }

  @Override
  public Integer call() throws InterruptedException {
    LoggerContext logging = loggingSoon.join();
    ParseResult parsed = spec.commandLine().getParseResult();
    try {
      layers = read(parsed, Map.of());
      flags = new ServerFlags(spec.commandLine(), layers.settings());
      if (parsed.hasMatchedOption("--" + ServerConfig.PRINT_CONFIG.name())) {
        logging.stop();
        spec.commandLine().getOut().print(flags.settings().file());
        spec.commandLine().getOut().flush();
        return 0;
      }
      return run(open(logging), logging);
    } catch (BadFlag e) {
      logging.stop();
      throw e;
    } catch (BadSettingException e) {
      logging.stop();
      spec.commandLine().getErr().println("carom-server: " + e.getMessage());
      return spec.exitCodeOnInvalidInput();
    } catch (StartFailure e) {
      logging.stop();
      PrintWriter err = spec.commandLine().getErr();
      err.println("carom-server: " + e.getMessage());
      err.flush();
      return FAILED;
    } finally {
      if (dataLock != null) {
        dataLock.close();
      }
    }
  }

  private Server open(LoggerContext logging) throws StartFailure {
    kernels = KernelWarmupThread.prepare();
    GameChoice choice = new GameChoice(flags);
    flags.check();
    ServerConfig config = flags.config(choice.gameName());
    Logger log = LoggerFactory.getLogger(ServerMain.class);
    logTail = LogTail.begin(logging);
    openData(logging, log);
    access = openAccess();
    if (AgonesFlags.isOn(config, System.getenv())) {
      agones = AgonesService.start(AgonesFlags.port(System.getenv()));
    }
    ServerStart start = new ServerStart(flags, choice, config, access, agones, log);
    ch.qos.logback.classic.Logger root = logging.getLogger(Logger.ROOT_LOGGER_NAME);
    root.setLevel(ch.qos.logback.classic.Level.ERROR);
    StartWatch watch = new StartWatch(GuardedGame.class, start::progress, ServerMain::hangs);
    try {
      start.warmUp();
      root.setLevel(ch.qos.logback.classic.Level.toLevel(flags.get(ServerConfig.LOG_LEVEL).name()));
      logStart(log, config);
      Server server = start.open();
      for (Room room : server.rooms()) { // those that are this server's, in a fleet
        RoomConfig own = room.settings();
        log.info(
            "room {}: {}, {} places", own.name(), String.join(", ", own.levels()), own.places());
      }
      play = start.play();
      plain = start.plain();
      fleet = start.fleet();
      server.admit(access);
      return server;
    } finally {
      watch.close();
    }
  }

  /** Ends the process, because a thread can't be ended. On the watchdog's thread. */
  private static void hangs(String where, ThreadStack stack) {
    Logger log = LoggerFactory.getLogger(ServerMain.class);
    log.error("the start hangs in {}; the server ends:", where, stack);
    ((LoggerContext) LoggerFactory.getILoggerFactory()).stop();
    System.exit(FAILED);
  }

  private AccessLists openAccess() throws StartFailure {
    try {
      return new AccessLists(
          flags.dataFolder(), flags.get(ServerConfig.ALLOW_LIST), InstantSource.system());
    } catch (IOException e) {
      throw new StartFailure(e.getMessage(), e);
    }
  }

  /**
   * Creates the data folder and begins the log in it. A server without a data folder runs, too, but
   * not if the operator named one.
   */
  private void openData(LoggerContext logging, Logger log) throws StartFailure {
    LogLimit.begin(logging);
    DataFolder data = flags.dataFolder();
    try {
      data.create();
      dataLock = FolderLock.of(data.root(), "data");
      LogFiles.begin(logging, data.logs(), flags.get(ServerConfig.LOG_KEEP));
    } catch (FolderLock.TakenException e) {
      throw new StartFailure(e.getMessage(), e);
    } catch (IOException e) {
      if (flags.isSet(ServerConfig.DATA)) {
        throw new StartFailure(e.getMessage(), e);
      }
      log.warn("nothing is kept in files: {}", e.getMessage());
    }
  }

  private void logStart(Logger log, ServerConfig config) {
    log.info(
        "start: {} {}, {} Hz, seed {}, Java {}",
        config.get(ServerConfig.NAME),
        version(),
        config.get(ServerConfig.TICK_RATE),
        config.get(ServerConfig.SEED),
        Runtime.version().feature());
    log.info("engine: {}", VectorModule.describe());
    layers.warnings().forEach(log::warn);
    if (layers.file() != null) {
      log.info("settings: {}", layers.file());
    }
    if (flags.get(ServerConfig.SCENE) != null) {
      SceneRun run = Scenes.get(flags.get(ServerConfig.SCENE)).start();
      log.info(
          "scene: players watch {} bodies and {} joints; {} kinds of particles aren't sent",
          run.world().bodyCount(),
          run.world().jointCount(),
          run.particles().size());
    }
  }

  private int run(Server server, LoggerContext logging) throws InterruptedException, StartFailure {
    Logger log = LoggerFactory.getLogger(ServerMain.class);
    Thread.setDefaultUncaughtExceptionHandler(
        (thread, error) -> log.error("thread {} ended by an error", thread.getName(), error));
    AtomicReference<Console> console = new AtomicReference<>();
    AtomicReference<WebServer> web = new AtomicReference<>();
    Thread hook =
        new Thread(
            () -> {
              log.info("stop: asked to");
              if (agones != null) {
                agones.stops();
              }
              WebServer answers = web.get();
              if (answers != null) {
                answers.stopping();
              }
              if (fleet != null && !fleet.drain(DRAIN_MS)) {
                log.warn("fleet: some rooms couldn't move to other servers");
              }
              server.close();
              if (fleet != null) {
                fleet.close();
              }
              if (agones != null) {
                agones.close();
              }
              server.status().forEach(line -> log.info("stopped: {}", line));
              logging.stop(); // writes the lines that are still queued
              if (answers != null) {
                answers.close();
              }
              Console prompt = console.get();
              if (prompt != null) {
                prompt.close();
              }
            },
            "carom-stop");
    Runtime.getRuntime().addShutdownHook(hook);
    if (ReadyLine.isByGradle()) {
      Signals.register("INT", ServerMain::stopSoon); // another code would be a failed build
    }
    CommandRegistry commands = commands(server);
    // Beside the first tick: the libraries load for as long as all the rest.
    FutureTask<WebServer> ports = new FutureTask<>(() -> openPorts(server, commands));
    new Thread(ports, "carom-ports").start();
    server.start();
    if (fleet != null) {
      fleet.serve(server);
    }
    if (server.config().get(ServerConfig.DEV)) {
      DevWatch.start(server.rooms(), flags.dataFolder());
    }
    while (server.count(Counter.TICKS) == 0 && !server.hasFailed() && !server.rooms().isEmpty()) {
      Thread.sleep(1); // the first tick of a large level takes as long as many later ones
    }
    web.set(opened(ports, server));
    int playPort = play == null ? 0 : play.tcpPort();
    String plainPorts = plain == null ? null : plain.ports();
    ReadyLine.print(System.out, server.tcpPort(), server.udpPort(), playPort, plainPorts);
    log.info("ready: tcp {} udp {}", server.tcpPort(), server.udpPort());
    if (agones != null) {
      agones.serve(new PodServer(server, fleet));
    }
    kernels.begin(); // not before: it would take the processor from the start
    String page = web.get() == null ? null : web.get().url();
    List<InetAddress> bound = flags.bindAddresses();
    boolean onlyHere = !bound.isEmpty() && bound.stream().allMatch(InetAddress::isLoopbackAddress);
    String playUrl = play == null ? null : play.url();
    ReadyLine.printHints(System.out, server.tcpPort(), page, playUrl, onlyHere);
    if (flags.get(ServerConfig.CONSOLE)) {
      console.set(Console.start(commands, flags.dataFolder().root().resolve("console.history")));
    } else { // with a console, the signal says that its terminal is gone
      Signals.register(
          "HUP",
          () ->
              commands
                  .run("reload", Caller.SIGNAL)
                  .text()
                  .lines()
                  .forEach(line -> log.info("reload: {}", line)));
    }
    server.awaitStop();
    if (server.hasFailed()) {
      log.error("the server ended because of the errors above");
    }
    return FAILED; // without a signal, only a failure leads here
  }

  private CommandRegistry commands(Server server) {
    CommandRegistry commands = new CommandRegistry();
    RoomCommands.add(
        commands,
        server.rooms(),
        flags.dataFolder(),
        server.uploads(),
        fleet == null ? SaveSource.NONE : fleet.member().saves());
    UploadCommands.add(commands, server.uploads());
    AccessCommands.add(commands, access, server.rooms());
    AccountCommands.add(commands, server.accounts(), server.rooms());
    server.chatCommands(new AdminChat(commands, access, server.rooms()));
    RedirectCommands.add(
        commands,
        server.rooms(),
        server::redirectVisitors,
        ServerProbe::problem,
        ServerMain::stopSoon);
    GameChoice choice = new GameChoice(flags);
    LiveSettings settings = new LiveSettings(this::startNow, server, choice.rooms(server.config()));
    Map<String, Consumer<String>> live = settings.consumers(access, ServerMain::logLevel);
    Supplier<EffectiveSettings> present =
        ReloadCommand.add(commands, flags.settings(), settings, live, access::reload);
    ServerCommands.add(commands, server::status, present, recordings(), ServerMain::replay);
    if (fleet != null) {
      FleetConsole.add(commands, fleet.member());
    }
    RoomChangeCommands.add(commands, server, server.rooms(), flags.dataFolder(), server.uploads());
    return commands;
  }

  /** Waits for the ports. A server that lacks one isn't ready, and is closed. */
  private static WebServer opened(FutureTask<WebServer> ports, Server server)
      throws InterruptedException, StartFailure {
    try {
      return ports.get();
    } catch (ExecutionException e) {
      server.close();
      if (e.getCause() instanceof StartFailure failure) {
        throw failure;
      }
      throw new IllegalStateException("the ports can't be opened: " + e.getCause(), e);
    }
  }

  /** Opens the ports of the standard protocols and that for HTTP; returns the latter, or null. */
  private WebServer openPorts(Server server, CommandRegistry commands) throws StartFailure {
    DataFolder data = flags.dataFolder();
    StatusFacts facts =
        new StatusFacts(
            () -> server.config().get(ServerConfig.NAME),
            version(),
            server.tcpPort(),
            server.udpPort(),
            server.rooms());
    try {
      Logins logins = Logins.begin(System::nanoTime);
      ProtocolFlags.open(
          server.config(),
          flags.bindAddresses(),
          data,
          flags.settings(),
          commands,
          facts,
          logins.rcon());
      WebSubject subject =
          new WebSubject(
              server.config().get(ServerConfig.NAME),
              version(),
              server.rooms(),
              server.networkCounters(),
              logins,
              fleet == null ? null : fleet.member().figures(),
              server.accounts() == null ? List.of() : server.accounts().figures());
      return WebFlags.open(
          server.config(), subject, data, recordings(), flags.settings(), commands, logTail);
    } catch (IOException e) {
      throw new StartFailure(e.getMessage(), e);
    }
  }

  /** Returns the folders in which this server's recordings are. */
  private List<Path> recordings() {
    Path own = flags.dataFolder().recordings();
    Path target = flags.record();
    return target != null && Files.isDirectory(target) ? List.of(own, target) : List.of(own);
  }

  private static String replay(String file) {
    StringWriter text = new StringWriter();
    PrintWriter out = new PrintWriter(text);
    CaromMain.run(out, out, "replay", file);
    return text.toString().strip();
  }

  /** Ends the process on a thread of its own, because an exit waits for all that runs. */
  private static void stopSoon() {
    new Thread(() -> System.exit(0), "carom-exit").start();
  }

  private static void logLevel(String name) {
    LoggerContext logging = (LoggerContext) LoggerFactory.getILoggerFactory();
    logging.getLogger(Logger.ROOT_LOGGER_NAME).setLevel(ch.qos.logback.classic.Level.toLevel(name));
  }

  /** Returns what the server would be if it started now. */
  private LiveSettings.Next startNow(Map<String, String> set) throws BadSettingException {
    CommandLine program = spec.commandLine();
    EffectiveSettings settings = read(program.getParseResult(), set).settings();
    ServerFlags next = new ServerFlags(program, settings);
    GameChoice choice = new GameChoice(next);
    next.check();
    ServerConfig config = next.config(choice.gameName());
    return new LiveSettings.Next(settings, config, choice.rooms(config));
  }

  private static String version() {
    String version = ServerMain.class.getPackage().getImplementationVersion();
    return version == null ? "(development build)" : version;
  }
}
