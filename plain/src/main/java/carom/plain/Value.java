package carom.plain;

/** A value with its name. */
public final class Value {
  /** Name of the value. */
  public String name = "";

  /** An Integer, Float, Boolean or String, or null. */
  public Object value;

  /** Creates one to be filled in. */
  public Value() {}

  /** Creates one. */
  public Value(String name, Object value) {
    this.name = name;
    this.value = value;
  }
}
