package carom.sim.event;

import carom.sim.Game;

/** Who is told that an entity exists, see {@link Game#audience}. */
public enum Audience {
  /** Whoever looks at the place where it is. */
  NEAR,
  /** Everybody, wherever they look: the ball, the flag. */
  ALL,
  /** The players on the team of its owner, wherever they look, and nobody else. */
  TEAM,
  /** The player it belongs to, and nobody else. */
  OWNER,
  /** Nobody but those who {@linkplain Game#seesAll see all}. */
  NOBODY
}
