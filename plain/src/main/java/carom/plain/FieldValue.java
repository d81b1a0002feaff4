package carom.plain;

/** The value of a field. */
public final class FieldValue {
  /** Owner: match, player or entity. */
  public String scope;

  /** Id of the player or entity; 0 of the match. */
  public int id;

  /** Name of the field. */
  public String name;

  /** A Boolean, Integer, Float or String; null when this player may no longer know it. */
  public Object value;

  /** Creates one to be filled in. */
  public FieldValue() {}
}
