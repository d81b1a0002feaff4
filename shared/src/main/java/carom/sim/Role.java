package carom.sim;

/** The purpose of a simulation: to decide or to predict. */
public enum Role {
  /** A server's simulation. It creates entities, moves balls back and keeps the score. */
  AUTHORITY,

  /**
   * A client's simulation. It moves the player's own body at once, and the server corrects it. It
   * mirrors the server's entities under their ids, and never creates, destroys or scores by itself.
   */
  PREDICTION
}
