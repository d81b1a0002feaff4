package carom.plain;

/** Refuses a client; the server closes the connection. */
public final class Refused {
  /** Name of the reason. */
  public String reason;

  /** Explanation for the player. */
  public String text;

  /** Creates one to be filled in. */
  public Refused() {}
}
