package carom.physics.laws;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.math.Trig;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Assemblies that made energy from nothing: a propeller, a torso with servos, a soft weld between
 * unlike boxes, a weight on a chain.
 *
 * <p>Goal: none has more energy than it was given, by 1 % and 1 mJ. Method: the very cases that
 * were reported, with other numbers of arms and other springs.
 */
final class PassiveJointTest {
  private static final float DT = 1f / 60;

  /** What holds the arms of a star. */
  private enum Hold {
    WELD,
    LIMITS,
    BRAKE,
    SLIDER_LIMITS,
    SLIDER_BRAKE,
    FRICTION,
    HINGE;

    JointDef<String> of(Body<String> a, Body<String> b, float x, float y) {
      return switch (this) {
        case WELD -> JointDef.weld(a, b, x, y);
        case LIMITS -> JointDef.revolute(a, b, x, y).limits(0, 0);
        case BRAKE -> JointDef.revolute(a, b, x, y).motor(0, 1e4f);
        case SLIDER_LIMITS -> JointDef.prismatic(a, b, x, y, 1, 0).limits(0, 0);
        case SLIDER_BRAKE -> JointDef.prismatic(a, b, x, y, 1, 0).motor(0, 1e4f);
        case FRICTION -> JointDef.friction(a, b, x, y, 1e4f, 1e4f);
        case HINGE -> JointDef.revolute(a, b, x, y);
      };
    }
  }

  /** A spring between a small and a larger box. */
  private enum Spring {
    HINGE,
    WELD,
    WELD_ANGLE,
    WELD_BOTH,
    SLIDER,
    MOTOR,
    WHEEL,
    ROD;

    JointDef<String> of(Body<String> a, Body<String> b, float hertz, float damping) {
      float x = b.x();
      float y = b.y();
      return switch (this) {
        case HINGE -> JointDef.revolute(a, b, x, y).spring(hertz, damping);
        case WELD -> JointDef.weld(a, b, x, y).spring(hertz, damping);
        case WELD_ANGLE -> JointDef.weld(a, b, x, y).angularSpring(hertz, damping);
        case WELD_BOTH ->
            JointDef.weld(a, b, x, y).spring(hertz, damping).angularSpring(hertz, damping);
        case SLIDER -> JointDef.prismatic(a, b, x, y, 1, 0.3f).spring(hertz, damping);
        case MOTOR ->
            JointDef.motor(a, b, 1e6f, 1e6f).spring(hertz, damping).angularSpring(hertz, damping);
        case WHEEL -> JointDef.wheel(a, b, x, y, 0.2f, 1).spring(hertz, damping);
        case ROD ->
            JointDef.distance(a, b, a.x(), a.y() + 0.1f, x + 0.2f, y).spring(hertz, damping);
      };
    }
  }

