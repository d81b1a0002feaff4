package carom.server.account;

/**
 * The sources of a player's skill: what a join token claims, which counts in every game, or what
 * the account has gained in each. Immutable; any thread.
 *
 * @param claim by the token, or {@link #NO_CLAIM}
 * @param values of the account, or null if it has none or they aren't known
 */
public record PlayerSkill(int claim, AccountValues values) {
  /** The claim of a token that says nothing. */
  public static final int NO_CLAIM = -1;

  /** Largest claim. */
  public static final int MAX_CLAIM = 1_000_000;

  /** The sources of a stranger. */
  public static final PlayerSkill UNKNOWN = new PlayerSkill(NO_CLAIM, null);

  /** Returns whether there is any source, so that {@link #in} answers. */
  public boolean isKnown() {
    return claim != NO_CLAIM || values != null;
  }

  /**
   * Returns the skill in a game, if it {@link #isKnown}.
   *
   * @param field of the account, that the game names
   * @param start value of a player who is new to the game
   */
  public int in(String game, String field, int start) {
    return claim != NO_CLAIM ? claim : values.count(game, field, start);
  }
}
