package carom.physics.particles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Allocations;
import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.WorldState;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.physics.particles.ParticleDef.Kind;
import org.junit.jupiter.api.Test;

/** Water and sand, alone and among bodies. */
final class ParticlesTest {
  private static final float DT = 1 / 60f;

  /** A tank of a width around x = 0, its floor at y = 0, its walls 20 m high. */
  private static World<String> tank(float width) {
    World<String> w = new World<>(new WorldDef());
    float half = 0.5f * width;
    w.createBody(
        new BodyDef()
            .shape(new Box(half + 1, 1, 0, -1))
            .shape(new Box(.5f, 10, -half - .5f, 10))
            .shape(new Box(.5f, 10, half + .5f, 10)),
        "tank");
    return w;
  }

  private static void run(World<String> w, Particles p, int ticks) {
    for (int i = 0; i < ticks; i++) {
      p.step(w, DT);
      w.step(DT);
    }
  }

  private static Particles water(float spacing) {
    return new Particles(new ParticleDef(Kind.WATER, spacing));
  }

  private static Body<String> body(World<String> w, Shape shape, float density, float x, float y) {
    return w.createBody(
        new BodyDef(BodyType.DYNAMIC)
            .shape(shape, Material.DEFAULT.withDensity(density))
            .position(x, y),
        "body");
  }

  private static double[] momentum(World<String> w, Particles p) {
    double[] sum = new double[3];
    for (int i = 0; i < p.count(); i++) {
      double px = p.mass() * p.velocityX(i);
      double py = p.mass() * p.velocityY(i);
      sum[0] += px;
      sum[1] += py;
      sum[2] += Math.abs(px) + Math.abs(py);
    }
    w.forEachBody(
        b -> {
          sum[0] += (double) b.mass() * b.velocityX();
          sum[1] += (double) b.mass() * b.velocityY();
        });
    return sum;
  }

  @Test
  void momentumOfParticlesAndBodiesTogetherIsKept() {
    for (Kind kind : Kind.values()) {
      World<String> w = new World<>(new WorldDef().withGravity(0, 0));
      Particles p = new Particles(new ParticleDef(kind, .1f).cohesion(5).friction(.3f));
      p.fill(new Box(1, 1), new Transform(-2, 0, 0), 5, 0);
      p.fill(new Box(1, 1), new Transform(2, .5f, 0), -3, 1);
      body(w, new Box(.4f, .4f), 2, 0, 0).setAngularVelocity(3);
      body(w, new Circle(.3f), .3f, 0, 1.5f);
      body(w, new Capsule(-.3f, 0, .3f, 0, .2f), 1, 0, -1.5f);
      double[] before = momentum(w, p);
      run(w, p, 120);
      double[] after = momentum(w, p);
      assertEquals(before[0], after[0], 1e-5 * before[2], kind + "");
      assertEquals(before[1], after[1], 1e-5 * before[2], kind + "");
    }
  }

  /** Level to a spacing or two; nothing lost; no layer more than 12 % denser than at rest. */
  @Test
  void brokenDamComesToRestLevelAndHardlyCompressed() {
    World<String> w = tank(8);
    Particles p = water(.1f);
    p.fill(new Box(1.5f, 2), new Transform(-2.45f, 2.05f, 0), 0, 0);
    int count = p.count();
    assertEquals(1200, count, 60);
    run(w, p, 1500);
    assertEquals(count, p.count());
    double[] top = new double[8];
    double speed = 0;
    int[] layer = new int[3];
    for (int i = 0; i < count; i++) {
      assertTrue(Math.abs(p.x(i)) < 4 && p.y(i) > 0, "lost at " + p.x(i) + " " + p.y(i));
      int column = (int) Math.floor(p.x(i) + 4);
      top[column] = Math.max(top[column], p.y(i));
      speed += Math.hypot(p.velocityX(i), p.velocityY(i)) / count;
      if (Math.abs(p.x(i)) < 3 && p.y(i) > .1 && p.y(i) < 1.3) {
        layer[(int) ((p.y(i) - .1) / .4)]++;
      }
    }
    for (double t : top) {
      assertEquals(count * .01 / 8, t, .25);
    }
    assertTrue(speed < 0.03, "mean speed=" + speed);
    for (int n : layer) {
      assertEquals(1, n * .01 / (6 * .4), .12);
    }
  }

  @Test
  void sandHeapsUpAndWaterDoesNot() {
    double[] top = new double[2];
    for (Kind kind : Kind.values()) {
      World<String> w = tank(12);
      Particles p = new Particles(new ParticleDef(kind, .1f));
      p.fill(new Box(.75f, 1.5f), new Transform(0, 1.6f, 0), 0, 0);
      run(w, p, 900);
      for (int i = 0; i < p.count(); i++) {
        top[kind.ordinal()] = Math.max(top[kind.ordinal()], p.y(i));
      }
    }
    assertTrue(top[0] < 0.7, "water=" + top[0]);
    assertTrue(top[1] > 0.9, "sand=" + top[1]);
  }

