package carom.client.interpolation;

/**
 * The known states of one entity slot, newest first: index 0 is the newest. Units: metres and
 * radians.
 */
public interface StateHistory {
  /** Returns the number of known states. */
  int size();

  /** Returns the tick after which the entity was in this state. */
  int tick(int index);

  /** Returns whether the slot held an entity then. */
  boolean alive(int index);

  /** Returns the generation, which differs between successive entities of a slot. */
  int generation(int index);

  /** Returns the teleport counter, modulo 16. States with different counters aren't connected. */
  int teleports(int index);

  /** Returns x of the body origin. */
  float x(int index);

  /** Returns y of the body origin. */
  float y(int index);

  /** Returns the angle, -pi..pi. */
  float angle(int index);

  /** Returns whether the entity stood still: it stays there until the next state. */
  boolean still(int index);
}
