package carom.sim.field;

/** A field for a whole number in a range, see {@link Field#count}. */
public final class Count extends IntField<Count> {
  Count(Spec spec) {
    super(spec);
  }

  static Count create(String name, int min, int max) {
    if (min >= max) {
      throw new IllegalArgumentException(
          "min=" + min + " of field " + name + " must be below max=" + max);
    }
    int start = Math.max(min, Math.min(max, 0));
    return new Count(Spec.of(name, "count " + min + ".." + max, min, max, start));
  }

  @Override
  Count with(Spec changed) {
    return new Count(changed);
  }

  /**
   * Returns the same field with another value to start with. Without it the value nearest to 0 is
   * the start.
   *
   * @throws IllegalArgumentException if the value is outside the range
   */
  public Count startsAt(int value) {
    return startingWith(encode(value, 0));
  }

  /**
   * Returns the same field, of which the lowest value is the best, such as a time. The start counts
   * as none.
   */
  public Count lowestIsBest() {
    return with(lowestBest());
  }

  @Override
  public Count startsFrom(Object value) {
    if (value instanceof Double number && number == number.intValue()) {
      return startsAt(number.intValue());
    }
    throw outside(value, "");
  }

  @Override
  int decode(int word, int tick) {
    return word;
  }

  @Override
  int encode(int value, int tick) {
    if (value < min() || value > max()) {
      throw outside(value, "; add stops at the limits, set refuses");
    }
    return value;
  }

  @Override
  int clamp(long value) {
    return (int) Math.max(min(), Math.min(max(), value));
  }

  @Override
  public String show(int word) {
    return Integer.toString(word);
  }
}
