package carom.physics.rows;

/**
 * The fields of a contact's row: offsets of ints from the row's beginning. The package's page has a
 * drawing.
 *
 * <p>An end names a body: by its place among the rows of bodies, or a static body that has no row
 * by its inverted slot ({@code ~slot}). Static bodies must therefore have the same slots in both
 * worlds. Of a contact with one point, the fields of the second point are zero.
 */
public final class ContactRow {
  /** Body A, the one of the lower slot: a place, or the inverted slot of a static body. */
  public static final int END_A = 0;

  /** Body B: a place, or the inverted slot of a static body. */
  public static final int END_B = END_A + 1;

  /** Parts of the bodies that touch: part of A, shifted by the bits of a part, and part of B. */
  public static final int PARTS = END_B + 1;

  /** Number of contact points, 1 or 2, in {@link #POINTS_MASK}; flags above. */
  public static final int POINTS_AND_FLAGS = PARTS + 1;

  /** Bits of {@link #POINTS_AND_FLAGS} that are the number of points. */
  public static final int POINTS_MASK = 0xff;

  /** Lowest bit of the flags in {@link #POINTS_AND_FLAGS}. */
  public static final int FLAGS_SHIFT = 8;

  /** Feature id of the first point; that of the second point follows it. */
  public static final int ID_0 = POINTS_AND_FLAGS + 1;

  /** Feature id of the second point. */
  public static final int ID_1 = ID_0 + 1;

  /** The first field that is a float, by its raw bits. All behind it are floats, too. */
  public static final int FLOATS = ID_1 + 1;

  /** Normal from A to B; its y follows its x. */
  public static final int NORMAL_X = FLOATS;

  /** Normal from A to B. */
  public static final int NORMAL_Y = NORMAL_X + 1;

  /** Normal impulse that the first point starts with, N s. */
  public static final int NORMAL_IMPULSE_0 = NORMAL_Y + 1;

  /** Friction impulse that the first point starts with, N s. */
  public static final int TANGENT_IMPULSE_0 = NORMAL_IMPULSE_0 + 1;

  /** Normal impulse that the second point starts with, N s. */
  public static final int NORMAL_IMPULSE_1 = TANGENT_IMPULSE_0 + 1;

  /** Friction impulse that the second point starts with, N s. */
  public static final int TANGENT_IMPULSE_1 = NORMAL_IMPULSE_1 + 1;

  /** Impulse of the rolling resistance that the contact starts with, N m s. */
  public static final int ROLLING_IMPULSE = TANGENT_IMPULSE_1 + 1;

  /** Normal impulse of the first point in the last step, all substeps together, N s. */
  public static final int TOTAL_IMPULSE_0 = ROLLING_IMPULSE + 1;

  /** Normal impulse of the second point in the last step, all substeps together, N s. */
  public static final int TOTAL_IMPULSE_1 = TOTAL_IMPULSE_0 + 1;

  /** Number of ints of a row. */
  public static final int INTS = TOTAL_IMPULSE_1 + 1;

  private ContactRow() {}
}
