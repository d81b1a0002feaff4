package carom.sim.field;

/**
 * A player, an entity or the match: what has values of a game's fields. Reading a value is one load
 * from an array. On a client, values that the player may not know stay as they began, and writes
 * that it can't predict are dropped, see {@link FieldStore}.
 *
 * <p>All methods throw {@link IllegalArgumentException} for a field that isn't declared by the game
 * or belongs to another scope. Methods without an index are for fields with one value, those with
 * an index for fields with several ({@link Field#times}). One thread; nothing allocates.
 *
 * @param <E> the class of entities
 * @param <P> the class of players
 */
public abstract class FieldHolder<E extends FieldHolder<E, P>, P extends FieldHolder<E, P>> {
  /** Creates a holder. */
  protected FieldHolder() {}

  /** Returns the values as words, for replication and tools. */
  public abstract FieldValues fieldValues();

  /**
   * Returns the word by which fields mean this holder, or 0 if none can.
   *
   * @see EntityRef
   */
  protected int reference() {
    return 0;
  }

  /** Returns a whole number, or the ticks left of a {@link Countdown}, 0 when it is over. */
  public final int get(IntField<?> field) {
    return getInt(field, word(field));
  }

  /** Returns one of several whole numbers or countdowns. */
  public final int get(IntField<?> field, int index) {
    return getInt(field, word(field, index));
  }

  /**
   * Sets a whole number, or the ticks left of a {@link Countdown}.
   *
   * @throws IllegalArgumentException if the value is outside the field's range; {@link #add} stops
   *     at the limits
   */
  public final void set(IntField<?> field, int value) {
    setInt(field, word(field), value);
  }

  /** Sets one of several whole numbers or countdowns, see {@link #set(IntField, int)}. */
  public final void set(IntField<?> field, int index, int value) {
    setInt(field, word(field, index), value);
  }

  /**
   * Adds to a whole number. The sum stops at the limits of the field.
   *
   * @param change may be negative
   */
  public final void add(IntField<?> field, int change) {
    addInt(field, word(field), change);
  }

  /** Adds to one of several whole numbers, see {@link #add(IntField, int)}. */
  public final void add(IntField<?> field, int index, int change) {
    addInt(field, word(field, index), change);
  }

  /** Returns a flag. */
  public final boolean get(Flag field) {
    return fieldValues().read(word(field)) != 0;
  }

  /** Returns one of several flags. */
  public final boolean get(Flag field, int index) {
    return fieldValues().read(word(field, index)) != 0;
  }

  /** Sets a flag. */
  public final void set(Flag field, boolean value) {
    fieldValues().write(word(field), value ? 1 : 0);
  }

  /** Sets one of several flags. */
  public final void set(Flag field, int index, boolean value) {
    fieldValues().write(word(field, index), value ? 1 : 0);
  }

  /** Returns a constant. */
  public final <T extends Enum<T>> T get(Choice<T> field) {
    return field.decode(fieldValues().read(word(field)));
  }

  /** Returns one of several constants. */
  public final <T extends Enum<T>> T get(Choice<T> field, int index) {
    return field.decode(fieldValues().read(word(field, index)));
  }

  /** Sets a constant. */
  public final <T extends Enum<T>> void set(Choice<T> field, T value) {
    fieldValues().write(word(field), value.ordinal());
  }

  /** Sets one of several constants. */
  public final <T extends Enum<T>> void set(Choice<T> field, int index, T value) {
    fieldValues().write(word(field, index), value.ordinal());
  }

  /** Returns a number of a {@link Ratio} or a {@link Real}. */
  public final float get(FloatField<?> field) {
    return field.decode(fieldValues().read(word(field)));
  }

  /** Returns one of several numbers. */
  public final float get(FloatField<?> field, int index) {
    return field.decode(fieldValues().read(word(field, index)));
  }

  /**
   * Sets a number of a {@link Ratio} or a {@link Real}. A ratio is rounded to its nearest step.
   *
   * @throws IllegalArgumentException if the value is NaN or outside the field's range; {@link #add}
   *     stops at the limits
   */
  public final void set(FloatField<?> field, float value) {
    fieldValues().write(word(field), field.encode(value));
  }

  /** Sets one of several numbers, see {@link #set(FloatField, float)}. */
  public final void set(FloatField<?> field, int index, float value) {
    fieldValues().write(word(field, index), field.encode(value));
  }

  /**
   * Adds to a number. The sum stops at the limits of the field. For a {@link Ratio} the change is
   * rounded to whole steps first.
   *
   * @param change may be negative
   */
  public final void add(FloatField<?> field, float change) {
    addFloat(field, word(field), change);
  }

  /** Adds to one of several numbers, see {@link #add(FloatField, float)}. */
  public final void add(FloatField<?> field, int index, float change) {
    addFloat(field, word(field, index), change);
  }

  /** Returns the entity that a field means, or null if there is none or it is gone. */
  public final E get(EntityRef field) {
    return entity(word(field));
  }

  /** Returns one of several entities, see {@link #get(EntityRef)}. */
  public final E get(EntityRef field, int index) {
    return entity(word(field, index));
  }

  /**
   * Sets the entity that a field means.
   *
   * @param entity null for none
   * @throws IllegalArgumentException if the entity is static level geometry
   */
  public final void set(EntityRef field, E entity) {
    fieldValues().write(word(field), reference(field, entity));
  }

  /** Sets one of several entities, see {@link #set(EntityRef, FieldHolder)}. */
  public final void set(EntityRef field, int index, E entity) {
    fieldValues().write(word(field, index), reference(field, entity));
  }

  /** Returns the player that a field means, or null if there is none or the player has left. */
  public final P get(PlayerRef field) {
    return player(word(field));
  }

  /** Returns one of several players, see {@link #get(PlayerRef)}. */
  public final P get(PlayerRef field, int index) {
    return player(word(field, index));
  }

  /**
   * Sets the player that a field means.
   *
   * @param player null for nobody
   */
  public final void set(PlayerRef field, P player) {
    fieldValues().write(word(field), reference(field, player));
  }

  /** Sets one of several players, see {@link #set(PlayerRef, FieldHolder)}. */
  public final void set(PlayerRef field, int index, P player) {
    fieldValues().write(word(field, index), reference(field, player));
  }

  /** Sets all fields to their start values. */
  public final void resetFields() {
    fieldValues().reset();
  }

  private int word(Field<?> field) {
    FieldValues values = fieldValues();
    return values.store().schema().word(field, values.scope());
  }

  private int word(Field<?> field, int index) {
    FieldValues values = fieldValues();
    return values.store().schema().word(field, values.scope(), index);
  }

  private int getInt(IntField<?> field, int word) {
    FieldValues values = fieldValues();
    return field.decode(values.read(word), values.store().tick());
  }

  private void setInt(IntField<?> field, int word, int value) {
    FieldValues values = fieldValues();
    values.write(word, field.encode(value, values.store().tick()));
  }

  private void addInt(IntField<?> field, int word, int change) {
    FieldValues values = fieldValues();
    int value = field.decode(values.readToAdd(word), values.store().tick());
    setInt(field, word, field.clamp((long) value + change));
  }

  private void addFloat(FloatField<?> field, int word, float change) {
    FieldValues values = fieldValues();
    values.write(word, field.add(values.readToAdd(word), change));
  }

  private static int reference(Field<?> field, FieldHolder<?, ?> target) {
    int word = target == null ? 0 : target.reference();
    if (target != null && word == 0) {
      throw new IllegalArgumentException(
          field.path() + " can't mean " + target + ", which is level geometry");
    }
    return word;
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
