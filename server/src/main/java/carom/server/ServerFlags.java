package carom.server;

import carom.game.Games;
import carom.net.kryo.server.KryoLimits;
import carom.net.seal.Encryption;
import carom.net.transport.Impairment;
import carom.options.BadFlag;
import carom.options.NetworkConditions;
import carom.options.Sockets;
import carom.server.access.AddressRange;
import carom.server.config.DataFolder;
import carom.server.config.ServerConfig;
import carom.server.config.SettingUnits;
import carom.server.lobby.Lobby;
import carom.server.query.ProtocolFlags;
import carom.server.recording.RotationLimit;
import carom.server.thin.plain.PlainFlags;
import carom.server.thin.web.PlayFlags;
import carom.server.web.WebFlags;
import java.io.File;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/**
 * The flags of {@code carom-server}. Picocli fills them in, {@link #check} refuses flags that don't
 * fit together, and {@link #config} turns the rest into the server's settings.
 */
final class ServerFlags {
  private static final int MAX_SPECTATOR_DELAY_S = 3_600;
  private static final int MAX_GRACE_S = 600;
  private static final int MAX_KEPT = 10_000;
  private static final int MAX_LOGS = 20;

  @Spec(Spec.Target.MIXEE)
  private CommandSpec program;

  @Option(
      names = "--config",
      paramLabel = "FILE",
      description =
          "File of settings: name = value, with the names of these flags (carom.conf in the data"
              + " folder, if it is there). Flags win over environment variables such as"
              + " CAROM_TICK_RATE, variables over the file.")
  @SuppressWarnings("unused") // the layers of settings read it
  private Path config;

  @Option(
      names = "--print-config",
      description = "Prints the settings as such a file, with what each does, and ends.")
  boolean printConfig;

  @Option(
      names = "--data",
      paramLabel = "FOLDER",
      defaultValue = "data",
      description =
          "Folder of the server's own files: settings, key, bans, levels, recordings, logs"
              + " (${DEFAULT-VALUE}).")
  private Path data;

  @Option(
      names = "--bind",
      paramLabel = "ADDRESS",
      description =
          "Address of this machine on which the ports are open; give it once for each; 0.0.0.0 ="
              + " all of IPv4 (all, also of IPv6).")
  private List<String> bind = List.of();

  @Option(
      names = "--tcp-port",
      paramLabel = "N",
      defaultValue = "54555",
      description = "Port for reliable messages, 0..65535, 0 = any free one (${DEFAULT-VALUE}).")
  int tcpPort;

  @Option(
      names = "--udp-port",
      paramLabel = "N",
      defaultValue = "54777",
      description = "Port for datagrams, 0..65535, 0 = any free one (${DEFAULT-VALUE}).")
  int udpPort;

  @Option(
      names = "--proxy-from",
      paramLabel = "NETWORK",
      description =
          "Address or network of a proxy (10.0.0.5, 10.0.0.0/8) before the TCP port: its"
              + " connections begin with a PROXY protocol header, version 2, that says where the"
              + " player is; give it once for each.")
  private List<String> proxyFrom = List.of();

  @Option(
      names = "--encryption",
      paramLabel = "on|off",
      defaultValue = "on",
      description =
          "Encrypt the links; off is for debugging, and players need it, too (${DEFAULT-VALUE}).")
  Encryption encryption;

  @Option(
      names = "--game",
      paramLabel = "NAME",
      description = "Game to run: ${COMPLETION-CANDIDATES} (that of the level, or arena).",
      completionCandidates = GameNames.class)
  String game;

  @Option(
      names = "--level",
      paramLabel = "FILE",
      description = "Level file, or the name of one that comes with the program (the game's own).")
  String level;

  @Option(
      names = "--levels",
      paramLabel = "A,B,C",
      description =
          "Levels that follow each other in every room: the next begins when a match is over, and"
              + " the first after the last.")
  String levels;

  @Option(
      names = "--room",
      paramLabel = "NAME=LEVELS",
      description =
          "A room with a name of its own, NAME=LEVEL[,LEVEL...][:PLAYERS]; give it once for each"
              + " room, up to 64 times. A game's name stands for its default level. Example:"
              + " --room cup=arena,commons:16 --room jump=platformer.")
  List<String> rooms = List.of();

  @Option(
      names = "--room-info",
      paramLabel = "ROOM:KEY=VALUE",
      description =
          "What lists of rooms show about a room, up to 8 entries for each; a room without a name"
              + " is called by its number. Example: --room-info cup:skill=beginners.")
  List<String> roomInfo = List.of();

