package carom.physics.laws;

import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import java.util.SplittableRandom;

/** Draws shapes of all kinds, 5 cm to 1 m large. */
final class RandomShapes {
  /** Number of kinds that have an area, and of all. */
  private static final int SOLID = 7;

  private static final int ALL = SOLID + 3;

  private RandomShapes() {}

  /** Draws a shape. A dynamic body needs a solid one. */
  static Shape draw(SplittableRandom random, boolean solid) {
    float size = (float) random.nextDouble(.05, 1);
    float flat = size * (float) random.nextDouble(.1, 1);
    return switch (random.nextInt(solid ? SOLID : ALL)) {
      case 0 -> new Circle(size);
      case 1 -> new Capsule(-size, 0, size, 0, flat);
      case 2 -> new Box(size, flat);
      case 3 -> Polygon.regular(3 + random.nextInt(5), size);
      case 4 -> Polygon.rounded(.3f * flat, -size, -flat, size, -flat, 0, flat);
      case 5 ->
          Compound.of(new Box(size, .1f * size), new Box(.1f * size, size), new Circle(.3f * size));
      case 6 ->
          Compound.of(
              new Box(.5f * size, .5f * flat, .5f * size, 0),
              new Box(.5f * size, .5f * flat, -.5f * size, 0));
      case 7 -> new Segment(-size, 0, size, .3f * flat);
      case 8 -> Chain.loop(-size, -flat, size, -flat, size, flat, 0, .5f * flat, -size, flat);
      default -> Chain.open(size, -flat, .5f * size, 0, -.5f * size, 0, -size, -flat);
    };
  }
}
