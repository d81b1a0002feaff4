package carom.sim.field;

import java.util.Locale;

/** Says what has a field: each player, each entity, the match as a whole, or an account. */
public enum Scope {
  /** Each player has a value of its own, from the join until the player leaves. */
  PLAYER(256),
  /** Each entity that was spawned has a value of its own. Static level geometry has none. */
  ENTITY(64),
  /** The simulation has one value. */
  MATCH(65_536),
  /**
   * Each player has a value, which the player's account keeps from stay to stay, where the server
   * keeps accounts. It is read and written as a field of the player, among whose names it is.
   */
  ACCOUNT(64);

  private final int mostWords;

  Scope(int mostWords) {
    this.mostWords = mostWords;
  }

  /** Returns the most words that the fields of this scope may take together, 32 bits each. */
  public int mostWords() {
    return mostWords;
  }

  /** Returns the scope whose targets hold the values: players, for those of accounts. */
  public Scope holder() {
    return this == ACCOUNT ? PLAYER : this;
  }

  /** Returns the name in lower case, as in {@code player.health}. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }
}
