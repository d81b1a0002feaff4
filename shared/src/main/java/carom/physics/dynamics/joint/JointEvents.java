package carom.physics.dynamics.joint;

import carom.physics.dynamics.Dynamics;

/** What {@link Dynamics#step} tells its owner about joints. */
@FunctionalInterface
public interface JointEvents {
  /**
   * A joint bears more than it can; the owner destroys it when the step is over.
   *
   * @param joint its slot
   */
  void broke(int joint);
}
