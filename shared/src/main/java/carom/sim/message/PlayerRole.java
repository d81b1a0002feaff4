package carom.sim.message;

/** The role in the game of a client that has a seat. */
public enum PlayerRole {
  /** Plays: the game gives it a body. */
  PLAYER,
  /** Watches, without a body. The game doesn't see it among the players. */
  SPECTATOR
}
