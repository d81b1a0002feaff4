package carom.sim.scene;

import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Shape;

/**
 * The colours of the scenes. A material's tag is its colour, 0xRRGGBB; tag 0 leaves the choice to
 * whoever draws.
 */
public final class SceneColors {
  /** What doesn't move. */
  public static final int STONE = 0x46566e;

  /** Metal. */
  public static final int STEEL = 0x9fb0c6;

  /** Planks and crates. */
  public static final int WOOD = 0xd9a566;

  /** Paper and cards. */
  public static final int PAPER = 0xf1ebdd;

  /** Liquids. */
  public static final int WATER = 0x3d8bd4;

  public static final int AMBER = 0xffb340;
  public static final int CORAL = 0xff6f61;
  public static final int TEAL = 0x36c5b0;
  public static final int SKY = 0x5aa9ff;
  public static final int VIOLET = 0xa58bff;
  public static final int LEAF = 0x7ed67e;

  private static final int[] BRIGHT = {AMBER, CORAL, VIOLET, SKY, TEAL, LEAF};

  private SceneColors() {}

  /**
   * Returns a bright colour.
   *
   * @param i any number; neighbours differ
   * @return 0xRRGGBB
   */
  public static int bright(int i) {
    return BRIGHT[Math.floorMod(i, BRIGHT.length)];
  }

  /**
   * Returns a colour between two others.
   *
   * @param from 0xRRGGBB
   * @param to 0xRRGGBB
   * @param share 0 = the first, 1 = the second
   * @return 0xRRGGBB
   */
  public static int mix(int from, int to, float share) {
    int rgb = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
      int a = from >> shift & 0xff;
      int b = to >> shift & 0xff;
      rgb |= Math.round(a + (b - a) * share) << shift;
    }
    return rgb;
  }

  /**
   * Returns the colour of what has tag 0.
   *
   * @param type the body's
   * @param shape the body's first
   * @return 0xRRGGBB
   */
  public static int untagged(BodyType type, Shape shape) {
    return switch (type) {
      case STATIC -> STONE;
      case KINEMATIC -> STEEL;
      case DYNAMIC -> bright(shape instanceof Circle ? 3 : shape.parts().get(0).vertexCount());
    };
  }

  /** {@link Material#DEFAULT} in a colour. */
  public static Material of(int rgb) {
    return Material.DEFAULT.withTag(rgb);
  }
}
