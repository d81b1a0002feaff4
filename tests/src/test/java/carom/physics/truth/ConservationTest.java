package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Isolated systems. Every impulse acts on two bodies with opposite signs, so momentum is kept to
 * rounding. The two points of application may be a little apart (overlap, and what the bodies moved
 * since the step began), which gives a small torque: angular momentum is kept to a few per mille of
 * the largest one that the bodies carry.
 */
final class ConservationTest {
  /** Bodies of all shapes that fly towards the middle. */
  private static World<String> swarm(long seed, double friction, double restitution) {
    World<String> w = Lab.lively();
    SplittableRandom r = new SplittableRandom(seed);
    for (int i = 0; i < 40; i++) {
      double x = (i % 8 - 3.5) * 2;
      double y = (i / 8 - 2) * 2;
      double density = r.nextDouble(.2, 5);
      Material m = new Material((float) density, (float) friction, (float) restitution);
      Body<String> b = Lab.body(w, Lab.Solid.values()[i % 5].shape, x, y, m);
      b.setVelocity(
          (float) (-.5 * x + r.nextDouble(-2, 2)), (float) (-.5 * y + r.nextDouble(-2, 2)));
      b.setAngularVelocity((float) r.nextDouble(-3, 3));
    }
    return w;
  }

  private static double spins(World<?> w) {
    double[] sum = new double[1];
    w.forEachBody(
        b ->
            sum[0] +=
                Math.abs(b.inertia() * b.angularVelocity())
                    + b.mass() * Lab.speed(b) * Math.hypot(b.centerX(), b.centerY()));
    return sum[0];
  }

  private static void check(World<String> w, double angular, long seed) {
    double[] before = Lab.momentum(w);
    double scale = before[3] + 1;
    double spin = spins(w) + 1;
    for (int i = 0; i < 300; i++) {
      w.step(DT);
      double[] now = Lab.momentum(w);
      String where = "seed=" + seed + " tick=" + i;
      assertEquals(before[0], now[0], 2e-6 * scale, where);
      assertEquals(before[1], now[1], 2e-6 * scale, where);
      assertEquals(before[2], now[2], angular * spin, where);
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void smoothCollisionsKeepMomentumToRounding(long seed) {
    check(swarm(seed, 0, 1), .01, seed);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void roughCollisionsKeepMomentumToRounding(long seed) {
    check(swarm(seed, .7, .3), .01, seed);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void inelasticCollisionsKeepMomentumAndLoseEnergy(long seed) {
    World<String> w = swarm(seed, .5, 0);
    double before = Lab.kinetic(w);
    check(w, .01, seed);
    assertTrue(Lab.kinetic(w) < before, "seed=" + seed);
  }

  /** Energy is lost to friction and inelastic impacts, never gained; seed for seed. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void collisionsDoNotAddEnergy(long seed) {
    World<String> w = swarm(seed, .7, .5);
    double last = Lab.kinetic(w);
    for (int i = 0; i < 300; i++) {
      w.step(DT);
      double now = Lab.kinetic(w);
      assertTrue(now < 1.01 * last, "seed=" + seed + " tick=" + i + " " + last + " " + now);
      last = now;
    }
  }

  /** A clump held together by joints of all kinds. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void jointsKeepMomentumToRounding(long seed) {
    World<String> w = Lab.space();
    SplittableRandom r = new SplittableRandom(seed);
    for (int i = 0; i < 12; i++) {
      Body<String> b =
          w.createBody(
              new BodyDef(BodyType.DYNAMIC)
                  .shape(i % 2 == 0 ? new Circle(.3f) : new Box(.4f, .2f))
                  .position(i, 0)
                  .velocity((float) r.nextDouble(-1, 1), (float) r.nextDouble(-1, 1))
                  .angularVelocity((float) r.nextDouble(-1, 1)),
              "link");
      if (i > 0) {
        Body<String> a = w.body(i - 1);
        float x = i - .5f;
        w.createJoint(
            switch (i % 6) {
              case 0 -> JointDef.revolute(a, b, x, 0).limits(-1, 1).spring(2, .1f);
              case 1 -> JointDef.distance(a, b, a.x(), 0, i, 0);
              case 2 -> JointDef.rope(a, b, a.x(), 0, i, 0, 1.2f);
              case 3 -> JointDef.weld(a, b, x, 0).angularSpring(3, .5f);
              case 4 -> JointDef.prismatic(a, b, x, 0, 1, 0).limits(-.3f, .3f).spring(1, .1f);
              default -> JointDef.wheel(a, b, i, 0, 0, 1).spring(4, .5f).motor(2, 1);
            });
      }
    }
    check(w, .02, seed);
  }
}
