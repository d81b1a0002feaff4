package carom.physics;

import carom.physics.dynamics.Dynamics;

/**
 * A world at one moment: a handful of arrays, made by {@link World#save} and taken over by {@link
 * World#restore}.
 *
 * <p>Belongs to the world that made it. Saving into the same object again costs no allocation
 * unless the world grew.
 */
public final class WorldState {
  final Object owner;
  final Dynamics.State dynamics = new Dynamics.State();
  Object[] handles = new Object[0];
  int slots;
  Object[] jointHandles = new Object[0];
  int jointSlots;
  long structure = -1;
  long jointStructure = -1;

  WorldState(Object owner) {
    this.owner = owner;
  }
}
