package carom.server.access;

import carom.net.protocol.RefusalReason;

/** Decides whether a client may come in. The lobby's thread asks; the answer takes no disk. */
@FunctionalInterface
public interface EntryRule {
  /** Lets everybody in. */
  EntryRule OPEN = (name, account, remote) -> null;

  /**
   * A client that may not come in.
   *
   * @param reason why, for the client
   * @param text why, for the player; may be empty
   */
  record Refusal(RefusalReason reason, String text) {}

  /**
   * Returns why a client may not come in, or null if it may.
   *
   * @param name name of the player, or null for a spectator
   * @param account the player's account by its join token, or empty
   * @param remote address and port, as the link tells them
   */
  Refusal refusal(String name, String account, String remote);

  /** Returns the check of join tokens that players must pass first, or null if they need none. */
  default JoinTokens tokens() {
    return null;
  }
}
