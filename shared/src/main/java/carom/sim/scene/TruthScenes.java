package carom.sim.scene;

import static carom.sim.scene.SceneBodies.PI;
import static carom.sim.scene.SceneBodies.fixed;
import static carom.sim.scene.SceneBodies.free;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.ShapeDef;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import carom.physics.math.SimRandom;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Makes the experiments whose outcome a law of mechanics tells: what slides keeps its speed, what
 * bounces its energy, what is joined its length, and nothing passes anything unseen.
 */
final class TruthScenes {
  private static final Material ICE = new Material(1, 0, 0);
  private static final Material ELASTIC = new Material(1, 0, 1);
  private static final int LANES = 20;

  private TruthScenes() {}

  /** Returns the scenes. */
  static List<Scene> all() {
    return List.of(
        new Scene(
            "seams",
            "without friction, over rows of boxes, wedges, turned boxes and ten chains",
            new View(0, 5, 60, 22),
            TruthScenes::seams),
        gas(
            "gas_isolated",
            "1,000 elastic discs fly apart; none of their energy is lost",
            new View(0, 0, 120, 70),
            false),
        gas(
            "gas_closed",
            "1,000 elastic discs in a box that they nearly fill",
            new View(0, 0, 36, 24),
            true),
        weightless(
            "blows_in_a_row",
            "rows of five discs, 10 cm to 0 apart: the last leaves as the first came",
            new View(2, 0, 26, 15),
            TruthScenes::rows),
        new Scene(
            "cradle_of_three",
            "three balls that touch, on rods: one falls, one rises",
            new View(1, 2, 14, 8),
            TruthScenes::cradle),
        weightless(
            "billiards",
            "fifteen balls in a triangle, struck at 8 m/s",
            new View(0, 0, 24, 14),
            TruthScenes::billiards),
        new Scene(
            "tilted_box",
            "an elastic box that lands on a corner keeps its energy",
            new View(0, 3, 16, 9),
            s -> turned(tray(s, 5, 60), new Box(0.5f, 0.3f), 0, 3, 0.3f)),
        new Scene(
            "elastic_boxes",
            "forty elastic boxes in a bin keep what energy they have",
            new View(0, 8, 30, 20),
            s -> {
              SimRandom rng = new SimRandom(1);
              for (int i = 0; i < 40; i++) {
                int layer = i / 5;
                float x = (i % 5 - 2) * 1.8f;
                turned(
                    tray(s, 5, i == 0 ? 60 : 0),
                    new Box(0.5f, 0.3f),
                    x,
                    2 + 1.5f * layer,
                    rng.between(-1, 1));
              }
            }),
        new Scene(
            "heavy_chains",
            "hinges that carry 1,000 times a link, and 100 times over 100 links",
            new View(0, 0, 240, 240),
            s -> {
              chain(s, -40, 30, 1000);
              chain(s, 20, 100, 100);
            }),
        weightless(
            "sensor_shots",
            "twenty bullets at 300 m/s to and fro through sensors of a metre",
            new View(0, 0, 84, 48),
            TruthScenes::shots),
        weightless(
            "paddles",
            "paddles at 100 m/s take resting bullets along",
            new View(0, 0, 84, 48),
            TruthScenes::paddles));
  }

  private static Scene weightless(
      String name, String what, View view, Consumer<SceneWorld<?>> builder) {
    return new Scene(name, what, view, builder).with(new WorldDef().withGravity(0, 0));
  }

  private static Scene gas(String name, String what, View view, boolean closed) {
    Scene scene = weightless(name, what, view, s -> gas(s, closed));
    return scene.with(scene.def().withRestitutionThreshold(0));
  }

  private static void seams(SceneWorld<?> s) {
    Material stone = ICE.withTag(SceneColors.STONE);
    for (int i = 0; i < 50; i++) {
      float x = i - 24.5f;
      fixed(s, new Box(0.5f, 0.5f), x, -0.5f, 0, stone);
      fixed(s, Polygon.of(-0.5f, 0, -0.2f, -1, 0.2f, -1, 0.5f, 0), x, 4, 0, stone);
      fixed(s, new Box(0.5f, 0.5f), x, 7.5f, i % 4 * PI / 2, stone);
    }
    for (int i = 0; i < 10; i++) {
      fixed(s, Chain.open(-3.5f, 0, -2.5f, 0, 0, 0, 2.5f, 0, 3.5f, 0), 5 * i - 22.5f, 12, 0, stone);
    }
    float[] speeds = {20, 5, 2};
    for (int floor = 0; floor < 4; floor++) {
      for (int i = 0; i < 6; i++) {
        Shape shape = (i & 1) == 0 ? new Circle(0.5f) : new Box(0.5f, 0.5f);
        s.body(
            new BodyDef(BodyType.DYNAMIC)
                .shape(shape, ICE.withTag(SceneColors.bright(i)))
                .position(-16.5f - 1.5f * i, 4 * floor + 0.5f)
                .velocity(speeds[i / 2], 0));
      }
    }
  }

  private static void gas(SceneWorld<?> s, boolean closed) {
    SimRandom rng = new SimRandom(1);
    for (int i = 0; i < 1000; i++) {
      int row = i / 32;
      s.body(
          new BodyDef(BodyType.DYNAMIC)
              .shape(new Circle(0.25f), ELASTIC.withTag(SceneColors.bright(row)))
              .position(
                  (i % 32 - 15.5f) * 0.55f + rng.between(-0.02f, 0.02f),
                  (row - 15.5f) * 0.55f + rng.between(-0.02f, 0.02f))
              .velocity(rng.between(-5, 5), rng.between(-5, 5)));
    }
    Material wall = ELASTIC.withTag(SceneColors.STONE);
    for (int side = -1; closed && side <= 1; side += 2) {
      fixed(s, new Box(1, 12), side * 11, 0, 0, wall);
      fixed(s, new Box(12, 1), 0, side * 11, 0, wall);
    }
  }

