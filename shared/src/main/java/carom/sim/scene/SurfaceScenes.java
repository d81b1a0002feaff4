package carom.sim.scene;

import static carom.sim.scene.SceneBodies.fixed;
import static carom.sim.scene.SceneBodies.floor;
import static carom.sim.scene.SceneBodies.free;
import static carom.sim.scene.SceneBodies.trough;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.WorldDef;
import carom.physics.effects.OneWay;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import java.util.ArrayList;
import java.util.List;

/** Makes the scenes of surfaces: friction, restitution, belts, one-way platforms, terrain. */
final class SurfaceScenes {
  /** Colour that marks one-way surfaces, which carry only what comes from above. */
  private static final int ONE_WAY = SceneColors.LEAF;

  private SurfaceScenes() {}

  static List<Scene> all() {
    return List.of(
        new Scene(
            "conveyor",
            "belts: surfaces that move while their bodies rest",
            new View(0, 5, 24, 13),
            SurfaceScenes::conveyor),
        new Scene(
            "one_way_platforms",
            "green platforms let through what comes from below",
            new View(0, 5, 22, 12),
            SurfaceScenes::oneWayPlatforms),
        new Scene(
                "bouncing",
                "restitution from 0 to 1 in eleven balls",
                new View(0, 4, 20, 10),
                SurfaceScenes::bouncing)
            .with(new WorldDef().withRestitutionThreshold(0.1f)),
        new Scene(
            "friction_ramp",
            "on a slope of 25 degrees, what has a friction above 0.47 stays",
            new View(0, 4.5f, 26, 12),
            SurfaceScenes::frictionRamp),
        new Scene(
            "rolling",
            "rolling resistance from 0 to 0.1: how far a ball rolls",
            new View(0, 6, 30, 14),
            SurfaceScenes::rolling),
        new Scene(
            "terrain",
            "chains are solid from one side and have no bumps where segments meet",
            new View(0, 3, 34, 16),
            SurfaceScenes::terrain));
  }

  private static <T> void conveyor(SceneWorld<T> s) {
    for (int i = 0; i < 4; i++) {
      int side = i % 2 == 0 ? 1 : -1;
      Material belt = new Material(1, 0.9f, 0).withTangentSpeed(3 * side);
      fixed(
          s,
          new Capsule(-4.5f, 0, 4.5f, 0, 0.3f),
          -1.8f * side,
          9.2f - 2.5f * i,
          0.06f * side,
          belt.withTag(SceneColors.mix(SceneColors.STONE, SceneColors.TEAL, 0.35f)));
    }
    s.eachTick(
        tick -> {
          if (tick % 40 == 0) {
            int k = tick / 40;
            free(s, SceneBodies.smallShape(k), -6 + 0.3f * (k % 3), 11, SceneColors.bright(k));
            SceneBodies.removeBelow(s, -8);
          }
        });
  }

  private static <T> void oneWayPlatforms(SceneWorld<T> s) {
    trough(s, 10, 9);
    Material grass = SceneColors.of(ONE_WAY);
    for (int row = 0; row < 3; row++) {
      for (int i = 0; i < 3; i++) {
        float x = (i - 1) * 6 + (row % 2) * 2 - 1;
        float angle = (i - 1) * 0.15f;
        fixed(s, new Box(1.8f, 0.12f), x, 2 + 2.4f * row, angle, grass);
      }
    }
    List<Body<T>> jumpers = new ArrayList<>();
    for (int i = 0; i < 16; i++) {
      Body<T> jumper =
          free(s, SceneBodies.smallShape(i), -8 + 1.06f * i, 0.5f, SceneColors.bright(i));
      jumpers.add(jumper);
    }
    s.eachTick(
        tick -> {
          for (int i = 0; i < jumpers.size(); i++) {
            if ((tick + 37 * i) % 200 == 100) {
              Body<T> jumper = jumpers.get(i);
              float mass = jumper.mass();
              jumper.applyImpulse(0, mass * 8.5f);
            }
          }
        });
    s.listener(new OneWay<>((body, shape) -> body.material(shape).tag() == ONE_WAY));
  }

