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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Nothing passes through what is solid, however fast. */
final class ContinuousTest {
  private static final float[] SPEEDS = {20, 50, 100, 200, 400, 700, 1000};
  private static final int TRIES = 25;

  /** What flies. */
  enum Missile {
    CIRCLE(new Circle(.1f)),
    BOX(new Box(.15f, .1f)),
    SPINNING_BOX(new Box(.15f, .1f)),
    CAPSULE(new Capsule(-.1f, 0, .1f, 0, .05f)),
    TRIANGLE(Polygon.of(-.1f, -.1f, .2f, -.1f, -.05f, .15f)),
    COMPOUND(Compound.of(new Box(.2f, .05f), new Box(.05f, .2f, -.1f, .1f))),
    PELLET(new Circle(.01f)),
    PLATE(new Box(.2f, .01f));

    final Shape shape;

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

  /** The sleeper is a plate so thin that the bullet would be behind it after a step. */
  @Test
  void aBulletHitsAndWakesWhatSleeps() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> plate = Scenes.box(w, 0, .5f, .05f, .5f, Material.DEFAULT);
    steps(w, 120);
    assertTrue(!plate.awake());
    Body<String> b = Scenes.disc(w, -5, .8f, .05f, Material.DEFAULT);
    b.setBullet(true);
    b.setVelocity(800, 0);
    steps(w, 3);
    assertTrue(plate.awake());
    assertTrue(plate.velocityX() > 1, "v=" + plate.velocityX());
    assertTrue(b.velocityX() < 800, "v=" + b.velocityX());
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
    for (int kind = 0; kind < 6; kind++) {
      World<String> w = new World<>(new WorldDef());
      Material smooth = new Material(1, 0, 0);
      boolean rolls = kind > 3;
      if (rolls && speed > 50) {
        continue;
      }
      BodyDef ground = new BodyDef();
      if (kind < 2 || kind == 4) {
        ground.shape(new Box(1000, 1, 900, -1), smooth);
      } else {
        float[] xy = new float[2 * 900];
        for (int i = 0; i < 900; i++) {
          xy[2 * i] = -100 + 2 * i;
        }
        ground.shape(Chain.open(xy), smooth);
      }
      w.createBody(ground, "ground");
      float half = rolls ? .5f : .1f;
      Shape shape = kind % 2 == 0 && !rolls ? new Box(.2f, .1f) : new Circle(half);
      Body<String> b =
          w.createBody(
              new BodyDef(BodyType.DYNAMIC)
                  .shape(shape, smooth)
                  .position(0, half)
                  .velocity(speed, 0)
                  .angularVelocity(rolls ? -speed / half : 0),
              "b");
      steps(w, 120);
      String name = "kind=" + kind + " speed=" + speed + " " + b;
      assertEquals(speed, b.velocityX(), 1e-3 * speed, name);
      assertEquals(2 * speed, b.x(), 1e-3 * speed, name);
      assertEquals(half, b.y(), rolls ? .06 : .01, name);
    }
  }

