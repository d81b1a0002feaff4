package carom.plain;

/** A player or a spectator. */
public final class Player {
  /** Id. */
  public int id;

  /** Name. */
  public String name;

  /** Number of the team. */
  public int team;

  /** Points. */
  public int score;

  /** True if it watches only. */
  public boolean spectator;

  /** True if it is ready. */
  public boolean ready;

  /** True if it has a body. */
  public boolean alive;

  /** Round trip, ms. */
  public int ping;

  /** Colour of its body, 0xRRGGBB; -1 for that of the team or the archetype. */
  public int rgb;

  /** Creates one to be filled in. */
  public Player() {}
}
