package carom.sim.scene;

import static carom.sim.scene.SceneBodies.fixed;
import static carom.sim.scene.SceneBodies.floor;
import static carom.sim.scene.SceneBodies.free;
import static carom.sim.scene.SceneBodies.trough;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.ShapeDef;
import carom.physics.WorldDef;
import carom.physics.effects.AreaEffect;
import carom.physics.effects.Attractor;
import carom.physics.effects.Buoyancy;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.SimRandom;
import java.util.List;

/** Makes the scenes of many bodies, sensors, filters, fluids and winds. */
final class MixedScenes {
  private MixedScenes() {}

  static List<Scene> all() {
    return List.of(
        new Scene(
            "mixer",
            "two paddles stir two colours into one",
            new View(0, 6.5f, 26, 15),
            MixedScenes::mixer),
        new Scene(
            "galton", "balls find the bell curve", new View(0, 9, 30, 21), MixedScenes::galton),
        new Scene(
            "shapes",
            "every shape there is: discs, boxes, polygons, capsules, rounded ones, compounds",
            new View(0, 6, 26, 14),
            MixedScenes::shapes),
        new Scene(
            "sensors",
            "a shaft that notices what is in it, and lifts it",
            new View(0, 6, 24, 14),
            MixedScenes::sensors),
        new Scene(
            "filters",
            "three sieves, each of which only one colour meets",
            new View(0, 5.5f, 22, 13),
            MixedScenes::filters),
        new Scene(
            "buoyancy",
            "light and heavy things in a pool with a current",
            new View(0, 4, 28, 14),
            MixedScenes::buoyancy),
        new Scene(
            "wind",
            "a gust turns the mill and drives the leaves",
            new View(0, 5, 26, 13),
            MixedScenes::wind),
        new Scene(
                "orbits",
                "two hundred moons around a planet, by an inverse-square attractor",
                new View(0, 0, 44, 24),
                MixedScenes::orbits)
            .with(new WorldDef().withGravity(0, 0)));
  }

  private static void mixer(SceneWorld<?> s) {
    trough(s, 9, 12);
    for (int side = -1; side <= 1; side += 2) {
      s.body(
          new BodyDef(BodyType.KINEMATIC)
              .shape(
                  Polygon.rounded(0.15f, -2.6f, -0.1f, 2.6f, -0.1f, 2.6f, 0.1f, -2.6f, 0.1f),
                  SceneColors.of(SceneColors.STEEL))
              .position(side * 4.2f, 3.2f)
              .angularVelocity(side * 1.6f));
    }
    for (int row = 0; row < 22; row++) {
      for (int column = 0; column < 26; column++) {
        boolean left = column < 13;
        float x = (column - 12.5f) * 0.66f;
        int rgb =
            left
                ? SceneColors.mix(SceneColors.AMBER, SceneColors.CORAL, row % 3 / 4f)
                : SceneColors.mix(SceneColors.SKY, SceneColors.VIOLET, row % 3 / 4f);
        if (Math.abs(x - Math.copySign(4.2f, x)) > 2.9f || row * 0.62f > 6.4f) {
          free(s, SceneBodies.smallShape(row + column), x, 0.5f + 0.62f * row, rgb);
        }
      }
    }
  }

  private static <T> void galton(SceneWorld<T> s) {
    Material peg = new Material(1, 0.1f, 0.4f).withTag(SceneColors.STEEL);
    for (int row = 0; row < 12; row++) {
      for (int i = 0; i <= row + 2; i++) {
        fixed(s, new Circle(0.12f), i - (row + 2) / 2f, 17 - 0.85f * row, 0, peg);
      }
    }
    floor(s, 10);
    for (int i = 0; i <= 16; i++) {
      fixed(s, new Box(0.06f, 3), i - 8, 3, 0, SceneBodies.STONE);
    }
    for (int side = -1; side <= 1; side += 2) {
      fixed(s, new Box(0.1f, 1.2f), side * 1.15f, 19.2f, side * -0.75f, SceneBodies.STONE);
      fixed(s, new Box(0.1f, 6.6f), side * 5f, 12, side * 0.52f, SceneBodies.STONE);
    }
    Material ball = new Material(1, 0.1f, 0.4f);
    s.eachTick(
        tick -> {
          if (tick % 9 == 0 && tick < 9 * 420) {
            int k = tick / 9;
            SimRandom rng = new SimRandom(k);
            int rgb = SceneColors.mix(SceneColors.AMBER, SceneColors.CORAL, k % 60 / 60f);
            free(s, new Circle(0.17f), rng.between(-0.25f, 0.25f), 19.6f, ball.withTag(rgb));
          }
        });
  }

