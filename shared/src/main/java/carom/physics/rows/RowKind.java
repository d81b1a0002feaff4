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
  CONTACT(ContactRow.INTS);

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

  /**
   * Returns the kind of a row in a sequence that has all bodies first, then all joints, then all
   * contacts.
   *
   * @param row its number, from 0
   * @param bodies number of bodies in the sequence
   * @param joints number of joints in the sequence
   */
  public static RowKind of(int row, int bodies, int joints) {
    return row < bodies ? BODY : row < bodies + joints ? JOINT : CONTACT;
  }
}
