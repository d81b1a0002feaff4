package carom.server.fleet;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;

/**
 * Counts what happens to a server in its fleet, and remembers the last of it for the operator. Any
 * thread.
 */
final class FleetNews {
  /** Most happenings that are remembered. */
  static final int MOST = 50;

  private static final double NS_PER_S = 1e9;
  private static final double[] TAKEOVER_LIMITS_S = {0.025, 0.05, 0.1, 0.25, 0.5, 1, 2.5, 5, 10};

  private final LongSupplier clock;
  private final String self;
  private final Deque<Happening> happenings = new ArrayDeque<>(); // guarded by itself
  private final AtomicLong[] takeovers = new AtomicLong[TAKEOVER_LIMITS_S.length + 1];
  private final AtomicLong takeoverNs = new AtomicLong();

  final AtomicLong claimsWon = new AtomicLong();
  final AtomicLong claimsRefused = new AtomicLong();
  final AtomicLong claimsLost = new AtomicLong();
  final AtomicLong movedIn = new AtomicLong();
  final AtomicLong movedOut = new AtomicLong();
  final AtomicLong deaths = new AtomicLong();

  /**
   * Something that happened.
   *
   * @param atNs when, by the fleet's monotonic clock
   * @param text what, for people
   */
  record Happening(long atNs, String text) {}

  /**
   * Creates news of nothing.
   *
   * @param clock monotonic nanoseconds
   * @param self name of this server
   */
  FleetNews(LongSupplier clock, String self) {
    this.clock = clock;
    this.self = self;
    for (int i = 0; i < takeovers.length; i++) {
      takeovers[i] = new AtomicLong();
    }
  }

  /** Notes something for the operator. */
  void tell(String text) {
    synchronized (happenings) {
      happenings.addFirst(new Happening(clock.getAsLong(), text));
      if (happenings.size() > MOST) {
        happenings.removeLast();
      }
    }
  }

  /** Returns what has happened, the latest first. */
  List<Happening> happenings() {
    synchronized (happenings) {
      return new ArrayList<>(happenings);
    }
  }

  /** Notes that this server lost a room that it owned. */
  void lost(String room, long claim) {
    claimsLost.incrementAndGet();
    tell("lost room " + room + ", claim " + claim);
  }

  /** Notes that a room of this server goes on at another one. */
  void movedOut(String room, String to) {
    movedOut.incrementAndGet();
    tell("moved room " + room + " to " + to);
  }

  /** Notes that a room of another server goes on here, which that one handed over. */
  void movedIn(String room, long claim) {
    movedIn.incrementAndGet();
    tell("room " + room + " moved here, claim " + claim);
  }

  /**
   * Notes that a room of a dead server goes on here.
   *
   * @param tick its present tick
   * @param ns time from the moment when the owner's claim was gone
   */
  void tookOver(String room, long claim, int tick, long ns) {
    int bucket = 0;
    while (bucket < TAKEOVER_LIMITS_S.length && ns / NS_PER_S > TAKEOVER_LIMITS_S[bucket]) {
      bucket++;
    }
    takeovers[bucket].incrementAndGet();
    takeoverNs.addAndGet(ns);
    tell(
        String.format(
            Locale.ROOT,
            "took over room %s at tick %d in %d ms, claim %d",
            room,
            tick,
            TimeUnit.NANOSECONDS.toMillis(ns),
            claim));
  }

  /** Notes that a server has come. */
  void came(ServerRecord server) {
    if (!server.name().equals(self)) {
      tell("server " + server.name() + " came");
    }
  }

  /** Notes that a server has gone. */
  void gone(ServerRecord server) {
    if (server.name().equals(self)) {
      return;
    }
    if (server.draining()) {
      tell("server " + server.name() + " left");
    } else {
      deaths.incrementAndGet();
      tell("server " + server.name() + " is lost");
    }
  }

  /** Returns the time that takeovers took, as a histogram. */
  FleetFigures.Durations takeovers() {
    List<Double> limits = new ArrayList<>();
    List<Long> counts = new ArrayList<>();
    for (int i = 0; i < takeovers.length; i++) {
      limits.add(i < TAKEOVER_LIMITS_S.length ? TAKEOVER_LIMITS_S[i] : Double.POSITIVE_INFINITY);
      counts.add(takeovers[i].get());
    }
    return new FleetFigures.Durations(limits, counts, takeoverNs.get() / NS_PER_S);
  }
}
