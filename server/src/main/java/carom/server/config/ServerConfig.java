package carom.server.config;

import carom.game.Games;
import carom.net.protocol.ProtocolLimits;
import carom.net.seal.Encryption;
import carom.options.NetworkConditions;
import carom.options.Rows;
import carom.options.Setting;
import carom.options.Settings;
import carom.physics.threads.WorkerThreads;
import carom.sim.message.BuiltInKinds;
import java.nio.file.Path;
import java.util.List;

/**
 * The settings of a server: a row for each, and a value for each row. Immutable; start from {@link
 * #defaults()}.
 *
 * <p><b>Length.</b> One table: each row says all there is to know of a setting.
 */
public final class ServerConfig extends Settings<ServerConfig> {
  /** Largest number of rooms. */
  public static final int MAX_ROOMS = 512;

  /** Largest number of seats in all rooms together: as many rooms as may be of the usual 64. */
  public static final int MAX_PLACES = 64 * MAX_ROOMS;

  /** The value of {@link #STORE} by which accounts keep nothing. */
  public static final String NO_STORE = "off";

  /** Longest time between checkpoints, s. */
  public static final int MAX_CHECKPOINT_S = 600;

  /** Flags that are no settings: other layers have none of them. */
  public static final Rows ONLY_FLAGS = Rows.ofFlags();

  /** All settings that an operator has, in the order of {@code --help}. */
  public static final Rows ROWS = Rows.ofFlags();

  private static final Rows INNER = Rows.inner();

  public static final Setting<Path> CONFIG =
      ONLY_FLAGS
          .path("config", "FILE", null)
          .text(
              "File of settings: name = value, with the names of these flags (carom.conf in the"
                  + " data folder, if it is there). Flags win over environment variables such as"
                  + " CAROM_TICK_RATE, variables over the file.");

  public static final Setting<Boolean> PRINT_CONFIG =
      ONLY_FLAGS
          .mark("print-config")
          .text("Prints the settings as such a file, with what each does, and ends.");

  public static final Setting<Path> DATA =
      ROWS.path("data", "FOLDER", "data")
          .text(
              "Folder of the server's own files: settings, key, bans, levels, recordings, logs"
                  + " ({default}).");

  public static final Setting<List<String>> BIND =
      ROWS.texts("bind", "ADDRESS")
          .text(
              "Address of this machine on which the ports are open; give it once for each;"
                  + " 0.0.0.0 = all of IPv4 (all, also of IPv6).");

  public static final Setting<Integer> TCP_PORT =
      ROWS.port("tcp-port", 54555)
          .text(
              "Port for reliable messages, {range}, 0 = any free one, or that of the pod's"
                  + " GameServer ({default}).");

  public static final Setting<Integer> UDP_PORT =
      ROWS.port("udp-port", 54777)
          .text(
              "Port for datagrams, {range}, 0 = any free one, or that of the pod's GameServer"
                  + " ({default}).");

  public static final Setting<List<String>> PROXY_FROM =
      ROWS.texts("proxy-from", "NETWORK")
          .text(
              "Address or network of a proxy (10.0.0.5, 10.0.0.0/8) before the TCP port: its"
                  + " connections begin with a PROXY protocol header, version 2, that says where"
                  + " the player is; give it once for each.");

  public static final Setting<Encryption> ENCRYPTION =
      ROWS.choice("encryption", "on|off", Encryption.ON)
          .text("Encrypt the links; off is for debugging, and players need it, too ({default}).");

  public static final Setting<String> GAME =
      ROWS.text("game", "NAME", null)
          .text("Game to run: {choices} (that of the level, or arena).")
          .choices(() -> String.join(", ", Games.names()));

  public static final Setting<String> LEVEL =
      ROWS.text("level", "FILE", null)
          .text("Level file, or the name of one that comes with the program (the game's own).");

  public static final Setting<String> LEVELS =
      ROWS.text("levels", "A,B,C", null)
          .text(
              "Levels that follow each other in every room: the next begins when a match is"
                  + " over, and the first after the last.")
          .live();

  public static final Setting<List<String>> ROOM =
      ROWS.texts("room", "NAME=LEVELS")
          .text(
              "A room with a name of its own, NAME=LEVEL[,LEVEL...][:PLAYERS]; give it once for"
                  + " each room, up to 512 times. A game's name stands for its default level."
                  + " Example: --room cup=arena,commons:16 --room jump=platformer.");