  @Test
  void lightBoxFloatsAndHeavyOneSinks() {
    World<String> w = tank(4);
    Particles p = water(.1f);
    p.fill(new Box(1.95f, .75f), new Transform(0, .8f, 0), 0, 0);
    Body<String> light = body(w, new Box(.4f, .3f), .4f, -1, 2.5f);
    Body<String> heavy = body(w, new Box(.3f, .3f), 4, 1, 2.5f);
    run(w, p, 900);
    assertTrue(light.y() > 1.2, "light y=" + light.y());
    assertTrue(heavy.y() < .6, "heavy y=" + heavy.y());
  }

  @Test
  void fountainAgainstALidStaysInside() {
    World<String> w = new World<>(new WorldDef());
    w.createBody(
        new BodyDef().shape(Chain.loop(-3, 0, 3, 0, 3, 4, 0, 4.5f, -3, 4), Material.DEFAULT),
        "vessel");
    Particles p = new Particles(new ParticleDef(Kind.WATER, .1f).maxCount(1500));
    Emitter fountain = new Emitter(0, .5f, 0, 1).width(.5f).speed(20);
    for (int tick = 0; tick < 300; tick++) {
      fountain.emit(p, tick, DT);
      p.step(w, DT);
      w.step(DT);
    }
    assertTrue(p.count() > 500, "count=" + p.count());
    for (int i = 0; i < p.count(); i++) {
      assertTrue(Math.abs(p.x(i)) < 3 && p.y(i) > 0 && p.y(i) < 4.5, p.x(i) + " " + p.y(i));
    }
  }

  /** However fast, through 2 mm of wall, lines and discs alike. */
  @Test
  void fastParticlesStopAtThinWalls() {
    Shape[] walls = {
      new Box(.001f, 5),
      Chain.open(0, -5, 0, 5),
      new Capsule(0, -5, 0, 5, .001f),
      new Circle(2, 2, 0)
    };
    for (Shape wall : walls) {
      for (float speed : new float[] {5, 50, 500, 5000, 90000}) {
        World<String> w = new World<>(new WorldDef().withGravity(0, 0));
        w.createBody(new BodyDef().shape(wall), "wall");
        Particles p = water(.05f);
        for (int i = 0; i < 40; i++) {
          p.add(-1 - i * .37f, (i % 9 - 4) * .2f, speed, 0);
        }
        run(w, p, 120);
        for (int i = 0; i < p.count(); i++) {
          assertTrue(p.x(i) < .3f || wall instanceof Circle, wall + " " + speed + " x=" + p.x(i));
          assertTrue(!wall.containsPoint(p.x(i), p.y(i)), wall + " " + speed);
        }
      }
    }
  }

  @Test
  void oneWayParticlesPushNobodyAndFiltersLetPass() {
    World<String> w = new World<>(new WorldDef().withGravity(0, 0).withSleeping(false));
    Body<String> target = body(w, new Box(.5f, .5f), 1, 0, 0);
    Particles oneWay = new Particles(new ParticleDef(Kind.WATER, .1f).twoWay(false));
    Particles ghost = new Particles(new ParticleDef(Kind.WATER, .1f).filter(new Filter(1, 0)));
    oneWay.add(-2, 0, 5, 0);
    ghost.add(-2, 0, 5, 0);
    for (int i = 0; i < 60; i++) {
      oneWay.step(w, DT);
      ghost.step(w, DT);
      w.step(DT);
    }
    assertEquals(0, target.velocityX());
    assertTrue(oneWay.x(0) < -.5, "x=" + oneWay.x(0));
    assertEquals(3, ghost.x(0), 1e-3);
    Particles pushing = water(.1f);
    pushing.add(-2, 0, 5, 0);
    run(w, pushing, 60);
    assertEquals(5 * .01 / 1.01, target.velocityX(), 1e-4);
  }

  @Test
  void idsOutliveTheOrderAndEndWithTheParticle() {
    World<String> w = tank(4);
    Particles p = new Particles(new ParticleDef(Kind.SAND, .1f).maxCount(300).lifetime(2));
    long first = p.add(.5f, 3, 0, 0);
    p.fill(new Box(1, 1), new Transform(0, 1, 0), 0, 0);
    assertTrue(p.count() <= 300);
    run(w, p, 30);
    assertEquals(first, p.id(p.indexOf(first)));
    assertTrue(p.remove(first));
    assertEquals(-1, p.indexOf(first));
    assertTrue(!p.remove(first));
    long again = p.add(0, 3, 0, 0);
    assertNotEquals(first, again);
    run(w, p, 100);
    assertEquals(1, p.count());
    assertEquals(0, p.indexOf(again));
    assertEquals(1, p.removeInside(new Aabb(-2, 0, 2, 5)));
    assertEquals(0, p.count());
    for (int i = 0; i < 300; i++) {
      assertNotEquals(Particles.NONE, p.add(0, 5 + i, 0, 0));
    }
    assertEquals(Particles.NONE, p.add(0, 1, 0, 0));
    assertEquals(2, p.removeInside(new Circle(1.2f), new Transform(0, 5, 0)));
    p.clear();
    assertEquals(0, p.count());
  }

