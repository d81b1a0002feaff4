package carom.server.config;

import carom.net.protocol.ProtocolLimits;
import carom.physics.threads.WorkerThreads;
import carom.sim.message.BuiltInKinds;
import carom.values.Records;
import java.util.Locale;
import java.util.Objects;

/**
 * The settings of a server. Immutable; start from {@link #defaults()}. The constructor refuses a
 * value outside its range with a message that names the setting, the value, the limits and where to
 * set it.
 *
 * @param gameName name of the game to run, one of those of {@code carom.game.Games}
 * @param serverName what players and log lines call this server, 1..40 characters
 * @param tickRateHz simulation steps per second, 10..240. 60 fits most games. Each session costs
 *     one datagram per tick in both directions
 * @param seed seed of the first room's random numbers; each further room's is one higher. The same
 *     seed and the same inputs give the same game
 * @param rooms number of rooms, 1..64. Each has its own world, players and thread
 * @param threads number of threads that may step one world together, 1..64: the room's own and
 *     helpers that all rooms share. 1 means no helpers. Helpers pay off in worlds of a thousand
 *     bodies and more, and change no result
 * @param maxPlayers seats of each room, 1..1,024 because the protocol numbers players in 10 bits;
 *     at most 4,096 in all rooms together. The lobby refuses a player when all rooms are full
 * @param handshakeTimeoutMs longest time from the opening of a link to a valid Hello, 100..60,000
 * @param loadTimeoutMs longest time from Welcome to Ready, 100..600,000. A slow machine on a slow
 *     line must be able to receive the level in this time
 * @param silenceTimeoutMs how long a playing session may stay silent (no datagram, no message)
 *     until its link counts as lost, 500..60,000. Dropped ticks and pauses of the server itself
 *     don't count
 * @param graceMs how long the body of a player whose link was lost stays in the game, 0..600,000; 0
 *     removes it at once
 * @param idleKickS time without another input after which a player gives way to a newcomer of a
 *     full room, s, 0..86,400; 0 = never
 * @param networkSharePercent share of a full room's seats that the players of one network (IPv4
 *     /24, IPv6 /64) keep when others want to play, percent, 1..100, but at least two seats
 * @param maxLoadPercent time that 95 of 100 ticks of a room may take, percent of their period, up
 *     to which it lets newcomers in, 0..300; 0 = whatever they take
 * @param catchUpTicks most ticks that a room runs in one burst after a pause, 1..60. A quarter of a
 *     second bridges a pause of the garbage collector or of a busy machine. The room drops and
 *     counts older ticks, so that a long pause doesn't cause a longer one
 * @param inputWindowTicks how far ahead of the newest consumed tick an input may lie, 4..64. The
 *     server refuses and counts inputs beyond
 * @param inputHoldTicks number of ticks for which the server repeats the last input when none
 *     arrives, 0..240. Then the input is neutral
 * @param snapshotRateHz snapshots per second and session while something moves, 1..240, at most one
 *     per tick
 * @param keepAliveRateHz datagrams per second and session while nothing is new, 1..60. Acks, the
 *     clock and the round trip time depend on them
 * @param snapshotBitsPerSecond budget of one session's snapshots, bits of payload per second,
 *     16,000..80,000,000. Entities that don't fit wait and collect priority
 * @param viewMetres largest half width and half height of a player's view, m, 0..4,096. In levels
 *     that are no larger the player sees everything. 0 = 64, and everything in small worlds. A room
 *     that is too busy tells players only of what they show
 * @param rosterIntervalMs shortest time between two rosters (names and scores), ms, 0..10,000
 * @param statusIntervalS time between two status lines in the log, s, 0..86,400; 0 = none
 * @param pausesIdleRooms whether a room without players, spectators and recording stops ticking. It
 *     goes on where it stopped as soon as a player comes
 * @param takesAnyCode whether players whose build of a game differs may play, with a warning; for
 *     developers
 * @param welcome what the server says to each player who joins, 0..120 characters; empty for
 *     nothing
 */
