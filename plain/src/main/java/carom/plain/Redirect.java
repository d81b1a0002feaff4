package carom.plain;

/** Sends the client to another server; the server closes the connection. */
public final class Redirect {
  /** Address, host:port. */
  public String server;

  /** Name of the room there. */
  public String room;

  /** To be shown there as a join token; empty for the one you have. */
  public String token;

  /** Creates one to be filled in. */
  public Redirect() {}
}
