package carom.physics.effects;

import carom.physics.Body;
import carom.physics.Collision;
import carom.physics.CollisionListener;
import carom.physics.math.Limits;

/**
 * One-way platforms: they carry bodies that stand or land on them, and let everything else pass,
 * from below and from the sides.
 *
 * <pre>
 *   world.listener(new OneWay&lt;&gt;((body, shape) -&gt; body.material(shape).tag() == PLATFORM));
 * </pre>
 *
 * <p>The rule needs no memory of its own, so it is right after a restore and on a client that
 * predicts. A contact counts when the platform's surface points up and one of two things holds: the
 * contact carried something in the step before, or the body was not yet in the platform a step ago,
 * because it is no deeper than it has just fallen. A body that rises through the platform, or began
 * to fall inside it, is deeper than that.
 *
 * <p>A body that lies on a corner at speed may spin through: the rule knows no corners. A game that
 * has rules of its own calls {@link #holds} in its own listener. Immutable.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
public final class OneWay<T> implements CollisionListener<T> {
  /** Overlap that still counts as standing on top, m. Soft contacts sink in a little. */
  private static final float TOLERANCE = 0.03f;

  /** Least upward part of the surface's normal, which is that of 45 degrees. */
  private static final float MIN_UP = 0.7f;

  private final Platforms<T> platforms;

  /**
   * Says which shapes are platforms.
   *
   * @param <T> the user's type of {@link Body#user()}
   */
  @FunctionalInterface
  public interface Platforms<T> {
    /**
     * Returns whether a shape is a one-way platform.
     *
     * @param body the body of the shape
     * @param shape number of the shape, see {@link Body#shape}
     */
    boolean contains(Body<T> body, int shape);
  }

  /**
   * Makes the rule for some shapes.
   *
   * @param platforms says which are one-way platforms
   */
  public OneWay(Platforms<T> platforms) {
    if (platforms == null) {
      throw new IllegalArgumentException("platforms=null; say which shapes are one-way platforms");
    }
    this.platforms = platforms;
  }

  /** Returns whether a contact responds: false if one of the shapes is a platform to pass. */
  @Override
  public boolean preSolve(Collision<T> c) {
    Limits.notNull("c", c);
    if (platforms.contains(c.other(), c.otherShapeIndex())) {
      return holds(c, false, 0, 1);
    }
    return !platforms.contains(c.self(), c.selfShapeIndex()) || holds(c, true, 0, 1);
  }

  /**
   * Returns whether a one-way platform carries the other body of a contact.
   *
   * @param c a contact about to be solved, see {@link CollisionListener#preSolve}
   * @param selfIsPlatform whether {@link Collision#self} is the platform, else the other one is
   * @param upX the way up, a unit vector; (0, 1) in most worlds
   * @param upY the way up
   */
  public static boolean holds(Collision<?> c, boolean selfIsPlatform, float upX, float upY) {
    Limits.notNull("c", c);
    float along = c.normalX() * upX + c.normalY() * upY;
    if ((selfIsPlatform ? along : -along) < MIN_UP) {
      return false;
    }
    boolean shallow = true;
    for (int i = 0; i < c.pointCount(); i++) {
      if (c.warmImpulse(i) > 0) {
        return true;
      }
      float fallen = Math.max(0, -c.normalSpeed(i)) * c.stepSeconds();
      shallow &= -c.separation(i) <= TOLERANCE + fallen;
    }
    return shallow;
  }
}