  public static final Setting<List<String>> ROOM_INFO =
      ROWS.texts("room-info", "ROOM:KEY=VALUE")
          .text(
              "What lists of rooms show about a room, up to 8 entries for each; a room without"
                  + " a name is called by its number. Example: --room-info cup:skill=beginners.");

  public static final Setting<String> SCENE =
      ROWS.text("scene", "NAME", null)
          .text("Scene of the library to watch, instead of a game; players have no bodies.");

  public static final Setting<String> WELCOME =
      ROWS.text("welcome", "TEXT", 0, BuiltInKinds.MAX_CHAT, "")
          .text("What the server says to each player who joins, up to 120 characters (nothing).")
          .live();

  public static final Setting<Integer> TICK_RATE =
      ROWS.whole("tick-rate", "HZ", 10, 240, 60)
          .text("Simulation steps per second, {range} ({default}).");

  public static final Setting<Long> SEED =
      ROWS.seed("seed", null)
          .text("Start of the random numbers; the same seed starts the same game (random).");

  public static final Setting<String> NAME =
      ROWS.text("name", "TEXT", 1, 40, "Carom")
          .text("What the log calls this server, {range} characters ({default}).")
          .live();

  public static final Setting<Integer> ROOMS =
      ROWS.whole("rooms", "N", 1, MAX_ROOMS, 1)
          .text(
              "Equal rooms that play side by side, {range}; a newcomer gets into the fullest that"
                  + " has a place ({default}).");

  public static final Setting<Integer> THREADS =
      ROWS.whole("threads", "N", 1, WorkerThreads.MAX_COUNT, 1)
          .text(
              "Threads that may step one world together, {range}: that of the room and helpers that"
                  + " all rooms share; for worlds of thousands of bodies ({default}).");

  public static final Setting<Integer> MAX_PLAYERS =
      ROWS.whole("max-players", "N", 1, ProtocolLimits.MAX_PLAYERS, 64)
          .text("Places in each room, {range}, at most 32768 in all rooms together ({default}).")
          .live();

  public static final Setting<Integer> SNAPSHOT_RATE =
      ROWS.whole("snapshot-rate", "HZ", 1, 240, null)
          .text("Snapshots per second and player, {range}, at most one a tick (one a tick).")
          .live();

  public static final Setting<Integer> BUDGET =
      ROWS.whole("budget", "KBIT", 16, 80000, 512)
          .text("Snapshots for one player, kbit/s of payload, {range} ({default}).")
          .live();

  public static final Setting<Integer> VIEW =
      ROWS.whole("view", "METRES", 0, 4096, 0)
          .text(
              "Largest half width and half height a player is told about, up to 4096; 0 = 64,"
                  + " and everything in small worlds ({default}).");

  public static final Setting<Integer> GRACE =
      ROWS.whole("grace", "S", 0, 600, 30)
          .text("Seconds the body of a player who lost the connection waits, {range} ({default}).");

  public static final Setting<Integer> IDLE_KICK =
      ROWS.whole("idle-kick", "S", 0, 86400, 60)
          .text(
              "Seconds without another input after which a player gives way to a newcomer, if"
                  + " the room is full, {range}; 0 = never ({default}).");

  public static final Setting<Integer> NETWORK_SHARE =
      ROWS.whole("network-share", "PERCENT", 1, 100, 6)
          .text(
              "Share of a full room's places that players of one network (IPv4 /24, IPv6 /64)"
                  + " keep when others want to play, {range}, at least two places; beyond it the"
                  + " newest gives way; 100 = never ({default}).");

  public static final Setting<Double> MAX_LOAD =
      ROWS.number("max-load", "X", 0, 3, 0.8)
          .text(
              "Largest part of their time that 95 of 100 ticks of a room may take for it to let"
                  + " newcomers in, {range}; 0 = whatever they take ({default}).")
          .live();

  public static final Setting<RoomRule> ROOM_RULE =
      ROWS.choice("room-rule", "fill|skill", RoomRule.FILL)
          .text(
              "Where players go who name no room: fill is the fullest room; skill is the fullest"
                  + " whose players are about as good, in games that name a skill"
                  + " ({default}).")
          .live();

