package carom.physics.effects;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;

/**
 * An effect acts on bodies from a distance, one body at a time. What it does to a body depends on
 * that body, the frame and the world's constants alone, so the order of the bodies doesn't matter.
 *
 * <p>The frame says where the effect is: its settings are coordinates of the frame. An effect that
 * stays where it was made has the identity as its frame; one that a body carries has the body's
 * pose.
 */
public interface Effect {
  /**
   * Acts on a body in the next step. Nothing happens to a body that sleeps, that is not dynamic, or
   * that the effect doesn't reach.
   *
   * @param world the body's world
   * @param body the body
   * @param frame where the effect is
   * @param strength factor on what it does, not negative; 1 is as set, 0 is nothing
   * @param dtSeconds length of the next step, s
   */
  void act(World<?> world, Body<?> body, Transform frame, float strength, float dtSeconds);

  /**
   * Returns the box outside of which the effect does nothing.
   *
   * @param frame where the effect is
   * @param out receives the box, world axes, m
   */
  void reach(Transform frame, Aabb out);
}
