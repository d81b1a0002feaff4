package carom.physics;

import carom.physics.dynamics.body.ShapeTable;

/**
 * Who collides with whom. Two shapes meet if they are in the same group above 0; they don't if they
 * are in the same group below 0; else if each one's mask has a bit of the other's category.
 *
 * @param category bits that say what the shape is; usually one
 * @param mask bits of the categories it meets
 * @param group 0 for none; an equal number beats category and mask
 */
public record Filter(int category, int mask, int group) {
  /** Category 1, meets everything, no group. */
  public static final Filter DEFAULT = new Filter(1, -1, 0);

  /** Meets nothing. */
  public static final Filter NOTHING = new Filter(0, 0, 0);

  /**
   * Category and mask, no group.
   *
   * @param category bits that say what the shape is
   * @param mask bits of the categories it meets
   */
  public Filter(int category, int mask) {
    this(category, mask, 0);
  }

  /**
   * The same in a group.
   *
   * @param newGroup above 0 meets its like, below 0 never does
   * @return a changed copy
   */
  public Filter withGroup(int newGroup) {
    return new Filter(category, mask, newGroup);
  }

  /**
   * Whether two shapes meet; the same either way round.
   *
   * @param other the other shape's filter
   * @return false if they pass through each other
   */
  public boolean meets(Filter other) {
    return ShapeTable.meet(category, mask, group, other.category, other.mask, other.group);
  }
}
