package carom.server;

import carom.game.GuardedGame;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.ServerMessage;
import carom.net.transport.NetworkCounter;
import carom.net.transport.ServerTransport;
import carom.physics.threads.WorkerThreads;
import carom.server.access.EntryRule;
import carom.server.access.GamePassword;
import carom.server.account.AccountService;
import carom.server.checkpoint.SlotDisk;
import carom.server.command.RoomKeeper;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.fleet.RoomHost;
import carom.server.lobby.Lobby;
import carom.server.match.HandedInMatch;
import carom.server.match.MatchLibrary;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.recording.RecordingFile;
import carom.server.recording.RotatingRecording;
import carom.server.recording.RotationLimit;
import carom.server.recording.ShownRecordings;
import carom.server.room.BotCrew;
import carom.server.room.FleetDoor;
import carom.server.room.FleetRoom;
import carom.server.room.Room;
import carom.server.room.RoomDirectory;
import carom.server.session.ChatCommands;
import carom.server.session.Ownership;
import carom.server.threads.Duty;
import carom.server.threads.DutyPool;
import carom.server.threads.LoaderThread;
import carom.server.threads.Watchdog;
import carom.server.upload.Uploads;
import carom.sim.Game;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.text.FileErrors;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A Carom server: a lobby and one or more rooms behind a transport. Rooms share only the lobby, the
 * transport, the helper threads and the level, which never changes. A room that fails does not
 * affect the others.
 *
 * <p>Drive the server in one of two ways.
 *
 * <ul>
 *   <li><b>By hand.</b> Call {@link #tick} again and again with times of your choice. Everything
 *       happens on the calling thread and nothing sleeps, so a test runs an hour of play in
 *       seconds.
 *   <li><b>By threads.</b> {@link #start} gives the rooms threads that they share and that keep the
 *       tick rate ({@code carom-rooms-1} and so on), and the lobby its own ({@code carom-lobby}).
 *       {@link #awaitStop} waits for the end.
 * </ul>
 *
 * <p>{@link #close} tells the players, ends all threads and closes the transport, which the server
 * owns.
 */
public final class Server implements AutoCloseable, RoomKeeper, RoomHost {
  private static final Logger LOG = LoggerFactory.getLogger(Server.class);

  private static final long LOBBY_NAP_NS = TimeUnit.MILLISECONDS.toNanos(5);

  /** Nap of the lobby without links, ns, if the transport doesn't tell of new links. */
  private static final long LOOKING_NAP_NS = TimeUnit.MILLISECONDS.toNanos(50);

  /**
   * Nap of the lobby without links, where the transport tells of new ones, ns: for lines of the
   * log.
   */
  private static final long IDLE_NAP_NS = TimeUnit.SECONDS.toNanos(1);

  private static final long JOIN_MS = 1_000;
  private static final long TROUBLES_GAP_NS = TimeUnit.SECONDS.toNanos(10);

  private final LiveConfig config;
  private final ServerTransport transport;
  private final LongSupplier clock;

  /** Threads that help rooms to step their worlds, or null. */
  private final WorkerThreads helpers;

  /** Guarded by itself where it changes. */
  private final List<Room> rooms = new CopyOnWriteArrayList<>();

  private final List<Room> roomsShown = Collections.unmodifiableList(rooms);
  private final RoomBuilder builder;
  private final HangingRooms hanging;
  private final RoomDirectory directory;
  private final Watchdog watchdog = new Watchdog(GuardedGame.class);
  private final Lobby lobby;
  private final StatusLine status;
  private final Map<String, ShownRecordings> recordings = new ConcurrentHashMap<>();
  private final List<RotatingRecording> rotations = new CopyOnWriteArrayList<>();

  /** Rooms that are removed, and whose links still say goodbye. */
  private final List<Room> leaving = new CopyOnWriteArrayList<>();

  private final List<ShownRecordings> ended = new CopyOnWriteArrayList<>();
  private final Object roomCommands = new Object(); // one at a time
  private RoomRecorder recorder = room -> {};
  private int spectatorDelayTicks;
  private int numbers; // of the rooms so far
  private final LoaderThread loader = new LoaderThread();
  private final SlotDisk disk = new SlotDisk();
  private FolderLock checkpointLock;
  private Path checkpoints;
  private int checkpointS;
  private volatile boolean gaveUp;
  private final DutyPool roomThreads;
  private final DutyPool lobbyThread;

  /** The turns of lobby and rooms. */
  private final List<DutyPool.Shift> shifts = new CopyOnWriteArrayList<>();

  private final Map<Room, DutyPool.Shift> roomShifts = new ConcurrentHashMap<>();
  private final CountDownLatch stopped = new CountDownLatch(1);
  private long nextStatusNs;
  private boolean statusScheduled;
  private String troublesLogged;
  private long troublesLoggedNs;
  private volatile boolean lobbyFailed;

  /** True for a server that goes on without rooms: in a fleet, others' rooms may come to it. */
  private volatile boolean mayBeEmpty;

  private volatile boolean started;
  private boolean closed;

  /**
   * Builds the level and sets up the games. The server accepts no link before it is driven.
   *
   * @param config all settings
   * @param games creates a game; the constructor calls it once for each room
   * @param level the level of every room
   * @param transport accepts links; owned by the server from now on
   * @param clock monotonic nanoseconds, {@code System::nanoTime} or virtual; read by every thread
   *     to measure durations and, with threads, to know the time
   */
  public Server(
      ServerConfig config,
      Supplier<Game> games,
      Level level,
      ServerTransport transport,
      LongSupplier clock) {
    this(
        config,
        RoomConfig.equalRooms(config, List.of(level.name())),
        new HandedInMatch(games, level),
        transport,
        clock);
  }

  /**
   * Builds the first match of each room. The server accepts no link before it is driven.
   *
   * @param config the settings that all rooms share
   * @param roomConfigs one for each room, with different names
   * @param library finds games and levels, for the first matches and for those that follow
   * @param transport accepts links; owned by the server from now on
   * @param clock as above
   * @throws IllegalArgumentException when a room's first match can't be played, or the rooms don't
   *     fit together; the message says why
   */
  public Server(
      ServerConfig config,
      List<RoomConfig> roomConfigs,
      MatchLibrary library,
      ServerTransport transport,
      LongSupplier clock) {
    this(config, roomConfigs, library, transport, clock, room -> Ownership.alone());
  }

  /**
   * Builds the first match of each room, as above, for a server that may be one of a fleet.
   *
   * @param ownerships returns whether the server owns a room that is about to be built, and throws
   *     an IllegalArgumentException if the room belongs to another one
   */
  public Server(
      ServerConfig config,
      List<RoomConfig> roomConfigs,
      MatchLibrary library,
      ServerTransport transport,
      LongSupplier clock,
      Function<RoomConfig, Ownership> ownerships) {
    RoomConfig.places(roomConfigs);
    this.config = new LiveConfig(config);
    this.transport = transport;
    this.clock = clock;
    this.helpers =
        config.get(ServerConfig.THREADS) == 1
            ? null
            : new WorkerThreads(config.get(ServerConfig.THREADS), System::nanoTime);
    directory = new RoomDirectory();
    builder =
        new RoomBuilder(
            this.config,
            library,
            loader,
            clock,
            directory,
            ownerships,
            helpers,
            new SecureRandom());
    List<Room> built = new ArrayList<>();
    for (RoomConfig own : roomConfigs) {
      built.add(builder.build(own, ++numbers, new Counters()));
    }
    rooms.addAll(built);
    directory.open(roomsShown);
    int threads = config.get(ServerConfig.ROOM_THREADS);
    roomThreads = new DutyPool("carom-rooms", threads, Thread.MAX_PRIORITY, clock, watchdog);
    lobbyThread = new DutyPool("carom-lobby", 1, Thread.NORM_PRIORITY, clock, null);
    hanging = new HangingRooms(this::again, this::giveUp, loader, threads);
    this.lobby = new Lobby(this.config, transport, roomsShown, directory);
    this.status = new StatusLine(roomsShown, clock.getAsLong());
  }

  /**
   * Keeps every room on the disk from now on, and first goes on from where an earlier run of the
   * server has left it; see {@link Room#checkpoint}. Call it before the first {@link #tick} or
   * {@link #start}, and before the rooms are recorded.
   *
   * @param folder gets a folder for each room; no other server may use it meanwhile
   * @param seconds time between checkpoints, 1..{@value ServerConfig#MAX_CHECKPOINT_S} s
   * @throws IOException if the folder can't be used; the message says why
   */
  public void checkpoint(Path folder, int seconds) throws IOException {
    if (seconds < 1 || seconds > ServerConfig.MAX_CHECKPOINT_S) {
      throw new IllegalArgumentException(
          "seconds=" + seconds + " is outside 1.." + ServerConfig.MAX_CHECKPOINT_S);
    }
    checkpointLock = FolderLock.of(folder, "folder");
    checkpoints = folder;
    checkpointS = seconds;
    for (Room room : rooms) {
      room.checkpoint(disk, folder.resolve(room.name()), seconds);
    }
    rooms.forEach(room -> room.reconcile(rooms));
  }

  /**
   * Records every room from its first tick on. Call it before the first {@link #tick} or {@link
   * #start}.
   *
   * @param target a new file, or a folder in which the server creates one file for each room
   * @return the files
   * @throws IOException when a file can't be created
   * @throws IllegalArgumentException when the target is a file and there are several rooms
   */
  public List<Path> record(Path target) throws IOException {
    if (rooms.size() > 1 && !Files.isDirectory(target)) {
      throw new IllegalArgumentException(
          "target=" + target + " is no folder; rooms=" + rooms.size() + " need one");
    }
    for (Room room : rooms) {
      record(room, target, false);
    }
    recorder = Files.isDirectory(target) ? room -> record(room, target, false) : null;
    return rooms.stream().flatMap(room -> recordings.get(room.name()).paths().stream()).toList();
  }

  /**
   * Records every room from its first tick on into a sequence of files. Call it before the first
   * {@link #tick} or {@link #start}, and not together with {@link #allowSpectators}, which shows
   * one file.
   *
   * @param folder the folder of the files
   * @param limit how much of a game each file holds
   * @param keep how many files of each room are kept; 0 = all
   * @throws IOException when a file can't be created
   * @throws IllegalArgumentException when the game can be recorded from tick 0 on only
   */
  public void recordRotating(Path folder, RotationLimit limit, int keep) throws IOException {
    recorder =
        room -> {
          RotatingRecording files = new RotatingRecording(() -> file(folder, room), limit, keep);
          rotations.add(files);
          room.record(files);
        };
    for (Room room : rooms) {
      recorder.begin(room);
    }
  }

  private void record(Room room, Path target, boolean temporary) throws IOException {
    ShownRecordings shown =
        new ShownRecordings(number -> path(target, room, number), room::age, temporary);
    if (spectatorDelayTicks > 0) {
      shown.delay(spectatorDelayTicks);
    }
    ShownRecordings before = recordings.put(room.name(), shown);
    if (before != null) {
      ended.add(before); // of a removed room of this name
    }
    room.record(shown);
  }

  /** Returns the path of a room's next recording, free but for that of the first match. */
  private Path path(Path target, Room room, int number) {
    Path path = file(target, room);
    return number == 1 ? path : RecordingFile.free(path);
  }

  private Path file(Path target, Room room) {
    return RecordingFile.fileFor(target, room.match().game(), room.isNamed() ? room.name() : "");
  }

  /**
   * Lets spectators watch every room with a delay. Call it before the first {@link #tick} or {@link
   * #start}, and after {@link #record} if that is called. Without {@link #record}, recordings go to
   * the system's folder for temporary files.
   *
   * @param delaySeconds age at which spectators see what happens, 1..3,600 s
   * @throws IOException when a file can't be created
   */
  public void allowSpectators(int delaySeconds) throws IOException {
    if (delaySeconds < 1 || delaySeconds > 3_600) {
      throw new IllegalArgumentException("delaySeconds=" + delaySeconds + " is outside 1..3600");
    }
    if (recordings.isEmpty()) {
      Path folder = Files.createTempDirectory("carom");
      folder.toFile().deleteOnExit();
      recorder = room -> record(room, folder, true);
      for (Room room : rooms) {
        recorder.begin(room);
      }
    }
    spectatorDelayTicks = delaySeconds * config().get(ServerConfig.TICK_RATE);
    recordings.values().forEach(recording -> recording.delay(spectatorDelayTicks));
    lobby.allowSpectators(recordings::get, delaySeconds);
  }

  /**
   * Sends all who wait for a place or watch to another server, soon; rooms send their players
   * themselves. Any thread.
   */
  public void redirectVisitors(ServerMessage.Redirect to) {
    lobby.redirect(to);
  }

  /** Sets what shows the rooms of the other servers of a fleet; before the first turn. */
  public void fleet(FleetDoor door) {
    mayBeEmpty = true;
    directory.fleet(door);
  }

  /**
   * Sets what keeps accounts; before {@link #checkpoint}.
   *
   * @param service the server's from now on
   */
  public void accounts(AccountService service) {
    directory.accounts(service);
  }

  /** Sets what plays bots for rooms, see {@link ServerConfig#BOTS}; before the first turn. */
  public void bots(BotCrew crew) {
    directory.bots(crew);
  }

  /**
   * Sets what keeps levels of players; before the first turn.
   *
   * @param levels the server's from now on
   */
  public void uploads(Uploads levels) {
    directory.uploads(levels);
  }

  /** Returns what keeps levels of players, or null if the server takes none. */
  public Uploads uploads() {
    return directory.uploads();
  }

  /** Returns what keeps accounts, or null if nothing does. */
  public AccountService accounts() {
    return directory.accounts();
  }

  /** Sets what runs commands in the chat; without it a line with a slash is ordinary chat. */
  public void chatCommands(ChatCommands commands) {
    directory.chatCommands(commands);
  }

  /**
   * Sets who may come in, from now on; without it everybody may. Any thread.
   *
   * @param rule asked once for each player and spectator
   */
  public void admit(EntryRule rule) {
    lobby.admit(rule);
  }

  /** Sets the password that players and spectators must know from now on. Any thread. */
  public void demand(GamePassword password) {
    lobby.demand(password);
  }

  /**
   * Does one turn of the lobby and then of each room, by hand.
   *
   * @param nowNs monotonic time in nanoseconds, not before the previous turn's
   * @return the amount of work done; 0 when nothing was due
   * @throws IllegalStateException when threads drive the server
   */
  public int tick(long nowNs) {
    if (started) {
      throw new IllegalStateException("threads drive this server; don't call tick as well");
    }
    int work = lobbyTurn(nowNs);
    for (int i = 0; i < rooms.size(); i++) {
      work += rooms.get(i).doWork(nowNs);
    }
    if (!leaving.isEmpty()) { // asked first: an iterator for each turn would be garbage
      for (Room room : leaving) {
        work += room.doWork(nowNs);
      }
      leaving.removeIf(room -> room.isClosed() && room.isDeserted());
    }
    return work;
  }

  private int lobbyTurn(long nowNs) {
    int work = lobby.doWork(nowNs);
    Throwable error = transport.nextError();
    if (error != null) {
      LOG.error("the network thread survived an error; {}", transport.troubles(), error);
    }
    logTroubles(nowNs);
    if (config().get(ServerConfig.STATUS_INTERVAL) > 0
        && (!statusScheduled || nowNs - nextStatusNs >= 0)) {
      if (statusScheduled) {
        status.next(nowNs).forEach(line -> LOG.info("status: {}", line));
      }
      statusScheduled = true;
      nextStatusNs = nowNs + TimeUnit.SECONDS.toNanos(config().get(ServerConfig.STATUS_INTERVAL));
    }
    return work;
  }

  /** Logs what the network refused, such as half-open connections, at most every ten seconds. */
  private void logTroubles(long nowNs) {
    if (troublesLogged != null && nowNs - troublesLoggedNs < TROUBLES_GAP_NS) {
      return;
    }
    String troubles = transport.troubles();
    if (!troubles.equals(troublesLogged) && !troubles.isEmpty()) {
      LOG.info("network since the start: {}", troubles);
    }
    troublesLogged = troubles;
    troublesLoggedNs = nowNs;
  }

  /** Starts the threads. They aren't daemon threads, so they keep the JVM alive. */
  public synchronized void start() {
    if (started || closed) {
      throw new IllegalStateException(closed ? "the server is closed" : "already started");
    }
    started = true;
    loader.start(watchdog, hanging::abandon);
    disk.start();
    LobbyDuty duty = new LobbyDuty();
    DutyPool.Shift shift =
        lobbyThread.add("the lobby", duty, 0, (thread, callback, stack) -> {}, this::shiftEnded);
    lobby.onNeeded(shift::wake);
    duty.idleNapNs = transport.onOpened(shift::wake) ? IDLE_NAP_NS : LOOKING_NAP_NS;
    shifts.add(shift);
    rooms.forEach(this::begin);
    watchdog.start();
  }

  /** Gives a room its turns. */
  private synchronized void begin(Room room) {
    if (closed) {
      return;
    }
    // The rooms' ticks are spread over a tick's time, so that they don't compete for the cores.
    long afterNs = (room.number() - 1) % rooms.size() * config().tickNs() / rooms.size();
    DutyPool.Shift shift =
        roomThreads.add(
            "room " + room.name(),
            new RoomDuty(room),
            afterNs,
            (thread, callback, stack) -> {
              shifts.remove(roomShifts.remove(room));
              hanging.abandon(room, thread, callback, stack);
            },
            this::shiftEnded);
    roomShifts.put(room, shift);
    shifts.add(shift);
    room.onNeeded(shift::wake);
  }

  /** Puts another room in the place of one, from its last checkpoint if there is one. */
  private void again(Room before) {
    if (!rooms.contains(before)) {
      return; // an operator has removed it
    }
    Room room = builder.build(before.settings(), before.number(), before.counters());
    if (checkpoints != null) {
      disk.flush();
      try {
        keep(room, before);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
    synchronized (rooms) {
      int index = rooms.indexOf(before);
      if (index < 0) {
        room.abandon("the room is removed");
        return;
      }
      rooms.set(index, room);
    }
    begin(room);
  }

  /** Keeps a room that comes while others run; of those, one may be what it replaces. */
  private void keep(Room room, Room before) throws IOException {
    room.checkpoint(disk, checkpoints.resolve(room.name()), checkpointS);
    List<Room> all = new ArrayList<>(rooms);
    all.remove(before);
    all.add(room);
    room.reconcile(all);
  }

  /** Begins to record a room. */
  @FunctionalInterface
  private interface RoomRecorder {
    void begin(Room room) throws IOException;
  }

  /** A room that an operator adds, while its first match is built. */
  private final class AddedRoom implements LoaderThread.Load {
    private final RoomConfig own;
    private final int nextNumber;
    private final CompletableFuture<Room> outcome = new CompletableFuture<>();

    AddedRoom(RoomConfig own, int nextNumber) {
      this.own = own;
      this.nextNumber = nextNumber;
    }

    @Override
    public String title() {
      return "room %s: level=\"%s\"".formatted(own.name(), String.join(",", own.levels()));
    }

    @Override
    public void run() {
      try {
        outcome.complete(builder.build(own, nextNumber, new Counters()));
      } catch (RuntimeException | Error e) { // such as too little memory for the level
        cancelled(e.getMessage() == null ? e.toString() : e.getMessage());
      }
    }

    @Override
    public void abandoned(String why) {
      cancelled(why);
    }

    @Override
    public void cancelled(String why) {
      outcome.completeExceptionally(new IllegalArgumentException(why));
    }

    Room await() {
      try {
        return outcome.get();
      } catch (ExecutionException e) {
        throw new IllegalArgumentException(e.getCause().getMessage(), e);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new IllegalArgumentException("interrupted while the room was built", e);
      }
    }
  }

  /** Adds a room, which is recorded, shown and kept as the others are. */
  @Override
  public Room addRoom(RoomConfig own) {
    synchronized (roomCommands) {
      if (rooms.size() >= ServerConfig.MAX_ROOMS) {
        throw new IllegalArgumentException(
            "rooms=" + ServerConfig.MAX_ROOMS + " is the limit; remove one before");
      }
      if (recorder == null) {
        throw new IllegalArgumentException(
            "this server records to one file, which has one room; give --record a folder");
      }
      RoomConfig seeded = own.withSeed(config().get(ServerConfig.SEED) + numbers);
      RoomConfig.places(settingsWith(null, seeded));
      own.levels().forEach(this::requireLevel);
      AddedRoom added = new AddedRoom(seeded, ++numbers);
      loader.execute(added);
      Room room = added.await();
      try {
        if (checkpoints != null) {
          disk.flush();
          keep(room, null);
        }
        recorder.begin(room);
      } catch (IOException e) {
        room.close(GoodbyeReason.SERVER_ERROR, "", clock.getAsLong());
        throw new IllegalArgumentException(
            "the room's files can't be written: " + FileErrors.reason(e), e);
      }
      addRoom(room);
      return room;
    }
  }

  @Override
  public Room prepare(RoomConfig own, Path slots, Ownership ownership) {
    own.levels().forEach(this::requireLevel);
    // Not on the loader's thread: rooms that come at once are built side by side.
    return builder.build(own, nextNumber(), new Counters(), ownership, slots);
  }

  @Override
  public void takeOver(FleetRoom prepared, Path slots) {
    Room room = (Room) prepared;
    synchronized (roomCommands) {
      RoomConfig.places(settingsWith(null, room.settings()));
    }
    try {
      if (slots != null) {
        room.resume(slots);
      }
      if (checkpoints != null) {
        room.checkpointAnew(disk, checkpoints.resolve(room.name()), checkpointS);
      }
      if (recorder != null) {
        recorder.begin(room);
      }
    } catch (IOException e) {
      room.close(GoodbyeReason.SERVER_ERROR, "", clock.getAsLong());
      throw new IllegalArgumentException(
          "the room's files can't be used: " + FileErrors.reason(e), e);
    }
    synchronized (roomCommands) {
      addRoom(room);
    }
  }

  private int nextNumber() {
    synchronized (roomCommands) {
      return ++numbers;
    }
  }

  private void addRoom(Room room) {
    synchronized (rooms) {
      rooms.add(room);
    }
    limitLinks(RoomConfig.places(rooms.stream().map(Room::settings).toList()));
    if (started) {
      begin(room);
    }
  }

  @Override
  public boolean hasThreads() {
    return started;
  }

  @Override
  public void forget(FleetRoom owned) {
    Room room = (Room) owned;
    synchronized (roomCommands) {
      synchronized (rooms) {
        rooms.remove(room);
      }
      DutyPool.Shift shift = roomShifts.remove(room);
      if (shift != null) {
        shift.stop();
      }
      room.closeArrivals();
    }
  }

  @Override
  public void drop(FleetRoom owned, String why) {
    Room room = (Room) owned;
    synchronized (roomCommands) {
      synchronized (rooms) {
        rooms.remove(room);
      }
      room.abandon(why);
      DutyPool.Shift shift = roomShifts.remove(room);
      if (shift != null) {
        shift.stop();
      }
    }
  }

  /** Returns the settings of all rooms but one, with another one's. */
  private List<RoomConfig> settingsWith(Room except, RoomConfig more) {
    List<RoomConfig> all = new ArrayList<>();
    rooms.stream().filter(room -> room != except).forEach(room -> all.add(room.settings()));
    all.add(more);
    return all;
  }

  private void limitLinks(int places) {
    transport.limitLinks(Lobby.mostLinks(places), Lobby.mostLinksOfAddress(places));
  }

  /** Removes a room. Its recording ends, and its checkpoints stay. */
  @Override
  public String removeRoom(Room room, String text) {
    synchronized (roomCommands) {
      if (rooms.stream().allMatch(other -> other == room || other.hasFailed())) {
        throw new IllegalArgumentException(
            "room=%s is the last one that runs; add another one before, or stop the server"
                .formatted(room.name()));
      }
      synchronized (rooms) {
        rooms.remove(room); // from now on nobody is sent there
      }
      DutyPool.Shift shift = roomShifts.remove(room);
      if (shift == null) {
        leaving.add(room);
      }
      String answer = room.dissolve(text);
      limitLinks(RoomConfig.places(rooms.stream().map(Room::settings).toList()));
      if (shift != null) {
        shift.stop(); // when the links have said goodbye
      }
      return answer;
    }
  }

  @Override
  public void changeRoom(Room room, UnaryOperator<RoomConfig> change) {
    synchronized (roomCommands) {
      RoomConfig next = change.apply(room.settings());
      int places = RoomConfig.places(settingsWith(room, next));
      next.levels().forEach(this::requireLevel);
      String problem = room.reconfigure(next);
      if (problem != null) {
        throw new IllegalArgumentException(problem);
      }
      limitLinks(places);
    }
  }

  @Override
  public int usualPlaces() {
    return config().get(ServerConfig.MAX_PLAYERS);
  }

  /** Throws an IllegalArgumentException if a level or its game isn't there. */
  private void requireLevel(String name) {
    try {
      builder.library().game(builder.library().level(name).level().gameName());
    } catch (LevelException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /** Puts those settings in force that may change while the server runs. Any thread. */
  public void configure(ServerConfig next) {
    config.change(present -> present.withLiveOf(next, ServerConfig.ROWS));
  }

  private void giveUp() {
    gaveUp = true;
    endIfFailed();
  }

  private void shiftEnded(DutyPool.Shift shift) {
    shifts.remove(shift);
    endIfFailed();
  }

  /** Ends the server when all rooms or the lobby have failed. Any thread. */
  private void endIfFailed() {
    if (hasFailed()) {
      shifts.forEach(DutyPool.Shift::stop);
      stopped.countDown();
    }
  }

  /** The work of the lobby. */
  private final class LobbyDuty implements Duty {
    private long idleNapNs;

    @Override
    public void turn(long nowNs) {
      lobbyTurn(nowNs);
    }

    @Override
    public long napNs(long nowNs) {
      return lobby.isDeserted() ? idleNapNs : LOBBY_NAP_NS;
    }

    @Override
    public boolean hasLinks() {
      return false; // short naps do
    }

    @Override
    public int progress() {
      return 0;
    }

    @Override
    public boolean hasFailed() {
      return lobbyFailed;
    }

    @Override
    public void fail(String why) {
      LOG.error("lobby closed, and with it the server: {}", why);
      lobbyFailed = true;
    }

    @Override
    public void close(long nowNs) {
      lobby.close(nowNs);
    }

    @Override
    public boolean isDeserted() {
      return lobby.isDeserted();
    }

    @Override
    public void closeLinks() {
      lobby.closeLinks();
    }
  }

  /** Waits until the server has ended, because of {@link #close} or a failure. */
  public void awaitStop() throws InterruptedException {
    stopped.await();
  }

  /**
   * Tells all players that the server stops and closes the transport. A server driven by threads
   * first waits up to {@value DutyPool#FAREWELL_MS} ms for the messages to arrive; one driven by
   * hand doesn't wait. Closing twice does nothing.
   */
  @Override
  public synchronized void close() {
    if (closed) {
      return;
    }
    closed = true;
    watchdog.close();
    if (started) {
      long endNs = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(JOIN_MS);
      shifts.forEach(DutyPool.Shift::stop);
      shifts.forEach(shift -> shift.join(endNs));
      roomThreads.close();
      lobbyThread.close();
    } else {
      long nowNs = clock.getAsLong();
      lobby.close(nowNs);
      rooms.forEach(room -> room.close(GoodbyeReason.SERVER_STOPPING, "", nowNs));
      lobby.closeLinks();
      rooms.forEach(Room::closeLinks);
    }
    loader.close();
    if (helpers != null) {
      helpers.close();
    }
    disk.close();
    rooms.forEach(Room::letAccountsGo);
    if (directory.bots() != null) {
      directory.bots().close();
    }
    if (directory.uploads() != null) {
      directory.uploads().close();
    }
    if (directory.accounts() != null) {
      directory.accounts().close();
    }
    if (checkpointLock != null) {
      checkpointLock.close();
    }
    rooms.forEach(Room::awaitRecording);
    leaving.forEach(Room::closeLinks);
    recordings.values().forEach(ShownRecordings::close);
    ended.forEach(ShownRecordings::close);
    rotations.forEach(RotatingRecording::close);
    transport.close();
    stopped.countDown();
  }

  /**
   * Returns whether errors, which are in the log, have ended the server: all rooms or the lobby
   * have failed, or too many threads hang in games.
   */
  public boolean hasFailed() {
    return lobbyFailed || gaveUp || (rooms.stream().allMatch(Room::hasFailed) && !mayStayEmpty());
  }

  private boolean mayStayEmpty() {
    return mayBeEmpty && rooms.isEmpty();
  }

  /** Returns the port for reliable messages, as the transport opened it. */
  public int tcpPort() {
    return transport.tcpPort();
  }

  /** Returns the port for datagrams, as the transport opened it. */
  public int udpPort() {
    return transport.udpPort();
  }

  /** Returns what the transport counts. Any thread. */
  public List<NetworkCounter> networkCounters() {
    return transport.networkCounters();
  }

  /** Returns all settings as they are now. */
  public ServerConfig config() {
    return config.get();
  }

  /**
   * Returns the rooms in the order of their numbers. A room whose game hangs is replaced by another
   * one of the same number and name, and operators add and remove rooms; the list shows that. While
   * threads drive the server, use only what the documentation of {@link Room} allows from any
   * thread.
   */
  @Override
  public List<Room> rooms() {
    return roomsShown;
  }

  /** Returns the sum of a counter over all rooms. Any thread. */
  public long count(Counter counter) {
    return rooms.stream().mapToLong(room -> room.counters().get(counter)).sum();
  }

  /**
   * Returns a report of the time since the start, for people: one line for each room, and one for
   * all rooms together if there are several. Any thread.
   */
  public List<String> status() {
    return status.sinceStart(clock.getAsLong());
  }

  /** Returns the number of links in the lobby; by hand only. */
  int visitorCount() {
    return lobby.visitorCount();
  }
}
