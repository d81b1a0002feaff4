package carom.net.protocol;

/**
 * Why the server didn't let a client in. The order is part of the protocol; new reasons go to the
 * end.
 */
public enum RefusalReason {
  /** Client and server speak different versions of the protocol. */
  PROTOCOL_VERSION("This game and the server have different versions. Update the older one."),
  /** Client and server would compute different physics. */
  PHYSICS_VERSION(
      "This game and the server compute physics differently. Use the same release on both."),
  /** No free player slot. */
  SERVER_FULL("The server is full. Try again in a moment."),
  /** The name breaks {@link PlayerName}. */
  NAME_INVALID("The server can't show this name. Choose another one."),
  /** Somebody plays under this name. */
  NAME_TAKEN("Somebody already plays under this name. Choose another one."),
  /** What the client sent was no handshake, or came in the wrong state. */
  BAD_REQUEST("The server didn't understand this game. Is it a Carom server?"),
  /** The same address has too many connections. */
  TOO_MANY_CONNECTIONS("Too many players connect from your address."),
  /** The server stops. */
  SHUTTING_DOWN("The server is shutting down."),
  /** The handshake took too long. */
  TOO_SLOW("Joining took too long. Check your connection and try again.");

  private final String playerText;

  RefusalReason(String playerText) {
    this.playerText = playerText;
  }

  /** One or two sentences for the player's screen. */
  public String playerText() {
    return playerText;
  }
}
