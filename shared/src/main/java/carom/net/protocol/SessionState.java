package carom.net.protocol;

/**
 * State of a session as the server sees it. The table in {@code docs/protocol/SESSIONS.md} lists
 * the legal transitions; a test compares the two.
 */
public enum SessionState {
  /** The link is open; the server waits for {@code Hello}. */
  CONNECTED,
  /**
   * The server has sent {@code Welcome}; the client fetches the level. A player whose room changes
   * its level or game has a body meanwhile.
   */
  LOADING,
  /** The client has sent {@code Ready}. It has a body, sends inputs and receives snapshots. */
  PLAYING,
  /** The link is lost. The server keeps the body and the session secret for the grace period. */
  GRACE,
  /** The session has ended. */
  CLOSED;

  /** Returns whether {@code next} may directly follow this state. */
  public boolean canBecome(SessionState next) {
    return switch (this) {
      case CONNECTED -> next == LOADING || next == CLOSED;
      case LOADING -> next == PLAYING || next == GRACE || next == CLOSED;
      case PLAYING -> next == LOADING || next == GRACE || next == CLOSED;
      case GRACE -> next == PLAYING || next == LOADING || next == CLOSED;
      case CLOSED -> false;
    };
  }

  /**
   * Returns {@code next} if it may follow this state.
   *
   * @throws IllegalStateException when it may not follow; this is a bug of the caller, which no
   *     client can cause
   */
  public SessionState become(SessionState next) {
    if (!canBecome(next)) {
      throw new IllegalStateException("session state " + this + " can't become " + next);
    }
    return next;
  }
}
