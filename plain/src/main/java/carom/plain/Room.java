package carom.plain;

/** A room. */
public final class Room {
  /** Name. */
  public String name;

  /** Name of the game. */
  public String game;

  /** Name of the level. */
  public String level;

  /** Phase of the match. */
  public String phase;

  /** Number of players. */
  public int players;

  /** Number of places. */
  public int places;

  /** Facts that the operator tells, texts. */
  public Value[] info;

  /** Creates one to be filled in. */
  public Room() {}
}