  public static final Setting<Double> SKILL_WAIT =
      ROWS.number("skill-wait", "S", 0, 60, 10)
          .text(
              "Longest time for which a player waits by --room-rule skill, until any room will"
                  + " do, {range} ({default}).")
          .live();

  public static final Setting<Integer> CHECKPOINT =
      ROWS.whole("checkpoint", "S", 0, MAX_CHECKPOINT_S, 0)
          .text(
              "Seconds between checkpoints in the data folder, {range}; a server that was"
                  + " killed goes on from the last one when it starts again, and players get their"
                  + " bodies back; 0 = none ({default}).");

  public static final Setting<String> STORE =
      ROWS.text("store", "WHERE", "data")
          .text(
              "Where accounts keep what games let last: data = a file in the data folder, off ="
                  + " nowhere, or postgresql://[USER[:PASSWORD]@]HOST[:PORT]/DATABASE, for several"
                  + " servers ({default}).");

  public static final Setting<Boolean> UPLOADS =
      ROWS.toggle("uploads", false)
          .text(
              "Take levels from players who have an account: checked, bounded, kept in the data"
                  + " folder; moderators remove them.");

  public static final Setting<List<String>> PLAYERS_CHOOSE =
      ROWS.texts("players-choose", "ROOM")
          .text(
              "A room that plays a level of a player as soon as more than half of its players with"
                  + " an account want that; give it once for each room, or all.")
          .live();

  public static final Setting<List<BotRule>> BOTS =
      ROWS.list("bots", "[ROOM=]N[:STRENGTH]", BotRule::parse)
          .text(
              "Fill a room in which people play up to N players with bots (weak, medium or strong;"
                  + " mixed without), which take the seats of people who leave and make room for"
                  + " those who come; give it once for all rooms, and once for each that differs"
                  + " (none).")
          .live();

  public static final Setting<String> RECORD =
      ROWS.text("record", "FILE", null)
          .text(
              "Record the game to this new file, or to a new file in this folder, which ends"
                  + " with a slash if it isn't there yet; 'carom replay FILE' computes it again.");

  public static final Setting<String> RECORD_ROTATE =
      ROWS.text("record-rotate", "LIMIT", "0")
          .text(
              "Begin another file in the folder of --record after so many minutes, 1..1440, or when"
                  + " one has reached a size, such as 256M or 2G; each is playable by itself; 0 ="
                  + " never ({default}).");

  public static final Setting<Integer> RECORD_KEEP =
      ROWS.whole("record-keep", "N", 0, 10000, 0)
          .text(
              "With --record-rotate: keep the last N files of this run and each room, 1..10000;"
                  + " 0 = all ({default}).");

  public static final Setting<Integer> SPECTATOR_DELAY =
      ROWS.whole("spectator-delay", "S", 0, 3600, 0)
          .text(
              "Show every game to spectators (carom-client --watch) S seconds late, 1..3600; 0"
                  + " = don't ({default}).");

  static {
    ROWS.addAll(NetworkConditions.ROWS);
  }

  public static final Setting<Boolean> QUERY =
      ROWS.toggle("query", true)
          .text("Answer A2S status queries of server lists and local networks (UDP).");

  public static final Setting<Integer> QUERY_PORT =
      ROWS.port("query-port", 27015)
          .text("Port for status queries, {range}, 0 = any free one ({default}).");

  public static final Setting<Boolean> RCON =
      ROWS.toggle("rcon", false)
          .text(
              "Take commands by Source RCON (TCP, not encrypted); the password is in"
                  + " rcon.password of the data folder.");

  public static final Setting<Integer> RCON_PORT =
      ROWS.port("rcon-port", 27015).text("Port for RCON, {range}, 0 = any free one ({default}).");

  public static final Setting<String> RCON_BIND =
      ROWS.text("rcon-bind", "ADDRESS", "127.0.0.1")
          .text("Address of this machine for RCON ({default}).");

  public static final Setting<String> PLAIN_PORT =
      ROWS.text("plain-port", "TCP[:UDP]", null)
          .text(
              "Port for clients with stock KryoNet and Kryo 2.24, not encrypted, and with a second"
                  + " number one for their datagrams; 0 = any free one. Without UDP snapshots go by"
                  + " TCP (none).");

  public static final Setting<Boolean> PLAIN_OPEN =
      ROWS.toggle("plain-open", false)
          .text(
              "Let clients come to --plain-port from outside private networks, too; anybody who"
                  + " sees their packets can read and change them.");

