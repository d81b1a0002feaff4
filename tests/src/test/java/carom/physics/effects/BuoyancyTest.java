package carom.physics.effects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Allocations;
import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.ShapeDef;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import org.junit.jupiter.api.Test;

/** Floating bodies against closed forms. */
final class BuoyancyTest {
  private static final float DT = 1 / 60f;
  private static final Aabb SEA = new Aabb(-100, -100, 100, 0);

  private static Body<String> body(World<String> w, Shape shape, float density, float y) {
    return w.createBody(
        new BodyDef(BodyType.DYNAMIC)
            .shape(shape, Material.DEFAULT.withDensity(density))
            .position(0, y),
        null);
  }

  private static void run(World<String> w, Buoyancy sea, int ticks) {
    for (int i = 0; i < ticks; i++) {
      sea.apply(w, DT);
      w.step(DT);
    }
  }

  @Test
  void floatingBoxSettlesAtTheDepthOfItsDensity() {
    for (float ratio : new float[] {0.1f, 0.3f, 0.5f, 0.9f}) {
      World<String> w = new World<>(new WorldDef().withSleeping(false));
      Body<String> box = body(w, new Box(1, .5f), 1000 * ratio, 1);
      run(w, new Buoyancy(SEA, 1000).drag(3).angularDrag(3), 1200);
      assertEquals(0.5 - ratio, box.y(), 1e-4, "ratio=" + ratio);
      assertEquals(0, box.velocityY(), 1e-3);
      assertEquals(0, box.angle(), 1e-3);
    }
  }

  @Test
  void discOfHalfTheDensityIsHalfSubmerged() {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> disc = body(w, new Circle(.7f), 500, .5f);
    Body<String> capsule = body(w, new Capsule(-1, 0, 1, 0, .5f), 500, .5f);
    capsule.setPose(20, .2f, 0);
    run(w, new Buoyancy(SEA, 1000).drag(3), 1200);
    assertEquals(0, disc.y(), 1e-4);
    assertEquals(0, capsule.y(), 1e-4);
  }

  /** Heave of a box: o^2 = g / draught; the discrete frequency is 2 asin(o dt / 2) / dt. */
  @Test
  void boxBobsWithTheFrequencyOfItsDraughtAndNeverTires() {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    float amplitude = 0.1f;
    Body<String> box = body(w, new Box(1, .5f), 500, amplitude);
    Buoyancy sea = new Buoyancy(SEA, 1000).drag(0).angularDrag(0);
    double omega = Math.sqrt(10 / 0.5);
    double phase = 2 * Math.asin(omega * DT / 2);
    double most = 0;
    for (int tick = 1; tick <= 3600; tick++) {
      run(w, sea, 1);
      if (tick <= 600) {
        assertEquals(amplitude * Math.cos(phase * tick), box.y(), 0.04 * amplitude, "tick=" + tick);
      }
      if (tick > 3300) {
        most = Math.max(most, box.y());
      }
    }
    assertEquals(amplitude, most, 0.02 * amplitude);
  }

  /**
   * Righting moment of a box of width b: rho g (b^3 / 12 - area * (G - B)) * heel, for small heel.
   */
  @Test
  void wideRaftRightsItselfWithTheMomentOfItsMetacentre() {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    float heel = 0.01f;
    Body<String> raft = body(w, new Box(2, .5f), 500, 0);
    raft.setPose(0, 0, heel);
    new Buoyancy(SEA, 1000).drag(0).angularDrag(0).apply(w, DT);
    w.step(DT);
    double moment = 1000 * 10 * (64.0 / 12 - 2 * 0.25) * heel;
    assertEquals(
        -moment * DT / raft.inertia(), raft.angularVelocity(), 1e-2 * moment * DT / raft.inertia());
  }

  @Test
  void tallBoxTipsOverAndARaftDoesNot() {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> pole = body(w, new Box(.3f, 1.5f), 500, 0);
    pole.setPose(-10, 0, 0.02f);
    Body<String> raft = body(w, new Box(1.5f, .3f), 500, 0);
    raft.setPose(10, 0, 0.4f);
    run(w, new Buoyancy(SEA, 1000).drag(2).angularDrag(2), 2400);
    assertEquals(Math.PI / 2, Math.abs(pole.angle()), 0.01);
    assertEquals(0, raft.angle(), 0.01);
  }

  @Test
  void whatIsSubmergedIsWholeWhateverTheShape() {
    Submerged s = new Submerged();
    Shape[] shapes = {
      new Box(1, 2, 3, 4), new Circle(1.5f, -2, 1), new Capsule(-1, 2, 3, 1, .5f), new Box(.1f, .1f)
    };
    for (Shape shape : shapes) {
      s.begin(5, -50, 0, 0, .6, .8, SEA, 0, 0, 0, 1);
      s.add(shape.parts().get(0));
      s.end();
      var mass = shape.mass(1);
      double cx = .6 * mass.centerX() - .8 * mass.centerY();
      double cy = .8 * mass.centerX() + .6 * mass.centerY();
      assertEquals(mass.mass(), s.area, 1e-5 * mass.mass(), shape.toString());
      assertEquals(cx, s.centroidX, 2e-3, shape.toString());
      assertEquals(cy, s.centroidY, 2e-3, shape.toString());
      assertEquals(mass.inertia(), s.second, 5e-3 * mass.inertia(), shape.toString());
    }
  }

