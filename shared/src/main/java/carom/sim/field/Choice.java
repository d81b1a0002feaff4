package carom.sim.field;

import carom.physics.math.Limits;

/**
 * A field for one of an enum's constants, see {@link Field#choice}.
 *
 * @param <E> the enum
 */
public final class Choice<E extends Enum<E>> extends Field<Choice<E>> {
  private final E[] constants;

  private Choice(Spec spec, E[] constants) {
    super(spec);
    this.constants = constants;
  }

  static <E extends Enum<E>> Choice<E> create(String name, Class<E> type) {
    E[] constants = Limits.notNull("type", type).getEnumConstants();
    if (constants.length == 0) {
      throw new IllegalArgumentException(
          "field " + name + " has no choice: " + type.getSimpleName() + " has no constants");
    }
    StringBuilder range = new StringBuilder("choice ");
    for (E constant : constants) {
      range.append(constant.ordinal() == 0 ? "" : "|").append(constant.name());
    }
    return new Choice<>(Spec.of(name, range.toString(), 0, constants.length - 1, 0), constants);
  }

  @Override
  Choice<E> with(Spec changed) {
    return new Choice<>(changed, constants);
  }

  /** Returns the same field with another constant to start with. */
  public Choice<E> startsAt(E constant) {
    return startingWith(Limits.notNull("constant", constant).ordinal());
  }

  @Override
  public Choice<E> startsFrom(Object value) {
    for (E constant : constants) {
      if (constant.name().equals(value)) {
        return startsAt(constant);
      }
    }
    throw outside(value, "");
  }

  /** Returns the constant of a word. */
  E decode(int word) {
    return constants[word];
  }

  @Override
  public Object value(int word) {
    return constants[word].name();
  }

  @Override
  public String show(int word) {
    return constants[word].name();
  }
}
