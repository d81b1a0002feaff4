package carom.plain;

/** A line of chat, in either direction. */
public final class Chat {
  /** Id of the player who said it; -1 for the server. */
  public int player = -1;

  /** Text that is said. */
  public String text = "";

  /** True if only the player's team hears it. */
  public boolean team;

  /** Creates one to be filled in. */
  public Chat() {}

  /** Creates one to all. */
  public Chat(String text) {
    this.text = text;
  }

  /** Creates one to all or to the own team. */
  public Chat(String text, boolean team) {
    this.text = text;
    this.team = team;
  }
}
