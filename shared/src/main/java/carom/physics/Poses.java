package carom.physics;

import carom.physics.math.Transform;

/**
 * The poses of bodies at another time, for queries about the past or the future of a world; see
 * {@link World#queries(Poses)}.
 */
public interface Poses {
  /**
   * Returns the largest distance, m, 0 or more, between any point of any body in these poses and
   * now. Queries cost more the larger it is. They may overlook bodies that are farther away.
   */
  float reach();

  /**
   * Writes the pose of one body.
   *
   * @param body the body's slot, see {@link Body#index}
   * @param out receives the pose of the body's origin
   * @return false if the body isn't there at that time
   */
  boolean place(int body, Transform out);
}