  private static void shapes(SceneWorld<?> s) {
    trough(s, 11, 9);
    Shape[] kinds = {
      new Circle(0.5f),
      new Box(0.6f, 0.35f),
      Polygon.regular(3, 0.6f),
      Polygon.regular(6, 0.55f),
      new Capsule(-0.5f, 0, 0.5f, 0, 0.25f),
      Polygon.rounded(0.2f, -0.4f, -0.3f, 0.4f, -0.3f, 0, 0.4f),
      Compound.of(new Box(0.6f, 0.18f), new Box(0.18f, 0.6f)),
      Compound.of(new Box(0.6f, 0.18f, 0, -0.4f), new Box(0.18f, 0.4f, -0.42f, 0.18f)),
      Compound.of(new Circle(0.35f, -0.55f, 0), new Circle(0.35f, 0.55f, 0), new Box(0.55f, 0.1f)),
      Compound.of(
          new Capsule(-0.5f, 0.4f, -0.3f, -0.3f, 0.12f),
          new Capsule(-0.3f, -0.3f, 0.3f, -0.3f, 0.12f),
          new Capsule(0.3f, -0.3f, 0.5f, 0.4f, 0.12f)),
    };
    for (int i = 0; i < 90; i++) {
      int row = i / 9;
      s.body(
          new BodyDef(BodyType.DYNAMIC)
              .shape(kinds[i % kinds.length], SceneColors.of(SceneColors.bright(i % kinds.length)))
              .position((i % 9 - 4) * 2 + 0.3f * (row % 2), 2 + 1.4f * row)
              .angle(0.7f * i));
    }
  }

  private static <T> void sensors(SceneWorld<T> s) {
    trough(s, 9, 5);
    fixed(s, new Box(3.6f, 0.2f), -5.2f, 1.4f, -0.35f, SceneBodies.STONE);
    fixed(s, new Box(3.6f, 0.2f), 5.2f, 1.4f, 0.35f, SceneBodies.STONE);
    Material air = SceneColors.of(SceneColors.TEAL);
    Body<T> shaft =
        s.body(
            new BodyDef()
                .shape(new ShapeDef(new Box(1.6f, 5), air).withSensor(true))
                .position(0, 5));
    for (int i = 0; i < 40; i++) {
      free(
          s, SceneBodies.smallShape(i), (i % 10 - 4.5f) * 1.6f, 4 + i / 10f, SceneColors.bright(i));
    }
    s.eachTick(
        tick ->
            shaft.forEachOverlap(
                body -> {
                  float side = body.x() < 0 ? -1 : 1;
                  float out = body.y() > 8 ? 4 * side : 0;
                  body.seekVelocity(out, 7, 6 * body.mass(), 1f / Scene.DEFAULT_TICK_RATE);
                  return true;
                }));
  }

  private static <T> void filters(SceneWorld<T> s) {
    trough(s, 8, 10);
    int[] colours = {SceneColors.CORAL, SceneColors.AMBER, SceneColors.SKY};
    for (int k = 0; k < 3; k++) {
      Filter sieve = new Filter(1, 2 << k);
      for (int i = -1; i <= 1; i += 2) {
        s.body(
            new BodyDef()
                .shape(new Box(4.1f, 0.12f), SceneColors.of(colours[k]), sieve)
                .position(4 * i, 2.6f + 2.2f * k)
                .angle(0.08f * i));
      }
    }
    s.eachTick(
        tick -> {
          if (tick % 12 == 0 && tick < 12 * 150) {
            int k = tick / 12;
            s.body(
                new BodyDef(BodyType.DYNAMIC)
                    .shape(
                        SceneBodies.smallShape(k),
                        SceneColors.of(colours[k % 3]),
                        new Filter(2 << k % 3, -1))
                    .position((k * 5 % 13 - 6) * 1.05f, 11));
          }
        });
  }

