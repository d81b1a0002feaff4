package carom.plain;

/** A rectangle to tint behind the bodies. */
public final class Zone {
  /** Left edge, metres. */
  public float minX;

  /** Lower edge, metres. */
  public float minY;

  /** Right edge, metres. */
  public float maxX;

  /** Upper edge, metres. */
  public float maxY;

  /** Colour, 0xRRGGBB. */
  public int rgb;

  /** Creates one to be filled in. */
  public Zone() {}
}
