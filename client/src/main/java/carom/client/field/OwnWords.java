package carom.client.field;

import carom.net.snapshot.exact.OwnState;
import carom.sim.entity.HostPlayer;
import carom.sim.field.Field;
import carom.sim.field.FieldValues;
import carom.sim.field.Schema;
import carom.sim.field.Scope;

/** The words of the own section: those of the own player's fields that players are told. */
public final class OwnWords {
  private final Schema schema;
  private final HostPlayer player;

  /**
   * Creates the words of a player.
   *
   * @param schema declares the fields
   */
  public OwnWords(Schema schema, HostPlayer player) {
    this.schema = schema;
    this.player = player;
  }

  /** Returns the number of words in each own section. */
  public static int count(Schema schema) {
    return schema.toldWords(Scope.PLAYER);
  }

  /** Reads the words as predicted. */
  public void read(OwnState out) {
    FieldValues values = player.fieldValues();
    for (int i = 0; i < out.words(); i++) {
      out.setWord(i, values.word(i));
    }
  }

  /** Gives the player the server's words. One that its field can't hold is passed over. */
  public void write(OwnState server) {
    FieldValues values = player.fieldValues();
    for (int i = 0; i < server.words(); i++) {
      Field<?> field = schema.field(Scope.PLAYER, i);
      if (server.word(i) >= field.min() && server.word(i) <= field.max()) {
        values.mirror(i, server.word(i));
      }
    }
  }
}
