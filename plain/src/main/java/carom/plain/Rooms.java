package carom.plain;

/** Lists rooms. */
public final class Rooms {
  /** Rooms. */
  public Room[] rooms;

  /** Number of rooms in further messages. */
  public int left;

  /** Creates one to be filled in. */
  public Rooms() {}
}
