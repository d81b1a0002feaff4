package carom.sim.entity;

import java.util.Objects;

/**
 * A player or spectator who enters a simulation, with all that comes from outside of it. A journal
 * has it, so that a replay asks no store of accounts.
 *
 * @param name any text
 * @param account the player's account, or empty for a stranger; at most {@value #MAX_ACCOUNT}
 *     characters
 * @param values what the account has kept, in the order of {@code Schema.lastingWords}; null for
 *     the starts of all fields. Never changed
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
public record Newcomer(String name, String account, int[] values) {
  /** Most characters of an account. */
  public static final int MAX_ACCOUNT = 64;

  /**
   * Checks the account.
   *
   * @throws IllegalArgumentException if it is too long
   */
  public Newcomer {
    Objects.requireNonNull(name, "name");
    if (account.length() > MAX_ACCOUNT) {
      throw new IllegalArgumentException(
          "account has characters=" + account.length() + ", at most " + MAX_ACCOUNT);
    }
  }

  /** Returns a stranger, who has no account. */
  public static Newcomer stranger(String name) {
    return new Newcomer(name, "", null);
  }
}
