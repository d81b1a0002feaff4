package carom.net.protocol;

/**
 * Reason why the server did not admit a client. The order is part of the protocol, so new reasons
 * go to the end.
 */
public enum RefusalReason {
  /** Client and server speak different versions of the protocol. */
  PROTOCOL_VERSION(
      "This game and the server have different versions. Update the older one.", false),
  /** Client and server would compute different physics. */
  PHYSICS_VERSION(
      "This game and the server compute physics differently. Use the same release on both.", false),
  /** The server has no free place for a player. */
  SERVER_FULL("The server is full. Try again in a moment.", true),
  /** The name breaks {@link PlayerName}. */
  NAME_INVALID("The server can't show this name. Choose another one.", false),
  /** The client sent something other than a handshake, or sent it in the wrong state. */
  BAD_REQUEST("The server didn't understand this game. Is it a Carom server?", false),
  /** The client's address has too many connections. */
  TOO_MANY_CONNECTIONS("Too many players connect from your address.", true),
  /** The server stops. */
  SHUTTING_DOWN("The server is shutting down.", true),
  /** The handshake took too long. */
  TOO_SLOW("Joining took too long. Check your connection and try again.", true),
  /** The client's game has other fields. */
  GAME_VERSION("The server plays another version of this game. Use the same build.", false),
  /** The client asked for a room that the server doesn't have. */
  ROOM_UNKNOWN("The server has no such room. Choose another one.", false),
  /** The room that the client asked for has no free place. */
  ROOM_FULL("The room is full. Choose another one or try again in a moment.", true),
  /** The operator has banned the player's name or address. */
  BANNED("You are banned from this server.", false),
  /** The player isn't on the operator's list of those who may play. */
  NOT_ALLOWED("This server is only for invited players.", false),
  /** The client asked to watch, and the server has no spectators. */
  NOT_SHOWN("This server shows its games to nobody.", false),
  /** The operator's backend decides who may join, and the join token doesn't let this player in. */
  TOKEN_INVALID("This server lets in only players that its site sends.", false),
  /** The server is too busy for more players. */
  OVERLOADED("This server is too busy for more players.", true),
  /** The operator demands a password, and the client showed none or a wrong one. */
  PASSWORD_WRONG("This server asks for a password.", false),
  /** The servers of a fleet don't know at this moment who has the client's place. */
  FLEET_UNSETTLED("The servers are changing places. Try again in a moment.", true);

  private final String playerText;
  private final boolean retryUseful;

  RefusalReason(String playerText, boolean retryUseful) {
    this.playerText = playerText;
    this.retryUseful = retryUseful;
  }

  /** Returns one or two sentences for the player's screen. */
  public String playerText() {
    return playerText;
  }

  /** Returns whether the cause may pass in a moment, so that a retry makes sense. */
  public boolean retryUseful() {
    return retryUseful;
  }
}
