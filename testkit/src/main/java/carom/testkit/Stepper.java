package carom.testkit;

import carom.client.ClientConfig;
import carom.client.InputSource;
import carom.client.bots.Bot;
import carom.client.bots.BotBrain;
import carom.client.link.ConnectionPhase;
import carom.game.Games;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.transport.ClientTransport;
import carom.net.transport.Impairment;
import carom.net.transport.ServerTransport;
import carom.options.NetworkConditions.Preset;
import carom.server.Server;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.MatchLibrary;
import carom.server.metrics.Counter;
import carom.server.room.Room;
import carom.sim.Game;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.phase.Findings;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/**
 * Runs a scenario: it owns one server, any number of clients and the clock, and advances them in
 * slices of 2 ms on the calling thread. In memory nothing sleeps, and two equal runs end in equal
 * {@linkplain #hash hashes}. The same scenario also runs {@linkplain #overSockets over sockets}, in
 * real time.
 *
 * <p>The clients compare each state they decode with the server's. {@link #close} fails if the
 * server counted errors.
 */
public final class Stepper implements AutoCloseable {
  /** Seed of all random numbers. {@code -Dcarom.seed=N} sets another. */
  public static final long SEED = Long.getLong("carom.seed", 42);

  private static final double JOIN_SECONDS = 8;
  private static final long SEED_STRIDE = 1_000; // a client may connect again, with further seeds

  private final Wire wire;
  private final Function<ServerTransport, Server> servers;
  private final List<SimulatedClient> clients = new ArrayList<>();
  private long nowNs;
  private long lookNs;
  private long lookedNs;
  private ServerTransport transport;
  private KeptRooms kept; // null if servers keep nothing
  private Consumer<Server> starts = started -> {};
  private Server server;
  private long hash;
  private int hashedTick = -1;
  private boolean expulsionsExpected;
  private boolean gameFailuresExpected;

  private Stepper(Wire wire, ServerConfig config, Level level, long startNs) {
    this.wire = wire;
    this.nowNs = startNs;
    ServerConfig settings =
        config.with(ServerConfig.STATUS_INTERVAL, 0).with(ServerConfig.GAME, level.gameName());
    servers =
        transport ->
            new Server(
                settings,
                () -> Games.create(level.gameName()),
                level,
                transport,
                this::lookAtServerClock);
    startServer();
  }

  private Stepper(
      Wire wire, ServerConfig config, List<RoomConfig> rooms, MatchLibrary library, long startNs) {
    this.wire = wire;
    this.nowNs = startNs;
    ServerConfig settings = config.with(ServerConfig.STATUS_INTERVAL, 0);
    servers = transport -> new Server(settings, rooms, library, transport, this::lookAtServerClock);
    startServer();
  }

  /** Returns a stepper in memory and virtual time, with these rooms. */
  public static Stepper ofRooms(ServerConfig config, MatchLibrary library, RoomConfig... rooms) {
    return new Stepper(new InProcessWire(), config, List.of(rooms), library, 1_000_000_000L);
  }

  /** Returns a stepper over KryoNet on loopback in real time, with these rooms. */
  public static Stepper ofRoomsOverSockets(
      ServerConfig config, MatchLibrary library, RoomConfig... rooms) {
    return new Stepper(new SocketWire(), config, List.of(rooms), library, System.nanoTime());
  }

  /** Returns a stepper in memory and virtual time, with the default level of a game. */
  public static Stepper of(String game) {
    return of(builtIn(game), ServerConfig.defaults());
  }

