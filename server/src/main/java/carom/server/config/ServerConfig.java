package carom.server.config;

import carom.net.protocol.Limits;
import carom.physics.threads.WorkerThreads;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * Every setting of a server. Immutable; a value outside its range is refused when the record is
 * built, with a message that names the setting, the value, the limits and where to set it.
 *
 * <p>Start from {@link #defaults()} and change single settings with the {@code with...} methods.
 *
 * @param gameName name of the game to run; the names are those of {@code carom.game.Games}
 * @param serverName what players and log lines call this server, 1..40 characters
 * @param tickRateHz simulation steps per second, 10..240. 60 fits most games; each session costs
 *     one datagram per tick in both directions
 * @param seed start of the first room's random numbers, each further room's is one higher; the same
 *     seed and the same inputs give the same game
 * @param rooms how many rooms play at once, 1..64: each is a world, a set of players and a thread
 *     of its own, all with the same game and level
 * @param threads how many threads may step one world together, 1..64: the room's own, and helpers
 *     that all rooms share. 1 has no helpers. They pay for worlds of a thousand bodies and more,
 *     and change no result
 * @param maxPlayers seats of each room, 1..1,024 (the protocol numbers players in 10 bits); whoever
 *     finds all rooms full is refused politely. All rooms together have at most 4,096 seats
 * @param handshakeTimeoutMs how long a link may take from its opening to a valid Hello, and how
 *     long a refused one may linger until its refusal is delivered, 100..60,000
 * @param loadTimeoutMs how long a player may take from Welcome to Ready, 100..600,000: a slow
 *     machine on a slow line pulls the level in this time
 * @param silenceTimeoutMs how long a playing session may stay silent (no datagram, no message)
 *     until its link counts as lost, 500..60,000; time for which the server itself stood still, and
 *     dropped ticks, doesn't count
 * @param graceMs how long the body of a lost player waits for its owner, 0..600,000; 0 removes it
 *     at once
 * @param catchUpTicks ticks that may be made good in one burst after a pause, 1..60; a quarter of a
 *     second at 60 Hz bridges a collector's pause or a busy machine's hiccup. What lies further
 *     behind is dropped and counted, so that a long pause can't snowball
 * @param inputWindowTicks how far ahead of the newest consumed tick an input may lie, 4..64; inputs
 *     beyond are refused and counted
 * @param inputHoldTicks how long the last input is repeated when none arrives, 0..240, until the
 *     player counts as neutral (half a second at 60 Hz)
 * @param snapshotRateHz snapshots per second and session while something moves, 1..240, at most one
 *     per tick
 * @param keepAliveRateHz datagrams per second and session while nothing is new, 1..60: acks, clock
 *     and RTT live on them
 * @param snapshotBitsPerSecond budget of one session's snapshots, bits of payload, 16,000 to
 *     80,000,000; what does not fit waits and collects priority
 * @param viewMetres largest half width and half height of what a player is told about, 0..4,096; in
 *     levels that are no larger everything is in sight. 0 = 64, and everything in small worlds
 * @param rosterIntervalMs shortest time between two rosters (names and scores), 0..10,000
 * @param statusIntervalS seconds between two status lines in the log, 0..86,400; 0 = none
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
    int catchUpTicks,
    int inputWindowTicks,
    int inputHoldTicks,
    int snapshotRateHz,
    int keepAliveRateHz,
    int snapshotBitsPerSecond,
    int viewMetres,
    int rosterIntervalMs,
    int statusIntervalS) {

  private static final int MAX_SERVER_NAME = 40;
  private static final int MAX_PLACES = 4_096;

  /** Checks every setting; throws {@link IllegalArgumentException} for the first bad one. */
  public ServerConfig {
    Objects.requireNonNull(gameName, "gameName");
    Objects.requireNonNull(serverName, "serverName");
    if (gameName.isBlank()) {
      throw new IllegalArgumentException("gameName is blank; set the name of a game with --game");
    }
    if (serverName.isBlank() || serverName.length() > MAX_SERVER_NAME) {
      throw new IllegalArgumentException(
          "serverName=\"%s\" has %d characters, allowed are 1..%d; set it with --name"
              .formatted(serverName, serverName.strip().length(), MAX_SERVER_NAME));
    }
    check("tickRateHz", tickRateHz, 10, 240, "--tick-rate");
    check("rooms", rooms, 1, 64, "--rooms");
    check("threads", threads, 1, WorkerThreads.MAX_COUNT, "--threads");
    check("maxPlayers", maxPlayers, 1, Limits.MAX_PLAYERS, "--max-players");
    if (rooms * maxPlayers > MAX_PLACES) {
      throw new IllegalArgumentException(
          "rooms=%d with maxPlayers=%d each are %d places, a server has at most %d; %s"
              .formatted(
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
    check("catchUpTicks", catchUpTicks, 1, 60, "withCatchUpTicks");
    check("inputWindowTicks", inputWindowTicks, 4, 64, "withInputWindowTicks");
    check("inputHoldTicks", inputHoldTicks, 0, 240, "withInputHoldTicks");
    check("snapshotRateHz", snapshotRateHz, 1, 240, "--snapshot-rate");
    check("keepAliveRateHz", keepAliveRateHz, 1, 60, "withKeepAliveRateHz");
    check("snapshotBitsPerSecond", snapshotBitsPerSecond, 16_000, 80_000_000, "--budget");
    check("viewMetres", viewMetres, 0, 4_096, "--view");
    check("rosterIntervalMs", rosterIntervalMs, 0, 10_000, "withRosterIntervalMs");
    check("statusIntervalS", statusIntervalS, 0, 86_400, "--status-interval");
  }

  private static void check(String name, int value, int min, int max, String where) {
    if (value < min || value > max) {
      throw new IllegalArgumentException(
          "%s=%d is outside %d..%d; set it with %s".formatted(name, value, min, max, where));
    }
  }

  /** The settings of a server that is started without any flag. */
  public static ServerConfig defaults() {
    return new ServerConfig(
        "arena", "Carom", 60, 1, 1, 1, 64, 5_000, 20_000, 6_000, 30_000, 15, 32, 30, 60, 6, 512_000,
        0, 250, 60);
  }

  /** Nanoseconds of one tick, rounded down; use a tick loop for exact deadlines. */
  public long tickNs() {
    return 1_000_000_000L / tickRateHz;
  }

  /** Places of all rooms together. */
  public int places() {
    return rooms * maxPlayers;
  }

  /** A copy that runs the game of this name. */
  public ServerConfig withGameName(String value) {
    return with(draft -> draft.gameName = value);
  }

  /** A copy with this server name. */
  public ServerConfig withServerName(String value) {
    return with(draft -> draft.serverName = value);
  }

  /** A copy with this many ticks per second. */
  public ServerConfig withTickRateHz(int value) {
    return with(draft -> draft.tickRateHz = value);
  }

  /** A copy with this seed. */
  public ServerConfig withSeed(long value) {
    return with(draft -> draft.seed = value);
  }

  /** A copy with this many rooms. */
  public ServerConfig withRooms(int value) {
    return with(draft -> draft.rooms = value);
  }

  /** A copy in which this many threads may step one world together. */
  public ServerConfig withThreads(int value) {
    return with(draft -> draft.threads = value);
  }

  /** A copy with this many seats in each room. */
  public ServerConfig withMaxPlayers(int value) {
    return with(draft -> draft.maxPlayers = value);
  }

  /** A copy with this handshake deadline. */
  public ServerConfig withHandshakeTimeoutMs(int value) {
    return with(draft -> draft.handshakeTimeoutMs = value);
  }

  /** A copy with this loading deadline. */
  public ServerConfig withLoadTimeoutMs(int value) {
    return with(draft -> draft.loadTimeoutMs = value);
  }

  /** A copy with this silence timeout. */
  public ServerConfig withSilenceTimeoutMs(int value) {
    return with(draft -> draft.silenceTimeoutMs = value);
  }

  /** A copy with this grace period. */
  public ServerConfig withGraceMs(int value) {
    return with(draft -> draft.graceMs = value);
  }

  /** A copy with this catch-up bound. */
  public ServerConfig withCatchUpTicks(int value) {
    return with(draft -> draft.catchUpTicks = value);
  }

  /** A copy with this input window. */
  public ServerConfig withInputWindowTicks(int value) {
    return with(draft -> draft.inputWindowTicks = value);
  }

  /** A copy with this input hold. */
  public ServerConfig withInputHoldTicks(int value) {
    return with(draft -> draft.inputHoldTicks = value);
  }

  /** A copy with this snapshot rate. */
  public ServerConfig withSnapshotRateHz(int value) {
    return with(draft -> draft.snapshotRateHz = value);
  }

  /** A copy with this keep-alive rate. */
  public ServerConfig withKeepAliveRateHz(int value) {
    return with(draft -> draft.keepAliveRateHz = value);
  }

  /** A copy with this snapshot budget. */
  public ServerConfig withSnapshotBitsPerSecond(int value) {
    return with(draft -> draft.snapshotBitsPerSecond = value);
  }

  /** A copy with this largest view. */
  public ServerConfig withViewMetres(int value) {
    return with(draft -> draft.viewMetres = value);
  }

  /** A copy with this roster interval. */
  public ServerConfig withRosterIntervalMs(int value) {
    return with(draft -> draft.rosterIntervalMs = value);
  }

  /** A copy with this status interval. */
  public ServerConfig withStatusIntervalS(int value) {
    return with(draft -> draft.statusIntervalS = value);
  }

  private ServerConfig with(Consumer<Draft> change) {
    Draft draft = new Draft(this);
    change.accept(draft);
    return draft.build();
  }

  /** The settings as variables, so that each {@code with...} method names just its own. */
  private static final class Draft {
    private String gameName;
    private String serverName;
    private int tickRateHz;
    private long seed;
    private int rooms;
    private int threads;
    private int maxPlayers;
    private int handshakeTimeoutMs;
    private int loadTimeoutMs;
    private int silenceTimeoutMs;
    private int graceMs;
    private int catchUpTicks;
    private int inputWindowTicks;
    private int inputHoldTicks;
    private int snapshotRateHz;
    private int keepAliveRateHz;
    private int snapshotBitsPerSecond;
    private int viewMetres;
    private int rosterIntervalMs;
    private int statusIntervalS;

    Draft(ServerConfig from) {
      gameName = from.gameName;
      serverName = from.serverName;
      tickRateHz = from.tickRateHz;
      seed = from.seed;
      rooms = from.rooms;
      threads = from.threads;
      maxPlayers = from.maxPlayers;
      handshakeTimeoutMs = from.handshakeTimeoutMs;
      loadTimeoutMs = from.loadTimeoutMs;
      silenceTimeoutMs = from.silenceTimeoutMs;
      graceMs = from.graceMs;
      catchUpTicks = from.catchUpTicks;
      inputWindowTicks = from.inputWindowTicks;
      inputHoldTicks = from.inputHoldTicks;
      snapshotRateHz = from.snapshotRateHz;
      keepAliveRateHz = from.keepAliveRateHz;
      snapshotBitsPerSecond = from.snapshotBitsPerSecond;
      viewMetres = from.viewMetres;
      rosterIntervalMs = from.rosterIntervalMs;
      statusIntervalS = from.statusIntervalS;
    }

    ServerConfig build() {
      return new ServerConfig(
          gameName,
          serverName,
          tickRateHz,
          seed,
          rooms,
          threads,
          maxPlayers,
          handshakeTimeoutMs,
          loadTimeoutMs,
          silenceTimeoutMs,
          graceMs,
          catchUpTicks,
          inputWindowTicks,
          inputHoldTicks,
          snapshotRateHz,
          keepAliveRateHz,
          snapshotBitsPerSecond,
          viewMetres,
          rosterIntervalMs,
          statusIntervalS);
    }
  }
}
