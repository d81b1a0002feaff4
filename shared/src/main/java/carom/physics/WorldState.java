package carom.physics;

import carom.physics.dynamics.DynamicsState;
import carom.physics.dynamics.Stamp;
import carom.physics.geometry.MassData;

/**
 * A world at one moment: a handful of arrays, made by {@link World#save} and taken over by {@link
 * World#restore}.
 *
 * <p>Belongs to the world that made it. Saving into the same object again costs no allocation
 * unless the world grew.
 */
public final class WorldState {
  final Object owner;
  final DynamicsState dynamics = new DynamicsState();
  Object[] handles = new Object[0];
  ShapeDef[][] shapes = new ShapeDef[0][];
  MassData[] ownMasses = new MassData[0];
  int slots;
  Object[] jointHandles = new Object[0];
  int jointSlots;
  final Stamp structure = new Stamp();
  final Stamp jointStructure = new Stamp();

  WorldState(Object owner) {
    this.owner = owner;
  }

  /**
   * What the last {@link World#save} into this state copied: numbers that no step changes, such as
   * masses, and handles only if one of them changed since the save before.
   *
   * @return bytes of bodies, contacts and joints
   */
  public long bytes() {
    return dynamics.bytes();
  }
}
