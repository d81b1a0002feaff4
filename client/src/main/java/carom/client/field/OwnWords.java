package carom.client.field;

import carom.net.snapshot.exact.OwnState;
import carom.sim.Player;
import carom.sim.field.Field;
import carom.sim.field.FieldValues;
import carom.sim.field.Schema;
import carom.sim.field.Scope;

/** The words of the own section: the own player's memory, then its fields that players are told. */
public final class OwnWords {
  private final Schema schema;
  private final Player player;

  /**
   * Creates the words of a player.
   *
   * @param schema declares the fields
   */
  public OwnWords(Schema schema, Player player) {
    this.schema = schema;
    this.player = player;
  }

  /** Returns the number of words in each own section. */
  public static int count(Schema schema) {
    return Player.MEMORY_SIZE + schema.toldWords(Scope.PLAYER);
  }

  /** Reads the words as predicted. */
  public void read(OwnState out) {
    for (int i = 0; i < Player.MEMORY_SIZE; i++) {
      out.setWord(i, player.memory()[i]);
    }
    FieldValues values = player.fieldValues();
    for (int i = Player.MEMORY_SIZE; i < out.words(); i++) {
      out.setWord(i, values.word(i - Player.MEMORY_SIZE));
    }
  }

  /** Gives the player the server's words. One that its field can't hold is passed over. */
  public void write(OwnState server) {
    for (int i = 0; i < Player.MEMORY_SIZE; i++) {
      player.memory()[i] = server.word(i);
    }
    FieldValues values = player.fieldValues();
    for (int i = Player.MEMORY_SIZE; i < server.words(); i++) {
      int word = i - Player.MEMORY_SIZE;
      Field<?> field = schema.field(Scope.PLAYER, word);
      if (server.word(i) >= field.min() && server.word(i) <= field.max()) {
        values.mirror(word, server.word(i));
      }
    }
  }
}
