package carom.sim.message;

/** A feeling that a player shows above its body for a moment. */
public enum Emote {
  /** Hello. */
  HELLO("Hello!"),
  /** Thanks. */
  THANKS("Thanks!"),
  /** Well played. */
  NICE("Nice!"),
  /** Sorry. */
  SORRY("Sorry!"),
  /** Laughter. */
  LAUGH("Ha ha!"),
  /** Surprise. */
  WOW("Wow!"),
  /** Anger. */
  GRR("Grr!"),
  /** A call to go on. */
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
