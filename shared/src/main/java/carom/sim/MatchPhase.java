package carom.sim;

/** The phase of a match with a {@link MatchClock}. */
public enum MatchPhase {
  /** The match waits for players. */
  WARM_UP("warm-up"),
  /** The match is about to begin. */
  COUNTDOWN("countdown"),
  /** The match is played. */
  PLAYING("playing"),
  /** The match is over, and the players see the result. */
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
