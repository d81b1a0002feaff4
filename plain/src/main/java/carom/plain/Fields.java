package carom.plain;

/** Tells of fields that changed. */
public final class Fields {
  /** Values of the fields. */
  public FieldValue[] values;

  /** Creates one to be filled in. */
  public Fields() {}
}
