package carom.sim.field;

/**
 * A field for a part of a whole, 0..1 in equal steps, see {@link Field#ratio(String)}. The number
 * of steps is stored, so server and clients have exactly the same value. A value is rounded to the
 * nearest step, and a change by less than half a step has no effect.
 */
public final class Ratio extends FloatField<Ratio> {
  /** Number of steps unless {@link Field#ratio(String, int)} says otherwise. */
  public static final int STEPS = 65_535;

  /** Most steps; a float tells no more apart. */
  public static final int MAX_STEPS = 1 << 24;

  Ratio(Spec spec) {
    super(spec);
  }

  static Ratio create(String name, int steps) {
    if (steps < 1 || steps > MAX_STEPS) {
      throw new IllegalArgumentException(
          "steps=" + steps + " of field " + name + " are outside 1.." + MAX_STEPS);
    }
    return new Ratio(Spec.of(name, "ratio 0..1 in " + steps + " steps", 0, steps, 0));
  }

  @Override
  Ratio with(Spec changed) {
    return new Ratio(changed);
  }

  /**
   * Returns the same field with another value to start with.
   *
   * @throws IllegalArgumentException if the value is outside 0..1
   */
  public Ratio startsAt(float value) {
    return startingWith(encode(value));
  }

  @Override
  public Ratio startsFrom(Object value) {
    if (value instanceof Double number) {
      return startsAt(number.floatValue());
    }
    throw outside(value, "; write a number");
  }

  @Override
  float decode(int word) {
    return (float) word / max();
  }

  @Override
  int encode(float value) {
    if (!(value >= 0 && value <= 1)) {
      throw outside(value, "; add stops at the limits, set refuses");
    }
    return Math.round(value * max());
  }

  @Override
  int add(int word, float change) {
    if (Float.isNaN(change)) {
      throw outside(change, "");
    }
    int steps = Math.round(Math.max(-1, Math.min(1, change)) * max());
    return Math.max(0, Math.min(max(), word + steps));
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
