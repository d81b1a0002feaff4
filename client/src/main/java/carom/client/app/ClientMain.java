package carom.client.app;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.InputSource;
import carom.client.PredictionMode;
import carom.client.link.ConnectionPhase;
import carom.client.link.RoomBrowser;
import carom.client.replay.ReplayClient;
import carom.client.replay.SpectatorThread;
import carom.client.settings.SettingsFile;
import carom.client.stats.NetStats;
import carom.client.view.ClientView;
import carom.net.frame.Trust;
import carom.net.protocol.PlayerName;
import carom.net.seal.KnownServers;
import carom.net.transport.ClientTransport;
import carom.options.BadFlag;
import carom.sim.scene.catalog.Scenes;
import carom.text.Suggestion;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.ServiceLoader;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The program {@code carom-client}: plays on a server, in a window or without one. */
@Command(
    name = "carom-client",
    mixinStandardHelpOptions = true,
    versionProvider = ProgramVersion.class,
    sortOptions = false,
    description = "Plays on a Carom server.")
public final class ClientMain implements Callable<Integer> {
  private static final String LIST = "list";
  private static final long SECOND = 1_000_000_000L;
  private static final long FRAME_NS = SECOND / 120;

  @Mixin private final NetworkOptions network = new NetworkOptions();

  @Option(
      names = "--name",
      paramLabel = "NAME",
      description = "Player's name (in a window that of the settings, else ${DEFAULT-VALUE}).",
      defaultValue = "player")
  private String name = "player";

  @Option(
      names = "--settings",
      paramLabel = "FILE",
      description = "The player's settings, for a window (in the user's folder of settings).")
  private Path settings = SettingsFile.usual();

  @Option(
      names = "--headless",
      description = "No window: a status line each second, a JSON line at the end.")
  private boolean headless;

  @Option(
      names = "--seconds",
      paramLabel = "S",
      description = "Leave after this time; 0 = stay (${DEFAULT-VALUE}).",
      defaultValue = "0")
  private double seconds;

  @Option(
      names = "--prediction",
      paramLabel = "MODE",
      description =
          "What is simulated ahead of the server: island (the own body and what it touches), all"
              + " (as much as possible) or none (${DEFAULT-VALUE}).",
      defaultValue = "island")
  private PredictionMode prediction = PredictionMode.ISLAND;

  @Option(
      names = "--synctest",
      description =
          "For developers: roll the prediction back 8 ticks in each tick, and count other hashes.")
  private boolean syncTest;

  @Option(names = "--net-graph", description = "Start with the net graph shown.")
  private boolean netGraph;

  @Option(names = "--debug", description = "Start with debug drawing.")
  private boolean debug;

  @Option(
      names = "--screenshot",
      paramLabel = "FILE",
      description = "Write the window's last picture there when --seconds are over.",
      defaultValue = "")
  private String screenshot = "";

  @Option(
      names = "--volume",
      paramLabel = "PERCENT",
      description = "Loudness of the sounds, 0..100; 0 = silent (as in the settings).")
  private Integer volume;

  @Option(
      names = "--scene",
      paramLabel = "NAME",
      description = "Look at a scene of the library, without a server; list = show their names.",
      defaultValue = "")
  private String scene = "";

  @Option(
      names = "--replay",
      paramLabel = "FILE",
      description = "Play what carom-server --record has written, also while it is being written.")
  private Path replay;

  @Option(
      names = "--watch",
      paramLabel = "ROOM",
      arity = "0..1",
      fallbackValue = "1",
      defaultValue = "0",
      description =
          "Watch this room of the server instead of playing, as late as the server wants it (1 when"
              + " no number is given).")
  private int watch;

  @Option(
      names = "--list",
      description = "Print the rooms of the server instead of playing, one a line.")
  private boolean list;

  @CommandLine.Spec private CommandLine.Model.CommandSpec spec;

  private ClientMain() {}

  /**
   * Runs the program, and exits with 0 after a normal end, 1 if playing was not possible, 2 on bad
   * flags.
   */
  public static void main(String[] args) {
    System.exit(run(args));
  }

  /** Runs the program like {@link #main}, but returns the exit code. */
  public static int run(String... args) {
    return BadFlag.explainedBy(new CommandLine(new ClientMain()))
        .setCaseInsensitiveEnumValuesAllowed(true)
        .execute(args);
  }

