package carom.plain;

/** Tells of players of whom only score or ping changed. */
public final class Scores {
  /** Id, score and ping of each. */
  public int[] scores;

  /** Creates one to be filled in. */
  public Scores() {}
}
