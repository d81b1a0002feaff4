package carom.sim;

/** What a simulation is for: to decide, or to foresee. */
public enum Role {
  /** The server's simulation. It creates entities, moves balls back, keeps the score. */
  AUTHORITY,

  /**
   * A client's simulation. It moves the player's own body at once and is corrected by the server.
   * It mirrors the server's entities under their ids and never creates, destroys or scores by
   * itself.
   */
  PREDICTION
}
