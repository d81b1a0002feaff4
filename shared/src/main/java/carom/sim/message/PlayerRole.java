package carom.sim.message;

/** The role in the game of a client that has a seat. */
public enum PlayerRole {
  /** The participant plays: the game gives it a body. */
  PLAYER,
  /** The participant watches, without a body. The game doesn't see it among the players. */
  SPECTATOR
}
