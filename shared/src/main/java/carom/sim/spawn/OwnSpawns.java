package carom.sim.spawn;

/**
 * Tells what a client knows of the entities that its own player's {@code Game.input} spawned. A
 * predicted simulation asks it whenever {@code Game.input} spawns.
 */
public interface OwnSpawns {
  /** Value of {@link #key} of an entity that the server hasn't told. */
  int UNKNOWN = -1;

  /** Returns whether the entities that a player's input spawns are shown before the server's. */
  boolean predicts(int playerId);

  /**
   * Returns what the server calls an entity: {@code id | generation << 16}, or {@link #UNKNOWN}.
   *
   * @param origin the entity's origin
   */
  int key(int origin);
}
