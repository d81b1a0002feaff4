package carom.client.bots;

/** Skill of a bot. */
public enum Strength {
  /** Opponent for beginners. */
  WEAK,
  /** Opponent for most. */
  MEDIUM,
  /** Opponent that is hard to beat. */
  STRONG;

  /** Returns the value that belongs to this strength. */
  float of(float weak, float medium, float strong) {
    return this == WEAK ? weak : this == MEDIUM ? medium : strong;
  }
}
