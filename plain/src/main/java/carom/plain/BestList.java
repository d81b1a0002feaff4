package carom.plain;

/** The best of one field. */
public final class BestList {
  /** Name of the field. */
  public String field;

  /** Index of the player's own entry, or -1. */
  public int own;

  /** Entries, the best first. */
  public BestEntry[] entries;

  /** Creates one to be filled in. */
  public BestList() {}
}
