package carom.server.session;

import carom.net.protocol.SessionState;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Requests of newcomers for seats of a full room. A seat is given up by the player that lost the
 * connection first, or else by the one that has been idle for longest. The room's thread, but for
 * {@link #ask}.
 */
public final class SeatRequests {
  private final Counters counters;
  private final Seats seats;
  private final long idleTicks;
  private final AtomicInteger open = new AtomicInteger();

  /**
   * Creates an object without requests.
   *
   * @param idleTicks ticks without another input after which a player counts as idle; 0 for never
   */
  public SeatRequests(Counters counters, Seats seats, long idleTicks) {
    this.counters = counters;
    this.seats = seats;
    this.idleTicks = idleTicks;
  }

  /** Asks for a seat, from any thread. Returns false when nobody would give one up. */
  public boolean ask() {
    long willing = counters.get(Counter.PLAYERS_IN_GRACE) + counters.get(Counter.PLAYERS_IDLE);
    if (willing > open.get()) {
      open.incrementAndGet();
    }
    return willing > 0;
  }

  /** Notes that a player has given up a seat. */
  public void served() {
    open.decrementAndGet();
  }

  /** Returns the session that gives up its seat next, or null. It also counts who is idle. */
  public Session next(Session[] sessions) {
    Session lost = null;
    Session idle = null;
    int idleCount = 0;
    for (Session session : sessions) {
      if (session == null || seats.isClaimed(session.seat())) {
        continue;
      }
      if (session.state() == SessionState.GRACE
          && (lost == null || session.graceEndNs() - lost.graceEndNs() < 0)) {
        lost = session;
      } else if (isIdle(session)) {
        idleCount++;
        idle = idle == null || session.idleTicks() > idle.idleTicks() ? session : idle;
      }
    }
    counters.set(Counter.PLAYERS_IDLE, idleCount);
    Session first = lost != null ? lost : idle;
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
