package carom.client.link;

import carom.client.view.ClientView;

/** Where a client stands on its way into the game. */
public enum ConnectionPhase {
  /** Nothing was started yet. */
  IDLE,
  /** The link is being opened. */
  CONNECTING,
  /** The link is open; the server has not let us in yet. */
  JOINING,
  /** The level is on its way. */
  LOADING,
  /** In the game. */
  PLAYING,
  /** The link was lost; the client tries to come back by itself. The last picture stays. */
  RECONNECTING,
  /** Over: refused, left, kicked, or out of reach. {@link ClientView#message} says why. */
  ENDED
}
