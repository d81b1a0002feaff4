package carom.physics;

import carom.physics.dynamics.body.ShapeTable;
import carom.physics.math.Limits;

/**
 * A filter decides which shapes collide with each other. Two shapes in the same group collide if
 * the group is above 0, and don't if it is below 0. Otherwise they collide if the mask of each has
 * a bit of the other's category.
 *
 * @param category bits that say what the shape is; usually one
 * @param mask bits of the categories that the shape collides with
 * @param group 0 for none; a common group takes precedence over category and mask
 */
public record Filter(int category, int mask, int group) {
  /** The default filter: category 1, a mask of all categories, no group. */
  public static final Filter DEFAULT = new Filter(1, -1, 0);

  /** A filter that lets a shape collide with nothing. */
  public static final Filter NOTHING = new Filter(0, 0, 0);

  /**
   * Makes a filter of category and mask, without a group.
   *
   * @param category bits that say what the shape is; usually one
   * @param mask bits of the categories that the shape collides with
   */
  public Filter(int category, int mask) {
    this(category, mask, 0);
  }

  /**
   * Returns a copy in another group.
   *
   * @param newGroup above 0 to collide with shapes of this group, below 0 not to, 0 for none
   * @return a changed copy
   */
  public Filter withGroup(int newGroup) {
    return new Filter(category, mask, newGroup);
  }

  /**
   * Returns whether two shapes with these filters collide. The order of the two doesn't matter.
   *
   * @param other the other shape's filter
   * @return false if they pass through each other
   */
  public boolean meets(Filter other) {
    Limits.notNull("other", other);
    return ShapeTable.meet(category, mask, group, other.category, other.mask, other.group);
  }
}
