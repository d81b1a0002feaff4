package carom.net.protocol;

/**
 * Why a session that was playing ended. The order is part of the protocol; new reasons go to the
 * end.
 */
public enum GoodbyeReason {
  /** The player left. */
  LEFT("You left the game.", false),
  /** The server stops, or restarts. */
  SERVER_STOPPING("The server is shutting down.", true),
  /** Nothing was heard of the client for too long. */
  TIMEOUT("The connection to the server was lost.", true),
  /** The operator removed the player. */
  KICKED("The operator removed you from the game.", false),
  /** Another connection resumed this session. */
  RESUMED_ELSEWHERE("You continued this game from another connection.", false),
  /** The client broke the protocol. */
  PROTOCOL_ERROR("The server closed the connection because of data it couldn't understand.", false),
  /** An error in the server or its game. */
  SERVER_ERROR("The server had to stop the game because of an error.", true);

  private final String playerText;
  private final boolean retryUseful;

  GoodbyeReason(String playerText, boolean retryUseful) {
    this.playerText = playerText;
    this.retryUseful = retryUseful;
  }

  /** One sentence for the player's screen. */
  public String playerText() {
    return playerText;
  }

  /** Whether a client should try to come back by itself. */
  public boolean retryUseful() {
    return retryUseful;
  }
}
