package carom.server.session;

/**
 * Why one session should end, or lose its link, at the next tick: the player leaves, the client
 * broke the protocol, or the link has closed. Several may be true at once. The room's thread.
 */
public final class Departure {
  private boolean leaves;
  private String offence;
  private boolean linkLost;
  private String linkLostReason = "";

  Departure() {}

  /** Forgets all reasons, because the client has a new link. */
  void begin() {
    leaves = false;
    offence = null;
    linkLost = false;
    linkLostReason = "";
  }

  /** Notes that the player leaves. */
  void leave() {
    leaves = true;
  }

  /** Notes that the client broke the protocol. The first offence counts. */
  void expel(String forOffence) {
    if (offence == null) {
      offence = forOffence;
    }
  }

  /** Notes that the link has closed. */
  void loseLink(String reason) {
    linkLost = true;
    linkLostReason = reason;
  }

  /** Returns whether the player leaves. */
  public boolean leaves() {
    return leaves;
  }

  /** Returns what the client did if it should be expelled, or null. */
  public String offence() {
    return offence;
  }

  /** Returns whether the link has closed. */
  public boolean isLinkLost() {
    return linkLost;
  }

  /** Returns why the link has closed. */
  public String linkLostReason() {
    return linkLostReason;
  }
}
