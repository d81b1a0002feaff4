package carom.net.protocol;

/**
 * Why the server didn't let a client in. The order is part of the protocol; new reasons go to the
 * end.
 */
public enum RefusalReason {
  /** Client and server speak different versions of the protocol. */
  PROTOCOL_VERSION(
      "This game and the server have different versions. Update the older one.", false),
  /** Client and server would compute different physics. */
  PHYSICS_VERSION(
      "This game and the server compute physics differently. Use the same release on both.", false),
  /** No free player slot. */
  SERVER_FULL("The server is full. Try again in a moment.", true),
  /** The name breaks {@link PlayerName}. */
  NAME_INVALID("The server can't show this name. Choose another one.", false),
  /** What the client sent was no handshake, or came in the wrong state. */
  BAD_REQUEST("The server didn't understand this game. Is it a Carom server?", false),
  /** The same address has too many connections. */
  TOO_MANY_CONNECTIONS("Too many players connect from your address.", true),
  /** The server stops. */
  SHUTTING_DOWN("The server is shutting down.", true),
  /** The handshake took too long. */
  TOO_SLOW("Joining took too long. Check your connection and try again.", true);

  private final String playerText;
  private final boolean retryUseful;

  RefusalReason(String playerText, boolean retryUseful) {
    this.playerText = playerText;
    this.retryUseful = retryUseful;
  }

  /** One or two sentences for the player's screen. */
  public String playerText() {
    return playerText;
  }

  /** Whether it may be over in a moment, so that trying again makes sense. */
  public boolean retryUseful() {
    return retryUseful;
  }
}
