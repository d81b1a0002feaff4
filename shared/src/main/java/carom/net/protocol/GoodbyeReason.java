package carom.net.protocol;

/**
 * Reason for the end of a session that was playing. The order is part of the protocol, so new
 * reasons go to the end.
 */
public enum GoodbyeReason {
  /** The player left. */
  LEFT("You left the game.", false),
  /** The server stops or restarts. */
  SERVER_STOPPING("The server is shutting down.", true),
  /** The server received nothing from the client for too long. */
  TIMEOUT("The server heard nothing from you for too long.", true),
  /** The operator removed the player. */
  KICKED("The operator removed you from the game.", false),
  /** Another connection resumed this session. */
  RESUMED_ELSEWHERE("You continued this game from another connection.", false),
  /** The client broke the protocol. */
  PROTOCOL_ERROR("The server closed the connection because of data it couldn't understand.", false),
  /** The server or its game had an error. */
  SERVER_ERROR("The server had to stop the game because of an error.", true),
  /** The player did nothing, and a newcomer took the seat. */
  IDLE("You did nothing for a while, and the place was needed.", false),
  /** The room is full, and a newcomer of another network took the seat. */
  CROWDED(
      "The room is full, and your network held more than its share of the places. A newcomer from"
          + " elsewhere took yours.",
      false),
  /** The operator closed the room, and no other one has a seat. */
  ROOM_CLOSED("The operator closed this room, and the others are full.", true);

  private final String playerText;
  private final boolean retryUseful;

  GoodbyeReason(String playerText, boolean retryUseful) {
    this.playerText = playerText;
    this.retryUseful = retryUseful;
  }

  /** Returns one sentence for the player's screen. */
  public String playerText() {
    return playerText;
  }

  /** Returns whether a client should try to come back by itself. */
  public boolean retryUseful() {
    return retryUseful;
  }
}
