package carom.plain;

import java.util.Arrays;

/** A message of the game's own, in either direction. */
public final class Custom {
  /** Name of its kind. */
  public String kind = "";

  /** Values with their names. */
  public Value[] values = {};

  /** Creates one to be filled in. */
  public Custom() {}

  /** Creates one without values. */
  public Custom(String kind) {
    this.kind = kind;
  }

  /**
   * Adds a value and returns this message.
   *
   * @param value an Integer, Float, Boolean or String; a choice is the name of its constant
   */
  public Custom with(String name, Object value) {
    values = Arrays.copyOf(values, values.length + 1);
    values[values.length - 1] = new Value(name, value);
    return this;
  }

  /** Returns the value of a name, or null if there is none. */
  public Object get(String name) {
    for (Value value : values) {
      if (value.name.equals(name)) {
        return value.value;
      }
    }
    return null;
  }
}
