package carom.sim.field;

/** A field for yes or no, see {@link Field#flag}. */
public final class Flag extends Field<Flag> {
  Flag(Spec spec) {
    super(spec);
  }

  @Override
  Flag with(Spec changed) {
    return new Flag(changed);
  }

  /** Returns the same field with another value to start with. */
  public Flag startsAt(boolean value) {
    return startingWith(value ? 1 : 0);
  }

  @Override
  public Flag startsFrom(Object value) {
    if (value instanceof Boolean truth) {
      return startsAt(truth);
    }
    throw outside(value, "; write true or false");
  }

  @Override
  public Object value(int word) {
    return word != 0;
  }

  @Override
  public String show(int word) {
    return Boolean.toString(word != 0);
  }
}
