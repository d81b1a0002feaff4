package carom.sim.level;

import carom.physics.math.Limits;

/**
 * The look of an entity. The simulation never reads it.
 *
 * @param rgb fill colour, 0xRRGGBB
 * @param outlineRgb colour of the edge, 0xRRGGBB
 * @param look a hint for details on top of the plain shape
 */
public record Appearance(int rgb, int outlineRgb, Look look) {
  /** Plain grey, the default. */
  public static final Appearance DEFAULT = of(0x8d99ae);

  /** The kind of an entity, for a renderer that draws details. */
  public enum Look {
    /** The shape without details. */
    PLAIN,
    /** A part of the level's frame. */
    WALL,
    /** A surface to stand on. */
    PLATFORM,
    /** A player's body; it belongs to the entity's owner. */
    PLAYER,
    /** A ball that rolls. */
    BALL,
    /** A crate made of planks. */
    CRATE,
    /** A bumper that throws back what hits it. */
    BUMPER,
    /** A coin to be collected. */
    COIN,
    /** A lamp, on or off. */
    LAMP
  }

  /** Checks that there is a look. */
  public Appearance {
    Limits.notNull("look", look);
  }

  /** Returns a plain appearance whose edge has 60 % of the fill's brightness. */
  public static Appearance of(int rgb) {
    return of(rgb, Look.PLAIN);
  }

  /** Returns an appearance whose edge has 60 % of the fill's brightness. */
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
