package carom.sim.field;

/**
 * A field whose value is a whole number: {@link Count} or {@link Countdown}.
 *
 * @param <F> the kind of field
 */
public abstract class IntField<F extends IntField<F>> extends Field<F> {
  IntField(Spec spec) {
    super(spec);
  }

  /** Returns the value of a word at a tick. */
  abstract int decode(int word, int tick);

  /**
   * Returns the word of a value that is set at a tick.
   *
   * @throws IllegalArgumentException if the field can't hold the value
   */
  abstract int encode(int value, int tick);

  /** Returns the nearest value that the field can hold. */
  abstract int clamp(long value);
}
