package carom.sim.field;

/**
 * A field whose value is a {@code float}: {@link Ratio} or {@link Real}.
 *
 * @param <F> the kind of field
 */
public abstract class FloatField<F extends FloatField<F>> extends Field<F> {
  FloatField(Spec spec) {
    super(spec);
  }

  /** Returns the value of a word. */
  abstract float decode(int word);

  /**
   * Returns the word of a value.
   *
   * @throws IllegalArgumentException if the field can't hold the value
   */
  abstract int encode(float value);

  /** Returns the word of a sum, at the limit if the sum is beyond it. */
  abstract int add(int word, float change);
}
