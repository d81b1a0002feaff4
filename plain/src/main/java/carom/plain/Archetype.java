package carom.plain;

/** A kind of bodies. */
public final class Archetype {
  /** Name. */
  public String name;

  /** Colour, 0xRRGGBB. */
  public int rgb;

  /** Colour of the edge, 0xRRGGBB. */
  public int outline;

  /** Way it is drawn; of PLAYER the colour of its owner counts. */
  public String look;

  /** True if it touches nothing. */
  public boolean sensor;

  /** Convex pieces in the body's frame. */
  public Part[] parts;

  /** Creates one to be filled in. */
  public Archetype() {}
}