  private static void bouncing(SceneWorld<?> s) {
    floor(s, 12);
    for (int i = 0; i <= 10; i++) {
      float e = i / 10f;
      Material m =
          new Material(1, 0.6f, e)
              .withTag(SceneColors.mix(SceneColors.STEEL, SceneColors.CORAL, e));
      free(s, new Circle(0.5f), -7.5f + 1.5f * i, 7, m);
    }
  }

  private static void frictionRamp(SceneWorld<?> s) {
    float slope = (float) StrictMath.toRadians(25);
    float cos = (float) StrictMath.cos(slope);
    float sin = (float) StrictMath.sin(slope);
    floor(s, 20);
    fixed(s, new Box(11, 0.25f), 0, 4.8f, -slope, new Material(1, 1, 0).withTag(SceneColors.STONE));
    fixed(s, new Box(0.25f, 2), 12, 2, 0, SceneBodies.STONE);
    for (int i = 0; i < 10; i++) {
      // Friction mixes as sqrt(f1 f2), and the slope has 1. The most slippery boxes are lowest.
      float f = 0.29f + 0.04f * i;
      float along = 9 - 1.9f * i;
      int rgb = SceneColors.mix(SceneColors.SKY, SceneColors.CORAL, i / 9f);
      s.body(
          new BodyDef(BodyType.DYNAMIC)
              .shape(new Box(0.5f, 0.35f), new Material(1, f * f, 0).withTag(rgb))
              .position(along * cos + 0.6f * sin, 4.8f - along * sin + 0.6f * cos)
              .angle(-slope));
    }
  }

  private static void rolling(SceneWorld<?> s) {
    for (int i = 0; i < 7; i++) {
      float y = 0.3f + 1.9f * i;
      fixed(s, new Box(13.5f, 0.1f), 0, y, 0, SceneBodies.STONE);
      fixed(s, new Box(0.1f, 0.5f), 13.4f, y + 0.6f, 0, SceneBodies.STONE);
      float c = i == 0 ? 0 : 0.1f * i / 6;
      Material m =
          new Material(1, 0.9f, 0.2f)
              .withRollingResistance(c)
              .withTag(SceneColors.mix(SceneColors.TEAL, SceneColors.VIOLET, i / 6f));
      s.body(
          new BodyDef(BodyType.DYNAMIC)
              .shape(new Circle(0.55f), m)
              .position(-12.5f, y + 0.65f)
              .velocity(4.5f, 0)
              .angularVelocity(-4.5f / 0.55f));
    }
  }

  private static void terrain(SceneWorld<?> s) {
    int points = 65;
    float[] hills = new float[2 * points];
    for (int i = 0; i < points; i++) {
      float x = -16 + 0.5f * i;
      hills[2 * i] = x;
      hills[2 * i + 1] = (float) (0.8 * StrictMath.cos(0.7 * x) + 0.012 * x * x - 0.5);
    }
    s.body(new BodyDef().shape(Chain.open(hills), SceneBodies.STONE));
    int corners = 40;
    float[] bowl = new float[2 * corners];
    for (int i = 0; i < corners; i++) {
      double a = 2 * Math.PI * i / corners;
      bowl[2 * i] = (float) (3.2 * StrictMath.cos(a));
      bowl[2 * i + 1] = (float) (2.2 * StrictMath.sin(a));
    }
    s.body(
        new BodyDef(BodyType.KINEMATIC)
            .shape(Chain.loop(bowl), SceneColors.of(SceneColors.STEEL))
            .position(0, 6.5f)
            .angularVelocity(0.8f));
    for (int i = 0; i < 24; i++) {
      int row = i / 5;
      free(
          s,
          SceneBodies.smallShape(i),
          -1.4f + 0.7f * (i % 5),
          5.6f + 0.6f * row,
          SceneColors.bright(i));
    }
    for (int i = 0; i < 10; i++) {
      int side = i % 2 == 0 ? -1 : 1;
      free(s, new Circle(0.4f), side * (8 + 0.85f * i), 6, SceneColors.bright(i));
    }
  }
}
