package carom.sim;

import carom.sim.entity.EntityTable;
import carom.sim.entity.HostEntity;
import carom.sim.entity.PlayerTable;
import carom.sim.field.FieldValues;

/** The fields of a match, its players and its entities together. Allocates for names only. */
final class AllFields {
  private final FieldValues match;
  private final EntityTable entities;
  private final PlayerTable players;

  /** Creates the view of a match's fields and those of its entities and players. */
  public AllFields(FieldValues match, EntityTable entities) {
    this.match = match;
    this.entities = entities;
    players = entities.players();
  }

  /** Sets all fields that mean a player who left to null. */
  public void forgetPlayer(int playerId) {
    match.forget(playerId);
    for (int i = 0; i < players.limit(); i++) {
      if (players.participant(i) != null) {
        players.participant(i).fieldValues().forget(playerId);
      }
    }
    for (int i = 0; i < entities.capacity(); i++) {
      if (entities.get(i) != null) {
        entities.get(i).fieldValues().forget(playerId);
      }
    }
  }

  /**
   * Makes all fields that mean an entity mean another.
   *
   * @param word of {@link carom.sim.field.EntityRef#word}
   * @param by the word of the other
   */
  public void replaceEntity(int word, int by) {
    match.replaceEntity(word, by);
    for (int i = 0; i < players.limit(); i++) {
      if (players.get(i) != null) {
        players.get(i).fieldValues().replaceEntity(word, by);
      }
    }
    for (int i = 0; i < entities.capacity(); i++) {
      if (entities.get(i) != null) {
        entities.get(i).fieldValues().replaceEntity(word, by);
      }
    }
  }

  /** Returns the id of the player whose, or whose entity's, values are; negative for others. */
  public int playerOf(FieldValues values) {
    for (int i = 0; i < players.limit(); i++) {
      if (players.get(i) != null && players.get(i).fieldValues() == values) {
        return i;
      }
    }
    for (int i = 0; i < entities.capacity(); i++) {
      if (entities.get(i) != null && entities.get(i).fieldValues() == values) {
        return entities.get(i).ownerId();
      }
    }
    return HostEntity.NO_OWNER;
  }

  /** Names what has values, for messages to people: a player, an entity or the match. */
  public String nameOf(FieldValues values) {
    for (int i = 0; i < players.limit(); i++) {
      if (players.get(i) != null && players.get(i).fieldValues() == values) {
        return "player " + i;
      }
    }
    for (int i = 0; i < entities.capacity(); i++) {
      if (entities.get(i) != null && entities.get(i).fieldValues() == values) {
        return "entity " + i;
      }
    }
    return values == match ? "the match" : "a player or entity that is gone";
  }
}
