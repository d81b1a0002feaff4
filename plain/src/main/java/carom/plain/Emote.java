package carom.plain;

/** An emote that a player shows, in either direction. */
public final class Emote {
  /** Id of the player who shows it. */
  public int player = -1;

  /** Name of the emote, such as HELLO. */
  public String emote = "";

  /** Creates one to be filled in. */
  public Emote() {}

  /** Creates one. */
  public Emote(String emote) {
    this.emote = emote;
  }
}
