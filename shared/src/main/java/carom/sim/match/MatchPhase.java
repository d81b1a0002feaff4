package carom.sim.match;

/** What a match with a {@link MatchClock} is at. */
public enum MatchPhase {
  /** The match waits for players. */
  WARM_UP("warm-up"),
  /** It is about to begin. */
  COUNTDOWN("countdown"),
  /** It is played. */
  PLAYING("playing"),
  /** It is over, and the players see the result. */
  OVER("over");

  private final String text;

  MatchPhase(String text) {
    this.text = text;
  }

  /** Returns the phase for people, at most 16 characters. */
  public String text() {
    return text;
  }
}
