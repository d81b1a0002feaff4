package carom.plain;

/** A kind of the game's own messages. */
public final class Kind {
  /** Name. */
  public String name;

  /** Sender: client, server or both. */
  public String from;

  /** Arguments with their ranges, for people. */
  public String[] arguments;

  /** Creates one to be filled in. */
  public Kind() {}
}
