package carom.sim.scene;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import java.util.ArrayList;
import java.util.List;

/** Makes the bodies that many scenes share. Lengths are in metres, angles in radians. */
final class SceneBodies {
  static final float PI = (float) Math.PI;
  static final Material STONE = SceneColors.of(SceneColors.STONE);

  private SceneBodies() {}

  /** Makes a floor whose surface is y = 0. */
  static void floor(SceneWorld<?> s, float halfWidth) {
    fixed(s, new Box(halfWidth, 0.5f), 0, -0.5f, 0, STONE);
  }

  /** Makes a floor with a wall at either end. */
  static void trough(SceneWorld<?> s, float halfWidth, float wallHeight) {
    floor(s, halfWidth + 0.5f);
    for (int side = -1; side <= 1; side += 2) {
      float x = side * (halfWidth + 0.25f);
      fixed(s, new Box(0.25f, wallHeight / 2), x, wallHeight / 2, 0, STONE);
    }
  }

  /** Makes a static body. */
  static <T> Body<T> fixed(
      SceneWorld<T> s, Shape shape, float x, float y, float angle, Material m) {
    return s.body(new BodyDef().shape(shape, m).position(x, y).angle(angle));
  }

  /** Makes a dynamic body. */
  static <T> Body<T> free(SceneWorld<T> s, Shape shape, float x, float y, Material m) {
    return s.body(new BodyDef(BodyType.DYNAMIC).shape(shape, m).position(x, y));
  }

  /** Makes a dynamic body of the default material in a colour. */
  static <T> Body<T> free(SceneWorld<T> s, Shape shape, float x, float y, int rgb) {
    return free(s, shape, x, y, SceneColors.of(rgb));
  }

  /**
   * Returns one of four shapes of about half a metre.
   *
   * @param k any number; neighbours get different shapes
   */
  static Shape smallShape(int k) {
    return switch (Math.floorMod(k, 4)) {
      case 0 -> new Circle(0.27f);
      case 1 -> new Box(0.25f, 0.25f);
      case 2 -> Polygon.regular(5, 0.3f);
      default -> new Box(0.34f, 0.17f);
    };
  }

  /** Removes dynamic bodies that fell below a height, so that an emitter can go on for ever. */
  static <T> void removeBelow(SceneWorld<T> s, float minY) {
    List<Body<T>> gone = new ArrayList<>();
    s.world()
        .forEachBody(
            body -> {
              if (body.type() == BodyType.DYNAMIC && body.y() < minY) {
                gone.add(body);
              }
            });
    gone.forEach(s::remove);
  }
}
