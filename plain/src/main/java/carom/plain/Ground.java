package carom.plain;

/** A body that never moves. */
public final class Ground {
  /** Place, metres. */
  public float x;

  /** Place, metres. */
  public float y;

  /** Angle, radians counterclockwise. */
  public float angle;

  /** Kind of the body. */
  public Archetype kind;

  /** Creates one to be filled in. */
  public Ground() {}
}