  @Override
  public Integer call() {
    String problem = network.problem();
    if (problem == null && PlayerName.problem(name) != null) {
      problem = "--name: " + PlayerName.problem(name);
    } else if (!(seconds >= 0 && seconds <= 1e6)) {
      problem = "--seconds=" + seconds + " is outside 0..1000000";
    } else if (problem == null && volume != null && (volume < 0 || volume > 100)) {
      problem = "--volume=" + volume + " is outside 0..100";
    }
    if (problem == null && replay != null) {
      problem = replayProblem();
    }
    if (problem == null && !scene.isEmpty()) {
      problem = sceneProblem();
    }
    if (problem == null && (watch < 0 || watch > 255)) {
      problem = "--watch=" + watch + " is outside 1..255";
    } else if (problem == null && watch > 0 && (replay != null || !scene.isEmpty())) {
      problem = "--watch excludes --replay and --scene";
    }
    if (problem != null) {
      throw new BadFlag(spec.commandLine(), problem);
    }
    if (scene.equals(LIST)) {
      Scenes.all()
          .forEach(s -> System.out.printf(Locale.ROOT, "%-18s %s%n", s.name(), s.description()));
      return 0;
    }
    network.startLogging();
    ClientConfig config = network.config(name).withPrediction(prediction).withSyncTest(syncTest);
    if (list) {
      return listRooms();
    }
    if (watch > 0) {
      return watch(config);
    }
    if (headless) {
      try (StopSignal stop = new StopSignal();
          ClientTransport transport = network.sockets(trust());
          GameClient client = new GameClient(config, transport, InputSource.IDLE)) {
        return playHeadless(client, stop);
      }
    }
    return openWindow(config, replay, null);
  }

  /** Returns what a server must be like; the known ones are in a file beside the settings. */
  private Trust trust() {
    return network.trust(KnownServers.in(settings.resolveSibling("known_servers")));
  }

  private int openWindow(ClientConfig config, Path recording, SpectatorThread spectator) {
    boolean named =
        spec.commandLine().getParseResult().hasMatchedOption("--host")
            || spec.commandLine().getParseResult().hasMatchedOption("--tcp-port");
    SettingsFile kept = new SettingsFile(settings);
    kept.load();
    if (!kept.problem().isEmpty()) {
      System.err.println("carom-client: " + kept.problem());
    }
    ClientOptions options =
        new ClientOptions(
            config,
            network.impairment(),
            trust(),
            named,
            seconds,
            netGraph,
            debug,
            screenshot,
            volume == null ? -1 : volume,
            kept,
            spec.commandLine().getParseResult().hasMatchedOption("--name"),
            recording,
            spectator,
            scene.isEmpty() ? null : Scenes.get(scene));
    for (Window window : ServiceLoader.load(Window.class)) {
      return window.launch(options);
    }
    System.err.println("This build has no window; start with --headless.");
    return 1;
  }

  /** Prints the server's rooms; returns 1 if it doesn't tell them. */
  private int listRooms() {
    try (ClientTransport transport = network.sockets(trust());
        RoomBrowser browser = new RoomBrowser(network.address(), transport)) {
      while (!browser.isDone()) {
        browser.update(System.nanoTime());
        if (!sleepUntil(System.nanoTime() + FRAME_NS)) {
          return 1;
        }
      }
      if (!browser.problem().isEmpty()) {
        System.err.println("carom-client: " + browser.problem());
        return 1;
      }
      System.out.println(RoomTable.of(browser.rooms()));
      return 0;
    }
  }

  private int watch(ClientConfig config) {
    try (StopSignal stop = new StopSignal();
        ClientTransport transport = network.sockets(trust())) {
      int exit = 1;
      SpectatorThread spectator = new SpectatorThread(config, watch, transport);
      while (spectator != null) {
        try (SpectatorThread watched = spectator) {
          Path file = watched.await();
          if (file != null) {
            exit =
                headless ? watchHeadless(file, watched, stop) : openWindow(config, file, watched);
          }
          spectator = stop.asked() ? null : watched.follow();
          if (file == null || spectator != null) {
            System.err.println("carom-client: " + watched.message());
          }
        }
      }
      return exit;
    } catch (IOException e) {
      System.err.println("carom-client: can't watch: " + e);
      return 1;
    }
  }

