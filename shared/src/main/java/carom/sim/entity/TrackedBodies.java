package carom.sim.entity;

import carom.physics.Body;
import carom.sim.level.Archetype;

/**
 * The bodies whose past is remembered, by the ids of their entities. Bodies that are not tracked
 * are taken to have always been where they are.
 *
 * @param <T> the world's user type
 */
interface TrackedBodies<T> {
  /** Returns a number above all ids in use. */
  int limit();

  /** Returns the body of an id, or null if the id is free. */
  Body<T> body(int id);

  /** Returns the archetype of an id in use. */
  Archetype archetype(int id);

  /** Returns whether a body of the world is one of these. */
  boolean isTracked(Body<T> body);
}
