package carom.sim.message;

/** What a client that has a seat does in the game. */
public enum PlayerRole {
  /** Plays: the game gives it a body. */
  PLAYER,
  /** Watches, without a body. The game doesn't see it among the players. */
  SPECTATOR
}
