package carom.sim.level;

/**
 * How an entity wants to be drawn. The simulation never reads it.
 *
 * @param rgb fill colour, 0xRRGGBB
 * @param outlineRgb colour of the edge, 0xRRGGBB
 * @param look a hint for details on top of the plain shape
 */
public record Appearance(int rgb, int outlineRgb, Look look) {
  /** Plain grey. */
  public static final Appearance DEFAULT = of(0x8d99ae);

  /** What a thing is, for a renderer that draws details. */
  public enum Look {
    /** The bare shape. */
    PLAIN,
    /** Part of the level's frame. */
    WALL,
    /** Somewhere to stand. */
    PLATFORM,
    /** A player's body; belongs to the entity's owner. */
    PLAYER,
    /** Rolls. */
    BALL,
    /** Made of planks. */
    CRATE,
    /** Throws back what hits it. */
    BUMPER,
    /** Waits to be collected. */
    COIN,
    /** Shines, or could. */
    LAMP
  }

  /** A fill colour with an edge of the same hue at 60 % of the brightness. */
  public static Appearance of(int rgb) {
    return of(rgb, Look.PLAIN);
  }

  /** A fill colour and a look, with an edge of the same hue at 60 % of the brightness. */
  public static Appearance of(int rgb, Look look) {
    return new Appearance(rgb, darker(rgb), look);
  }

  private static int darker(int rgb) {
    return scale(rgb >> 16) << 16 | scale(rgb >> 8) << 8 | scale(rgb);
  }

  private static int scale(int channel) {
    return (channel & 0xff) * 3 / 5;
  }
}
