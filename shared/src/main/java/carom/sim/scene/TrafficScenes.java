package carom.sim.scene;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Shape;
import carom.physics.math.Trig;
import java.util.List;

/**
 * Makes the scenes on which the wire is measured: many small bodies of which some move, as in the
 * known comparisons of snapshot codecs.
 */
final class TrafficScenes {
  private static final float SMALL = 0.2f;
  private static final int CROSSING_TICKS = 1_110;

  private TrafficScenes() {}

  static List<Scene> all() {
    return List.of(
        new Scene(
            "plough",
            "a big box is driven to and fro through 900 small ones",
            new View(0, 6, 100, 38),
            TrafficScenes::plough),
        new Scene(
                "plough_above",
                "a big disc circles through 900 small boxes on a table, seen from above",
                new View(0, 0, 44, 44),
                TrafficScenes::ploughAbove)
            .with(new WorldDef().withGravity(0, 0)),
        new Scene(
            "churn",
            "600 small bodies in a turning drum: none of them ever rests",
            new View(0, 0, 24, 24),
            TrafficScenes::churn));
  }

  /** Makes a big box that turns round near either end of a trough, and hops now and then. */
  private static <T> void plough(SceneWorld<T> s) {
    SceneBodies.trough(s, 47, 20);
    Shape box = new Box(SMALL, SMALL);
    for (int k = 0; k < 900; k++) {
      int row = k / 150;
      float x = (k % 150 - 74.5f) * 0.6f;
      SceneBodies.free(s, box, x, SMALL + 2 * SMALL * row, SceneColors.bright(row));
    }
    Body<T> big =
        s.body(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(1.5f, 1.5f), SceneColors.of(SceneColors.CORAL).withDensity(4))
                .position(-46, 1.6f));
    s.eachTick(
        tick -> {
          float goal = tick / CROSSING_TICKS % 2 == 0 ? 5 : -5;
          float hop = tick % 240 == 239 ? 5 : big.velocityY();
          big.setVelocity(big.velocityX() + 0.08f * (goal - big.velocityX()), hop);
        });
  }

  private static <T> void ploughAbove(SceneWorld<T> s) {
    Shape box = new Box(SMALL, SMALL);
    for (int k = 0; k < 900; k++) {
      int row = k / 30;
      s.body(
          new BodyDef(BodyType.DYNAMIC)
              .shape(box, SceneColors.of(SceneColors.bright(row)))
              .linearDamping(3)
              .angularDamping(3)
              .position((k % 30 - 14.5f) * 1.2f, (row - 14.5f) * 1.2f));
    }
    Body<T> big =
        s.body(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Circle(1.5f), SceneColors.of(SceneColors.CORAL).withDensity(6))
                .position(-20, 0));
    // It circles around a point that circles around the origin.
    s.eachTick(
        tick -> {
          float goalX = 11 * Trig.cos(0.006f * tick) + 6 * Trig.cos(0.014f * tick);
          float goalY = 11 * Trig.sin(0.006f * tick) - 6 * Trig.sin(0.014f * tick);
          float pull = Math.min(1, tick / 60f);
          big.setVelocity(
              0.9f * big.velocityX() + 0.3f * pull * (goalX - big.x()),
              0.9f * big.velocityY() + 0.3f * pull * (goalY - big.y()));
        });
  }

  private static void churn(SceneWorld<?> s) {
    Material wall = SceneBodies.STONE.withFriction(0.9f);
    s.body(
        new BodyDef(BodyType.KINEMATIC)
            .shape(new Box(0.5f, 6, 6, 0), wall)
            .shape(new Box(0.5f, 6, -6, 0), wall)
            .shape(new Box(6, 0.5f, 0, 6), wall)
            .shape(new Box(6, 0.5f, 0, -6), wall)
            .angularVelocity(1.2f));
    for (int k = 0; k < 600; k++) {
      int row = k / 24;
      SceneBodies.free(
          s,
          SceneBodies.smallShape(k),
          (k % 24 - 11.5f) * 0.4f,
          (row - 12) * 0.4f,
          SceneColors.bright(k));
    }
  }
}