  /** Replays what is watched, and prints a line per second; returns 1 if it diverged. */
  private int watchHeadless(Path file, SpectatorThread spectator, StopSignal stop)
      throws IOException {
    try (ReplayClient client = new ReplayClient(file)) {
      client.seek(Integer.MAX_VALUE);
      long start = System.nanoTime();
      long nextLine = start + SECOND;
      for (long now = start;
          (seconds == 0 || now - start < seconds * SECOND) && !stop.asked() && !client.ended();
          now = System.nanoTime()) {
        client.update(now);
        if (now >= nextLine) {
          nextLine += SECOND;
          System.out.printf(
              Locale.ROOT,
              "watching tick=%d players=%d%s%s%n",
              client.tick(),
              client.view().players().size(),
              client.waiting() ? " waiting for more" : "",
              client.divergence() == null ? "" : " diverged at " + client.divergence().tick());
        }
        if (client.waiting() && !spectator.end().isEmpty()) {
          System.err.println("carom-client: " + spectator.end());
          break;
        }
        if (!sleepUntil(now + FRAME_NS)) {
          break;
        }
      }
      return client.divergence() == null ? 0 : 1;
    }
  }

  private String replayProblem() {
    if (headless || !scene.isEmpty()) {
      return "--replay and "
          + (headless ? "--headless" : "--scene")
          + " exclude each other; 'carom replay FILE' plays without a window";
    }
    try {
      new ReplayClient(replay).close();
      return null;
    } catch (IOException e) {
      return "--replay: " + e.getMessage();
    }
  }

  private String sceneProblem() {
    if (headless) {
      return "--scene and --headless exclude each other: a scene is there to be looked at";
    }
    return scene.equals(LIST) || Scenes.names().contains(scene)
        ? null
        : "--scene: unknown scene="
            + scene
            + Suggestion.didYouMean(scene, Scenes.names())
            + "; --scene list shows all";
  }

  private int playHeadless(GameClient client, StopSignal stop) {
    long start = System.nanoTime();
    long nextLine = start + SECOND;
    long now = start;
    boolean played = false;
    ClientView view = client.view();
    while ((seconds == 0 || now - start < seconds * SECOND)
        && view.phase() != ConnectionPhase.ENDED
        && !stop.asked()) {
      client.update(now);
      played |= view.phase() == ConnectionPhase.PLAYING;
      if (now >= nextLine) {
        nextLine += SECOND;
        System.out.println(line(view));
      }
      if (!sleepUntil(now + FRAME_NS)) {
        break;
      }
      now = System.nanoTime();
    }
    boolean stayed = view.phase() == ConnectionPhase.PLAYING;
    if (!stayed) {
      System.err.println(view.message());
    }
    System.out.println(summary(client.stats(), played, now));
    return played && stayed ? 0 : 1;
  }

  private static String line(ClientView view) {
    NetStats s = view.stats();
    return String.format(
        Locale.ROOT,
        "%s tick=%d entities=%d players=%d rtt=%.1fms loss=%.1f%% snapshots=%.0f/s in=%.0fkbit/s"
            + " margin=%.0f/%.1f delay=%.0fms corrections=%d exact=%.2f%%%s",
        view.phase().name().toLowerCase(Locale.ROOT),
        view.tick(),
        view.entityCount(),
        view.players().size(),
        s.rttMs(),
        s.lossPercent(),
        s.snapshotsPerSecond(),
        s.kbitInPerSecond(),
        s.inputMargin(),
        s.targetMargin(),
        s.interpolationDelayMs(),
        s.corrections(),
        100 * s.exactRate(),
        view.message().isEmpty() ? "" : " " + view.message());
  }

  private static String summary(NetStats s, boolean joined, long nowNs) {
    double played = s.playedSeconds(nowNs);
    return String.format(
        Locale.ROOT,
        "{\"joined\":%b,\"reconnects\":%d,\"snapshotsPerSecond\":%.2f,\"gapP99Ms\":%.2f,"
            + "\"rttP50Ms\":%.2f,\"kbitPerSecond\":%.2f,\"corrections\":%d,"
            + "\"correctionMeanMetres\":%.4f,\"exactRate\":%.5f,\"overTcp\":%b}",
        joined,
        s.reconnects(),
        played > 0 ? s.snapshots() / played : 0,
        s.gapP99Ms(),
        s.rttP50Ms(),
        played > 0 ? s.playingBytesIn() * 8 / 1_000.0 / played : 0,
        s.corrections(),
        s.correctionMeanMetres(),
        s.exactRate(),
        s.isOverTcp());
  }

  private static boolean sleepUntil(long deadlineNs) {
    long waitNs = deadlineNs - System.nanoTime();
    try {
      if (waitNs > 0) {
        Thread.sleep(waitNs / 1_000_000, (int) (waitNs % 1_000_000));
      }
      return true;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }
}