  @Test
  void equalRunsGiveEqualBitsAlsoAfterARestore() {
    for (Kind kind : Kind.values()) {
      World<String> w = tank(4);
      World<String> w2 = tank(4);
      Particles p = new Particles(new ParticleDef(kind, .1f).lifetime(1.5f));
      Particles q = new Particles(new ParticleDef(kind, .1f).lifetime(1.5f));
      body(w, new Box(.3f, .2f), .5f, 0, 3);
      body(w2, new Box(.3f, .2f), .5f, 0, 3);
      Emitter hose = new Emitter(-1.5f, 2, 1, .2f).width(.4f).speed(4);
      ParticleState state = null;
      WorldState worldState = null;
      long[] hashes = new long[180];
      for (int tick = 0; tick < 180; tick++) {
        hose.emit(p, tick, DT);
        hose.emit(q, tick, DT);
        run(w, p, 1);
        run(w2, q, 1);
        hashes[tick] = p.stateHash() ^ Long.rotateLeft(w.stateHash(), 1);
        assertEquals(p.stateHash(), q.stateHash(), kind + " tick=" + tick);
        assertEquals(w.stateHash(), w2.stateHash(), kind + " tick=" + tick);
        if (tick == 99) {
          state = p.save(null);
          worldState = w.save(null);
        }
      }
      p.restore(state);
      w.restore(worldState);
      for (int tick = 100; tick < 180; tick++) {
        hose.emit(p, tick, DT);
        run(w, p, 1);
        assertEquals(hashes[tick], p.stateHash() ^ Long.rotateLeft(w.stateHash(), 1), "" + tick);
      }
    }
  }

  @Test
  void tenThousandStepWithoutAllocation() {
    World<String> w = tank(18);
    Particles p = water(.1f);
    p.fill(new Box(8.9f, 3), new Transform(0, 3.1f, 0), 0, 0);
    body(w, new Box(.5f, .5f), .5f, 0, 8);
    assertEquals(10_000, p.count());
    run(w, p, 60);
    ParticleState s = p.save(null);
    long least =
        Allocations.least(
            5,
            () -> {
              for (int i = 0; i < 10; i++) {
                run(w, p, 1);
                p.save(s);
                p.restore(s);
                p.stateHash();
              }
            });
    assertTrue(least < 200, "bytes in 10 steps: " + least);
    assertEquals(10_000, p.count());
  }

  @Test
  void badInputIsNamed() {
    Particles p = water(.1f);
    assertNames("spacing=0.0", () -> new ParticleDef(Kind.SAND, 0));
    assertNames("kind=null", () -> new ParticleDef(null, 1));
    assertNames("density=NaN", () -> new ParticleDef(Kind.SAND, 1).density(Float.NaN));
    assertNames("maxCount=0", () -> new ParticleDef(Kind.SAND, 1).maxCount(0));
    assertNames("substeps=17", () -> new ParticleDef(Kind.SAND, 1).substeps(17));
    assertNames("lifetime=0.0", () -> new ParticleDef(Kind.SAND, 1).lifetime(0));
    assertNames("x=NaN", () -> p.add(Float.NaN, 0, 0, 0));
    assertNames("vy=Infinity", () -> p.add(0, 0, 0, Float.POSITIVE_INFINITY));
    assertNames("dtSeconds=1.0", () -> p.step(tank(1), 1));
    assertNames("other particles", () -> p.restore(water(.1f).save(null)));
    assertNames("speed=-1.0", () -> new Emitter(0, 0, 1, 0).speed(-1));
    assertNames("direction=0.0 0.0", () -> new Emitter(0, 0, 0, 0));
    assertThrows(IndexOutOfBoundsException.class, () -> p.x(0));
  }

  private static void assertNames(String what, Runnable call) {
    String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
    assertTrue(message.contains(what), message);
  }

  /** Bodies that feel no push back press water as hard as they like, but not through the floor. */
  @Test
  void oneWayBodiesDontPressWaterThroughTheFloor() {
    World<String> world = new World<>(new WorldDef());
    world.createBody(
        new BodyDef()
            .shape(new Box(30, 1, 0, -1))
            .shape(new Box(1, 30, -11, 30))
            .shape(new Box(1, 30, 11, 30)),
        "room");
    for (int i = 0; i < 20; i++) {
      world.createBody(
          new BodyDef(BodyType.DYNAMIC).position(i - 9.5f, 3).shape(new Box(.4f, .4f)), "box");
    }
    Particles water =
        new Particles(new ParticleDef(ParticleDef.Kind.WATER, .1f).twoWay(false).maxCount(2000));
    for (int i = 0; i < 2000; i++) {
      int row = i / 190;
      water.add(-9.5f + i % 190 * .1f, .1f + row * .1f, 0, 0);
    }
    for (int tick = 0; tick < 240; tick++) {
      world.step(1 / 60f);
      water.step(world, 1 / 60f);
    }
    for (int i = 0; i < water.count(); i++) {
      assertTrue(water.y(i) > -.2f && Math.abs(water.x(i)) < 10.2f, water.x(i) + " " + water.y(i));
    }
  }
}