  private static void buoyancy(SceneWorld<?> s) {
    trough(s, 12, 8);
    Aabb pool = new Aabb(-12, 0, 12, 4.5f);
    Material water = SceneColors.of(SceneColors.WATER);
    s.body(
        new BodyDef()
            .shape(new ShapeDef(new Box(12, 2.25f), water).withSensor(true))
            .position(0, 2.25f));
    for (int i = 0; i < 30; i++) {
      int row = i / 10;
      float density = 0.15f + 0.06f * i;
      int rgb = SceneColors.mix(SceneColors.PAPER, 0x4a3b32, i / 29f);
      Shape shape = i % 5 == 4 ? new Box(1, 0.2f) : SceneBodies.smallShape(i);
      free(
          s,
          shape,
          (i % 10 - 4.5f) * 2.2f,
          6 + 1.3f * row,
          SceneColors.of(rgb).withDensity(density));
    }
    Buoyancy fluid = new Buoyancy(pool, 1).drag(1.5f).angularDrag(1).flow(0.6f, 0);
    s.eachTick(tick -> fluid.apply(s.world(), 1f / Scene.DEFAULT_TICK_RATE));
  }

  private static <T> void wind(SceneWorld<T> s) {
    trough(s, 12, 9);
    fixed(
        s,
        Polygon.of(-0.5f, 0, 0.5f, 0, 0.15f, 5, -0.15f, 5),
        3,
        0,
        0,
        new Material(1, 0.6f, 0).withTag(SceneColors.STONE));
    BodyDef sails = new BodyDef(BodyType.DYNAMIC).position(3, 5).angularDamping(0.3f);
    Filter above = new Filter(2, 0);
    sails.shape(new Box(2.6f, 0.1f), SceneColors.of(SceneColors.PAPER), above);
    sails.shape(new Box(0.1f, 2.6f), SceneColors.of(SceneColors.PAPER), above);
    Body<T> mill = s.body(sails);
    s.joint(JointDef.revolute(null, mill, 3, 5));
    for (int i = 0; i < 80; i++) {
      int rgb = SceneColors.mix(SceneColors.LEAF, SceneColors.AMBER, i % 8 / 7f);
      s.body(
          new BodyDef(BodyType.DYNAMIC)
              .shape(
                  Polygon.rounded(0.04f, -0.2f, 0, 0, -0.07f, 0.2f, 0, 0, 0.07f),
                  SceneColors.of(rgb).withDensity(0.3f),
                  new Filter(1, 1))
              .position(-11 + 0.27f * i, 1 + i % 7)
              .angle(i)
              .linearDamping(0.6f)
              .angularDamping(0.6f));
    }
    AreaEffect gust = AreaEffect.wind(new Aabb(-12, 2, 12, 9), 9, 1.2f, 1.6f).categories(1);
    AreaEffect draught = AreaEffect.wind(new Aabb(-12, 0, 12, 2), -7, 1.5f, 1.6f).categories(1);
    s.eachTick(
        tick -> {
          gust.apply(s.world(), 1f / Scene.DEFAULT_TICK_RATE);
          draught.apply(s.world(), 1f / Scene.DEFAULT_TICK_RATE);
          mill.applyTorque(-40);
        });
  }

  private static void orbits(SceneWorld<?> s) {
    fixed(s, new Circle(2.5f), 0, 0, 0, SceneColors.of(SceneColors.AMBER));
    SimRandom rng = new SimRandom(3);
    for (int i = 0; i < 200; i++) {
      double radius = 4.5 + 7 * Math.sqrt(rng.nextFloat());
      double a = 2 * Math.PI * rng.nextFloat();
      // Circular orbits: v^2 = strength * minimum^2 / r.
      double v = Math.sqrt(20 * 2.5 * 2.5 / radius);
      float cos = (float) StrictMath.cos(a);
      float sin = (float) StrictMath.sin(a);
      s.body(
          new BodyDef(BodyType.DYNAMIC)
              .shape(
                  new Circle(0.1f + 0.12f * rng.nextFloat()),
                  new Material(1, 0.2f, 0.5f).withTag(SceneColors.bright(i)))
              .position((float) radius * cos, (float) radius * sin)
              .velocity((float) -v * sin, (float) v * cos));
    }
    Attractor planet =
        new Attractor(0, 0, 60).strength(20).falloff(Attractor.Falloff.INVERSE_SQUARE, 2.5f);
    s.eachTick(tick -> planet.apply(s.world(), 1f / Scene.DEFAULT_TICK_RATE));
  }
}
