package carom.sim.scene;

import static carom.sim.scene.SceneBodies.fixed;
import static carom.sim.scene.SceneBodies.floor;
import static carom.sim.scene.SceneBodies.free;
import static carom.sim.scene.SceneBodies.trough;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.WorldDef;
import carom.physics.effects.Explosion;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import java.util.List;

/** Makes the scenes of stacks, houses and falling bodies. */
final class StackScenes {
  private StackScenes() {}

  static List<Scene> all() {
    return List.of(
        new Scene(
            "pyramid",
            "20 rows of crates stand still until a heavy ball comes",
            new View(0, 10.5f, 40, 24),
            StackScenes::pyramid),
        new Scene(
            "dominoes",
            "each domino topples one that is a sixth larger",
            new View(2, 4, 26, 11),
            StackScenes::dominoes),
        new Scene(
                "newton_cradle",
                "two elastic balls come, two go; the rest stay where they hang",
                new View(0, 4, 14, 9),
                StackScenes::cradle)
            .with(new WorldDef().withRestitutionThreshold(0.05f)),
        new Scene(
            "arch",
            "a stone arch carries itself and whatever lands on it",
            new View(0, 4.2f, 20, 12),
            StackScenes::arch),
        new Scene(
            "card_house",
            "five storeys of cards, held by friction alone",
            new View(0, 4.6f, 15, 11),
            StackScenes::cardHouse),
        new Scene(
            "sleep_field",
            "resting towers sleep; a rolling ball wakes those it touches",
            new View(0, 6, 46, 18),
            StackScenes::sleepField),
        new Scene(
            "explosion",
            "a bang below a house of crates, every five seconds",
            new View(0, 6, 26, 15),
            StackScenes::explosion),
        new Scene(
            "bullets",
            "shots at 1,000 m/s against walls of one centimetre",
            new View(0, 5, 26, 13),
            StackScenes::bullets));
  }

  private static void pyramid(SceneWorld<?> s) {
    floor(s, 60);
    Shape crate = new Box(0.5f, 0.5f);
    for (int row = 0; row < 20; row++) {
      int rgb = SceneColors.mix(SceneColors.CORAL, SceneColors.AMBER, row / 19f);
      for (int i = 0; i < 20 - row; i++) {
        free(s, crate, i - (19 - row) / 2f, row + 0.5f, rgb);
      }
    }
    s.eachTick(
        tick -> {
          if (tick == 240) {
            s.body(
                new BodyDef(BodyType.DYNAMIC)
                    .shape(new Circle(1.2f), SceneColors.of(SceneColors.STEEL).withDensity(8))
                    .position(-24, 6)
                    .velocity(26, 4));
          }
        });
  }

  private static void dominoes(SceneWorld<?> s) {
    floor(s, 40);
    float x = -8;
    float half = 0.25f;
    for (int i = 0; i < 17; i++) {
      int rgb = SceneColors.mix(SceneColors.SKY, SceneColors.VIOLET, i / 16f);
      Body<?> domino = free(s, new Box(half * 0.14f, half), x, half, rgb);
      if (i == 0) {
        domino.setAngularVelocity(-3.5f);
      }
      x += half * 0.95f;
      half *= 7f / 6;
    }
  }

  private static <T> void cradle(SceneWorld<T> s) {
    fixed(s, new Box(5, 0.2f), 0, 8.2f, 0, SceneBodies.STONE);
    Material steel = new Material(4, 0, 1).withTag(SceneColors.STEEL);
    int balls = 7;
    for (int i = 0; i < balls; i++) {
      // The gaps make the balls hit one after the other, as billiard balls do.
      float anchorX = (i - (balls - 1) / 2f) * 1.05f;
      boolean lifted = i < 2;
      float x = lifted ? anchorX - 3.6f : anchorX;
      float y = lifted ? 8 - 4.8f : 8 - 6;
      Body<T> ball =
          free(s, new Circle(0.5f), x, y, lifted ? steel.withTag(SceneColors.AMBER) : steel);
      s.joint(JointDef.distance(null, ball, anchorX, 8, x, y));
    }
  }

  private static void arch(SceneWorld<?> s) {
    floor(s, 30);
    float inner = 4;
    float outer = 5.2f;
    float spring = 1;
    for (int side = -1; side <= 1; side += 2) {
      fixed(s, new Box(0.8f, spring / 2), side * 4.6f, spring / 2, 0, SceneBodies.STONE);
    }
    int stones = 15;
    for (int i = 0; i < stones; i++) {
      double from = Math.PI * i / stones;
      double to = Math.PI * (i + 1) / stones;
      Polygon stone =
          Polygon.of(
              ring(inner, from, true), ring(inner, from, false),
              ring(outer, from, true), ring(outer, from, false),
              ring(outer, to, true), ring(outer, to, false),
              ring(inner, to, true), ring(inner, to, false));
      int rgb = i == stones / 2 ? SceneColors.AMBER : SceneColors.mix(0x8d99ae, 0xb8c1d1, i % 2);
      free(s, stone, 0, spring, new Material(2, 0.8f, 0).withTag(rgb));
    }
    s.eachTick(
        tick -> {
          if (tick >= 120 && tick % 60 == 0 && tick <= 600) {
            int k = tick / 60;
            free(s, SceneBodies.smallShape(k), (k % 3 - 1) * 0.5f, 9, SceneColors.bright(k));
          }
        });
  }

