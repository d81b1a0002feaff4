package carom.server;

import carom.net.protocol.GoodbyeReason;
import carom.net.transport.ServerTransport;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counters;
import carom.server.room.Room;
import carom.server.session.Seats;
import carom.sim.Game;
import carom.sim.Level;
import java.security.SecureRandom;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A Carom server: a lobby and a room behind a transport.
 *
 * <p>Drive it in one of two ways. By hand: call {@link #tick} again and again with a time of your
 * choice; everything happens on the calling thread, nothing sleeps, and a test runs an hour in
 * seconds. By threads: {@link #start} gives the room a thread that keeps the tick rate and the
 * lobby one of its own; {@link #awaitStop} waits for the end.
 *
 * <p>{@link #close} tells the players and ends both; it owns and closes the transport.
 */
public final class Server implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Server.class);
  private static final long NS_PER_MS = 1_000_000;

  /** The longest nap of the room's thread: datagrams get their arrival time when it wakes. */
  private static final long ROOM_NAP_NS = 4 * NS_PER_MS;

  private static final long LOBBY_NAP_NS = 5 * NS_PER_MS;
  private static final long FAREWELL_MS = 400;
  private static final long JOIN_MS = 1_000;
  private static final int MAX_FAILURES_IN_A_ROW = 100;

  private final ServerConfig config;
  private final ServerTransport transport;
  private final LongSupplier clock;
  private final Room room;
  private final Lobby lobby;
  private final StatusLine status;
  private final CountDownLatch ended = new CountDownLatch(1);
  private Thread roomThread;
  private Thread lobbyThread;
  private long nextStatusNs;
  private boolean statusScheduled;
  private volatile boolean stopping;
  private volatile boolean crashed;
  private boolean closed;

  /**
   * Builds the level, sets up the game and is ready to be driven; accepts nobody before that.
   *
   * @param config all settings
   * @param game an instance of the room's own
   * @param level where it is played
   * @param transport owned by the server from now on
   * @param clock monotonic nanoseconds, {@code System::nanoTime} or virtual; read to measure
   *     durations and, with threads, to know the time
   */
  public Server(
      ServerConfig config, Game game, Level level, ServerTransport transport, LongSupplier clock) {
    this.config = config;
    this.transport = transport;
    this.clock = clock;
    SecureRandom random = new SecureRandom();
    this.room =
        new Room(config, game, level, clock, new Seats(config.maxPlayers(), random::nextLong));
    this.lobby = new Lobby(config, transport, room, level, random::nextLong);
    this.status = new StatusLine(room, config, clock.getAsLong());
  }

  /**
   * One turn of lobby and room, by hand.
   *
   * @param nowNs monotonic time in nanoseconds, not before the previous turn's
   * @return how much was done; 0 when nothing was due
   * @throws IllegalStateException when threads drive the server
   */
  public int tick(long nowNs) {
    if (roomThread != null) {
      throw new IllegalStateException("threads drive this server; don't call tick as well");
    }
    return lobbyTurn(nowNs) + room.doWork(nowNs);
  }

  private int lobbyTurn(long nowNs) {
    int work = lobby.doWork(nowNs);
    if (config.statusIntervalS() > 0) {
      if (!statusScheduled || nowNs - nextStatusNs >= 0) {
        if (statusScheduled) {
          LOG.info("status: {}", status.next(nowNs));
        }
        statusScheduled = true;
        nextStatusNs = nowNs + TimeUnit.SECONDS.toNanos(config.statusIntervalS());
      }
    }
    return work;
  }

  /**
   * Starts the room's and the lobby's thread; both are ordinary threads that keep the JVM alive.
   */
  public synchronized void start() {
    if (roomThread != null || closed) {
      throw new IllegalStateException(closed ? "the server is closed" : "already started");
    }
    roomThread = new Thread(this::runRoom, "carom-room");
    lobbyThread = new Thread(this::runLobby, "carom-lobby");
    roomThread.setPriority(Thread.MAX_PRIORITY);
    roomThread.start();
    lobbyThread.start();
  }

  private void runRoom() {
    LongConsumer work = room::doWork;
    boolean orderly = false;
    try {
      int failures = 0;
      while (!stopping && !room.hasFailed()) {
        failures = turn("room", failures, work, clock.getAsLong());
        long waitNs = room.nextDeadlineNs() - clock.getAsLong();
        if (waitNs > 0) {
          LockSupport.parkNanos(this, Math.min(waitNs, ROOM_NAP_NS));
        }
      }
      room.close(GoodbyeReason.SERVER_STOPPING, "", clock.getAsLong());
      long endNs = clock.getAsLong() + FAREWELL_MS * NS_PER_MS;
      while (!room.isDeserted() && clock.getAsLong() - endNs < 0) {
        room.doWork(clock.getAsLong());
        LockSupport.parkNanos(this, ROOM_NAP_NS);
      }
      room.closeLinks();
      orderly = true;
    } finally {
      if (!orderly) {
        crashed = true;
      }
      stopping = true;
      ended.countDown();
    }
  }

  private void runLobby() {
    LongConsumer work = this::lobbyTurn;
    boolean orderly = false;
    try {
      int failures = 0;
      while (!stopping) {
        failures = turn("lobby", failures, work, clock.getAsLong());
        LockSupport.parkNanos(this, LOBBY_NAP_NS);
      }
      lobby.close(clock.getAsLong());
      long endNs = clock.getAsLong() + FAREWELL_MS * NS_PER_MS;
      while (!lobby.isDeserted() && clock.getAsLong() - endNs < 0) {
        lobby.doWork(clock.getAsLong());
        LockSupport.parkNanos(this, LOBBY_NAP_NS);
      }
      lobby.closeLinks();
      orderly = true;
    } finally {
      if (!orderly) {
        crashed = true;
      }
      stopping = true;
      ended.countDown();
    }
  }

  /**
   * One guarded turn: an exception that got through every inner guard is a bug; it is logged, and
   * the thread goes on unless it happens each time.
   */
  private int turn(String name, int failures, LongConsumer work, long nowNs) {
    try {
      work.accept(nowNs);
      return 0;
    } catch (RuntimeException | StackOverflowError e) {
      if (failures == 0) {
        LOG.error("the {} failed; it goes on", name, e);
      }
      if (failures + 1 >= MAX_FAILURES_IN_A_ROW) {
        LOG.error("the {} failed {} times in a row; the server stops", name, failures + 1);
        crashed = true;
        stopping = true;
      }
      return failures + 1;
    }
  }

  /** Waits until the server has ended, by {@link #close} or because its room failed. */
  public void awaitStop() throws InterruptedException {
    ended.await();
  }

  /**
   * Tells every player that the server stops, waits up to {@value #FAREWELL_MS} ms for them to hear
   * it (by hand: not at all), and closes the transport. Closing twice does nothing.
   */
  @Override
  public synchronized void close() {
    if (closed) {
      return;
    }
    closed = true;
    stopping = true;
    if (roomThread == null) {
      long nowNs = clock.getAsLong();
      lobby.close(nowNs);
      room.close(GoodbyeReason.SERVER_STOPPING, "", nowNs);
      lobby.closeLinks();
      room.closeLinks();
      ended.countDown();
    } else {
      join(roomThread);
      join(lobbyThread);
    }
    transport.close();
  }

  private static void join(Thread thread) {
    LockSupport.unpark(thread);
    try {
      thread.join(JOIN_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    if (thread.isAlive()) {
      LOG.warn("thread {} did not end within {} ms", thread.getName(), JOIN_MS);
    }
  }

  /** Whether the server ended by itself, because of errors that are in the log. */
  public boolean hasFailed() {
    return crashed || room.hasFailed();
  }

  /** Port for reliable messages, as the transport opened it. */
  public int tcpPort() {
    return transport.tcpPort();
  }

  /** Port for datagrams, as the transport opened it. */
  public int udpPort() {
    return transport.udpPort();
  }

  /** All settings. */
  public ServerConfig config() {
    return config;
  }

  /** The room. With threads: only what its documentation allows from any thread. */
  public Room room() {
    return room;
  }

  /** What the room counts; from any thread. */
  public Counters counters() {
    return room.counters();
  }

  /** One line for people about the time since the start; from any thread. */
  public String status() {
    return status.sinceStart(clock.getAsLong());
  }

  /** Links in the lobby; by hand only. */
  int visitorCount() {
    return lobby.visitorCount();
  }
}
