package carom.plain;

/** Lists the best of what accounts keep in the game. */
public final class Best {
  /** A list for each field that has any. */
  public BestList[] lists;

  /** Creates one to be filled in. */
  public Best() {}
}
