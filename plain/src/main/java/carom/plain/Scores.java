package carom.plain;

/** Tells of players that changed in nothing but score or ping. */
public final class Scores {
  /** Id, score and ping of each. */
  public int[] scores;

  /** Creates one to be filled in. */
  public Scores() {}
}
