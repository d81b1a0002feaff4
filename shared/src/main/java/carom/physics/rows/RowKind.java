package carom.physics.rows;

/**
 * The kinds of exact rows, in the order in which they are hashed and sent. Each has a class of its
 * fields.
 */
public enum RowKind {
  /** A body; its fields are in {@link BodyRow}. */
  BODY(BodyRow.INTS),

  /** A joint of a body; its fields are in {@link JointRow}. */
  JOINT(JointRow.INTS),

  /** A contact between two bodies; its fields are in {@link ContactRow}. */
  CONTACT(ContactRow.INTS),

  /** Words of the using program that belong to a body; its fields are in {@link FieldRow}. */
  FIELDS(FieldRow.INTS);

  /** Number of ints of the longest kind. */
  static final int LONGEST;

  static {
    int longest = 0;
    for (RowKind kind : values()) {
      longest = Math.max(longest, kind.ints);
    }
    LONGEST = longest;
  }

  private final int ints;

  RowKind(int ints) {
    this.ints = ints;
  }

  /** Returns the number of ints of a row of this kind. */
  public int ints() {
    return ints;
  }
}