  public static final Setting<String> FLEET =
      ROWS.text("fleet", "DIRECTORY", "none")
          .text(
              "Be one of a fleet of servers, which share their rooms by a directory:"
                  + " etcd:URL[,URL...] or postgresql:URL; see docs/server/FLEET.md ({default}).");

  public static final Setting<Path> FLEET_KEY =
      ROWS.path("fleet-key", "FILE", null)
          .text(
              "The fleet's key, the same on every server of it, by which players know the fleet;"
                  + " made if it isn't there (none).");

  public static final Setting<Path> DIRECTORY_CA =
      ROWS.path("directory-ca", "FILE", null)
          .text(
              "Certificates of the authorities that the directory's own must come from: PEM (those"
                  + " of the JDK).");

  public static final Setting<Path> DIRECTORY_CERT =
      ROWS.path("directory-cert", "FILE", null)
          .text("Certificate that the server shows the directory: PEM (none).");

  public static final Setting<Path> DIRECTORY_KEY =
      ROWS.path("directory-key", "FILE", null)
          .text("That certificate's private key: PEM, PKCS #8 without a password (none).");

  public static final Setting<String> ADVERTISE =
      ROWS.text("advertise", "HOST[:TCP[:UDP]]", null)
          .text(
              "Address by which players and the other servers of the fleet reach this one; without"
                  + " ports, those of the server (that of the pod, or none).");

  public static final Setting<Integer> FLEET_PORT =
      ROWS.port("fleet-port", 54556)
          .text(
              "Port for the other servers of the fleet, {range}, 0 = any free one, or that of the"
                  + " pod's GameServer ({default}).");

  public static final Setting<OnPartition> ON_PARTITION =
      ROWS.choice("on-partition", "stop|keep", OnPartition.STOP)
          .text(
              "What rooms do while the fleet's directory doesn't answer: stand still when the"
                  + " server's lease is over, or go on ({default}).");

  public static final Setting<Durability> DURABILITY =
      ROWS.choice("durability", "none|async|sync", Durability.ASYNC)
          .text(
              "What outlives a server of the fleet: nothing, its rooms but perhaps the last"
                  + " moment, or all that players were told ({default}).");

  public static final Setting<Agones> AGONES =
      ROWS.choice("agones", "on|auto|off", Agones.AUTO)
          .text(
              "Tell the sidecar of Agones how the server is, see docs/server/AGONES.md; auto: if"
                  + " Agones has set AGONES_SDK_HTTP_PORT in the environment ({default}).");

  public static final Setting<Integer> STATUS_INTERVAL =
      ROWS.whole("status-interval", "S", 0, 86400, 60)
          .text("Seconds between status lines in the log, 0 = none ({default}).");

  public static final Setting<Idle> IDLE =
      ROWS.choice("idle", "pause|run", Idle.PAUSE)
          .text(
              "What a room does while nobody plays or watches and nothing is recorded: pause"
                  + " until a player comes, or run on ({default}).");

  public static final Setting<Boolean> DEV =
      ROWS.toggle("dev", false)
          .text(
              "For developers of games: play level files, and games of --games, anew when they"
                  + " change, and let in players whose build of the game differs, with a warning.");

  public static final Setting<Boolean> ALLOW_LIST =
      ROWS.toggle("allow-list", false)
          .text(
              "Let only players in that allow.txt of the data folder names; the command 'allow'"
                  + " adds to it.")
          .live();

  public static final Setting<Path> PASSWORD_FILE =
      ROWS.path("password-file", "FILE", null)
          .text(
              "Demand a password from players and spectators: the first line of this file, at"
                  + " least 12 characters; made with a random one if it isn't there (none).");

  public static final Setting<Path> JOIN_KEY =
      ROWS.path("join-key", "FILE", null)
          .text(
              "Demand join tokens that belong to this public key: Ed25519, PEM (everybody may"
                  + " join).");

  public static final Setting<Integer> TOKEN_USES =
      ROWS.whole("token-uses", "N", 0, 1024, 0)
          .text(
              "Seats that one account may have at a time with join tokens, {range}, 0 = any"
                  + " number ({default}).");

  public static final Setting<Boolean> WEB =
      ROWS.toggle("web", true)
          .text(
              "Show the live page and answer /healthz, /readyz and /metrics (Prometheus) over"
                  + " HTTP; --no-web doesn't.");

