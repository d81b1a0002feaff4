package carom.client.bots;

/** How well a bot plays. */
public enum Strength {
  /** For beginners. */
  WEAK,
  /** For most. */
  MEDIUM,
  /** Hard to beat. */
  STRONG;

  /** Returns the value that belongs to this strength. */
  float of(float weak, float medium, float strong) {
    return this == WEAK ? weak : this == MEDIUM ? medium : strong;
  }
}
