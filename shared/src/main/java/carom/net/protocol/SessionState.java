package carom.net.protocol;

/**
 * A session's life, as the server sees it. The legal transitions are those of the table in {@code
 * docs/PROTOCOL.md}; a test holds the two against each other.
 */
public enum SessionState {
  /** The link is open; the server waits for {@code Hello}. */
  CONNECTED,
  /** {@code Welcome} was sent; the client fetches the level. */
  LOADING,
  /** The client said {@code Ready}: it has a body, sends inputs, receives snapshots. */
  PLAYING,
  /** The link was lost; body and session secret are kept for the grace period. */
  GRACE,
  /** The end. */
  CLOSED;

  /** Whether {@code next} may follow this state directly. */
  public boolean canBecome(SessionState next) {
    return switch (this) {
      case CONNECTED -> next == LOADING || next == CLOSED;
      case LOADING -> next == PLAYING || next == CLOSED;
      case PLAYING -> next == GRACE || next == CLOSED;
      case GRACE -> next == PLAYING || next == CLOSED;
      case CLOSED -> false;
    };
  }

  /**
   * Returns {@code next} when it may follow.
   *
   * @throws IllegalStateException when it may not; a bug of the caller, never something a client
   *     can cause
   */
  public SessionState become(SessionState next) {
    if (!canBecome(next)) {
      throw new IllegalStateException("session state " + this + " can't become " + next);
    }
    return next;
  }
}
