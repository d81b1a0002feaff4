package carom.client.link;

/**
 * Decides when to try to come back after a link was lost: soon at first, then ever later, and for a
 * minute and a half at most. One connection's; one thread.
 */
final class ReconnectTimer {
  private static final long MS = 1_000_000L;
  private static final long FIRST_WAIT_NS = 250 * MS;
  private static final long STANDBY_WAIT_NS = 1_000 * MS;
  private static final long LONGEST_WAIT_NS = 4_000 * MS;
  private static final long GIVE_UP_NS = 90_000 * MS;

  /** Time for which a first connection is tried, where a player waits for it. */
  private static final long GIVE_UP_FIRST_NS = 30_000 * MS;

  private boolean running;
  private boolean wasIn;
  private long lostNs;
  private long nextAttemptNs;
  private long waitNs = FIRST_WAIT_NS;
  private int attempts;

  /**
   * Starts the time within which the client must come back, or come in.
   *
   * @param fromGame whether it was in the game
   */
  void start(long nowNs, boolean fromGame) {
    running = true;
    wasIn = fromGame;
    lostNs = nowNs;
    attempts = fromGame ? 0 : 1;
    waitNs = FIRST_WAIT_NS;
  }

  /** Stops: the client is back. */
  void stop() {
    running = false;
    attempts = 0;
    waitNs = FIRST_WAIT_NS;
  }

  /** Returns whether the client tries again to come back or to come in. */
  boolean isRunning() {
    return running;
  }

  /** Returns whether the client was playing and tries to come back. */
  boolean isComingBack() {
    return running && wasIn;
  }

  /**
   * Sets the time of the next attempt, and doubles the wait for the one after it. In a fleet, each
   * server is tried at once, before any is tried again.
   *
   * @param servers the number of servers that are tried in turn, 0 outside a fleet
   * @param standby whether one of them speaks by itself if it can; it is given a moment
   */
  void scheduleAttempt(long nowNs, int servers, boolean standby) {
    if (attempts < servers) {
      nextAttemptNs = nowNs + (standby && attempts == 0 ? STANDBY_WAIT_NS : 0);
      return;
    }
    nextAttemptNs = nowNs + waitNs;
    waitNs = Math.min(LONGEST_WAIT_NS, waitNs * 2);
  }

  /** Notes that an attempt begins. */
  void attempt() {
    attempts++;
  }

  /** Returns whether the next attempt is due. */
  boolean isDue(long nowNs) {
    return nowNs >= nextAttemptNs;
  }

  /** Returns whether the client has tried for long enough. */
  boolean isOver(long nowNs) {
    return nowNs - lostNs > (wasIn ? GIVE_UP_NS : GIVE_UP_FIRST_NS);
  }

  /** Returns how many attempts there were since the start. */
  int attempts() {
    return attempts;
  }
}
