package carom.lab.soak;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.net.transport.Impairment;
import carom.physics.Body;
import carom.server.Server;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.MatchLibrary;
import carom.server.metrics.Counter;
import carom.server.room.Room;
import carom.server.session.LoadedLevel;
import carom.sim.Game;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.level.LevelException;
import carom.sim.message.Emote;
import carom.testkit.Folders;
import carom.testkit.Stepper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * One soak. It lets a server and its clients live through a script of incidents, and checks after
 * every tick what must always hold:
 *
 * <ul>
 *   <li>each state that a client decodes, if clients decode, equals the server's of that tick;
 *   <li>what a client shows is there, and what is there it shows, see {@link EntityWatch};
 *   <li>all bodies have finite poses and velocities, and all that a checkpoint holds is in range;
 *   <li>no more seats are taken than a room has, and the server counts no error;
 *   <li>every queue is within its bound, see {@link QueueBounds};
 *   <li>a server that starts after another one goes on from a state that was, with the players who
 *       had seats then, see {@link ProvenStates}; players come back to them, see {@link Comebacks};
 *   <li>no player has seats in two rooms;
 *   <li>a recording of each server's life replays to the same hashes.
 * </ul>
 *
 * <p>All of it is in memory and virtual time, but for recordings and checkpoints: equal settings
 * and incidents give equal soaks.
 */
final class Soak {
  /**
   * The settings of a soak.
   *
   * @param seconds length, s of virtual time
   * @param clients largest number of clients at a time
   * @param play what clients do
   * @param folder for recordings and checkpoints
   * @param records whether what happens is recorded and computed again
   */
  record Settings(
      long seed, double seconds, int clients, Play play, Path folder, boolean records) {}

  /** The work that the clients of a soak do, from the most to the least. */
  enum Play {
    /** Clients predict. */
    PREDICTING,
    /** Clients decode snapshots and interpolate. */
    INTERPOLATING,
    /** Clients send inputs and acknowledge snapshots, but don't decode them. */
    INPUT_ONLY
  }

  /** Datagrams that aren't lost are read every 2 ms, or once a tick where nothing is predicted. */
  private static final int COARSE_SLICES = 8;

  /** Of input-only clients, one in so many has the server send it a predicted set. */
  private static final int PREDICTED = 4;

  /** Seats of each room, fewer than clients: some are refused. */
  static final int SEATS = 12;

  private static final int CHECKPOINT_S = 20;

  /** Time between two looks at all queues, ns; longer where nothing else takes time. */
  private static final long LOOK_NS = 1_000_000_000L;

  private static final int RARE_LOOKS = 10;

  /** Time after which a server that has begun has its first ticks behind it, ns. */
  private static final long SETTLED_NS = 100_000_000L;

  /**
   * The failures that no server of a soak counts. A checkpoint fails where any number of the whole
   * state isn't finite or in its range.
   */
  private static final List<Counter> FAILURES =
      List.of(
          Counter.SESSIONS_FAILED,
          Counter.GAME_FAILURES,
          Counter.CHECKPOINTS_FAILED,
          Counter.CALLBACKS_ABANDONED);

  private static final LoadedLevel WORKSHOP = new LoadedLevel(Workshop.level());

  /** The installed games and levels, and one of joints. */
  private static final MatchLibrary LIBRARY =
      new MatchLibrary() {
        @Override
        public Game game(String name) {
          return INSTALLED.game(name);
        }

        @Override
        public LoadedLevel level(String name) throws LevelException {
          return name.equals(WORKSHOP.level().name()) ? WORKSHOP : INSTALLED.level(name);
        }
      };

  private static final List<RoomConfig> ROOMS =
      List.of(
          room("cup", "arena", "platformer", "commons"),
          room("jump", "platformer", "rockets"),
          room("works", WORKSHOP.level().name(), "arena"));

  private static RoomConfig room(String name, String... levels) {
    return new RoomConfig(name, "", List.of(levels), SEATS, 1, Map.of());
  }

  private final Settings settings;
  private final Stepper stepper;
  private final Guest[] clients;
  private final Map<Incident.Kind, Integer> happened = new EnumMap<>(Incident.Kind.class);
  private final Map<Room, EntityWatch> watches = new HashMap<>();
  private final Map<Room, Integer> checkedTicks = new HashMap<>();
  private final Map<Guest, Long> thawNs = new HashMap<>();
  private final ProvenStates states = new ProvenStates();
  private final Comebacks comebacks = new Comebacks();
  private final QueueBounds queues = new QueueBounds();
  private final Replays replays = new Replays();
  private final long startNs;
  private long lookNs;
  private boolean crashed;
  private int lives;
  private int worlds;
  private long ticks;
  private long compared;
  private long entitiesSeen;
  private int number;

