package carom.sim.entity;

import carom.physics.Collision;

/**
 * The rule of one-way platforms: they carry bodies that stand or land on them, and let everything
 * else pass, from below and from the sides.
 *
 * <p>The rule needs no memory of its own. A contact counts when the platform's surface points up
 * and one of two things holds: the contact carried something in the tick before, or the body was
 * not yet in the platform a tick ago, because it is no deeper than it has just fallen. A body that
 * rises through the platform, or began to fall inside it, is deeper than that.
 */
public final class OneWay {
  /** Overlap that still counts as standing on top, in metres. Soft contacts sink in a little. */
  private static final float TOLERANCE = 0.03f;

  /** Least upward part of the surface's normal, which is that of 45 degrees. */
  private static final float MIN_UP = 0.7f;

  private OneWay() {}

  /**
   * Returns whether two touching bodies push each other.
   *
   * @param tickSeconds from tick to tick, seconds
   * @param c a contact about to be solved
   * @return false when one of the two is a one-way platform that lets the other pass
   */
  public static boolean responds(float tickSeconds, Collision<Entity> c) {
    if (c.other().user().archetype().oneWay()) {
      return holds(tickSeconds, c, -c.normalY());
    }
    if (c.self().user().archetype().oneWay()) {
      return holds(tickSeconds, c, c.normalY());
    }
    return true;
  }

  /**
   * Returns whether a platform carries the other body.
   *
   * @param up the upward part of the normal from the platform to the other body
   */
  private static boolean holds(float tickSeconds, Collision<Entity> c, float up) {
    if (up < MIN_UP) {
      return false;
    }
    boolean shallow = true;
    for (int i = 0; i < c.pointCount(); i++) {
      if (c.warmImpulse(i) > 0) {
        return true;
      }
      float fallen = Math.max(0, -c.normalSpeed(i)) * tickSeconds;
      shallow &= -c.separation(i) <= TOLERANCE + fallen;
    }
    return shallow;
  }
}