  @ParameterizedTest
  @EnumSource
  void starsOfThreeToEightArmsGainNothing(Hold hold) {
    for (int arms = 3; arms <= 8; arms++) {
      for (float speed : new float[] {1e-4f, 1, 10}) {
        World<String> w = world(0);
        Body<String> hub = w.createBody(dynamic(0, 0).shape(new Circle(0.5f), material(1)), "hub");
        for (int i = 0; i < arms; i++) {
          float angle = 2 * Trig.PI * i / arms;
          float cos = Trig.cos(angle);
          float sin = Trig.sin(angle);
          BodyDef def = dynamic(1.5f * cos, 1.5f * sin).angle(angle);
          Body<String> arm = w.createBody(def.shape(new Box(1, 0.1f), material(1), apart()), "arm");
          w.createJoint(hold.of(hub, arm, 0.5f * cos, 0.5f * sin));
          arm.setVelocity(0, i == 0 ? speed : 0);
        }
        assertPassive(w, 300, energy(w), hold + " arms=" + arms + " speed=" + speed);
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void aPlusOfFiveBoxesGainsNothing(Hold hold) {
    World<String> w = world(0);
    Body<String> hub = box(w, 0.5f, 0.5f, 0, 0, 1);
    for (int i = 0; i < 4; i++) {
      float x = i == 0 ? 1 : i == 2 ? -1 : 0;
      float y = i == 1 ? 1 : i == 3 ? -1 : 0;
      Body<String> arm = box(w, 0.5f, 0.5f, x, y, 1);
      w.createJoint(hold.of(hub, arm, x / 2, y / 2));
      arm.setVelocity(0, i == 0 ? 1 : 0);
    }
    assertPassive(w, 600, energy(w), hold.toString());
  }

  @ParameterizedTest
  @EnumSource
  void springsBetweenUnlikeBoxesGainNothing(Spring spring) {
    for (float hertz : new float[] {2, 10, 20, 60, 120, 1000}) {
      for (float damping : new float[] {0, 0.1f, 0.5f, 5}) {
        World<String> w = world(0);
        Body<String> small = box(w, 0.2f, 0.2f, 0, 0, 1);
        Body<String> large = box(w, 0.5f, 0.5f, 0.9f, 0, 1);
        w.createJoint(spring.of(small, large, hertz, damping));
        large.setVelocity(0.0006f, 0.0008f);
        large.setAngularVelocity(hertz == 60 ? 1 : 0);
        assertPassive(w, 300, energy(w), spring + " hertz=" + hertz + " damping=" + damping);
      }
    }
  }

  @Test
  void twoSoftWeldsOnASmallBoxGainNothing() {
    for (float hertz : new float[] {1, 2, 5, 10}) {
      World<String> w = world(0);
      Body<String> left = box(w, 0.5f, 0.5f, -0.6f, 0, 1);
      Body<String> small = box(w, 0.1f, 0.1f, 0, 0, 1);
      Body<String> right = box(w, 0.5f, 0.5f, 0.6f, 0, 1);
      w.createJoint(
          JointDef.weld(left, small, -0.1f, 0).spring(hertz, 0.5f).angularSpring(hertz, 0.5f));
      w.createJoint(
          JointDef.weld(small, right, 0.1f, 0).spring(hertz, 0.5f).angularSpring(hertz, 0.5f));
      right.setVelocity(0, 0.5f);
      assertPassive(w, 900, energy(w), "hertz=" + hertz);
    }
  }

  /** A weight on a chain: folded back to the anchor (0), level (1), thrown up (2). */
  @ParameterizedTest
  @CsvSource({"4, 0", "4, 1", "4, 2", "8, 0", "8, 2"})
  void aWeightOnAChainGainsNothing(int links, int how) {
    for (float weight : new float[] {50, 200, 1000, 5000, 10_000}) {
      World<String> w = world(-10);
      Body<String> before = null;
      for (int i = 0; i < links; i++) {
        float from = how == 0 ? (i % 2) * 0.5f : i * 0.5f;
        float middle = how == 0 ? 0.25f : from + 0.25f;
        float density = (i == links - 1 ? weight : 1) / 0.05f;
        BodyDef def = dynamic(middle, 0).velocity(0, how == 2 ? 8 : 0);
        Body<String> link =
            w.createBody(def.shape(new Box(0.25f, 0.05f), material(density), apart()), "link");
        w.createJoint(JointDef.revolute(before, link, from, 0));
        before = link;
      }
      double fall = 10 * weight * 0.5 * links;
      assertPassive(w, 600, fall, "weight=" + weight + " links=" + links);
    }
  }

  /** Planks that loads threw about got 490 times what was put in. */
  @ParameterizedTest
  @CsvSource({"0.09, 230", "0.09, 1000", "1, 230", "5, 20"})
  void aBridgeUnderHeavyLoadsGainsNothing(float plank, float ratio) {
    World<String> w = world(-10);
    Body<String> before = null;
    for (int i = 0; i < 7; i++) {
      BodyDef def =
          dynamic(i * plank, 0).shape(new Box(plank / 2, plank / 12), material(1), apart());
      Body<String> next = w.createBody(def, "plank");
      w.createJoint(JointDef.revolute(before, next, (i - 0.5f) * plank, 0));
      before = next;
    }
    w.createJoint(JointDef.revolute(null, before, 6.5f * plank, 0));
    double heavy = 0;
    for (float x : new float[] {1.2f, 4.8f, 0.2f}) {
      BodyDef def = dynamic(x * plank, plank * (1 + x / 2));
      Material stone = material(ratio / (6 * 1.13f));
      Body<String> load = w.createBody(def.shape(new Circle(plank * 0.6f), stone), "load");
      heavy += load.mass() * 10;
    }
    assertPassive(w, 240, heavy * 4 * plank, "plank=" + plank + " ratio=" + ratio);
  }

  /**
   * What pulls far outside of a body turns it more than it moves it. One got 53,000 times its own.
   */
  @Test
  void chainsOfHingesFarOutsideGainNothing() {
    for (long seed = 1; seed <= 200; seed++) {
      Random r = new Random(seed);
      World<String> w = world(0);
      Body<String> before = null;
      for (int i = 0; i < 4; i++) {
        Body<String> next = plank(w, 0.1f, i, 3, 10, r);
        if (before != null) {
          float x = i + 4 * r.nextFloat() - 2.5f;
          w.createJoint(JointDef.revolute(before, next, x, r.nextFloat() - 0.5f));
        }
        before = next;
      }
      assertPassive(w, 120, energy(w), "seed=" + seed);
    }
  }

  /** Wheels that were off their lines had springs of another stiffness, and lost their momentum. */
  @ParameterizedTest
  @ValueSource(longs = {56, 73, 192, 250, 289, 387})
  void wheelsThatFlyFarOffKeepTheirMomentum(long seed) {
    Random r = new Random(seed);
    World<String> w = world(0);
    Body<String> before = null;
    double scale = 0;
    for (int i = 0; i < 5; i++) {
      Body<String> next = plank(w, 0.1f + 0.4f * r.nextFloat(), i, i == 3 ? 1 : 30, 20, r);
      if (before != null) {
        float turn = 6 * r.nextFloat();
        JointDef<String> wheel =
            JointDef.wheel(before, next, i - r.nextFloat(), 0, Trig.cos(turn), Trig.sin(turn));
        w.createJoint(wheel.spring(1 + 20 * r.nextFloat(), 0).motor(0, 100));
      }
      scale += next.mass() * Math.hypot(next.velocityX(), next.velocityY());
      before = next;
    }
    double[] had = momentum(w);
    for (int i = 0; i < 120; i++) {
      w.step(DT);
      double[] now = momentum(w);
      assertEquals(had[0], now[0], 1e-4 * scale, "step=" + i);
      assertEquals(had[1], now[1], 1e-4 * scale, "step=" + i);
    }
  }

  private static Body<String> plank(
      World<String> w, float halfX, float x, float density, float fast, Random r) {
    Material material = material(density);
    BodyDef def =
        dynamic(x, 0).shape(new Box(halfX, 0.02f + 0.08f * r.nextFloat()), material, apart());
    float vx = fast * (2 * r.nextFloat() - 1);
    return w.createBody(def.velocity(vx, fast * (2 * r.nextFloat() - 1)), "plank");
  }

  private static double[] momentum(World<String> w) {
    double[] sum = new double[2];
    w.forEachBody(
        b -> {
          sum[0] += (double) b.mass() * b.velocityX();
          sum[1] += (double) b.mass() * b.velocityY();
        });
    return sum;
  }

  /** What is carried along isn't passive: a trolley sets in motion what hangs on it. */
  @ParameterizedTest
  @EnumSource
  void whatATrolleyCarriesGoesWithIt(Hold hold) {
    for (float weight : new float[] {1, 1000}) {
      World<String> w = world(0);
      Body<String> trolley =
          w.createBody(new BodyDef(BodyType.KINEMATIC).shape(new Box(0.2f, 0.1f)), "trolley");
      Body<String> before = trolley;
      for (int i = 0; i < 4; i++) {
        float density = (i == 3 ? weight : 1) / 0.05f;
        BodyDef def = dynamic(0, -0.25f - 0.5f * i);
        Material material = material(density);
        Body<String> link =
            w.createBody(def.shape(new Box(0.05f, 0.25f), material, apart()), "link");
        boolean top = i == 0;
        w.createJoint(
            top ? hold.of(before, link, 0, 0) : JointDef.revolute(before, link, 0, -0.5f * i));
        before = link;
      }
      trolley.setVelocity(1, 0);
      double way = before.x();
      for (int i = 0; i < 300; i++) {
        w.step(DT);
        way += DT * before.velocityX();
      }
      assertEquals(way, before.x(), 0.1, hold + " weight=" + weight + ", moved without speed");
      double far = Math.hypot(trolley.x() - before.x(), trolley.y() - before.y());
      assertEquals(5, trolley.x(), 1e-3);
      assertTrue(far < 1.8, hold + " weight=" + weight + " far=" + far);
    }
  }

  private static void assertPassive(World<String> w, int steps, double given, String what) {
    double before = energy(w);
    for (int i = 0; i < steps; i++) {
      w.step(DT);
      double gained = energy(w) - before;
      assertTrue(gained <= 0.01 * given + 0.001, what + " gained=" + gained + " J, step=" + i);
    }
  }

  /**
   * Chains of like masses, hung from a point far above, with hinges far outside of their bodies: 3
   * in 100 gained up to 13 times their energy.
   */
  @Test
  void chainsWithFarAnchorsGainNothing() {
    for (int seed = 1; seed <= 140; seed++) {
      Random r = new Random(31L * seed);
      World<String> w = world(-10);
      Body<String> before = null;
      double given = 0;
      for (int i = 3 + r.nextInt(6); i > 0; i--) {
        float half = 0.1f + 0.3f * r.nextFloat();
        Box shape = new Box(half, half * (0.2f + 0.8f * r.nextFloat()));
        float x = w.bodyCount() + 0.3f * r.nextFloat();
        BodyDef def = dynamic(x, r.nextFloat());
        def.velocity(8 * r.nextFloat() - 4, 8 * r.nextFloat() - 4);
        Material even = material(1 / (half * half));
        Body<String> b = w.createBody(def.shape(shape, even, apart()), "link");
        float far = 3 * r.nextFloat() - 1;
        w.createJoint(
            before == null
                ? JointDef.revolute(null, b, b.x(), b.y() + 3 + 3 * r.nextFloat())
                : JointDef.revolute(
                    before,
                    b,
                    before.x() + far * (b.x() - before.x()),
                    before.y() + far * (b.y() - before.y())));
        given += b.mass() * 10 * 20;
        before = b;
      }
      assertPassive(w, 240, given, "seed=" + seed);
    }
  }

  /**
   * What was held back of a change of velocity took its turning from where bodies were before they
   * moved: one in five lost up to 11 % of its angular momentum.
   */
  @Test
  void sliderOnASpringKeepsTurning() {
    for (int seed = 1; seed <= 60; seed++) {
      Random r = new Random(31L * seed);
      World<String> w = world(0);
      float far = 1 + 2 * r.nextFloat();
      float along = Trig.PI * r.nextFloat();
      Box one = new Box(0.2f + 0.3f * r.nextFloat(), 0.2f);
      Body<String> a = w.createBody(dynamic(0, 0).shape(one, material(1), apart()), "one");
      Box two = new Box(0.2f, 0.2f + 0.3f * r.nextFloat());
      Body<String> b = w.createBody(dynamic(far, 0).shape(two, material(1), apart()), "two");
      JointDef<String> slider =
          JointDef.prismatic(a, b, far * r.nextFloat(), 0, Trig.cos(along), Trig.sin(along));
      w.createJoint(slider.spring(1 + 30 * r.nextFloat(), r.nextFloat()));
      float spin = 2 + 8 * r.nextFloat();
      a.setVelocity(0, -spin * far / 2);
      b.setVelocity(0, spin * far / 2);
      a.setAngularVelocity(spin);
      b.setAngularVelocity(spin);
      double before = angularMomentum(a) + angularMomentum(b);
      for (int i = 0; i < 300; i++) {
        w.step(DT);
      }
      double now = angularMomentum(a) + angularMomentum(b);
      assertEquals(before, now, 1e-3 * before, "seed=" + seed);
    }
  }

  private static double angularMomentum(Body<String> b) {
    double turning = (double) b.centerX() * b.velocityY() - (double) b.centerY() * b.velocityX();
    return b.mass() * turning + b.inertia() * b.angularVelocity();
  }

  private static double energy(World<String> w) {
    double[] sum = new double[1];
    w.forEachBody(
        b -> {
          double vx = b.velocityX();
          double vy = b.velocityY();
          double turn = b.angularVelocity();
          sum[0] += 0.5 * b.mass() * (vx * vx + vy * vy) + 0.5 * b.inertia() * turn * turn;
          sum[0] -= b.mass() * w.gravityY() * b.centerY();
        });
    return sum[0];
  }

  private static World<String> world(float gravity) {
    return new World<>(new WorldDef().withGravity(0, gravity).withSleeping(false));
  }

  private static BodyDef dynamic(float x, float y) {
    return new BodyDef(BodyType.DYNAMIC).position(x, y);
  }

  private static Material material(float density) {
    return new Material(density, 0.6f, 0);
  }

  /** Arms don't touch each other. */
  private static Filter apart() {
    return Filter.DEFAULT.withGroup(-1);
  }

  private static Body<String> box(
      World<String> w, float halfX, float halfY, float x, float y, float density) {
    return w.createBody(dynamic(x, y).shape(new Box(halfX, halfY), material(density)), "box");
  }
}