  Soak(Settings settings) throws IOException {
    this.settings = settings;
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.SEED, settings.seed);
    stepper = Stepper.ofRooms(config, LIBRARY, ROOMS.toArray(new RoomConfig[0]));
    stepper.expectExpulsions();
    clients = new Guest[settings.clients];
    startNs = stepper.nowNs();
    stepper.stopServer();
    stepper.whenStarted(this::begin);
    beginWorld();
    stepper.startServer();
  }

  /**
   * Runs the incidents, and goes on until the soak's end.
   *
   * @throws AssertionError when something doesn't hold
   */
  void run(List<Incident> incidents) throws IOException {
    try (stepper;
        replays) {
      int next = 0;
      while (elapsedS() < settings.seconds) {
        while (next < incidents.size() && incidents.get(next).atS() <= elapsedS()) {
          happen(incidents.get(next++));
        }
        step();
      }
      end(false);
      replays.end();
    }
  }

  /** Returns the virtual time since the soak began, s. */
  double elapsedS() {
    return (stepper.nowNs() - startNs) * 1e-9;
  }

  /** Returns the bounds that no queue was compared with, such as one of a renamed queue. */
  List<String> unseenQueues() {
    return queues.unseen(settings.play);
  }

  /** Returns the most important of what the soak saw, in one line. */
  String counts() {
    return String.format(
        Locale.ROOT,
        "ticks=%d crashes=%d restarts=%d resumed=%d back=%d replayed=%d",
        ticks,
        happened.getOrDefault(Incident.Kind.CRASH, 0),
        happened.getOrDefault(Incident.Kind.RESTART, 0),
        states.resumed(),
        comebacks.came(),
        replays.ticks());
  }

  /** Returns what the soak saw, for people. */
  String summary() {
    return String.format(
        Locale.ROOT,
        "ticks=%d states compared=%d entities seen=%d replayed ticks=%d%nincidents=%s%nplayers"
            + " who came back to their seats=%d, %s%n%s",
        ticks,
        compared,
        entitiesSeen,
        replays.ticks(),
        happened,
        comebacks.came(),
        states.summary(),
        queues.summary());
  }

  private void step() {
    for (Map.Entry<Guest, Long> frozen : List.copyOf(thawNs.entrySet())) {
      if (stepper.nowNs() - frozen.getValue() >= 0) {
        frozen.getKey().freeze(false);
        thawNs.remove(frozen.getKey());
      }
    }
    stepper.step(settings.play == Play.PREDICTING ? 1 : COARSE_SLICES);
    for (Guest client : clients) {
      if (client != null) {
        client.update(stepper.nowNs());
        comebacks.look(client, stepper.nowNs());
      }
    }
    for (Room room : stepper.server().rooms()) {
      if (room.tick() != checkedTicks.getOrDefault(room, -1)) {
        checkedTicks.put(room, room.tick());
        ticks++;
        check(room);
        states.tick(room);
      }
    }
    if (stepper.nowNs() - lookNs >= 0) {
      lookNs = stepper.nowNs() + LOOK_NS * (settings.play == Play.INPUT_ONLY ? RARE_LOOKS : 1);
      List<Object> roots = new ArrayList<>();
      roots.add(stepper.server());
      for (Guest client : clients) {
        if (client != null) {
          roots.addAll(client.roots());
        }
      }
      queues.check(roots);
      ProvenStates.requireOneSeatEach(stepper.server().rooms());
    }
  }

  private void check(Room room) {
    SimulationHost simulation = room.simulation();
    for (int id = 0, left = simulation.entityCount(); left > 0; id++) {
      HostEntity entity = simulation.entity(id);
      if (entity == null) {
        continue;
      }
      left--;
      Body<HostEntity> body = entity.body();
      float sum =
          body.x()
              + body.y()
              + body.angle()
              + body.velocityX()
              + body.velocityY()
              + body.angularVelocity();
      if (!Float.isFinite(sum)) {
        throw failure(room, "entity=" + id + " isn't finite: " + body);
      }
    }
    if (room.seats().takenCount() > SEATS) {
      throw failure(room, "taken seats=" + room.seats().takenCount() + " of " + SEATS);
    }
    if (settings.play == Play.INPUT_ONLY) {
      return;
    }
    EntityWatch watch = watches.computeIfAbsent(room, r -> new EntityWatch());
    watch.follow(room);
    for (Guest client : clients) {
      if (client instanceof FullGuest full && full.room().equals(room.name())) {
        entitiesSeen += watch.check(full.client());
      }
    }
  }

  private AssertionError failure(Room room, String what) {
    return new AssertionError("room=" + room.name() + " tick=" + room.tick() + ": " + what);
  }

  // ---- incidents

  private void happen(Incident incident) throws IOException {
    Guest client = clients[incident.client()];
    boolean there = client != null;
    switch (incident.kind()) {
      case JOIN -> join(incident);
      case LEAVE, DIE -> leave(incident);
      case CUT -> {
        if (there && client.isConnected()) {
          client.cut();
        }
      }
      case BLACKOUT -> {
        if (there && client.isConnected()) {
          disturb(client);
          client.blackout(incident.detail() % 20_000 / 1e3);
        }
      }
      case FREEZE -> {
        if (there) {
          disturb(client);
          client.freeze(true);
          thawNs.put(client, stepper.nowNs() + incident.detail() % 3_000 * 1_000_000);
        }
      }
      case NETWORK -> {
        if (there && client.isConnected()) {
          disturb(client);
          Impairment network = incident.network().withSeed(incident.detail());
          client.impair(network);
        }
      }
      case TALK -> {
        if (isPlaying(client)) {
          client.say("this happened: " + incident.detail());
        }
      }
      case EMOTE -> {
        if (isPlaying(client)) {
          client.show(Emote.values()[(int) (incident.detail() % Emote.values().length)]);
        }
      }
      case MOVE -> {
        if (isPlaying(client)) {
          comebacks.forget(client);
          client.changeRoom(ROOMS.get((int) (incident.detail() % ROOMS.size())).name());
        }
      }
      case LEVEL -> {
        List<Room> rooms = stepper.server().rooms();
        rooms.get((int) (incident.detail() % rooms.size())).simulation().matchOver();
      }
      case STALL -> stepper.stallServer(incident.detail() % 2_000 / 1e3);
      case RESTART -> {
        boolean anew = incident.detail() % 2 == 0;
        end(false);
        if (anew) {
          beginWorld();
        }
        stepper.startServer();
      }
      case CRASH -> {
        end(true);
        stepper.startServer();
      }
      default -> throw new AssertionError(incident);
    }
    happened.merge(incident.kind(), 1, Integer::sum);
  }

  private void join(Incident incident) {
    if (clients[incident.client()] != null) {
      return;
    }
    String name = "p" + number++;
    clients[incident.client()] =
        settings.play == Play.INPUT_ONLY
            ? new InputOnlyGuest(
                name,
                stepper.transport(),
                stepper::nowNs,
                incident.network(),
                number % PREDICTED == 0,
                incident.detail())
            : new FullGuest(stepper, config(name), incident.network(), incident.detail());
  }

  private ClientConfig config(String name) {
    return ClientConfig.of(name)
        .withServer("localhost", stepper.tcpPort(), stepper.udpPort())
        .with(
            ClientConfig.PREDICTION,
            settings.play == Play.PREDICTING ? PredictionMode.ISLAND : PredictionMode.NONE);
  }

  private void leave(Incident incident) {
    Guest client = clients[incident.client()];
    if (client == null) {
      return;
    }
    client.end(incident.kind() == Incident.Kind.DIE);
    clients[incident.client()] = null;
    comebacks.forget(client);
    thawNs.remove(client);
    compared += client.compared();
  }

  private void disturb(Guest client) {
    if (client instanceof FullGuest full) {
      watches.values().forEach(watch -> watch.disturbed(full.client()));
    }
  }

  private static boolean isPlaying(Guest client) {
    return client != null && client.isPlaying();
  }

  // ---- the lives of the server

  /** Lets the next server begin anew. */
  private void beginWorld() throws IOException {
    Path folder = settings.folder.resolve("world" + worlds);
    Folders.delete(folder);
    worlds++;
    stepper.keepCheckpoints(settings.folder.resolve("world" + worlds), CHECKPOINT_S);
    states.forget();
    comebacks.forgetAll();
  }

  private Path recordings() {
    return settings.folder.resolve("life" + lives);
  }

  private void begin(Server server) {
    states.requireResumed(server.rooms(), crashed);
    lookNs = stepper.nowNs() + SETTLED_NS;
    lives++;
    if (settings.records) {
      try {
        server.record(Files.createDirectories(recordings()));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  private void end(boolean crash) throws IOException {
    for (Counter failures : FAILURES) {
      if (stepper.count(failures) > 0) {
        throw new AssertionError(
            failures + "=" + stepper.count(failures) + "; " + stepper.server().status());
      }
    }
    crashed = crash;
    comebacks.serverEnds(stepper.server().rooms(), stepper.nowNs());
    states.serverEnds(stepper.server().rooms());
    if (crash) {
      stepper.crashServer();
    } else {
      stepper.stopServer();
    }
    watches.clear();
    checkedTicks.clear();
    if (settings.records) {
      replays.begin(recordings());
    }
  }
}
