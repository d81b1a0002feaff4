package carom.plain;

/** A team. */
public final class Team {
  /** Name. */
  public String name;

  /** Colour, 0xRRGGBB. */
  public int rgb;

  /** Creates one to be filled in. */
  public Team() {}
}