  @Option(
      names = "--scene",
      paramLabel = "NAME",
      description = "Scene of the library to watch, instead of a game; players have no bodies.")
  String scene;

  @Option(
      names = "--welcome",
      paramLabel = "TEXT",
      defaultValue = "",
      description =
          "What the server says to each player who joins, up to 120 characters (nothing).")
  private String welcome;

  @Option(
      names = "--tick-rate",
      paramLabel = "HZ",
      defaultValue = "60",
      description = "Simulation steps per second, 10..240 (${DEFAULT-VALUE}).")
  int tickRate;

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
          "Equal rooms that play side by side, 1..64, each with a thread of its own;"
              + " a newcomer gets into the fullest that has a place (${DEFAULT-VALUE}).")
  private int equalRooms;

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
      names = "--idle-kick",
      paramLabel = "S",
      defaultValue = "60",
      description =
          "Seconds without another input after which a player gives way to a newcomer, if the room"
              + " is full, 0..86400; 0 = never (${DEFAULT-VALUE}).")
  private int idleKickS;

  @Option(
      names = "--network-share",
      paramLabel = "PERCENT",
      defaultValue = "6",
      description =
          "Share of a full room's places that players of one network (IPv4 /24, IPv6 /64) keep when"
              + " others want to play, 1..100, at least two places; beyond it the newest gives way;"
              + " 100 = never (${DEFAULT-VALUE}).")
  private int networkShare;

  @Option(
      names = "--max-load",
      paramLabel = "X",
      defaultValue = "0.8",
      description =
          "Largest part of their time that 95 of 100 ticks of a room may take for it to let"
              + " newcomers in, 0..3; 0 = whatever they take (${DEFAULT-VALUE}).")
  private double maxLoad;

  @Option(
      names = "--checkpoint",
      paramLabel = "S",
      defaultValue = "0",
      description =
          "Seconds between checkpoints in the data folder, 0..600; a server that was killed goes on"
              + " from the last one when it starts again, and players get their bodies back; 0 ="
              + " none (${DEFAULT-VALUE}).")
  int checkpointS;

  @Option(
      names = "--record",
      paramLabel = "FILE",
      description =
          "Record the game to this new file, or to a new file in this folder, which ends with a"
              + " slash if it isn't there yet; 'carom replay FILE' computes it again.")
  private String record;

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
  int recordKeep;

  @Option(
      names = "--spectator-delay",
      paramLabel = "S",
      defaultValue = "0",
      description =
          "Show every game to spectators (carom-client --watch) S seconds late, 1..3600; 0 = don't"
              + " (${DEFAULT-VALUE}).")
  int spectatorDelayS;

  @Mixin private final NetworkConditions network = new NetworkConditions();
  @Mixin final ProtocolFlags protocols = new ProtocolFlags();
  @Mixin final PlainFlags plain = new PlainFlags();

  @Option(
      names = "--status-interval",
      paramLabel = "S",
      defaultValue = "60",
      description = "Seconds between status lines in the log, 0 = none (${DEFAULT-VALUE}).")
  private int statusIntervalS;

  @Option(
      names = "--idle",
      paramLabel = "pause|run",
      defaultValue = "pause",
      description =
          "What a room does while nobody plays or watches and nothing is recorded: pause until a"
              + " player comes, or run on (${DEFAULT-VALUE}).")
  private Idle idle;

  @Option(
      names = "--dev",
      paramLabel = "true|false",
      arity = "0..1",
      negatable = true,
      fallbackValue = "true",
      defaultValue = "false",
      description =
          "For developers of games: let in players whose build of the game differs, with a warning"
              + " instead of a refusal.")
  private boolean dev;

  @Option(
      names = "--allow-list",
      paramLabel = "true|false",
      arity = "0..1",
      negatable = true,
      fallbackValue = "true",
      defaultValue = "false",
      description =
          "Let only players in that allow.txt of the data folder names; the command 'allow' adds"
              + " to it.")
  boolean allowList;

  @Option(
      names = "--password-file",
      paramLabel = "FILE",
      description =
          "Demand a password from players and spectators: the first line of this file, at least 12"
              + " characters; made with a random one if it isn't there (none).")
  Path passwordFile;

  @Option(
      names = "--join-key",
      paramLabel = "FILE",
      description =
          "Demand join tokens that belong to this public key: Ed25519, PEM (everybody may join).")
  Path joinKey;

  @Option(
      names = "--token-uses",
      paramLabel = "N",
      defaultValue = "0",
      description =
          "Seats that one account may have at a time with join tokens, 0..1024, 0 = any number"
              + " (${DEFAULT-VALUE}).")
  int tokenUses;

  @Mixin final WebFlags web = new WebFlags();
  @Mixin final PlayFlags play = new PlayFlags();

  @Option(
      names = "--console",
      paramLabel = "true|false",
      arity = "0..1",
      negatable = true,
      fallbackValue = "true",
      defaultValue = "true",
      description =
          "Read commands from standard input; 'help' shows them. For a server in the background of"
              + " a terminal: --no-console.")
  boolean console;

  @Option(
      names = "--log-level",
      paramLabel = "L",
      defaultValue = "info",
      description = "How much is logged: ${COMPLETION-CANDIDATES} (${DEFAULT-VALUE}).")
  LogLevel logLevel;

  @Option(
      names = "--log-keep",
      paramLabel = "N",
      defaultValue = "10",
      description =
          "Older files of 10 MB that the log in the data folder keeps beside the present one,"
              + " 0..20; 0 = log to standard error only (${DEFAULT-VALUE}).")
  int logKeep;

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

  /** The values of {@code --idle}. */
  private enum Idle {
    PAUSE,
    RUN
  }

  /** The values of {@code --log-level}, from nothing to everything. */
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

  /** The names of all games, for the help text. */
  static final class GameNames implements Iterable<String> {
    @Override
    public Iterator<String> iterator() {
      return Games.names().iterator();
    }
  }

  /**
   * Checks the flags that {@link ServerConfig} doesn't check.
   *
   * @throws BadFlag for the first flag that can't be used
   */
  void check() {
    for (String network : proxyFrom) {
      if (AddressRange.parse(network).isEmpty()) {
        throw bad("--proxy-from: " + AddressRange.problem(network));
      }
    }
    requireRange("--tcp-port", tcpPort, 0, Sockets.MAX_PORT);
    requireRange("--udp-port", udpPort, 0, Sockets.MAX_PORT);
    String problem =
        Sockets.first(
            web.problem(), play.problem(), protocols.problem(), plain.problem(bindAddresses()));
    if (problem != null) {
      throw bad(problem);
    }
    requireRange("--grace", graceS, 0, MAX_GRACE_S);
    requireRange("--checkpoint", checkpointS, 0, Server.MAX_CHECKPOINT_S);
    requireRange("--max-load", maxLoad, 0, ServerConfig.MAX_LOAD_PERCENT / 100);
    requireRange(
        "--budget", budget, ServerConfig.MIN_BUDGET / 1_000, ServerConfig.MAX_BUDGET / 1_000);
    requireRange("--log-keep", logKeep, 0, MAX_LOGS);
    if (record != null && roomCount() > 1 && !recordsToFolder()) {
      throw bad("--record=" + record + " is no folder; rooms=" + roomCount() + " need one");
    }
    requireRange("--spectator-delay", spectatorDelayS, 0, MAX_SPECTATOR_DELAY_S);
    checkRotation();
    if (network.problem() != null) {
      throw bad(network.problem());
    }
  }

  /**
   * Checks that the flags which say what rooms there are exclude each other.
   *
   * @throws BadFlag when they don't
   */
  void checkRooms() {
    ParseResult given = program.commandLine().getParseResult();
    if (!rooms.isEmpty()) {
      for (String other : List.of("--rooms", "--level", "--levels", "--game", "--scene")) {
        if (given.hasMatchedOption(other)) {
          throw bad(
              "--room and "
                  + other
                  + " exclude each other: each --room names its levels; leave "
                  + other
                  + " out");
        }
      }
      if (rooms.size() > ServerConfig.MAX_ROOMS) {
        throw bad(
            String.format(
                Locale.ROOT,
                "--room is given %d times, a server has 1..%d rooms; leave some out",
                rooms.size(),
                ServerConfig.MAX_ROOMS));
      }
    }
    if (levels != null) {
      for (String other : List.of("--level", "--game", "--scene")) {
        if (given.hasMatchedOption(other)) {
          throw bad("--levels and " + other + " exclude each other; leave " + other + " out");
        }
      }
    }
  }

  private int roomCount() {
    return rooms.isEmpty() ? equalRooms : rooms.size();
  }

  private void checkRotation() {
    boolean rotates = rotation().rotates();
    requireRange("--record-keep", recordKeep, 0, MAX_KEPT);
    if (rotates && !recordsToFolder()) {
      throw bad("--record-rotate=" + recordRotate + " needs a folder; give one by --record");
    }
    if (rotates && spectatorDelayS > 0) {
      throw bad(
          "--record-rotate="
              + recordRotate
              + " can't be combined with --spectator-delay="
              + spectatorDelayS
              + ": spectators see one file; leave one of them out");
    }
    if (recordKeep > 0 && !rotates) {
      throw bad("--record-keep=" + recordKeep + " needs --record-rotate");
    }
  }

  /** Refuses a value in the flag's unit, and shows it as the operator wrote it. */
  private void requireRange(String flag, double value, int min, int max) {
    if (!(value >= min && value <= max)) { // NaN is in no range
      OptionSpec written = program.commandLine().getParseResult().matchedOption(flag);
      String unit = SettingUnits.plain(written.paramLabel());
      throw bad(
          String.format(
              Locale.ROOT,
              "%s=%s is outside %d..%d%s",
              flag,
              written.originalStringValues().get(0),
              min,
              max,
              unit.isEmpty() ? "" : " " + unit));
    }
  }

  /**
   * Returns the settings of a server that runs this game; call {@link #check} before.
   *
   * @throws BadFlag when a setting is out of range
   */
  ServerConfig config(String gameName) {
    try {
      return ServerConfig.defaults()
          .withGameName(gameName)
          .withServerName(name)
          .withTickRateHz(tickRate)
          .withSeed(seed == null ? new SecureRandom().nextLong() : seed)
          .withMaxPlayers(maxPlayers)
          .withSnapshotBitsPerSecond(1_000 * budget)
          .withViewMetres(view)
          .withRooms(roomCount())
          .withThreads(threads)
          .withGraceMs(graceS * 1_000)
          .withIdleKickS(idleKickS)
          .withNetworkSharePercent(networkShare)
          .withMaxLoadPercent((int) Math.round(100 * maxLoad))
          .withInputHoldTicks(tickRate / 2)
          .withSnapshotRateHz(snapshotRate == null ? tickRate : snapshotRate)
          .withStatusIntervalS(statusIntervalS)
          .withPausesIdleRooms(idle == Idle.PAUSE)
          .withTakesAnyCode(dev)
          .withWelcome(welcome);
    } catch (IllegalArgumentException e) {
      throw bad(e.getMessage());
    }
  }

  /**
   * Returns the transport's limits for open links. Those that play, those that wait and those that
   * watch have limits of their own in the lobby; here is room for all of them. A single address may
   * hold all seats, because a whole school may be behind one router.
   *
   * @param places number of seats of all rooms
   */
  KryoLimits limits(int places) {
    return KryoLimits.DEFAULT.withConnections(
        Lobby.mostLinks(places), Lobby.mostLinksOfAddress(places));
  }

  /** Returns the folder of the server's own files. */
  DataFolder dataFolder() {
    return new DataFolder(data);
  }

  /** Returns the networks of proxies before the TCP port. */
  List<AddressRange> proxies() {
    return proxyFrom.stream().map(network -> AddressRange.parse(network).orElseThrow()).toList();
  }

  /** Returns the addresses to listen on, empty for all. */
  List<InetAddress> bindAddresses() {
    return bind.stream().map(text -> address("--bind", text)).distinct().toList();
  }

  private InetAddress address(String flag, String text) {
    try {
      return InetAddress.getByName(text);
    } catch (UnknownHostException e) {
      throw bad(flag + "=" + text + " is no address; give one such as 127.0.0.1 or ::1");
    }
  }

  /** Returns the file or folder of {@code --record}, or null if nothing is recorded. */
  Path record() {
    try {
      return record == null ? null : Path.of(record);
    } catch (InvalidPathException e) {
      throw bad("--record=" + record + " can't be the name of a file or folder");
    }
  }

  /** Returns whether {@code --record} names a folder: one that is there, or to be made. */
  boolean recordsToFolder() {
    return record != null
        && (record.endsWith("/") || record.endsWith(File.separator) || Files.isDirectory(record()));
  }

  /** Returns the limit of {@code --record-rotate} for each file. */
  RotationLimit rotation() {
    try {
      return RotationLimit.parse(recordRotate);
    } catch (IllegalArgumentException e) {
      throw bad("--record-rotate=" + e.getMessage());
    }
  }

  /** Returns the impairment that the flags ask for, or null if they ask for none. */
  Impairment impairment() {
    return network.isBad() ? network.impairment() : null;
  }

  /** Returns an exception for the caller to throw: one line on standard error and exit code 2. */
  BadFlag bad(String message) {
    return new BadFlag(program.commandLine(), message);
  }
}
