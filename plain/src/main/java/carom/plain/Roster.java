package carom.plain;

/** Tells of players who came, changed or went. */
public final class Roster {
  /** Players who came or changed. */
  public Player[] players;

  /** Ids of those who went. */
  public int[] gone;

  /** Creates one to be filled in. */
  public Roster() {}
}
