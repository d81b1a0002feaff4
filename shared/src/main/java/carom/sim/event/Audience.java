package carom.sim.event;

/** The players who are told about an entity or an event, see {@code Game.audience}. */
public enum Audience {
  /** Players who look at the place where it is. */
  NEAR,
  /** All players, wherever they look: for the ball, the flag. */
  ALL,
  /** The players on the team of its owner, wherever they look, and no others. */
  TEAM,
  /** The player it belongs to, and no other. */
  OWNER,
  /** The players who see everything, and no others. */
  NOBODY
}
