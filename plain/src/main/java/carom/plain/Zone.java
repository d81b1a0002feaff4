package carom.plain;

/** A rectangle of the level behind the bodies, to tint if it has a colour. */
public final class Zone {
  /** Name that the level gives it, often that of others, too. */
  public String name;

  /** Left edge, metres. */
  public float minX;

  /** Lower edge, metres. */
  public float minY;

  /** Right edge, metres. */
  public float maxX;

  /** Upper edge, metres. */
  public float maxY;

  /** Colour, 0xRRGGBB; -1 for none. */
  public int rgb;

  /** Creates one to be filled in. */
  public Zone() {}
}