  /** Disc cut at t r: against a fine sum of strips. */
  @Test
  void discSegmentHasTheMomentsOfItsStrips() {
    Submerged s = new Submerged();
    for (double t = -1.1; t <= 1.2; t += 0.1) {
      s.begin(0, -2 * t, 0, 0, 1, 0, SEA, 0, 0, 0, 1);
      s.add(new Circle(2));
      s.end();
      double area = 0;
      double first = 0;
      double second = 0;
      int n = 20000;
      for (int i = 0; i < n; i++) {
        double y = -2 + 4 * (i + .5) / n;
        if (y < 2 * t) {
          double half = Math.sqrt(4 - y * y);
          area += 2 * half * 4 / n;
          first += y * 2 * half * 4 / n;
          second += (y * y * 2 * half + 2.0 / 3 * half * half * half) * 4 / n;
        }
      }
      assertEquals(area, s.area, 2e-3, "t=" + t);
      if (area > 0.01) {
        assertEquals(first / area, s.centroidY, 2e-3, "t=" + t);
        assertEquals(second - first * first / area, s.second, 5e-3, "t=" + t);
      }
    }
  }

  @Test
  void edgesOfTheAreaCutWhatIsSubmerged() {
    Submerged s = new Submerged();
    s.begin(0, 0, 0, 0, 1, 0, new Aabb(-.25f, -9, 9, 9), 0, .5, 0, 1);
    s.add(new Box(1, 1));
    s.end();
    assertEquals(1.25 * 1.5, s.area, 1e-6);
    assertEquals(.375, s.centroidX, 1e-6);
    assertEquals(-.25, s.centroidY, 1e-6);
    s.begin(0, 0, 0, 0, 1, 0, new Aabb(0, -9, 9, 9), 0, 5, 0, 1);
    s.add(new Circle(1));
    s.end();
    assertEquals(Math.PI / 2, s.area, 1e-3);
    assertEquals(4 / (3 * Math.PI), s.centroidX, 1e-3);
  }

  @Test
  void flowCarriesAndDragNeverOvershoots() {
    World<String> w = new World<>(new WorldDef().withGravity(0, 0));
    Body<String> light = body(w, new Box(1, 1), 1, -20);
    light.setAngularVelocity(10);
    Buoyancy river = new Buoyancy(SEA, 1000).drag(50).angularDrag(50).flow(3, 0);
    float before = 0;
    for (int i = 0; i < 60; i++) {
      run(w, river, 1);
      assertTrue(light.velocityX() >= before && light.velocityX() <= 3.0001f, "" + light);
      before = light.velocityX();
    }
    assertEquals(3, light.velocityX(), 1e-3);
    assertEquals(0, light.angularVelocity(), 1e-3);
  }

  @Test
  void sensorBoundsTheFluid() {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> pool =
        w.createBody(
            new BodyDef().shape(new ShapeDef(new Box(5, 2)).withSensor(true)).position(0, -2),
            "pool");
    Body<String> box = body(w, new Box(.5f, .5f), 500, .3f);
    Buoyancy fluid = new Buoyancy(new Aabb(), 1000).drag(3);
    for (int i = 0; i < 900; i++) {
      fluid.apply(w, pool, DT);
      w.step(DT);
    }
    assertEquals(0, box.y(), 1e-3);
  }

  @Test
  void floatingBoxFallsAsleepAndWakesWhenTheFluidIsToldToChange() {
    World<String> w = new World<>(new WorldDef());
    Body<String> box = body(w, new Box(1, .5f), 500, .2f);
    Buoyancy sea = new Buoyancy(SEA, 1000).drag(3).angularDrag(3);
    run(w, sea, 900);
    assertTrue(!box.awake());
    assertEquals(0, box.y(), 2e-2);
    sea.surface(0, -1, 0, 1).wake(w);
    run(w, sea, 900);
    assertEquals(-1, box.y(), 2e-2);
    box.applyForce(0, 1);
    assertTrue(box.awake());
  }

  @Test
  void badNumbersAreNamed() {
    Buoyancy b = new Buoyancy(SEA, 1000);
    assertNames("density=NaN", () -> new Buoyancy(SEA, Float.NaN));
    assertNames("area=", () -> new Buoyancy(new Aabb(1, 0, 0, 0), 1));
    assertNames("drag=-1.0", () -> b.drag(-1));
    assertNames("up=0.0 0.0", () -> b.surface(0, 0, 0, 0));
    assertNames("dtSeconds=0.0", () -> b.apply(new World<>(new WorldDef()), 0));
  }

  private static void assertNames(String what, Runnable call) {
    String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
    assertTrue(message.contains(what), message);
  }

  @Test
  void steadyCallAllocatesNothing() {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    for (int i = 0; i < 20; i++) {
      body(w, i % 2 == 0 ? new Circle(.5f) : new Capsule(0, 0, 1, 0, .3f), 500, 0)
          .setPose(3 * i, 0, 0);
    }
    Buoyancy sea = new Buoyancy(SEA, 1000);
    Attractor attractor = new Attractor(0, 0, 100);
    AreaEffect wind = AreaEffect.wind(SEA, 1, 0, 1);
    Explosion bang = new Explosion(0, -5, 20).impulse(0.1f).blockedByStatics(true);
    Runnable tick =
        () -> {
          sea.apply(w, DT);
          attractor.apply(w, DT);
          wind.apply(w, DT);
          bang.explode(w);
          w.step(DT);
        };
    for (int i = 0; i < 2000; i++) {
      tick.run();
    }
    long least =
        Allocations.least(
            5,
            () -> {
              for (int i = 0; i < 60; i++) {
                tick.run();
              }
            });
    assertTrue(least < 200, "bytes in 60 ticks: " + least);
  }
}
