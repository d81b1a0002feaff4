package carom.physics;

/**
 * Receives the joints that break during {@link World#step}, and those that come and go; see {@link
 * World#jointListener}.
 *
 * @param <T> the user's type of {@link Body#user()}
 */
@FunctionalInterface
public interface JointListener<T> {
  /**
   * Receives a joint that exceeded its limit of force or torque. Called at the end of the step, in
   * the order of the joints' indices. The joint is destroyed when the step is over.
   *
   * <p>The same is allowed as in a {@link CollisionListener}.
   *
   * @param joint still valid during the call, with the force that broke it
   */
  void broke(Joint<T> joint);

  /**
   * Receives a joint that was just created, by any method of the world. Does nothing by default.
   */
  default void created(Joint<T> joint) {}

  /**
   * Receives a joint that is about to be destroyed: by the program, because it broke, or with one
   * of its bodies. Does nothing by default.
   *
   * @param joint still valid during the call
   */
  default void destroyed(Joint<T> joint) {}
}