  public static final Setting<Integer> WEB_PORT =
      ROWS.port("web-port", 8090).text("Port for HTTP, {range}, 0 = any free one ({default}).");

  public static final Setting<String> WEB_BIND =
      ROWS.text("web-bind", "ADDRESS", "127.0.0.1")
          .text(
              "Address of this machine for HTTP. On a loopback address visitors at this machine"
                  + " may watch, others only with the token in admin.token of the data folder"
                  + " ({default}).");

  public static final Setting<List<String>> WEB_HOST =
      ROWS.texts("web-host", "NAME")
          .text(
              "Name under which browsers may open the page, beside addresses and localhost;"
                  + " give it once for each name.");

  public static final Setting<List<String>> WEB_BEHIND =
      ROWS.texts("web-behind", "NETWORK")
          .text(
              "Address or network of a proxy (127.0.0.1, 10.0.0.0/8) before the page: its"
                  + " visitors come from where X-Forwarded-For says, and watch with the token only;"
                  + " give it once for each.");

  public static final Setting<Integer> PLAY_PORT =
      ROWS.port("play-port", null)
          .text(
              "Port for HTTP and WebSocket at which browsers play (/play) and thin clients of any"
                  + " language (/thin, see docs/protocol/THIN.md), {range}, 0 = any free one"
                  + " (closed).");

  public static final Setting<List<String>> PLAY_HOST =
      ROWS.texts("play-host", "NAME")
          .text(
              "Name under which browsers may reach the play port, beside its addresses and"
                  + " localhost, or whose pages may connect to it, such as game.example.org; give"
                  + " it once for each.");

  public static final Setting<List<String>> PLAY_BEHIND =
      ROWS.texts("play-behind", "NETWORK")
          .text(
              "Address or network of a proxy (127.0.0.1, 10.0.0.0/8) before the play port: its"
                  + " players come from where X-Forwarded-For says; give it once for each.");

  public static final Setting<String> PLAY_ADVERTISE =
      ROWS.text("play-advertise", "HOST:PORT", null)
          .text(
              "Address of the proxy before the play port, at which browsers and thin clients that"
                  + " the other servers of a fleet send here come in (that of --advertise, and none"
                  + " with --play-behind).");

  public static final Setting<Path> TLS_CERT =
      ROWS.path("tls-cert", "FILE", null)
          .text(
              "Encrypt the play port with the certificates in this file: PEM, the server's own"
                  + " first; read again when it changes (not encrypted).");

  public static final Setting<Path> TLS_KEY =
      ROWS.path("tls-key", "FILE", null)
          .text("The certificate's private key: PEM, PKCS #8 without a password (none).");

  public static final Setting<Boolean> CONSOLE =
      ROWS.toggle("console", true)
          .text(
              "Read commands from standard input; 'help' shows them. For a server in the"
                  + " background of a terminal: --no-console.");

  public static final Setting<LogLevel> LOG_LEVEL =
      ROWS.choice("log-level", "L", LogLevel.INFO)
          .text("How much is logged: {choices} ({default}).")
          .live();

  public static final Setting<Integer> LOG_KEEP =
      ROWS.whole("log-keep", "N", 0, 20, 10)
          .text(
              "Older files of 10 MB that the log in the data folder keeps beside the present"
                  + " one, {range}; 0 = log to standard error only ({default}).");

  public static final Setting<Integer> HANDSHAKE_TIMEOUT_MS =
      INNER
          .whole("handshakeTimeoutMs", "MS", 100, 60_000, 5_000)
          .text("Longest time from the opening of a link to a valid Hello.");

  public static final Setting<Integer> LOAD_TIMEOUT_MS =
      INNER
          .whole("loadTimeoutMs", "MS", 100, 600_000, 20_000)
          .text(
              "Longest time from Welcome to Ready. A slow machine on a slow line must be able"
                  + " to receive the level in this time.");

  public static final Setting<Integer> SILENCE_TIMEOUT_MS =
      INNER
          .whole("silenceTimeoutMs", "MS", 500, 60_000, 6_000)
          .text(
              "How long a playing session may stay silent (no datagram, no message) until its link"
                  + " counts as lost. Dropped ticks and pauses of the server itself don't count.");

