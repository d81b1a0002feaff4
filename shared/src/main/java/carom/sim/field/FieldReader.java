package carom.sim.field;

/**
 * A holder of fields of a game that may be read: a player, an entity or the match. Reading a value
 * is one load from an array. On a client, values that the player may not know stay as they began.
 *
 * <p>All methods throw {@link IllegalArgumentException} for a field that isn't declared by the game
 * or belongs to another scope. Methods without an index are for fields with one value, those with
 * an index for fields with several ({@link Field#times}). One thread; nothing allocates.
 *
 * @param <E> the class of entities
 * @param <P> the class of players
 */
public interface FieldReader<E extends FieldReader<E, P>, P extends FieldReader<E, P>> {
  /** Returns the values as words, for replication and tools. */
  FieldValues fieldValues();

  /**
   * Returns the word by which fields mean this holder, or 0 if none can.
   *
   * @see EntityRef
   */
  default int reference() {
    return 0;
  }

  /** Returns a whole number, or the ticks left of a {@link Countdown}, 0 when it is over. */
  default int get(IntField<?> field) {
    return getInt(field, fieldValues().word(field));
  }

  /** Returns one of several whole numbers or countdowns. */
  default int get(IntField<?> field, int index) {
    return getInt(field, fieldValues().word(field, index));
  }

  /** Returns a flag. */
  default boolean get(Flag field) {
    return fieldValues().read(fieldValues().word(field)) != 0;
  }

  /** Returns one of several flags. */
  default boolean get(Flag field, int index) {
    return fieldValues().read(fieldValues().word(field, index)) != 0;
  }

  /** Returns a constant. */
  default <T extends Enum<T>> T get(Choice<T> field) {
    return field.decode(fieldValues().read(fieldValues().word(field)));
  }

  /** Returns one of several constants. */
  default <T extends Enum<T>> T get(Choice<T> field, int index) {
    return field.decode(fieldValues().read(fieldValues().word(field, index)));
  }

  /** Returns a number of a {@link Ratio} or a {@link Real}. */
  default float get(FloatField<?> field) {
    return field.decode(fieldValues().read(fieldValues().word(field)));
  }

  /** Returns one of several numbers. */
  default float get(FloatField<?> field, int index) {
    return field.decode(fieldValues().read(fieldValues().word(field, index)));
  }

  /** Returns the entity that a field means, or null if there is none or it is gone. */
  default E get(EntityRef field) {
    return entity(fieldValues().word(field));
  }

  /** Returns one of several entities, see {@link #get(EntityRef)}. */
  default E get(EntityRef field, int index) {
    return entity(fieldValues().word(field, index));
  }

  /** Returns the player that a field means, or null if there is none or the player has left. */
  default P get(PlayerRef field) {
    return player(fieldValues().word(field));
  }

  /** Returns one of several players, see {@link #get(PlayerRef)}. */
  default P get(PlayerRef field, int index) {
    return player(fieldValues().word(field, index));
  }

  private int getInt(IntField<?> field, int word) {
    FieldValues values = fieldValues();
    return field.decode(values.read(word), values.store().tick());
  }

  @SuppressWarnings("unchecked") // the simulation that made the store has entities of this class
  private E entity(int word) {
    FieldValues values = fieldValues();
    int key = values.read(word) - 1;
    return key < 0
        ? null
        : (E) values.store().references().entity(EntityRef.id(key), EntityRef.generation(key));
  }

  @SuppressWarnings("unchecked") // the simulation that made the store has players of this class
  private P player(int word) {
    FieldValues values = fieldValues();
    int key = values.read(word) - 1;
    return key < 0 ? null : (P) values.store().references().player(key);
  }
}
