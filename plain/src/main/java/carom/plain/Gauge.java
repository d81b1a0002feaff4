package carom.plain;

/** A field that players see. */
public final class Gauge {
  /** Kind of the gauge. */
  public String kind;

  /** Text for the player. */
  public String label;

  /** Owner of the field: match, player or entity. */
  public String scope;

  /** Name of the field. */
  public String field;

  /** Value of an empty bar. */
  public float least;

  /** Value of a full bar. */
  public float most;

  /** Creates one to be filled in. */
  public Gauge() {}
}
