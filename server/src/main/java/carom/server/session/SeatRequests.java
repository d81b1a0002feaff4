package carom.server.session;

import carom.net.admission.AddressGroup;
import carom.net.protocol.SessionState;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;

/**
 * Requests of newcomers for seats of a full room. A seat is given up by a bot, or else by the
 * player that lost the connection first, or else by the one that has been idle for longest, or else
 * by one whose network holds more than its share. A player that has just lost the connection has a
 * moment to come back: {@value #LONGEST_WAIT_MS} ms or a third of the grace period, whichever is
 * shorter. Without it, a full server would give everybody's seats away after a crash. A crowd has
 * no such moment. The room's thread, but for {@link #ask}.
 */
public final class SeatRequests {
  private static final long LONGEST_WAIT_MS = 10_000;
  private static final long NS_PER_MS = 1_000_000;

  private final Counters counters;
  private final Seats seats;
  private final long idleTicks;
  private final long shortestLeftNs; // of its grace period, when a lost player gives way
  private final int networkSharePercent;
  private final AtomicInteger open = new AtomicInteger();

  /**
   * Seats that nobody plays in and that no link claims: nobody waits for a seat that is claimed.
   */
  private volatile int willing;

  private final AtomicReference<Seats.Seat> crowding = new AtomicReference<>();

  /**
   * Creates an object without requests.
   *
   * @param config says how long a lost player is waited for, when a player counts as idle, and a
   *     network's share
   */
  public SeatRequests(Counters counters, Seats seats, ServerConfig config) {
    this.counters = counters;
    this.seats = seats;
    shortestLeftNs =
        (config.graceMs() - Math.min(LONGEST_WAIT_MS, config.graceMs() / 3)) * NS_PER_MS;
    idleTicks = (long) config.get(ServerConfig.IDLE_KICK) * config.get(ServerConfig.TICK_RATE);
    networkSharePercent = config.get(ServerConfig.NETWORK_SHARE);
  }

  /**
   * Asks for a seat, from any thread. Returns false when no seat would be given up.
   *
   * @param account the newcomer's account, or empty
   * @param origin where the newcomer comes from
   */
  public boolean ask(String account, AddressGroup origin) {
    int count = willing;
    if (count > open.get()) {
      open.incrementAndGet();
    }
    return count > 0 || askCrowd(account, origin);
  }

  private boolean askCrowd(String account, AddressGroup origin) {
    SeatShares shares = new SeatShares(seats.count(), networkSharePercent);
    Seats.Seat seat = seats.givesWay(shares, account, origin);
    return seat != null && (crowding.compareAndSet(null, seat) || crowding.get() != null);
  }

  /**
   * Returns the session that gives up its seat because its network holds more than its share, or
   * null. Each request is returned once.
   */
  public Session takeCrowding(Session[] sessions) {
    Seats.Seat seat = crowding.get();
    if (seat == null) {
      return null;
    }
    crowding.set(null);
    Session session = sessions[seat.id()];
    boolean gives = session != null && session.seat() == seat && !seats.isClaimed(seat);
    return gives ? session : null;
  }

  /** Notes that a player has given up a seat. */
  public void served() {
    open.decrementAndGet();
  }

  /**
   * Returns the session that gives up its seat next, or null. It also counts who is idle.
   *
   * @param sessions in order of arrival; of several bots, the last gives way
   * @param nowNs monotonic time
   */
  public Session next(List<Session> sessions, long nowNs) {
    Session bot = null;
    Session lost = null;
    Session idle = null;
    int botCount = 0;
    int idleCount = 0;
    int lostCount = 0;
    for (int i = 0; i < sessions.size(); i++) { // a room has 1,024 seats, and most are empty
      Session session = sessions.get(i);
      if (seats.isClaimed(session.seat())) {
        continue;
      }
      if (session.seat().isBots()) {
        botCount++;
        bot = session;
      } else if (session.state() == SessionState.GRACE || session.isStandIn()) {
        if (session.graceEndNs() - nowNs <= shortestLeftNs) {
          lostCount++;
          lost = lost == null || session.graceEndNs() - lost.graceEndNs() < 0 ? session : lost;
        }
      } else if (isIdle(session)) {
        idleCount++;
        idle = idle == null || session.idleTicks() > idle.idleTicks() ? session : idle;
      }
    }
    counters.set(Counter.PLAYERS_IDLE, idleCount);
    willing = botCount + lostCount + idleCount; // one thread writes it
    Session first = bot != null ? bot : lost != null ? lost : idle;
    if (first == null) {
      open.set(0);
    }
    return open.get() > 0 ? first : null;
  }

  private boolean isIdle(Session session) {
    return idleTicks > 0
        && session.state() == SessionState.PLAYING
        && session.idleTicks() >= idleTicks;
  }
}
