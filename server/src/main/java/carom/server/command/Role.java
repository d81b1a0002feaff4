package carom.server.command;

/**
 * A role says how far a person who gives commands is trusted. It may do what those before it may.
 */
public enum Role {
  /** A player that an operator has listed as admin: people are removed, muted, banned, let in. */
  MODERATOR,

  /** Knows the page's token or RCON's password: all but files outside the data folder. */
  OPERATOR,

  /** Sits at the server's own console, and so has its files anyway. */
  CONSOLE;

  /** Returns whether this role may do what is for another. */
  public boolean includes(Role other) {
    return compareTo(other) >= 0;
  }
}
