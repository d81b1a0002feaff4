package carom.client.link;

/** The phases of a client's way into the game. */
public enum ConnectionPhase {
  /** The client hasn't been updated yet. */
  IDLE,
  /** The link is being opened. */
  CONNECTING,
  /** The link is open; the server hasn't answered yet. */
  JOINING,
  /** The level is being downloaded. */
  LOADING,
  /** The client is in the game. */
  PLAYING,
  /** The link was lost and the client tries to come back. The last picture stays. */
  RECONNECTING,
  /** The client was refused or kicked, has left, or can't reach the server. The view says why. */
  ENDED
}
