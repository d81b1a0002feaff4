package carom.physics;

import carom.physics.math.Transform;

/**
 * Where bodies were or will be, for questions about a world at another time; see {@link
 * World#queries(Poses)}.
 */
public interface Poses {
  /**
   * How far any point of any body may be from where it is now, metres, 0 or more. Questions cost
   * more the larger it is; what is farther away may be overlooked.
   */
  float reach();

  /**
   * Where one body is.
   *
   * @param body its index, see {@link Body#index}
   * @param out receives the pose of its origin
   * @return false when it isn't there
   */
  boolean place(int body, Transform out);
}