  public static final Setting<Integer> CATCH_UP_TICKS =
      INNER
          .whole("catchUpTicks", "N", 1, 60, 15)
          .text(
              "Most ticks that a room runs in one burst after a pause. A quarter of a second"
                  + " bridges a pause of the garbage collector or of a busy machine. The room drops"
                  + " and counts older ticks, so that a long pause doesn't cause a longer one.");

  public static final Setting<Integer> ROOM_THREADS =
      INNER
          .whole(
              "roomThreads",
              "N",
              2,
              MAX_ROOMS,
              Math.max(2, Math.min(MAX_ROOMS, Runtime.getRuntime().availableProcessors())))
          .text(
              "Most threads that rooms share: one for each processor, and at least two, so that a"
                  + " game that hangs stops no other room. With as many that hang, the server"
                  + " ends.");

  public static final Setting<Integer> INPUT_WINDOW_TICKS =
      INNER
          .whole("inputWindowTicks", "N", 4, 64, 32)
          .text(
              "How far ahead of the newest consumed tick an input may lie. The server refuses"
                  + " and counts inputs beyond.");

  public static final Setting<Integer> KEEP_ALIVE_RATE =
      INNER
          .whole("keepAliveRate", "HZ", 1, 60, 5)
          .text(
              "Datagrams per second and session while nothing is new. Acknowledgements, the"
                  + " clock and the round trip time depend on them.");

  public static final Setting<Integer> ROSTER_INTERVAL_MS =
      INNER
          .whole("rosterIntervalMs", "MS", 0, 10_000, 250)
          .text("Shortest time between two rosters (names and scores).");

  /** The values of {@code --idle}. */
  public enum Idle {
    /** A room without people stands still. */
    PAUSE,
    /** A room without people runs on. */
    RUN
  }

  /** The values of {@code --room-rule}. */
  public enum RoomRule {
    /** The fullest room. */
    FILL,
    /** The fullest room whose players are about as good. */
    SKILL
  }

  /** The values of {@code --on-partition}. */
  public enum OnPartition {
    /** Rooms stand still while the server can't know that it owns them. */
    STOP,
    /** Rooms go on. */
    KEEP
  }

  /** The values of {@code --durability}. */
  public enum Durability {
    /** Rooms have no followers; they begin anew. */
    NONE,
    /** The follower gets the journal as fast as it can. */
    ASYNC,
    /** Players are told of a tick when the follower has it. */
    SYNC
  }

  /** The values of {@code --agones}. */
  public enum Agones {
    /** There is a sidecar, at its usual port unless the environment has another. */
    ON,
    /** There is a sidecar if the environment has its port. */
    AUTO,
    /** The server tells nobody. */
    OFF
  }

  /** The values of {@code --log-level}, from nothing to everything. */
  public enum LogLevel {
    /** The log is empty. */
    OFF,
    /** The log has failures only. */
    ERROR,
    /** The log has failures and suspicious things. */
    WARN,
    /** The log also has what happens. */
    INFO,
    /** The log also has why things happen. */
    DEBUG,
    /** The log has everything. */
    TRACE
  }

  /** Creates the settings of a {@code carom-server} that is started without any flag. */
  public ServerConfig() {}

  /**
   * Returns the settings of a program that drives a server by hand. It counts on every tick and on
   * equal random numbers, so rooms neither pause nor refuse newcomers, and the seed is 1.
   */
  public static ServerConfig defaults() {
    return new ServerConfig()
        .with(GAME, "arena")
        .with(SEED, 1)
        .with(MAX_LOAD, 0)
        .with(IDLE, Idle.RUN);
  }

  /** Returns the length of one tick, ns, rounded down. Use a tick loop for exact deadlines. */
  public long tickNs() {
    return 1_000_000_000L / get(TICK_RATE);
  }

  /** Returns how long the body of a player whose link was lost waits, ms. */
  public int graceMs() {
    return 1_000 * get(GRACE);
  }

  /** Returns the budget of one session's snapshots, bytes of payload per second. */
  public int bytesPerSecond() {
    return 1_000 / Byte.SIZE * get(BUDGET);
  }

  /** Returns the number of snapshots per second: one a tick if none is set. */
  public int snapshotRateHz() {
    Integer rate = get(SNAPSHOT_RATE);
    return rate == null ? get(TICK_RATE) : rate;
  }
}
