package carom.sim.phase;

/**
 * Is told of each change that a game's rules make, and that clients therefore can't compute. It is
 * for tests of games: it is called from within the game's own call, so it can tell the line.
 */
@FunctionalInterface
public interface RuleWatch {
  /**
   * Receives that a rule changes an entity or a field.
   *
   * @param playerId id of the player whose body, other entity or field it is; negative if it is no
   *     player's
   * @param isEntity whether it is an entity that changes, and no field
   */
  void changes(int playerId, boolean isEntity);
}
