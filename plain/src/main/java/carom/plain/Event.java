package carom.plain;

/** Something that happened once. */
public final class Event {
  /** Index in {@link Match#events}. */
  public int kind;

  /** Tick at which it happened. */
  public int tick;

  /** Place, metres. */
  public float x;

  /** Place, metres. */
  public float y;

  /** Strength. */
  public float strength;

  /** Id of the player who caused it, or -1. */
  public int player;

  /** Id of the body that it happened to, or -1. */
  public int first;

  /** Id of the other body that took part, or -1. */
  public int second;

  /** Number whose meaning depends on the kind. */
  public int data;

  /** Creates one to be filled in. */
  public Event() {}
}
