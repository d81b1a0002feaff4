package carom.physics;

import carom.physics.dynamics.DynamicsState;

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
  final Handles<?> handles = new Handles<>();

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
