package carom.sim.field;

import carom.physics.math.Limits;

/**
 * A holder of fields of a game that may be written, too. On a client, writes that it can't predict
 * are dropped, see {@link FieldStore}.
 *
 * @param <E> the class of entities
 * @param <P> the class of players
 */
public interface FieldHolder<E extends FieldReader<E, P>, P extends FieldReader<E, P>>
    extends FieldReader<E, P> {
  /**
   * Sets a whole number, or the ticks left of a {@link Countdown}.
   *
   * @throws IllegalArgumentException if the value is outside the field's range; {@link #add} stops
   *     at the limits
   */
  default void set(IntField<?> field, int value) {
    setInt(field, fieldValues().word(field), value);
  }

  /** Sets one of several whole numbers or countdowns, see {@link #set(IntField, int)}. */
  default void set(IntField<?> field, int index, int value) {
    setInt(field, fieldValues().word(field, index), value);
  }

  /**
   * Adds to a whole number. The sum stops at the limits of the field.
   *
   * @param change may be negative
   */
  default void add(IntField<?> field, int change) {
    addInt(field, fieldValues().word(field), change);
  }

  /** Adds to one of several whole numbers, see {@link #add(IntField, int)}. */
  default void add(IntField<?> field, int index, int change) {
    addInt(field, fieldValues().word(field, index), change);
  }

  /** Sets a flag. */
  default void set(Flag field, boolean value) {
    fieldValues().write(fieldValues().word(field), value ? 1 : 0);
  }

  /** Sets one of several flags. */
  default void set(Flag field, int index, boolean value) {
    fieldValues().write(fieldValues().word(field, index), value ? 1 : 0);
  }

  /** Sets a constant. */
  default <T extends Enum<T>> void set(Choice<T> field, T value) {
    fieldValues().write(fieldValues().word(field), Limits.notNull("value", value).ordinal());
  }

  /** Sets one of several constants. */
  default <T extends Enum<T>> void set(Choice<T> field, int index, T value) {
    fieldValues().write(fieldValues().word(field, index), Limits.notNull("value", value).ordinal());
  }

  /**
   * Sets a number of a {@link Ratio} or a {@link Real}. A ratio is rounded to its nearest step.
   *
   * @throws IllegalArgumentException if the value is NaN or outside the field's range; {@link #add}
   *     stops at the limits
   */
  default void set(FloatField<?> field, float value) {
    fieldValues().write(fieldValues().word(field), field.encode(value));
  }

  /** Sets one of several numbers, see {@link #set(FloatField, float)}. */
  default void set(FloatField<?> field, int index, float value) {
    fieldValues().write(fieldValues().word(field, index), field.encode(value));
  }

  /**
   * Adds to a number. The sum stops at the limits of the field. For a {@link Ratio} the change is
   * rounded to whole steps first.
   *
   * @param change may be negative
   */
  default void add(FloatField<?> field, float change) {
    addFloat(field, fieldValues().word(field), change);
  }

  /** Adds to one of several numbers, see {@link #add(FloatField, float)}. */
  default void add(FloatField<?> field, int index, float change) {
    addFloat(field, fieldValues().word(field, index), change);
  }

  /**
   * Sets the entity that a field means.
   *
   * @param entity null for none
   * @throws IllegalArgumentException if the entity is static level geometry
   */
  default void set(EntityRef field, E entity) {
    fieldValues().write(fieldValues().word(field), reference(field, entity));
  }

  /** Sets one of several entities, see {@link #set(EntityRef, FieldReader)}. */
  default void set(EntityRef field, int index, E entity) {
    fieldValues().write(fieldValues().word(field, index), reference(field, entity));
  }

  /**
   * Sets the player that a field means.
   *
   * @param player null for nobody
   */
  default void set(PlayerRef field, P player) {
    fieldValues().write(fieldValues().word(field), reference(field, player));
  }

  /** Sets one of several players, see {@link #set(PlayerRef, FieldReader)}. */
  default void set(PlayerRef field, int index, P player) {
    fieldValues().write(fieldValues().word(field, index), reference(field, player));
  }

  /** Sets all fields to their start values, but for those that accounts keep. */
  default void resetFields() {
    fieldValues().reset();
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

  private static int reference(Field<?> field, FieldReader<?, ?> target) {
    int word = target == null ? 0 : target.reference();
    if (target != null && word == 0) {
      throw new IllegalArgumentException(
          field.path() + " can't mean " + target + ", which is level geometry");
    }
    return word;
  }
}
