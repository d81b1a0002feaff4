package carom.sim.message;

/** A feeling that a player shows above its body for a moment. */
public enum Emote {
  /** The player says hello. */
  HELLO("Hello!"),
  /** The player says thanks. */
  THANKS("Thanks!"),
  /** The player praises a move. */
  NICE("Nice!"),
  /** The player is sorry. */
  SORRY("Sorry!"),
  /** The player laughs. */
  LAUGH("Ha ha!"),
  /** The player is surprised. */
  WOW("Wow!"),
  /** The player is angry. */
  GRR("Grr!"),
  /** The player calls to go on. */
  GO("Go, go!");

  private final String text;

  Emote(String text) {
    this.text = text;
  }

  /** Returns what is shown. */
  public String text() {
    return text;
  }
}
