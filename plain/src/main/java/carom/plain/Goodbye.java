package carom.plain;

/** Ends the game for this client; the server closes the connection. */
public final class Goodbye {
  /** Name of the reason. */
  public String reason;

  /** Explanation for the player. */
  public String text;

  /** Creates one to be filled in. */
  public Goodbye() {}
}
