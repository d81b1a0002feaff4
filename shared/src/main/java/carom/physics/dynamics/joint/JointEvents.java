package carom.physics.dynamics.joint;

/** Receives what {@code Dynamics.step} has to tell about joints. */
@FunctionalInterface
public interface JointEvents {
  /**
   * Tells that a joint bears more than it can; the owner destroys it when the step is over.
   *
   * @param joint its slot
   */
  void broke(int joint);
}
