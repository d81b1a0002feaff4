package carom.server;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.core.io.JsonStringEncoder;
import java.io.IOException;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Tells Agones how this server is: healthy, ready for players, allocated while somebody plays, and
 * at its end that it may be deleted. When the GameServer has the label {@value #SUPERSEDED}, the
 * server drains.
 *
 * <p>A thread of its own, {@code carom-agones}, does all of it: it reads counters of the rooms and
 * waits for nobody but the sidecar, and for that one at most a deadline. A sidecar that isn't there
 * yet, fails or hangs is asked again and again.
 */
final class AgonesService implements AutoCloseable {
  /** Label of the GameServer by which an operator or Agones says that the server has to go. */
  public static final String SUPERSEDED = "carom.dev/superseded";

  private static final Logger LOG = LoggerFactory.getLogger(AgonesService.class);
  private static final String ROOMS = "/v1beta1/counters/rooms";
  private static final String PLAYERS = "/v1beta1/lists/players";
  private static final String EMPTY = "{}";
  private static final Pattern CAPACITY = Pattern.compile("\"capacity\": ?\"?(\\d{1,18})");

  /** Most changes of the list of players in one turn, so that health is told in time. */
  private static final int MOST_CHANGES = 20;

  /** Parts of the period of Agones' health check after which health is told. */
  private static final int HEALTH_PARTS = 2;

  /**
   * The times that the service keeps, ms.
   *
   * @param nap between two looks at the server
   * @param health most between two words of health
   * @param empty for which a server stays allocated after its last player left
   * @param retry after a failure
   * @param deadline of a request
   * @param look between two questions for the GameServer, beside its watch
   */
  record Pace(int nap, int health, int empty, int retry, int deadline, int look) {
    static final Pace USUAL = new Pace(100, 2_000, 30_000, 500, 2_000, 10_000);
  }

  /** The states of a GameServer that Agones is told. */
  private enum Told {
    NOTHING("", ""),
    READY("/ready", "Ready"),
    ALLOCATED("/allocate", "Allocated"),
    SHUTDOWN("/shutdown", "Shutdown");

    private final String path;
    private final String state;

    Told(String path, String state) {
      this.path = path;
      this.state = state;
    }
  }

  /** An answer to the question if the GameServer declares a counter or list. */
  private enum Declared {
    UNKNOWN,
    YES,
    NO
  }

  private final Sidecar sidecar;
  private final Pace pace;
  private final GameServerWatch watch;
  private final Thread thread = new Thread(this::run, "carom-agones");
  private final Object news = new Object();
  private GameServer present; // guarded by news; null until Agones has said something
  private int changes; // guarded by news; what the watch has heard

  /** True once Agones has done as {@link #told} says, if that is ready; guarded by news. */
  private boolean readySeen;

  /** True if it was told allocated before; guarded by news. */
  private boolean wasAllocated;

  private Told told = Told.NOTHING; // guarded by news
  private long toldNs; // guarded by news
  private volatile AgonesSubject subject;
  private volatile boolean stopping;
  private volatile boolean closed;

  // The service's thread only.
  private long healthNs;
  private long lookNs;
  private long retryNs;
  private long busyNs;
  private boolean superseded;
  private boolean failing;
  private boolean unhealthy;
  private String toldDraining = "";
  private Declared rooms = Declared.UNKNOWN;
  private Declared players = Declared.UNKNOWN;
  private long toldCount = -1;
  private long capacity;
  private final Set<String> toldPlayers = new HashSet<>();
  private long fullNs;

  AgonesService(int port, Pace pace) {
    this.pace = pace;
    sidecar = new Sidecar(port, pace.deadline());
    watch = new GameServerWatch(sidecar, pace.retry(), this::heard);
    thread.setDaemon(true);
    long nowNs = System.nanoTime();
    healthNs = nowNs;
    lookNs = nowNs;
    retryNs = nowNs;
    fullNs = nowNs;
  }

  /**
   * Begins to tell the sidecar that the server is healthy; it isn't ready before {@link #serve}.
   *
   * @param port of the sidecar, at this machine
   */
  public static AgonesService start(int port) {
    AgonesService service = new AgonesService(port, Pace.USUAL);
    service.start();
    LOG.info("agones: the sidecar is at port {}", port);
    return service;
  }

  void start() {
    thread.start();
    watch.start();
  }

  /**
   * Waits until the GameServer has an address.
   *
   * @param mostMs longest time to wait, ms
   * @throws IOException if it has none by then; the message says what to do
   */
  public GameServer awaitAddress(int mostMs) throws IOException {
    long endNs = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(mostMs);
    synchronized (news) {
      while (present == null || present.address().isEmpty()) {
        long leftMs = TimeUnit.NANOSECONDS.toMillis(endNs - System.nanoTime());
        if (leftMs <= 0) {
          throw new IOException(
              (present == null ? "the sidecar doesn't answer" : "the GameServer has no address")
                  + " after "
                  + mostMs
                  + " ms; name this server's ports and address (--advertise HOST), or --agones"
                  + " off");
        }
        try {
          news.wait(leftMs);
        } catch (InterruptedException e) {
          Thread.currentThread().interrupt();
          throw new IOException("interrupted", e);
        }
      }
      return present;
    }
  }

  /** Tells Agones from now on that the server is ready: players can come to its ports. */
  public void serve(AgonesSubject newSubject) {
    busyNs = System.nanoTime();
    subject = newSubject;
  }

  /** Tells Agones nothing more but that the server is healthy, because it is about to stop. */
  public void stops() {
    stopping = true;
  }

  private void heard(GameServer server) {
    synchronized (news) {
      changes++;
      note(server);
    }
  }

  /** Notes what Agones says; guarded by news. */
  private void note(GameServer server) {
    present = server;
    if (told == Told.READY && server.state().equals(Told.READY.state)) {
      readySeen = true;
    } else if (told == Told.READY
        && (readySeen || !wasAllocated)
        && server.state().equals(Told.ALLOCATED.state)) {
      LOG.info("agones: the server was allocated");
      told = Told.ALLOCATED; // by a matchmaker, whose players are about to come
      toldNs = System.nanoTime();
    }
    news.notifyAll();
  }

  private GameServer present() {
    synchronized (news) {
      return present;
    }
  }

  private void run() {
    while (!closed) {
      try {
        turn(System.nanoTime());
        Thread.sleep(pace.nap());
      } catch (InterruptedException e) {
        return;
      } catch (RuntimeException e) {
        LOG.error("agones: the thread survived an error", e);
      }
    }
  }

  private static long ns(long ms) {
    return TimeUnit.MILLISECONDS.toNanos(ms);
  }

  private void turn(long nowNs) {
    tellHealth(nowNs);
    if (nowNs - retryNs < 0) {
      return;
    }
    try {
      if (nowNs - lookNs >= 0) {
        lookNs = nowNs + ns(present() == null ? pace.retry() : pace.look());
        look();
      }
      AgonesSubject server = subject;
      if (server != null && !stopping) {
        obeyLabel(server);
        tellState(server, nowNs);
        tellDraining(server);
        tellRooms(server);
        tellPlayers(server, nowNs);
      }
    } catch (IOException e) {
      failed(e, nowNs);
    }
  }

  private void answered() {
    if (failing) {
      failing = false;
      LOG.info("agones: the sidecar answers again");
    }
  }

  private void failed(IOException e, long nowNs) {
    retryNs = nowNs + ns(pace.retry());
    if (!failing && !closed) {
      failing = true;
      LOG.warn("agones: {}; asked again each {} ms", e.getMessage(), pace.retry());
    }
  }

  private void tellHealth(long nowNs) {
    if (nowNs - healthNs < 0) {
      return;
    }
    AgonesSubject server = subject;
    String problem = server == null || stopping ? "" : server.problem();
    if (!problem.isEmpty()) {
      if (!unhealthy) {
        LOG.error("agones: isn't told that the server is healthy: {}", problem);
      }
      unhealthy = true;
      healthNs = nowNs + ns(pace.retry());
      return;
    }
    if (unhealthy) {
      LOG.info("agones: the server is healthy again");
    }
    unhealthy = false;
    GameServer now = present();
    long periodMs = now == null ? 0 : TimeUnit.SECONDS.toMillis(now.healthPeriodS());
    long every = periodMs == 0 ? pace.health() : Math.min(pace.health(), periodMs / HEALTH_PARTS);
    try {
      sidecar.tell("POST", "/health", EMPTY);
      healthNs = nowNs + ns(every);
      answered();
    } catch (IOException e) {
      healthNs = nowNs + ns(Math.min(every, pace.retry()));
      failed(e, nowNs);
    }
  }

  private void look() throws IOException {
    int before;
    synchronized (news) {
      before = changes;
    }
    Sidecar.Answer answer = sidecar.ask("GET", "/gameserver", null);
    if (!answer.isOk()) {
      throw Sidecar.refusal("/gameserver", answer);
    }
    GameServer server = GameServer.parse(answer.text().getBytes(UTF_8));
    synchronized (news) {
      if (changes == before) { // what the watch has heard meanwhile may be newer
        note(server);
      }
    }
  }

  private void obeyLabel(AgonesSubject server) {
    GameServer now = present();
    if (!superseded && now != null && "true".equals(now.labels().get(SUPERSEDED))) {
      superseded = true;
      LOG.info("agones: the label {} says that this server has to go; it drains", SUPERSEDED);
      server.drain();
    }
  }

  private void tellState(AgonesSubject server, long nowNs) throws IOException {
    boolean played = server.roomsInUse() > 0;
    boolean drains = superseded || server.isDraining();
    if (played) {
      busyNs = nowNs;
    }
    Told before;
    Told wanted;
    synchronized (news) {
      before = told;
      wanted = wanted(played, drains, drains && server.isDrained(), nowNs);
      if (wanted == told && !isOverdue(nowNs)) {
        return;
      }
      told = wanted; // before the answer, which what the watch hears may overtake
      toldNs = nowNs;
      readySeen = false;
      wasAllocated = before == Told.ALLOCATED;
    }
    try {
      if (before == Told.NOTHING && wanted == Told.ALLOCATED) {
        sidecar.tell("POST", Told.READY.path, EMPTY);
      }
      sidecar.tell("POST", wanted.path, EMPTY);
      LOG.info("agones: told {}", wanted.path);
    } catch (IOException e) {
      synchronized (news) {
        told = before;
      }
      throw e;
    }
  }

  /** Returns what Agones should be told; guarded by news. */
  private Told wanted(boolean played, boolean drains, boolean drained, long nowNs) {
    if (told == Told.SHUTDOWN || (drained && !played)) {
      return Told.SHUTDOWN;
    }
    long sinceNs = toldNs - busyNs > 0 ? toldNs : busyNs;
    if (played || (told == Told.ALLOCATED && nowNs - sinceNs < ns(pace.empty()))) {
      return Told.ALLOCATED;
    }
    return drains && told != Told.NOTHING ? told : Told.READY; // nobody new is sent here
  }

  /** Returns whether Agones didn't do what it was told, and should have by now; guarded by news. */
  private boolean isOverdue(long nowNs) {
    String state = present == null ? "" : present.state();
    boolean isSo =
        told == Told.READY
            ? readySeen || state.equals("RequestReady") || state.equals("Reserved")
            : state.equals(told.state);
    return !isSo && !state.isEmpty() && nowNs - toldNs >= ns(2L * pace.look());
  }

  private void tellDraining(AgonesSubject server) throws IOException {
    String draining = String.valueOf(superseded || server.isDraining());
    if (!draining.equals(toldDraining)) {
      sidecar.tell(
          "PUT", "/metadata/label", "{\"key\":\"carom-draining\",\"value\":\"" + draining + "\"}");
      toldDraining = draining;
    }
  }

  /** Returns whether the GameServer declares a counter or list. */
  private static Declared declared(String path, Sidecar.Answer answer) {
    LOG.info("agones: the GameServer has {}{}", answer.isOk() ? "" : "no ", path);
    return answer.isOk() ? Declared.YES : Declared.NO;
  }

  /** Tells how many rooms are in use. How many a server is meant to carry is the operator's. */
  private void tellRooms(AgonesSubject server) throws IOException {
    if (rooms == Declared.UNKNOWN) {
      Sidecar.Answer answer = sidecar.ask("GET", ROOMS, null);
      Matcher found = CAPACITY.matcher(answer.text());
      capacity = found.find() ? Long.parseLong(found.group(1)) : 0;
      rooms = declared(ROOMS, answer);
    }
    long count = Math.min(capacity, server.roomsInUse());
    if (rooms == Declared.YES && count != toldCount) {
      Sidecar.Answer answer = sidecar.ask("PATCH", ROOMS, "{\"count\":\"" + count + "\"}");
      if (!answer.isOk()) {
        rooms = Declared.UNKNOWN; // its capacity may be another
        throw Sidecar.refusal(ROOMS, answer);
      }
      toldCount = count;
    }
  }

  private void tellPlayers(AgonesSubject server, long nowNs) throws IOException {
    if (players == Declared.UNKNOWN) {
      players = declared(PLAYERS, sidecar.ask("GET", PLAYERS, null));
    }
    if (players == Declared.NO) {
      return;
    }
    Set<String> now = server.players();
    int changes = 0;
    for (String name : Set.copyOf(toldPlayers)) {
      if (!now.contains(name) && changes++ < MOST_CHANGES) {
        Sidecar.Answer answer = sidecar.ask("POST", PLAYERS + ":removeValue", value(name));
        if (!answer.isOk() && !answer.says("not found")) {
          throw Sidecar.refusal(PLAYERS + ":removeValue", answer);
        }
        toldPlayers.remove(name);
        fullNs = nowNs;
      }
    }
    for (String name : now) {
      if (!toldPlayers.contains(name) && nowNs - fullNs >= 0 && changes++ < MOST_CHANGES) {
        Sidecar.Answer answer = sidecar.ask("POST", PLAYERS + ":addValue", value(name));
        if (answer.says("out of range")) {
          fullNs = nowNs + ns(pace.look());
          return; // the list is full; its capacity is the operator's
        }
        if (!answer.isOk() && !answer.says("already exists")) {
          throw Sidecar.refusal(PLAYERS + ":addValue", answer);
        }
        toldPlayers.add(name);
      }
    }
  }

  private static String value(String name) {
    return "{\"value\":\""
        + new String(JsonStringEncoder.getInstance().quoteAsString(name))
        + "\"}";
  }

  /** Tells Agones that the GameServer may be deleted, and ends; at the very end of the server. */
  @Override
  public void close() {
    closed = true;
    thread.interrupt();
    watch.close();
    synchronized (news) {
      if (told == Told.SHUTDOWN || subject == null) {
        return; // Agones knows, or the server never began
      }
    }
    for (int i = 0; i < 2; i++) {
      try {
        sidecar.tell("POST", Told.SHUTDOWN.path, EMPTY);
        LOG.info("agones: told {}", Told.SHUTDOWN.path);
        return;
      } catch (IOException e) {
        LOG.warn("agones: {}", e.getMessage());
      }
    }
  }
}