public record ServerConfig(
    String gameName,
    String serverName,
    int tickRateHz,
    long seed,
    int rooms,
    int threads,
    int maxPlayers,
    int handshakeTimeoutMs,
    int loadTimeoutMs,
    int silenceTimeoutMs,
    int graceMs,
    int idleKickS,
    int networkSharePercent,
    int maxLoadPercent,
    int catchUpTicks,
    int inputWindowTicks,
    int inputHoldTicks,
    int snapshotRateHz,
    int keepAliveRateHz,
    int snapshotBitsPerSecond,
    int viewMetres,
    int rosterIntervalMs,
    int statusIntervalS,
    boolean pausesIdleRooms,
    boolean takesAnyCode,
    String welcome) {

  private static final int MAX_SERVER_NAME = 40;

  /** Largest load up to which rooms can let newcomers in, percent. */
  public static final int MAX_LOAD_PERCENT = 300;

  /** Smallest snapshot budget of a player, bits of payload per second. */
  public static final int MIN_BUDGET = 16_000;

  /** Largest snapshot budget of a player, bits of payload per second. */
  public static final int MAX_BUDGET = 80_000_000;

  /** Largest number of rooms. */
  public static final int MAX_ROOMS = 64;

  /** Largest number of seats in all rooms together. */
  public static final int MAX_PLACES = 4_096;

  /**
   * Checks every setting.
   *
   * @throws IllegalArgumentException if a setting is out of range; the message names the first
   */
  public ServerConfig {
    Objects.requireNonNull(gameName, "gameName");
    Objects.requireNonNull(serverName, "serverName");
    if (gameName.isBlank()) {
      throw new IllegalArgumentException("gameName is blank; set the name of a game with --game");
    }
    if (serverName.isBlank() || serverName.length() > MAX_SERVER_NAME) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "serverName=\"%s\" has %d characters, allowed are 1..%d; set it with --name",
              serverName,
              serverName.strip().length(),
              MAX_SERVER_NAME));
    }
    check("tickRateHz", tickRateHz, 10, 240, "--tick-rate");
    check("rooms", rooms, 1, MAX_ROOMS, "--rooms");
    check("threads", threads, 1, WorkerThreads.MAX_COUNT, "--threads");
    check("maxPlayers", maxPlayers, 1, ProtocolLimits.MAX_PLAYERS, "--max-players");
    if (rooms * maxPlayers > MAX_PLACES) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "rooms=%d with maxPlayers=%d each are %d places, a server has at most %d; %s",
              rooms,
              maxPlayers,
              rooms * maxPlayers,
              MAX_PLACES,
              "lower --rooms or --max-players"));
    }
    check("handshakeTimeoutMs", handshakeTimeoutMs, 100, 60_000, "withHandshakeTimeoutMs");
    check("loadTimeoutMs", loadTimeoutMs, 100, 600_000, "withLoadTimeoutMs");
    check("silenceTimeoutMs", silenceTimeoutMs, 500, 60_000, "withSilenceTimeoutMs");
    check("graceMs", graceMs, 0, 600_000, "--grace");
    check("idleKickS", idleKickS, 0, 86_400, "--idle-kick");
    check("networkSharePercent", networkSharePercent, 1, 100, "--network-share");
    check("maxLoadPercent", maxLoadPercent, 0, MAX_LOAD_PERCENT, "--max-load");
    check("catchUpTicks", catchUpTicks, 1, 60, "withCatchUpTicks");
    check("inputWindowTicks", inputWindowTicks, 4, 64, "withInputWindowTicks");
    check("inputHoldTicks", inputHoldTicks, 0, 240, "withInputHoldTicks");
    check("snapshotRateHz", snapshotRateHz, 1, 240, "--snapshot-rate");
    check("keepAliveRateHz", keepAliveRateHz, 1, 60, "withKeepAliveRateHz");
    check("snapshotBitsPerSecond", snapshotBitsPerSecond, MIN_BUDGET, MAX_BUDGET, "--budget");
    check("viewMetres", viewMetres, 0, 4_096, "--view");
    check("rosterIntervalMs", rosterIntervalMs, 0, 10_000, "withRosterIntervalMs");
    check("statusIntervalS", statusIntervalS, 0, 86_400, "--status-interval");
    check("welcome's length", welcome.length(), 0, BuiltInKinds.MAX_CHAT, "--welcome");
  }

  private static void check(String name, int value, int min, int max, String where) {
    if (value < min || value > max) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "%s=%d is outside %d..%d; set it with %s",
              name,
              value,
              min,
              max,
              where));
    }
  }

  /**
   * Returns the settings of a server that is started without any flag. Only {@code carom-server}
   * sets {@code pausesIdleRooms} and {@code maxLoadPercent}, because a program that drives a server
   * by hand counts on its ticks.
   */
  public static ServerConfig defaults() {
    return new ServerConfig(
        /* gameName= */ "arena",
        /* serverName= */ "Carom",
        /* tickRateHz= */ 60,
        /* seed= */ 1,
        /* rooms= */ 1,
        /* threads= */ 1,
        /* maxPlayers= */ 64,
        /* handshakeTimeoutMs= */ 5_000,
        /* loadTimeoutMs= */ 20_000,
        /* silenceTimeoutMs= */ 6_000,
        /* graceMs= */ 30_000,
        /* idleKickS= */ 60,
        /* networkSharePercent= */ 6,
        /* maxLoadPercent= */ 0,
        /* catchUpTicks= */ 15,
        /* inputWindowTicks= */ 32,
        /* inputHoldTicks= */ 30,
        /* snapshotRateHz= */ 60,
        /* keepAliveRateHz= */ 5,
        /* snapshotBitsPerSecond= */ 512_000,
        /* viewMetres= */ 0,
        /* rosterIntervalMs= */ 250,
        /* statusIntervalS= */ 60,
        /* pausesIdleRooms= */ false,
        /* takesAnyCode= */ false,
        /* welcome= */ "");
  }

  /** Returns the length of one tick, ns, rounded down. Use a tick loop for exact deadlines. */
  public long tickNs() {
    return 1_000_000_000L / tickRateHz;
  }

  /** Returns a copy that runs the game of this name. */
  public ServerConfig withGameName(String value) {
    return Records.with(this, "gameName", value);
  }

  /** Returns a copy with this server name. */
  public ServerConfig withServerName(String value) {
    return Records.with(this, "serverName", value);
  }

  /** Returns a copy with this many ticks per second. */
  public ServerConfig withTickRateHz(int value) {
    return Records.with(this, "tickRateHz", value);
  }

  /** Returns a copy with this seed. */
  public ServerConfig withSeed(long value) {
    return Records.with(this, "seed", value);
  }

  /** Returns a copy with this many rooms. */
  public ServerConfig withRooms(int value) {
    return Records.with(this, "rooms", value);
  }

  /** Returns a copy in which this many threads may step one world together. */
  public ServerConfig withThreads(int value) {
    return Records.with(this, "threads", value);
  }

  /** Returns a copy with this many seats in each room. */
  public ServerConfig withMaxPlayers(int value) {
    return Records.with(this, "maxPlayers", value);
  }

  /** Returns a copy with this handshake deadline. */
  public ServerConfig withHandshakeTimeoutMs(int value) {
    return Records.with(this, "handshakeTimeoutMs", value);
  }

  /** Returns a copy with this share of a full room's seats for one network, percent. */
  public ServerConfig withNetworkSharePercent(int value) {
    return Records.with(this, "networkSharePercent", value);
  }

  /** Returns a copy with this loading deadline. */
  public ServerConfig withLoadTimeoutMs(int value) {
    return Records.with(this, "loadTimeoutMs", value);
  }

  /** Returns a copy with this silence timeout. */
  public ServerConfig withSilenceTimeoutMs(int value) {
    return Records.with(this, "silenceTimeoutMs", value);
  }

  /** Returns a copy with this grace period. */
  public ServerConfig withGraceMs(int value) {
    return Records.with(this, "graceMs", value);
  }

  /** Returns a copy with this time after which an idle player gives way. */
  public ServerConfig withIdleKickS(int value) {
    return Records.with(this, "idleKickS", value);
  }

  /** Returns a copy with this load up to which rooms let newcomers in, percent. */
  public ServerConfig withMaxLoadPercent(int value) {
    return Records.with(this, "maxLoadPercent", value);
  }

  /** Returns a copy with this catch-up bound. */
  public ServerConfig withCatchUpTicks(int value) {
    return Records.with(this, "catchUpTicks", value);
  }

  /** Returns a copy with this input window. */
  public ServerConfig withInputWindowTicks(int value) {
    return Records.with(this, "inputWindowTicks", value);
  }

  /** Returns a copy with this input hold. */
  public ServerConfig withInputHoldTicks(int value) {
    return Records.with(this, "inputHoldTicks", value);
  }

  /** Returns a copy with this snapshot rate. */
  public ServerConfig withSnapshotRateHz(int value) {
    return Records.with(this, "snapshotRateHz", value);
  }

  /** Returns a copy with this keep-alive rate. */
  public ServerConfig withKeepAliveRateHz(int value) {
    return Records.with(this, "keepAliveRateHz", value);
  }

  /** Returns a copy with this snapshot budget. */
  public ServerConfig withSnapshotBitsPerSecond(int value) {
    return Records.with(this, "snapshotBitsPerSecond", value);
  }

  /** Returns a copy with this largest view. */
  public ServerConfig withViewMetres(int value) {
    return Records.with(this, "viewMetres", value);
  }

  /** Returns a copy with this roster interval. */
  public ServerConfig withRosterIntervalMs(int value) {
    return Records.with(this, "rosterIntervalMs", value);
  }

  /** Returns a copy with this status interval. */
  public ServerConfig withStatusIntervalS(int value) {
    return Records.with(this, "statusIntervalS", value);
  }

  /** Returns a copy whose rooms pause while they are idle, or don't. */
  public ServerConfig withPausesIdleRooms(boolean value) {
    return Records.with(this, "pausesIdleRooms", value);
  }

  /** Returns a copy in which the server says this to each player who joins. */
  public ServerConfig withWelcome(String value) {
    return Records.with(this, "welcome", value);
  }

  /**
   * Returns a copy with the values that may change while a server runs taken from other settings.
   */
  public ServerConfig withLiveValuesOf(ServerConfig other) {
    return withServerName(other.serverName)
        .withMaxPlayers(other.maxPlayers)
        .withMaxLoadPercent(other.maxLoadPercent)
        .withSnapshotRateHz(other.snapshotRateHz)
        .withSnapshotBitsPerSecond(other.snapshotBitsPerSecond)
        .withWelcome(other.welcome);
  }

  /** Returns a copy in which players with another build of a game may play, or not. */
  public ServerConfig withTakesAnyCode(boolean value) {
    return Records.with(this, "takesAnyCode", value);
  }
}
