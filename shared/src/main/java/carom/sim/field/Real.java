package carom.sim.field;

/** A field for any {@code float} but NaN, kept to the last bit, see {@link Field#real}. */
public final class Real extends FloatField<Real> {
  Real(Spec spec) {
    super(spec);
  }

  @Override
  Real with(Spec changed) {
    return new Real(changed);
  }

  /**
   * Returns the same field with another value to start with.
   *
   * @throws IllegalArgumentException if the value is NaN
   */
  public Real startsAt(float value) {
    return startingWith(encode(value));
  }

  @Override
  public Real startsFrom(Object value) {
    if (value instanceof Double number) {
      return startsAt(number.floatValue());
    }
    throw outside(value, "; write a number");
  }

  @Override
  float decode(int word) {
    return Float.intBitsToFloat(word);
  }

  @Override
  int encode(float value) {
    if (Float.isNaN(value)) {
      throw outside(value, ", which has no NaN");
    }
    return Float.floatToRawIntBits(value);
  }

  @Override
  int add(int word, float change) {
    return encode(decode(word) + change);
  }

  @Override
  public Object value(int word) {
    return decode(word);
  }

  @Override
  public String show(int word) {
    return Float.toString(decode(word));
  }
}