  /**
   * Returns a stepper in memory and virtual time for a game of the author's own. It {@linkplain
   * Games#add adds} the game, so clients find it.
   *
   * @param game makes a new instance for each simulation, such as {@code Cars::new}
   * @param level resource {@code levels/LEVEL.json} on the class path, or the name of a file
   */
  public static Stepper of(Supplier<Game> game, String level) {
    Games.add(game);
    try {
      Path file = Path.of(level);
      return of(
          Files.isRegularFile(file) ? Level.load(file) : Level.builtIn(level),
          ServerConfig.defaults());
    } catch (LevelException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /** Returns a stepper in memory and virtual time. */
  public static Stepper of(Level level, ServerConfig config) {
    return new Stepper(new InProcessWire(), config, level, 1_000_000_000L);
  }

  /** Returns a stepper over KryoNet on loopback in real time, with the default level of a game. */
  public static Stepper overSockets(String game) {
    return overSockets(builtIn(game), ServerConfig.defaults());
  }

  /** Returns a stepper over KryoNet on loopback in real time. */
  public static Stepper overSockets(Level level, ServerConfig config) {
    return new Stepper(new SocketWire(), config, level, System.nanoTime());
  }

  private static Level builtIn(String game) {
    try {
      return Level.builtIn(Games.create(game).defaultLevel());
    } catch (Exception e) {
      throw new IllegalStateException("the level of game " + game + " can't be read", e);
    }
  }

  // ---- the server

  private long lookAtServerClock() {
    lookedNs += lookNs;
    return nowNs + lookedNs;
  }

  /**
   * Makes the server's machine slow: by the clock with which the server measures its work, each
   * look at that clock takes so long. Ticks are due by the scenario's time, as before.
   *
   * @param ns 0 for a machine that takes no time
   */
  public void serverTakes(long ns) {
    lookNs = ns;
  }

  /** Starts another server at the same address, after the last one has ended. */
  public void startServer() {
    transport = wire.serve();
    server = servers.apply(transport);
    hashedTick = -1;
    if (kept != null) {
      kept.begin(server);
    }
    starts.accept(server);
    server.tick(nowNs);
  }

  /** Sets who sees each server that starts from now on, before its first tick. */
  public void whenStarted(Consumer<Server> listener) {
    starts = listener;
  }

  /**
   * Makes servers that start from now on keep checkpoints in a folder, one in so many seconds, and
   * go on from those that are there.
   */
  public void keepCheckpoints(Path folder, int seconds) {
    kept = new KeptRooms(folder, 0, seconds);
  }

  /**
   * Ends the server's process without a goodbye or a last checkpoint. What it had written stays, if
   * it {@linkplain #keepCheckpoints keeps checkpoints}.
   */
  public void crashServer() {
    requireHealthy();
    transport.close();
    kept = kept.crash(server);
    server = null;
  }

  /** Stops the server as an operator does. The server says goodbye to all clients. */
  public void stopServer() {
    requireHealthy();
    server.close();
    server = null;
  }

  /** Returns the running server, or null while it is stopped. */
  public Server server() {
    return server;
  }

  /** Returns the server's first room. */
  public Room room() {
    return server.rooms().get(0);
  }

  /** Returns a room of the server by its name. */
  public Room room(String name) {
    return server.rooms().stream().filter(room -> room.name().equals(name)).findFirst().get();
  }

  /** Returns the value of a counter of the server. */
  public long count(Counter counter) {
    return server.count(counter);
  }

  /** Returns the server's quantised state after a tick, or null if that was too long ago. */
  public FrameState frame(int tick) {
    return room().frames().at(tick);
  }

  /** Returns the server's newest quantised state. */
  public FrameState frame() {
    return room().frames().newest();
  }

  /** Returns the server's latest quantised states. */
  public FrameRing frames() {
    return room().frames();
  }

  /** Returns a client's player at the server, or null. */
  public HostPlayer player(SimulatedClient client) {
    return room().simulation().player(client.view().playerId());
  }

  /** Returns a client's body at the server, or null. */
  public HostEntity body(SimulatedClient client) {
    HostPlayer player = player(client);
    return player == null ? null : player.entity();
  }

  /** Declares that this scenario makes the server expel clients. */
  public void expectExpulsions() {
    expulsionsExpected = true;
  }

  /** Declares that the game of this scenario throws exceptions. */
  public void expectGameFailures() {
    gameFailuresExpected = true;
  }

  // ---- clients

  /**
   * Adds a client on a usual network, and runs until it sees its own body.
   *
   * @param player plays: a script, or a {@link Bot}
   */
  public SimulatedClient join(String name, Preset network, InputSource player) {
    return join(name, network.impairment().withSeed(SEED), player);
  }

  /** Adds a client on a usual network that a game's bot plays, and runs until it sees its body. */
  public SimulatedClient join(String name, Preset network, BotBrain brain) {
    return join(name, network, new Bot(SEED + clients.size(), brain));
  }

  /** Adds a client that begins to connect with the next slice. */
  public SimulatedClient add(String name, Impairment impairment, InputSource script) {
    return add(
        ClientConfig.of(name).withServer("localhost", wire.tcpPort(), wire.udpPort()),
        impairment,
        script);
  }

  /** Adds a client with the given settings. Their address must be this server's. */
  public SimulatedClient add(ClientConfig settings, Impairment impairment, InputSource script) {
    SimulatedClient client =
        new SimulatedClient(
            settings,
            wire.client(),
            impairment.withSeed(impairment.seed() + SEED_STRIDE * clients.size()),
            script,
            () -> nowNs);
    clients.add(client);
    return client;
  }

  /** Adds a client and runs until it sees its own body. */
  public SimulatedClient join(String name, Impairment impairment, InputSource script) {
    SimulatedClient client = add(name, impairment, script);
    awaitPlaying(client);
    return client;
  }

  /** Adds idle clients on a clean network, and runs until all see their bodies. */
  public List<SimulatedClient> join(int count) {
    List<SimulatedClient> joined = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      joined.add(add("player" + clients.size(), Impairment.NONE, InputSource.IDLE));
    }
    joined.forEach(this::awaitPlaying);
    return joined;
  }

  /** Runs until a client plays and sees its own body. */
  public void awaitPlaying(SimulatedClient client) {
    runUntil(
        client.name() + " plays",
        () ->
            client.view().phase() == ConnectionPhase.PLAYING
                && client.view().own() != null
                && !client.view().players().isEmpty(),
        JOIN_SECONDS);
  }

  /** Forgets a client that has left or died. */
  public void remove(SimulatedClient client) {
    clients.remove(client);
  }

  /** Returns all clients in the order in which they were added. */
  public List<SimulatedClient> clients() {
    return clients;
  }

  /** Returns the clients' side of the network, for peers that aren't clients. */
  public ClientTransport transport() {
    return wire.client();
  }

  /** Returns the TCP port of the server; 0 in memory. */
  public int tcpPort() {
    return wire.tcpPort();
  }

  /** Returns the UDP port of the server; 0 in memory. */
  public int udpPort() {
    return wire.udpPort();
  }

  /**
   * Kills a client's line for some time: nothing gets through in either direction, reliable
   * messages wait, and new links connect when the line is back.
   */
  public void blackout(SimulatedClient client, double seconds) {
    client.blackout(nowNs + (long) (seconds * 1e9));
  }

  // ---- time

  /** Returns the present time, ns. */
  public long nowNs() {
    return nowNs;
  }

  /** Advances time by one slice: the server first, then each client in order. */
  public void step() {
    step(1);
  }

  /** Advances time by several slices at once, for scenarios that needn't be so fine. */
  public void step(int slices) {
    for (int i = 0; i < slices; i++) {
      nowNs = wire.advance(nowNs);
    }
    stepServer();
    stepClients();
  }

  /** Advances time by one slice for the server only. {@link #stepClients} must follow. */
  public void stepTimeAndServer() {
    nowNs = wire.advance(nowNs);
    stepServer();
  }

  private void stepServer() {
    if (server != null) {
      server.tick(nowNs);
      FrameState frame = frame();
      if (frame.tick() != hashedTick) {
        hashedTick = frame.tick();
        hash = (hash ^ frame.hash()) * 0x9e3779b97f4a7c15L;
      }
    }
  }

  /** Advances the clients to the present time. */
  public void stepClients() {
    for (int i = 0; i < clients.size(); i++) {
      clients.get(i).update(nowNs, server == null ? null : server.rooms());
    }
  }

  /** Runs for a number of seconds. */
  public void run(double seconds) {
    long endNs = nowNs + (long) (seconds * 1e9);
    while (nowNs - endNs < 0) {
      step();
    }
  }

  /** Runs the clients for a number of seconds while the server's process stands still. */
  public void stallServer(double seconds) {
    long endNs = nowNs + (long) (seconds * 1e9);
    while (nowNs - endNs < 0) {
      nowNs = wire.advance(nowNs);
      stepClients();
    }
  }

  /** Runs until a condition holds, and fails when that takes too long. */
  public void runUntil(String what, BooleanSupplier condition, double maxSeconds) {
    long endNs = nowNs + (long) (maxSeconds * 1e9);
    while (!condition.getAsBoolean()) {
      if (nowNs - endNs >= 0) {
        throw new AssertionError("not within " + maxSeconds + " s: " + what + "; " + describe());
      }
      step();
    }
  }

  // ---- verdicts

  /** Returns a hash of all frames of this server so far. Equal runs in memory have equal hashes. */
  public long hash() {
    return hash;
  }

  /** Returns the number of states of all clients that were compared with the server's. */
  public long compared() {
    return clients.stream().mapToLong(SimulatedClient::compared).sum();
  }

  /** Returns what the first room's game does although no client can predict it; empty = nothing. */
  public List<String> findings() {
    Findings found = room().simulation().findings();
    return IntStream.range(0, found.count()).mapToObj(found::get).toList();
  }

  /** Requires that every client has the server's newest state. Holds in a world at rest. */
  public void requireAllSame() {
    for (SimulatedClient client : clients) {
      client.requireSame(frame());
    }
  }

  /** Returns the seed, the server's status and the clients, for messages. */
  public String describe() {
    return "seed="
        + SEED
        + " server="
        + (server == null ? "stopped" : server.status())
        + " clients="
        + clients;
  }

  private void requireHealthy() {
    requireZero(Counter.SESSIONS_FAILED);
    if (!gameFailuresExpected) {
      requireZero(Counter.GAME_FAILURES);
    }
    if (!expulsionsExpected) {
      requireZero(Counter.SESSIONS_EXPELLED);
    }
  }

  private void requireZero(Counter counter) {
    if (count(counter) != 0) {
      throw new AssertionError(counter + "=" + count(counter) + "; " + describe());
    }
  }

  /** Stops the server, checks its counters and closes the network. */
  @Override
  public void close() {
    try {
      if (server != null) {
        stopServer();
      }
    } finally {
      wire.close();
    }
  }
}
