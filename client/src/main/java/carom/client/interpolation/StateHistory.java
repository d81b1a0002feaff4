package carom.client.interpolation;

/**
 * The known states of one entity slot, newest first: index 0 is the newest. Units: metres, radians,
 * metres and radians per second.
 */
public interface StateHistory {
  /** StateHistory known. */
  int size();

  /** Tick after which the entity was in this state. */
  int tick(int index);

  /** Whether the slot held an entity then. */
  boolean alive(int index);

  /** Tells entities apart that held the slot one after the other. */
  int generation(int index);

  /** How often it was put elsewhere, modulo 16: between different numbers there is no way. */
  int teleports(int index);

  /** Body origin. */
  float x(int index);

  /** Body origin. */
  float y(int index);

  /** Angle in -pi..pi. */
  float angle(int index);

  /** Velocity. */
  float vx(int index);

  /** Velocity. */
  float vy(int index);

  /** Angular velocity. */
  float omega(int index);
}