  private static void rows(SceneWorld<?> s) {
    float[] gaps = {0.1f, 0.05f, 0.02f, 0.005f, 0};
    for (int row = 0; row < gaps.length; row++) {
      for (int i = 0; i < 5; i++) {
        float x = -4 + i * (1 + gaps[row]) + (i > 0 ? 0.5f : 0);
        s.body(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Circle(0.5f), ELASTIC.withTag(SceneColors.bright(row)))
                .position(x, 2.5f * (row - 2))
                .velocity(i == 0 ? 3 : 0, 0));
      }
    }
  }

  private static <T> void cradle(SceneWorld<T> s) {
    Body<T> beam = fixed(s, new Box(2, 0.1f), 1, 5, 0, SceneBodies.STONE);
    for (int i = 0; i < 3; i++) {
      float angle = i == 0 ? 0.6f : 0;
      float x = i - 5 * (float) StrictMath.sin(angle);
      float y = 5 - 5 * (float) StrictMath.cos(angle);
      Material m = ELASTIC.withTag(i == 0 ? SceneColors.AMBER : SceneColors.STEEL);
      Body<T> ball = free(s, new Circle(0.5f), x, y, m);
      s.joint(JointDef.distance(beam, ball, i, 5, x, y));
    }
  }

  private static void billiards(SceneWorld<?> s) {
    Material ivory = new Material(1, 0, 0.95f);
    for (int row = 0; row < 5; row++) {
      for (int i = 0; i <= row; i++) {
        Material m = ivory.withTag(SceneColors.bright(row + i));
        free(s, new Circle(0.5f), row * 0.86605f, i - row / 2f, m);
      }
    }
    s.body(
        new BodyDef(BodyType.DYNAMIC)
            .shape(new Circle(0.5f), ivory.withTag(SceneColors.PAPER))
            .position(-3, 0.01f)
            .velocity(8, 0));
  }

  /** Makes a floor with elastic walls of a height, unless that is 0, and returns the world. */
  private static <T> SceneWorld<T> tray(SceneWorld<T> s, float halfWidth, float height) {
    if (height > 0) {
      fixed(s, new Box(halfWidth + 2, 1), 0, -1, 0, ICE.withTag(SceneColors.STONE));
      for (int side = -1; side <= 1; side += 2) {
        Material wall = ELASTIC.withTag(SceneColors.STONE);
        fixed(s, new Box(1, height / 2), side * (halfWidth + 1), height / 2, 0, wall);
      }
    }
    return s;
  }

  private static void turned(SceneWorld<?> s, Shape shape, float x, float y, float angle) {
    Material m = ELASTIC.withTag(SceneColors.bright(Math.round(y)));
    s.body(new BodyDef(BodyType.DYNAMIC).shape(shape, m).position(x, y).angle(angle));
  }

  /** Makes a level chain of links of a metre and a kilogram; the last one is heavier. */
  private static <T> void chain(SceneWorld<T> s, float x0, int links, float ratio) {
    Filter together = Filter.DEFAULT.withGroup(-1);
    List<Body<T>> chain = new ArrayList<>();
    for (int i = 0; i < links; i++) {
      boolean last = i == links - 1;
      Material m = SceneColors.of(last ? SceneColors.CORAL : SceneColors.STEEL);
      Body<T> link =
          s.body(
              new BodyDef(BodyType.DYNAMIC)
                  .shape(new Box(0.5f, 0.1f), m.withDensity(5 * (last ? ratio : 1)), together)
                  .position(x0 + i + 0.5f, 0));
      s.joint(JointDef.revolute(i == 0 ? null : chain.get(i - 1), link, x0 + i, 0));
      chain.add(link);
    }
  }

  private static float lane(int i) {
    return 2 * (i - (LANES - 1) / 2f);
  }

  private static BodyDef bullet(int i, float x) {
    return new BodyDef(BodyType.DYNAMIC)
        .shape(new Circle(0.1f), ELASTIC.withTag(SceneColors.AMBER))
        .bullet(true)
        .position(x, lane(i));
  }

  private static void shots(SceneWorld<?> s) {
    for (int side = -1; side <= 1; side += 2) {
      fixed(s, new Box(1, 22), side * 41, 0, 0, ELASTIC.withTag(SceneColors.STONE));
    }
    for (int i = 0; i < LANES; i++) {
      ShapeDef sensor = new ShapeDef(new Box(0.5f, 0.6f), SceneColors.of(SceneColors.TEAL));
      s.body(new BodyDef().shape(sensor.withSensor(true)).position(0, lane(i)));
      s.body(bullet(i, -20 - 0.25f * i).velocity(300, 0));
    }
  }

  private static <T> void paddles(SceneWorld<T> s) {
    fixed(s, new Box(1, 22), 41, 0, 0, SceneBodies.STONE);
    List<Body<T>> paddles = new ArrayList<>();
    for (int i = 0; i < LANES; i++) {
      s.body(bullet(i, 0));
      paddles.add(
          s.body(
              new BodyDef(BodyType.KINEMATIC)
                  .shape(new Box(0.05f, 0.5f), SceneColors.of(SceneColors.CORAL))
                  .position(-38 - i / 12f, lane(i))
                  .velocity(100, 0)));
    }
    s.eachTick(
        tick -> {
          if (tick == 28) {
            paddles.forEach(paddle -> paddle.setVelocity(0, 0));
          }
        });
  }
}
