package carom.plain;

/** The place and angle of a body. */
public final class Body {
  /** Id of the body. */
  public int id;

  /** Place, metres. */
  public float x;

  /** Place, metres, upwards. */
  public float y;

  /** Angle, radians counterclockwise, 0..2 pi. */
  public float angle;

  /** Index in {@link Match#archetypes} if the body is new or has jumped, else -1. */
  public int archetype;

  /** Id of the player who owns it, or -1; it counts where an archetype is told. */
  public int owner;

  /** Creates one to be filled in. */
  public Body() {}
}
