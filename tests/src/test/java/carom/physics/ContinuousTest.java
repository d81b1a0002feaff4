package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Scenes.Rng;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Nothing passes through what is solid, however fast. */
final class ContinuousTest {
  private static final float[] SPEEDS = {20, 50, 100, 200, 400, 700, 1000};
  private static final int TRIES = 25;

  /** What flies. */
  private enum Missile {
    CIRCLE(new Circle(.1f)),
    BOX(new Box(.15f, .1f)),
    SPINNING_BOX(new Box(.15f, .1f)),
    CAPSULE(new Capsule(-.1f, 0, .1f, 0, .05f)),
    TRIANGLE(Polygon.of(-.1f, -.1f, .2f, -.1f, -.05f, .15f)),
    COMPOUND(Compound.of(new Box(.2f, .05f), new Box(.05f, .2f, -.1f, .1f))),
    PELLET(new Circle(.01f)),
    PLATE(new Box(.2f, .01f));

    private final Shape shape;

    Missile(Shape shape) {
      this.shape = shape;
    }

    boolean spins() {
      return this == SPINNING_BOX || this == PLATE || this == COMPOUND;
    }
  }

  /** What stands in the way, at x = 0, facing left. */
  private enum Wall {
    THIN_BOX(new BodyDef().shape(new Box(.005f, 4))),
    SEGMENT(new BodyDef().shape(new Segment(0, -4, 0, 4))),
    CHAIN(new BodyDef().shape(Chain.open(0, -4, 0, -1, 0, -.3f, 0, .4f, 0, 1.1f, 0, 4))),
    CIRCLE(new BodyDef().shape(new Circle(4, 4, 0))),
    AWAY(new BodyDef(BodyType.KINEMATIC).shape(new Box(.005f, 4)).velocity(8, 0)),
    TOWARDS(new BodyDef(BodyType.KINEMATIC).shape(new Box(.005f, 4)).velocity(-8, 0)),
    SIDEWAYS(new BodyDef(BodyType.KINEMATIC).shape(new Box(.005f, 8)).velocity(0, 20));

    private final BodyDef def;

    Wall(BodyDef def) {
      this.def = def;
    }
  }

  @ParameterizedTest
  @EnumSource
  void nothingPassesAWall(Missile missile) {
    List<String> failures = new ArrayList<>();
    int hits = 0;
    for (Wall wall : Wall.values()) {
      for (float speed : SPEEDS) {
        for (int seed = 1; seed <= TRIES; seed++) {
          Rng r = new Rng(seed * 1000L + (long) speed);
          World<String> w = Scenes.space();
          Body<String> target = w.createBody(wall.def, "wall");
          Body<String> b =
              w.createBody(
                  new BodyDef(BodyType.DYNAMIC)
                      .shape(missile.shape, new Material(1, r.in(0, 1), r.in(0, 1)))
                      .position(r.in(-speed / 60 - 1, -.7f), r.in(-.5f, .5f))
                      .angle(r.in(-3, 3))
                      .velocity(speed, r.in(-.2f, .2f) * speed)
                      .angularVelocity(missile.spins() ? r.in(-250, 250) : r.in(-5, 5)),
                  "missile");
          String name = missile + " " + wall + " speed=" + speed + " seed=" + seed;
          double energy = Scenes.kineticEnergy(w);
          for (int i = 0; i < 12; i++) {
            float before = b.velocityX();
            w.step(DT);
            boolean still = target.type() == BodyType.STATIC;
            if (still && Scenes.kineticEnergy(w) > energy * 1.001 + 1e-3) {
              failures.add(
                  name + " step=" + i + " energy " + energy + " to " + Scenes.kineticEnergy(w));
              break;
            }
            energy = Math.min(energy, Scenes.kineticEnergy(w));
            hits += before > 0 && b.velocityX() < .5f * before ? 1 : 0;
            if (isThrough(wall, target, b)) {
              failures.add(name + " step=" + i + " x=" + b.centerX());
              break;
            }
          }
        }
      }
    }
    assertTrue(failures.isEmpty(), failures.size() + " " + failures.stream().limit(8).toList());
    assertTrue(hits > Wall.values().length * SPEEDS.length * TRIES / 2, "hits=" + hits);
  }

  private static boolean isThrough(Wall wall, Body<String> target, Body<String> b) {
    float x = b.centerX();
    float y = b.centerY();
    if (wall == Wall.CIRCLE) {
      return (x - 4) * (x - 4) + y * y < 16;
    }
    return Math.abs(y) < 3 && x > target.centerX();
  }

  @ParameterizedTest
  @ValueSource(floats = {10, 50, 100, 300})
  void slidingAndRollingLoseNothing(float speed) {
    for (int kind = 0; kind < 4; kind++) {
      World<String> w = new World<>(new WorldDef());
      Material smooth = new Material(1, 0, 0);
      BodyDef ground = new BodyDef();
      if (kind < 2) {
        ground.shape(new Box(1000, 1, 900, -1), smooth);
      } else {
        float[] xy = new float[2 * 900];
        for (int i = 0; i < 900; i++) {
          xy[2 * i] = -100 + 2 * i;
        }
        ground.shape(Chain.open(xy), smooth);
      }
      w.createBody(ground, "ground");
      Shape shape = kind % 2 == 0 ? new Box(.2f, .1f) : new Circle(.1f);
      Body<String> b =
          w.createBody(
              new BodyDef(BodyType.DYNAMIC)
                  .shape(shape, smooth)
                  .position(0, .1f)
                  .velocity(speed, 0),
              "b");
      steps(w, 120);
      String name = "kind=" + kind + " speed=" + speed + " " + b;
      assertEquals(speed, b.velocityX(), 1e-3 * speed, name);
      assertEquals(2 * speed, b.x(), 1e-3 * speed, name);
      assertEquals(.1, b.y(), .01, name);
    }
  }
}
