package carom.sim;

import carom.physics.Collision;

/**
 * One-way platforms: they hold what stands or lands on them, and let everything else pass, from
 * below and from the sides.
 *
 * <p>The rule needs no memory of its own. A contact counts when the platform's surface points up
 * and either the contact carried something in the tick before, or the body was not yet in the
 * platform a tick ago: it is no deeper than it has just fallen. What rises through the platform, or
 * began to fall inside it, is deeper than that.
 */
public final class OneWay {
  /** Overlap that still counts as standing on top, metres: soft contacts sink in a little. */
  private static final float TOLERANCE = 0.03f;

  /** Least upward part of the surface's normal: 45 degrees. */
  private static final float MIN_UP = 0.7f;

  private OneWay() {}

  /**
   * Whether two touching bodies should push each other.
   *
   * @param s whose tick it is
   * @param c a contact about to be solved
   * @return false when one of the two is a one-way platform that lets the other pass
   */
  public static boolean responds(Simulation s, Collision<Entity> c) {
    if (c.other().user().archetype().oneWay()) {
      return holds(s, c, -c.normalY());
    }
    if (c.self().user().archetype().oneWay()) {
      return holds(s, c, c.normalY());
    }
    return true;
  }

  /** Up is the upward part of the normal from the platform to the rider. */
  private static boolean holds(Simulation s, Collision<Entity> c, float up) {
    if (up < MIN_UP) {
      return false;
    }
    boolean shallow = true;
    for (int i = 0; i < c.pointCount(); i++) {
      if (c.warmImpulse(i) > 0) {
        return true;
      }
      float fallen = Math.max(0, -c.normalSpeed(i)) * s.tickSeconds();
      shallow &= -c.separation(i) <= TOLERANCE + fallen;
    }
    return shallow;
  }
}
