package carom.sim.near;

import carom.physics.rows.FieldRow;
import carom.physics.rows.RowKind;
import carom.physics.rows.Rows;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.field.Field;
import carom.sim.field.FieldValues;
import carom.sim.field.Schema;
import carom.sim.field.Scope;

/**
 * Turns the fields of entities and of the players whose bodies they are into exact rows, and back.
 * Words that the viewer may not know are left out on both sides. One thread; allocates for the
 * first schema and to grow.
 */
final class FieldRows {
  /** The first chunk of the words of a player; those of an entity come before. */
  private static final int OF_PLAYER = Scope.ENTITY.mostWords() / FieldRow.WORD_INTS;

  /** The words of a scope that players are told: how many, and which all near know. */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  private record Words(int count, boolean[] shared) {
    static Words of(Schema schema, Scope scope) {
      int told = schema.toldWords(scope);
      Words words = new Words(told, new boolean[told]);
      for (int i = 0; i < told; i++) {
        words.shared[i] = schema.isShared(scope, i);
      }
      return words;
    }
  }

  private final int viewer;
  private final int[] row = new int[FieldRow.INTS];
  private Schema schema;
  private Words ofEntity;
  private Words ofPlayer;

  /**
   * Creates a converter.
   *
   * @param viewer id of the player whose client predicts; negative for one that knows all words
   *     that any player is told
   */
  FieldRows(int viewer) {
    this.viewer = viewer;
  }

  private void use(Schema of) {
    if (of != schema) {
      schema = of;
      ofEntity = Words.of(of, Scope.ENTITY);
      ofPlayer = Words.of(of, Scope.PLAYER);
    }
  }

  /**
   * Adds the rows of an entity and, if it is the body of its owner, of that player. The viewer's
   * own words are in its own section instead.
   */
  void read(Schema of, int place, HostEntity entity, HostPlayer owner, Rows to) {
    use(of);
    row[FieldRow.PLACE] = place;
    read(entity.fieldValues(), ofEntity, 0, entity.ownerId(), to);
    if (owner != null && owner.entity() == entity && owner.id() != viewer) {
      read(owner.fieldValues(), ofPlayer, OF_PLAYER, owner.id(), to);
    }
  }

  private void read(FieldValues values, Words words, int firstChunk, int owner, Rows to) {
    if (values.stamp() == 0) {
      return; // as at the start
    }
    boolean all = knowsAll(owner);
    for (int from = 0; from < words.count; from += FieldRow.WORD_INTS) {
      int any = 0;
      for (int i = 0; i < FieldRow.WORD_INTS; i++) {
        int word = from + i;
        boolean known = word < words.count && (all || words.shared[word]);
        int difference = known ? values.word(word) - values.start(word) : 0;
        row[FieldRow.WORDS + i] = difference;
        any |= difference;
      }
      if (any != 0) {
        row[FieldRow.CHUNK] = firstChunk + from / FieldRow.WORD_INTS;
        to.add(RowKind.FIELDS, row, 0);
      }
    }
  }

  private boolean knowsAll(int owner) {
    return viewer < 0 || owner == viewer;
  }

  /** Makes all words of another player that the viewer knows what they are at the start. */
  void reset(Schema of, HostPlayer player) {
    use(of);
    for (int word = 0; player.id() != viewer && word < ofPlayer.count; word++) {
      if (viewer < 0 || ofPlayer.shared[word]) {
        player.fieldValues().mirror(word, player.fieldValues().start(word));
      }
    }
  }

  /**
   * Sets the words of a row. Those that a field can't hold, and those beyond the last, are passed
   * over.
   *
   * @param from holds the row, which may come from anywhere
   * @param at where it begins
   * @param owner the player whose body the entity is, or null
   */
  void write(Schema of, int[] from, int at, HostEntity entity, HostPlayer owner) {
    use(of);
    int chunk = from[at + FieldRow.CHUNK];
    boolean isOfPlayer = chunk >= OF_PLAYER;
    if (isOfPlayer && (owner == null || owner.id() == viewer)) {
      return;
    }
    Scope scope = isOfPlayer ? Scope.PLAYER : Scope.ENTITY;
    Words words = isOfPlayer ? ofPlayer : ofEntity;
    FieldValues values = isOfPlayer ? owner.fieldValues() : entity.fieldValues();
    int first = (isOfPlayer ? chunk - OF_PLAYER : chunk) * FieldRow.WORD_INTS;
    for (int i = 0; i < FieldRow.WORD_INTS && first + i < words.count; i++) {
      int value = values.start(first + i) + from[at + FieldRow.WORDS + i];
      Field<?> field = of.field(scope, first + i);
      if (value >= field.min() && value <= field.max()) {
        values.mirror(first + i, value);
      }
    }
  }
}