  private static float ring(double radius, double angle, boolean isX) {
    return (float) (radius * (isX ? StrictMath.cos(angle) : StrictMath.sin(angle)));
  }

  private static void cardHouse(SceneWorld<?> s) {
    floor(s, 20);
    double lean = StrictMath.toRadians(24);
    double half = 1;
    double thick = 0.03;
    double sin = StrictMath.sin(lean);
    double cos = StrictMath.cos(lean);
    double foot = thick * cos + half * sin; // from a card's middle to its outermost point
    double rise = thick * sin + half * cos;
    Shape card = new Box((float) thick, (float) half);
    Shape flat = new Box((float) (2 * foot - 0.004), (float) thick);
    Material paper = new Material(0.5f, 0.9f, 0);
    double base = 0;
    for (int storey = 5; storey > 0; storey--) {
      for (int i = 0; i < storey; i++) {
        double x = (i - (storey - 1) / 2.0) * 4 * foot;
        Material back =
            paper.withTag((i + storey) % 2 == 0 ? SceneColors.PAPER : SceneColors.CORAL);
        for (int side = -1; side <= 1; side += 2) {
          s.body(
              new BodyDef(BodyType.DYNAMIC)
                  .shape(card, back)
                  .position((float) (x + side * foot), (float) (base + rise))
                  .angle((float) (side * lean)));
        }
        if (i > 0) {
          float y = (float) (base + 2 * rise + thick);
          free(s, flat, (float) (x - 2 * foot), y, paper.withTag(SceneColors.SKY));
        }
      }
      base += 2 * rise + 2 * thick;
    }
  }

  private static void sleepField(SceneWorld<?> s) {
    trough(s, 22, 4);
    for (int i = 0; i < 19; i++) {
      int height = 2 + i % 4;
      for (int j = 0; j < height; j++) {
        free(s, new Box(0.45f, 0.45f), -16 + 2 * i, 0.45f + 0.9f * j, SceneColors.bright(i % 6));
      }
    }
    s.eachTick(
        tick -> {
          if (tick == 150) {
            s.body(
                new BodyDef(BodyType.DYNAMIC)
                    .shape(new Circle(1), SceneColors.of(SceneColors.STEEL).withDensity(6))
                    .position(-20, 1)
                    .velocity(13, 0)
                    .angularVelocity(-13));
          }
        });
  }

  private static <T> void explosion(SceneWorld<T> s) {
    trough(s, 15, 6);
    for (int i = 0; i < 9; i++) {
      for (int j = 0; j < 7; j++) {
        free(
            s,
            new Box(0.4f, 0.4f),
            (i - 4) * 0.82f,
            1.4f + 0.8f * j,
            SceneColors.mix(SceneColors.WOOD, SceneColors.CORAL, j / 6f));
      }
    }
    for (int side = -1; side <= 1; side += 2) {
      fixed(s, new Box(0.5f, 0.4f), side * 3, 0.4f, 0, SceneBodies.STONE);
    }
    free(s, new Box(3.8f, 0.1f), 0, 0.9f, SceneColors.STEEL);
    Explosion bang = new Explosion(0, 0.4f, 7).impulse(9);
    s.eachTick(
        tick -> {
          if (tick % 300 == 180) {
            bang.explode(s.world());
          }
        });
  }

  private static void bullets(SceneWorld<?> s) {
    trough(s, 12, 12);
    for (int lane = 0; lane < 4; lane++) {
      float y = 1 + 2.5f * lane;
      fixed(s, new Box(0.005f, 1), 4, y, 0, SceneColors.of(SceneColors.STEEL));
      fixed(s, new Box(0.9f, 0.05f), 6, y - 0.5f, 0, SceneBodies.STONE);
      for (int i = 0; i < 3; i++) {
        free(s, new Box(0.2f, 0.2f), 6, y - 0.25f + 0.4f * i, SceneColors.bright(lane));
      }
    }
    s.eachTick(
        tick -> {
          if (tick % 60 == 59 && tick < 1200) {
            int shot = tick / 60;
            s.body(
                new BodyDef(BodyType.DYNAMIC)
                    .bullet(true)
                    .shape(
                        shot % 2 == 0 ? new Circle(0.1f) : new Box(0.16f, 0.06f),
                        SceneColors.of(SceneColors.bright(shot)).withDensity(4))
                    .position(-11, 1 + 2.5f * (shot % 4))
                    .velocity(1000, 0)
                    .angularVelocity(shot % 3 * 20));
          }
        });
  }
}
