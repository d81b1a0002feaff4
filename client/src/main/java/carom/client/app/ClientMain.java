package carom.client.app;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.InputSource;
import carom.client.LevelSender;
import carom.client.PredictionMode;
import carom.client.edit.EditFile;
import carom.client.link.ConnectionPhase;
import carom.client.link.RoomBrowser;
import carom.client.replay.ReplayClient;
import carom.client.replay.SpectatorThread;
import carom.client.settings.SettingsFile;
import carom.client.stats.NetStats;
import carom.client.view.ClientView;
import carom.game.GamesOption;
import carom.net.frame.Trust;
import carom.net.protocol.PlayerName;
import carom.net.protocol.ProtocolLimits;
import carom.net.seal.KnownServers;
import carom.net.seal.PlayerKey;
import carom.net.transport.ClientTransport;
import carom.options.BadFlag;
import carom.options.Flags;
import carom.options.Rows;
import carom.options.Setting;
import carom.sim.scene.Scenes;
import carom.text.FileErrors;
import carom.text.Suggestion;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.ServiceLoader;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

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

  private static final Rows ROWS = Rows.ofFlags();

  static {
    ROWS.addAll(NetworkOptions.ROWS);
  }

  private static final Setting<String> NAME =
      ROWS.text("name", "NAME", "player")
          .text("Player's name (in a window that of the settings, else {default}).")
          .checked(ClientMain::nameProblem);

  private static final Setting<Path> SETTINGS =
      ROWS.path("settings", "FILE", null)
          .text("The player's settings, for a window (in the user's folder of settings).");

  private static final Setting<Boolean> HEADLESS =
      ROWS.mark("headless").text("No window: a status line each second, a JSON line at the end.");

  private static final Setting<Double> SECONDS =
      ROWS.number("seconds", "S", 0, 1000000, 0)
          .text("Leave after this time; 0 = stay ({default}).");

  private static final Setting<PredictionMode> PREDICTION =
      ROWS.choice("prediction", "MODE", PredictionMode.ISLAND)
          .text(
              "What is simulated ahead of the server: island (the own body and what it"
                  + " touches), all (as much as possible) or none ({default}).");

  private static final Setting<Boolean> SYNCTEST =
      ROWS.mark("synctest")
          .text(
              "For developers: roll the prediction back 8 ticks in each tick, and count other"
                  + " hashes.");

  private static final Setting<Boolean> NET_GRAPH =
      ROWS.mark("net-graph").text("Start with the net graph shown.");

  private static final Setting<Boolean> DEBUG =
      ROWS.mark("debug").text("Start with debug drawing.");

  private static final Setting<String> SCREENSHOT =
      ROWS.text("screenshot", "FILE", "")
          .text("Write the window's last picture there when --seconds are over.");

  private static final Setting<Integer> VOLUME =
      ROWS.whole("volume", "PERCENT", 0, 100, null)
          .text("Loudness of the sounds, {range}; 0 = silent (as in the settings).");

  private static final Setting<String> SCENE =
      ROWS.text("scene", "NAME", "")
          .text("Look at a scene of the library, without a server; list = show their names.");

  private static final Setting<Path> REPLAY =
      ROWS.path("replay", "FILE", null)
          .text("Play what carom-server --record has written, also while it is being written.");

  private static final Setting<Integer> WATCH =
      ROWS.whole("watch", "ROOM", 1, 255, null)
          .text(
              "Watch this room of the server instead of playing, as late as the server wants it"
                  + " (1 when no number is given).")
          .alone("1");

  private static final Setting<String> HERE =
      ROWS.text("here", "LEVEL", "")
          .text("Start a game with this level on this machine, in this process; see --bots.");

  private static final Setting<Path> EDIT =
      ROWS.path("edit", "FILE", null)
          .text("Edit a level file, or begin a new one if there is none; F5 plays it.");

  private static final Setting<Integer> BOTS =
      ROWS.whole("bots", "N", 0, LocalGames.MAX_BOTS, 0)
          .text("Players of the machine in the game of --here or --edit, {range} ({default}).");

  private static final Setting<Boolean> OPEN =
      ROWS.mark("open").text("Let others join the game of --here, over the network.");

  private static final Setting<Boolean> ROOM_LIST =
      ROWS.mark("list").text("Print the rooms of the server instead of playing, one a line.");

  private static final Setting<Path> UPLOAD =
      ROWS.path("upload", "FILE", null)
          .text("Send a level of yours to the server instead of playing, if it takes some.");

  private static String nameProblem(String name) {
    String problem = PlayerName.problem(name);
    return problem == null ? null : ": " + problem;
  }

  @Mixin
  @SuppressWarnings("unused") // picocli gives it the flag
  private GamesOption games;

  private ClientConfig flags;
  private NetworkOptions network;

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
    CommandLine program = new CommandLine(new ClientMain());
    Flags.add(program.getCommandSpec(), ROWS);
    return BadFlag.explainedBy(program).execute(args);
  }

  @Override
  public Integer call() {
    flags = Flags.read(new ClientConfig(), spec.commandLine().getParseResult(), ROWS);
    network = new NetworkOptions(flags);
    String problem = network.problem();
    if (problem == null && flags.get(REPLAY) != null) {
      problem = replayProblem();
    }
    if (problem == null && !flags.get(SCENE).isEmpty()) {
      problem = sceneProblem();
    }
    if (problem == null && !flags.get(HERE).isEmpty()) {
      problem = hereProblem();
    }
    if (problem == null && flags.get(EDIT) != null) {
      problem = editProblem();
    }
    if (problem == null
        && flags.get(WATCH) != null
        && (flags.get(REPLAY) != null || !flags.get(SCENE).isEmpty())) {
      problem = "--watch excludes --replay and --scene";
    }
    if (problem != null) {
      throw new BadFlag(spec.commandLine(), problem);
    }
    if (flags.get(SCENE).equals(LIST)) {
      Scenes.all()
          .forEach(s -> System.out.printf(Locale.ROOT, "%-18s %s%n", s.name(), s.description()));
      return 0;
    }
    network.startLogging();
    ClientConfig config =
        network
            .config(flags.get(NAME))
            .with(ClientConfig.PREDICTION, flags.get(PREDICTION))
            .with(ClientConfig.SYNC_TEST, flags.get(SYNCTEST));
    if (flags.get(ROOM_LIST)) {
      return listRooms();
    }
    if (flags.get(UPLOAD) != null) {
      return upload(withKey(config), flags.get(UPLOAD));
    }
    if (flags.get(WATCH) != null) {
      return watch(config);
    }
    if (flags.get(HEADLESS)) {
      try (StopSignal stop = new StopSignal();
          ClientTransport transport = network.sockets(trust());
          GameClient client = new GameClient(config, transport, InputSource.IDLE)) {
        return playHeadless(client, stop);
      }
    }
    return openWindow(config, flags.get(REPLAY), null);
  }

  /** Returns what a server must be like; the known ones are in a file beside the settings. */
  private Trust trust() {
    return network.trust(
        KnownServers.in(flags.get(SETTINGS, SettingsFile.usual()).resolveSibling("known_servers")));
  }

  /** Returns the settings with the key beside the window's settings, unless another was named. */
  private ClientConfig withKey(ClientConfig config) {
    if (config.get(ClientConfig.KEY) != null) {
      return config;
    }
    Path file = flags.get(SETTINGS, SettingsFile.usual()).resolveSibling("player.key");
    try {
      return config.with(ClientConfig.KEY, PlayerKey.load(file));
    } catch (IOException e) {
      System.err.println("carom-client: servers won't know you again: " + e.getMessage());
      return config;
    }
  }

  private int openWindow(ClientConfig given, Path recording, SpectatorThread spectator) {
    ClientConfig config = withKey(given);
    boolean named =
        spec.commandLine().getParseResult().hasMatchedOption("--host")
            || spec.commandLine().getParseResult().hasMatchedOption("--tcp-port");
    SettingsFile kept = new SettingsFile(flags.get(SETTINGS, SettingsFile.usual()));
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
            flags.get(SECONDS),
            flags.get(NET_GRAPH),
            flags.get(DEBUG),
            flags.get(SCREENSHOT),
            flags.get(VOLUME, -1),
            kept,
            spec.commandLine().getParseResult().hasMatchedOption("--name"),
            recording,
            spectator,
            flags.get(SCENE).isEmpty() ? null : Scenes.get(flags.get(SCENE)),
            flags.get(HERE).isEmpty()
                ? null
                : new LocalGames.GameChoice(flags.get(HERE), flags.get(BOTS), flags.get(OPEN)),
            flags.get(EDIT),
            flags.get(BOTS));
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

  /** Sends a level, and prints what has come of it; returns 1 if the server doesn't take it. */
  private int upload(ClientConfig config, Path file) {
    byte[] level;
    try (InputStream in = Files.newInputStream(file)) {
      level = in.readNBytes(ProtocolLimits.MAX_OFFERED_BYTES + 1);
    } catch (IOException e) {
      throw new BadFlag(
          spec.commandLine(), "--upload=" + file + " can't be read: " + FileErrors.reason(e));
    }
    try (ClientTransport transport = network.sockets(trust());
        LevelSender sender = new LevelSender(config, level, transport)) {
      while (!sender.isDone()) {
        sender.update(System.nanoTime());
        if (!sleepUntil(System.nanoTime() + FRAME_NS)) {
          return 1;
        }
      }
      (sender.isTaken() ? System.out : System.err).println(sender.text());
      return sender.isTaken() ? 0 : 1;
    }
  }

  private int watch(ClientConfig config) {
    try (StopSignal stop = new StopSignal();
        ClientTransport transport = network.sockets(trust())) {
      int exit = 1;
      SpectatorThread spectator = new SpectatorThread(config, flags.get(WATCH), transport);
      while (spectator != null) {
        try (SpectatorThread watched = spectator) {
          Path file = watched.await();
          if (file != null) {
            exit =
                flags.get(HEADLESS)
                    ? watchHeadless(file, watched, stop)
                    : openWindow(config, file, watched);
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
          (flags.get(SECONDS) == 0 || now - start < flags.get(SECONDS) * SECOND)
              && !stop.asked()
              && !client.ended();
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
    if (flags.get(HEADLESS) || !flags.get(SCENE).isEmpty()) {
      return "--replay and "
          + (flags.get(HEADLESS) ? "--headless" : "--scene")
          + " exclude each other; 'carom replay FILE' plays without a window";
    }
    try {
      new ReplayClient(flags.get(REPLAY)).close();
      return null;
    } catch (IOException e) {
      return "--replay: " + e.getMessage();
    }
  }

  private String sceneProblem() {
    if (flags.get(HEADLESS)) {
      return "--scene and --headless exclude each other: a scene is there to be looked at";
    }
    return flags.get(SCENE).equals(LIST) || Scenes.names().contains(flags.get(SCENE))
        ? null
        : "--scene: unknown scene="
            + flags.get(SCENE)
            + Suggestion.didYouMean(flags.get(SCENE), Scenes.names())
            + "; --scene list shows all";
  }

  private String hereProblem() {
    if (flags.get(HEADLESS)
        || flags.get(REPLAY) != null
        || flags.get(WATCH) != null
        || !flags.get(SCENE).isEmpty()) {
      return "--here excludes --headless, --replay, --scene and --watch";
    }
    LocalGames games = LocalGames.find();
    if (games == null) {
      return "--here: this build can't start games; it lacks carom-launcher";
    }
    try {
      games.level(flags.get(HERE));
      return null;
    } catch (IllegalStateException e) {
      return "--here: " + e.getMessage();
    }
  }

  private String editProblem() {
    if (flags.get(HEADLESS)
        || flags.get(REPLAY) != null
        || flags.get(WATCH) != null
        || !flags.get(SCENE).isEmpty()
        || !flags.get(HERE).isEmpty()) {
      return "--edit excludes --headless, --here, --replay, --scene and --watch";
    }
    try {
      new EditFile(flags.get(EDIT));
      return null;
    } catch (IOException e) {
      return "--edit: " + e.getMessage();
    }
  }

  private int playHeadless(GameClient client, StopSignal stop) {
    long start = System.nanoTime();
    long nextLine = start + SECOND;
    long now = start;
    boolean played = false;
    ClientView view = client.view();
    while ((flags.get(SECONDS) == 0 || now - start < flags.get(SECONDS) * SECOND)
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