  /** Both are at one place at one time, off by part of their sizes, unless one stops the other. */
  @ParameterizedTest
  @ValueSource(strings = {"plate", "disc", "bullet", "spinning plate"})
  void bulletsHitWhatMoves(String kind) {
    List<String> failures = new ArrayList<>();
    for (float speed : SPEEDS) {
      for (int seed = 1; seed <= 60; seed++) {
        Rng r = new Rng(seed);
        World<String> w = Scenes.space();
        int[] begins = new int[1];
        w.listener(
            new CollisionListener<>() {
              @Override
              public void begin(Collision<String> c) {
                begins[0]++;
              }
            });
        Shape shape = new Circle(.05f);
        Shape other = new Circle(.02f);
        float vx = r.in(-50, 50);
        float vy = r.in(-50, 50);
        float spin = 0;
        if (kind.endsWith("plate")) {
          other = new Box(.005f, 1);
          vx = r.in(-15, 15);
          vy = r.in(-15, 15);
          spin = kind.equals("plate") ? 0 : r.in(-30, 30);
        } else if (kind.equals("bullet")) {
          vx = -speed * r.in(.3f, 1);
          vy = speed * r.in(-.2f, .2f);
        }
        float time = r.in(.02f, .1f);
        Body<String> target =
            w.createBody(
                new BodyDef(BodyType.DYNAMIC)
                    .shape(other)
                    .position(-vx * time, -vy * time)
                    .velocity(vx, vy)
                    .angle(-spin * time)
                    .angularVelocity(spin)
                    .bullet(kind.equals("bullet")),
                "target");
        Body<String> b =
            w.createBody(
                new BodyDef(BodyType.DYNAMIC)
                    .shape(shape)
                    .position(-speed * time, r.in(-.03f, .03f))
                    .velocity(speed, 0)
                    .bullet(true),
                "bullet");
        float x = target.centerX();
        steps(w, 9);
        boolean moved = Math.abs(target.velocityX() - vx) + Math.abs(target.velocityY() - vy) > .1;
        if (begins[0] < 1 || !moved) {
          failures.add(
              speed + " seed=" + seed + " begins=" + begins[0] + " moved=" + moved + " " + x + b);
        }
      }
    }
    assertTrue(failures.isEmpty(), failures.size() + " " + failures.stream().limit(8).toList());
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void nobodyLeavesAClosedRoom(boolean lines) {
    World<String> w = new World<>(new WorldDef());
    Material hard = new Material(1, .2f, 1);
    BodyDef room = new BodyDef();
    if (lines) {
      room.shape(Chain.loop(-5, -5, 5, -5, 5, 5, 0, 5, -5, 5), hard);
    } else {
      room.shape(new Box(5.01f, .005f, 0, -5.005f), hard)
          .shape(new Box(5.01f, .005f, 0, 5.005f), hard)
          .shape(new Box(.005f, 5.01f, -5.005f, 0), hard)
          .shape(new Box(.005f, 5.01f, 5.005f, 0), hard);
    }
    w.createBody(room, "room");
    Rng r = new Rng(77);
    Missile[] kinds = Missile.values();
    for (int i = 0; i < 200; i++) {
      w.createBody(
          new BodyDef(BodyType.DYNAMIC)
              .shape(kinds[i % kinds.length].shape, new Material(1, r.in(0, .5f), r.in(0, 1)))
              .position(-4.5f + .64f * (i % 15), -4.5f + .65f * Math.floorDiv(i, 15))
              .angle(r.in(-3, 3))
              .velocity(r.in(-1000, 1000), r.in(-1000, 1000))
              .angularVelocity(r.in(-250, 250))
              .bullet(i % 4 == 0),
          "b" + i);
    }
    for (int i = 0; i < 600; i++) {
      if (i % 60 == 30) {
        w.forEachBody(b -> b.setVelocity(b.velocityX() * 3, b.velocityY() * 3));
      }
      w.step(DT);
      int tick = i;
      w.forEachBody(
          b ->
              assertTrue(
                  Math.abs(b.centerX()) < 5 && Math.abs(b.centerY()) < 5,
                  b + " tick=" + tick + " at " + b.centerX() + " " + b.centerY()));
    }
  }

  @ParameterizedTest
  @ValueSource(floats = {10, 60, 150, 250})
  void aSpinningStickStaysOnItsSide(float spin) {
    for (int seed = 1; seed <= 20; seed++) {
      Rng r = new Rng(seed);
      World<String> w = new World<>(new WorldDef().withGravity(3, 0));
      w.createBody(new BodyDef().shape(new Box(.005f, 50)), "wall");
      Body<String> stick =
          w.createBody(
              new BodyDef(BodyType.DYNAMIC)
                  .shape(new Box(1, r.in(.01f, .05f)), new Material(1, r.in(0, 1), r.in(0, 1)))
                  .position(-r.in(1.1f, 2), 0)
                  .velocity(r.in(0, 30), 0)
                  .angularVelocity(seed % 2 == 0 ? spin : -spin),
              "stick");
      for (int i = 0; i < 300; i++) {
        w.step(DT);
        String name = "seed=" + seed + " tick=" + i + " x=" + stick.centerX();
        assertTrue(stick.centerX() < 0 || Math.abs(stick.centerY()) > 49, name);
      }
    }
  }

  @Test
  void anElasticBulletKeepsItsSpeed() {
    World<String> w = Scenes.space();
    Material hard = new Material(1, 0, 1);
    w.createBody(new BodyDef().shape(new Box(.005f, 4), hard).position(-6, 0), "left");
    w.createBody(new BodyDef().shape(new Box(.005f, 4), hard).position(6, 0), "right");
    Body<String> b = Scenes.disc(w, 0, 0, .05f, hard);
    b.setVelocity(1000, 0);
    int turns = 0;
    float last = 1000;
    for (int i = 0; i < 240; i++) {
      w.step(DT);
      turns += b.velocityX() * last < 0 ? 1 : 0;
      last = b.velocityX();
      assertEquals(1000, Math.abs(last), .1, "tick=" + i);
      assertTrue(Math.abs(b.x()) < 6, "tick=" + i);
    }
    assertTrue(turns > 100, "turns=" + turns);
  }

  @Test
  void anImpactBeginsOnceAndHolds() {
    World<String> w = Scenes.space();
    w.createBody(new BodyDef().shape(new Box(.005f, 4), new Material(1, 0, 0)), "wall");
    Body<String> b = Scenes.disc(w, -7, 0, .05f, new Material(1, 0, 0));
    b.setVelocity(900, 0);
    List<String> heard = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            heard.add("begin");
          }

          @Override
          public void end(Collision<String> c) {
            heard.add("end");
          }
        });
    steps(w, 30);
    assertEquals(List.of("begin"), heard);
    assertEquals(-.055, b.x(), .004);
    assertEquals(0, b.velocityX(), 1e-3);
  }

  @ParameterizedTest
  @ValueSource(floats = {30, 100, 300, 1000})
  void oneWayPlatformsPassFromBelowAndHoldFromAbove(float speed) {
    World<String> w = Scenes.space();
    w.createBody(new BodyDef().shape(new Box(3, .05f)), "platform");
    w.listener(
        new CollisionListener<>() {
          @Override
          public boolean preSolve(Collision<String> c) {
            Body<String> rider = c.self().user().equals("platform") ? c.other() : c.self();
            return rider.velocityY() <= 0 && rider.y() > 0;
          }
        });
    Body<String> up = Scenes.disc(w, -1, -speed / 50, .1f, Material.DEFAULT);
    up.setVelocity(0, speed);
    Body<String> down = Scenes.disc(w, 1, speed / 50, .1f, Material.DEFAULT);
    down.setVelocity(0, -speed);
    steps(w, 10);
    assertEquals(speed, up.velocityY(), 1e-3);
    assertTrue(up.y() > 1, "y=" + up.y());
    assertEquals(.15, down.y(), .01);
    assertEquals(0, down.velocityY(), 1e-3);
  }

  @Test
  void theBackOfAChainLetsPass() {
    World<String> w = Scenes.space();
    w.createBody(new BodyDef().shape(Chain.open(-3, 0, 0, 0, 3, 0)), "ground");
    Body<String> up = Scenes.disc(w, .01f, -5, .1f, Material.DEFAULT);
    up.setVelocity(0, 500);
    steps(w, 3);
    assertEquals(20, up.y(), .01);
  }

  @Test
  void whatDoesNotCollideIsNoObstacle() {
    World<String> w = Scenes.space();
    Filter ghost = new Filter(2, ~1, 0);
    BodyDef walls =
        new BodyDef()
            .shape(new Box(.005f, 4, 0, 0), Material.DEFAULT, ghost)
            .shape(new ShapeDef(new Box(.005f, 4, 1, 0), Material.DEFAULT, Filter.DEFAULT, true));
    w.createBody(walls, "walls");
    Body<String> off = w.createBody(new BodyDef().shape(new Box(.005f, 4, 2, 0)), "off");
    off.setEnabled(false);
    Body<String> b = Scenes.disc(w, -5, 0, .1f, Material.DEFAULT);
    b.setBullet(true);
    b.setVelocity(600, 0);
    w.step(DT);
    assertEquals(5, b.x(), .001);
    Body<String> mate = Scenes.disc(w, 10, 0, .1f, Material.DEFAULT);
    w.createJoint(JointDef.distance(b, mate, b.x(), b.y(), 10, 0).spring(.01f, 0));
    steps(w, 2);
    assertTrue(b.x() > 20, "x=" + b.x());
  }

  @Test
  void teleportsAreNotMotion() {
    World<String> w = Scenes.space();
    w.createBody(new BodyDef().shape(new Box(.005f, 4)), "wall");
    Body<String> b = Scenes.disc(w, -5, 0, .1f, Material.DEFAULT);
    b.setPose(5, 0, 0);
    b.setVelocity(60, 0);
    w.step(DT);
    assertEquals(6, b.x(), .001);
  }

  @Test
  void nothingIsSweptIfTheWorldSaysSo() {
    World<String> w = new World<>(new WorldDef().withGravity(0, 0).withContinuous(false));
    w.createBody(new BodyDef().shape(new Box(.005f, 4)), "wall");
    Body<String> b = Scenes.disc(w, -5, 0, .1f, Material.DEFAULT);
    b.setVelocity(600, 0);
    w.step(DT);
    assertEquals(5, b.x(), .001);
  }
}
