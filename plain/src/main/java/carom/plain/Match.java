package carom.plain;

/** Begins a match, the first or the next: forget all bodies, fields and players. */
public final class Match {
  /** Id of the own player. */
  public int player;

  /** Newest tick. */
  public int tick;

  /** Number of the match on this connection, from 1; its snapshots carry it. */
  public int number;

  /** Name of the room. */
  public String room;

  /** Name of the game. */
  public String game;

  /** Name of the level. */
  public String level;

  /** Least x, least y, greatest x and greatest y that players normally reach, metres. */
  public float[] bounds;

  /** Acceleration of free bodies along x and y, m/s^2. */
  public float[] gravity;

  /** Colours of the background. */
  public Theme theme;

  /** Rectangles to tint behind the bodies, such as goals and water. */
  public Zone[] zones;

  /** Kinds of bodies, by index. */
  public Archetype[] archetypes;

  /** Bodies that never move. */
  public Ground[] ground;

  /** Kinds of events, by index. */
  public EventLook[] events;

  /** Fields that players see. */
  public Gauge[] gauges;

  /** Teams; empty without teams. */
  public Team[] teams;

  /** Kinds of the game's own messages. */
  public Kind[] messages;

  /** Number of {@link More} that follow at once. */
  public int more;

  /** Creates one to be filled in. */
  public Match() {}
}
