package carom.sim.scene;

import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Shape;

/**
 * The colours of the scenes. A material's tag is its colour, 0xRRGGBB. Tag 0 leaves the choice to
 * the renderer, see {@link #untagged}.
 */
public final class SceneColors {
  /** Grey blue, for what does not move. */
  public static final int STONE = 0x46566e;

  /** Light grey, for metal. */
  public static final int STEEL = 0x9fb0c6;

  /** Light brown, for planks and crates. */
  public static final int WOOD = 0xd9a566;

  /** Off-white, for paper and cards. */
  public static final int PAPER = 0xf1ebdd;

  /** Blue, for liquids. */
  public static final int WATER = 0x3d8bd4;

  /** Orange yellow. */
  public static final int AMBER = 0xffb340;

  /** Orange red. */
  public static final int CORAL = 0xff6f61;

  /** Blue green. */
  public static final int TEAL = 0x36c5b0;

  /** Light blue. */
  public static final int SKY = 0x5aa9ff;

  /** Light violet. */
  public static final int VIOLET = 0xa58bff;

  /** Light green. */
  public static final int LEAF = 0x7ed67e;

  private static final int[] BRIGHT = {AMBER, CORAL, VIOLET, SKY, TEAL, LEAF};

  private SceneColors() {}

  /**
   * Returns one of six bright colours.
   *
   * @param i any number; neighbours get different colours
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
   * @param share 0 for the first, 1 for the second
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
   * Returns the colour of a body whose material has tag 0.
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

  /**
   * Returns {@link Material#DEFAULT} in a colour.
   *
   * @param rgb 0xRRGGBB
   * @return the material
   */
  public static Material of(int rgb) {
    return Material.DEFAULT.withTag(rgb);
  }
}
