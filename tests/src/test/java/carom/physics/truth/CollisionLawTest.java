package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static carom.physics.truth.Lab.ICE;
import static carom.physics.truth.Lab.ball;
import static carom.physics.truth.Lab.body;
import static carom.physics.truth.Lab.disc;
import static carom.physics.truth.Lab.fixed;
import static carom.physics.truth.Lab.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.Collision;
import carom.physics.CollisionListener;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Collisions against Newton's law of impact (Goldsmith, "Impact", 1960, chapter 2): the normal
 * speed turns around times e, the impulse is {@code j = (1 + e) v / (1/m1 + 1/m2)}.
 */
final class CollisionLawTest {
  static List<Arguments> masses() {
    List<Arguments> all = new ArrayList<>();
    for (double ratio : new double[] {.001, .01, .1, .5, 1, 2, 10, 100, 1000}) {
      for (double e : new double[] {0, .25, .5, .75, 1}) {
        all.add(Arguments.of(ratio, e));
      }
    }
    return all;
  }

  /** v1' = v1 - (1 + e) m2 (v1 - v2) / (m1 + m2), and v2' likewise. */
  @ParameterizedTest
  @MethodSource("masses")
  void headOnDiscsExchangeMomentum(double ratio, double e) {
    World<String> w = Lab.space();
    Material m = new Material(1, 0, (float) e);
    Body<String> a = ball(w, -2, 0, 1, m);
    Body<String> b = ball(w, 2, 0, ratio, m);
    checkHeadOn(w, a, b, e);
  }

  /**
   * The same with two contact points. Without a bounce, what sequential impulses leave unsolved
   * between the two points stays as a slight turn: at most 1 % of the speed.
   */
  @ParameterizedTest
  @MethodSource("masses")
  void headOnBoxesExchangeMomentum(double ratio, double e) {
    World<String> w = Lab.space();
    Material m = new Material(1, .5f, (float) e);
    Body<String> a = body(w, new Box(.5f, .5f), -2, 0, m);
    Body<String> b = body(w, new Box(.5f, .5f), 2, 0, m.withDensity((float) ratio));
    checkHeadOn(w, a, b, e);
    assertEquals(0, a.angularVelocity(), e > 0 ? 5e-3 : .05);
    assertEquals(0, b.angularVelocity(), e > 0 ? 5e-3 : .05);
  }

  private static void checkHeadOn(World<String> w, Body<String> a, Body<String> b, double e) {
    a.setVelocity(3, 0);
    b.setVelocity(-2, 0);
    steps(w, 90);
    double both = a.mass() + b.mass();
    double tolerance = e > 0 ? 5e-3 : .03;
    assertEquals(3 - (1 + e) * b.mass() * 5 / both, a.velocityX(), tolerance);
    assertEquals(-2 + (1 + e) * a.mass() * 5 / both, b.velocityX(), tolerance);
    double p = 3 * a.mass() - 2 * b.mass();
    double now = a.mass() * a.velocityX() + b.mass() * b.velocityX();
    assertEquals(p, now, 1e-5 * both, "momentum");
    assertEquals(0, Math.abs(a.velocityY()) + Math.abs(b.velocityY()), 5e-3);
  }

  static List<Arguments> walls() {
    List<Arguments> all = new ArrayList<>();
    for (Lab.Solid solid : Lab.Solid.values()) {
      for (double e : new double[] {0, .3, .6, 1}) {
        for (double v : new double[] {2, 8, 20}) {
          all.add(Arguments.of(solid, e, v));
        }
      }
    }
    return all;
  }

  /**
   * A wall answers with e times the speed, whatever meets it. Without a bounce, flat bodies that
   * dived deep keep up to 5 % of their speed from being pushed out, as a turn and a slow retreat.
   */
  @ParameterizedTest
  @MethodSource("walls")
  void whateverMeetsAWallLeavesItWithItsRestitution(Lab.Solid solid, double e, double v) {
    World<String> w = Lab.space();
    fixed(w, new Box(10, 1), 0, -1, 0, ICE);
    Body<String> b = body(w, solid.shape, 0, 2, new Material(1, 0, (float) e));
    b.setVelocity(0, (float) -v);
    steps(w, 90);
    assertEquals(e * v, b.velocityY(), (e > 0 ? .002 : .05) * v);
    assertEquals(0, b.velocityX(), 1e-3 * v);
    assertEquals(0, b.angularVelocity(), (e > 0 ? .002 : .1) * v);
  }

  /** Approaches below the threshold don't bounce. */
  @ParameterizedTest
  @CsvSource({"0.5,1,0", "0.98,1,0", "1.02,1,1.02", "3,4,0", "5,4,5"})
  void slowApproachesDoNotBounce(float v, float threshold, double expected) {
    World<String> w =
        new World<>(
            new WorldDef()
                .withSleeping(false)
                .withGravity(0, 0)
                .withRestitutionThreshold(threshold));
    fixed(w, new Box(10, 1), 0, -1, 0, ICE);
    Body<String> b = disc(w, 0, .7, .5, new Material(1, 0, 1));
    b.setVelocity(0, -v);
    steps(w, 90);
    assertEquals(expected, b.velocityY(), 5e-3);
  }

  static List<Arguments> drops() {
    List<Arguments> all = new ArrayList<>();
    for (double e : new double[] {.3, .5, .7, .9, 1}) {
      for (double height : new double[] {1, 3, 10}) {
        all.add(Arguments.of(e, height));
      }
    }
    return all;
  }

  /** h' = e^2 h, bounce after bounce, while the approach is faster than the threshold. */
  @ParameterizedTest
  @MethodSource("drops")
  void bounceHeightsShrinkByTheSquareOfTheRestitution(double e, double height) {
    World<String> w = Lab.floor(ICE);
    Body<String> b = disc(w, 0, .5 + height, .5, new Material(1, 0, (float) e));
    double expected = height;
    double top = 0;
    int bounces = 0;
    boolean rising = false;
    for (int i = 0; i < 900 && bounces < 4; i++) {
      w.step(DT);
      if (b.velocityY() > 0) {
        rising = true;
        top = Math.max(top, b.y() - .5);
      } else if (rising) {
        rising = false;
        expected *= e * e;
        if (expected < .08) {
          return;
        }
        bounces++;
        assertEquals(expected, top, .01 * expected + .002, "bounce " + bounces);
        top = 0;
      }
    }
    assertTrue(bounces > 0);
  }

  static List<Arguments> oblique() {
    List<Arguments> all = new ArrayList<>();
    for (double offset : new double[] {0, .2, .4, .6, .8, .95}) {
      for (double e : new double[] {0, .5, 1}) {
        for (double mass : new double[] {1, 3}) {
          all.add(Arguments.of(offset, e, mass));
        }
      }
    }
    return all;
  }

  /** Only the component along the line of centres changes; it is asked for where they touched. */
  @ParameterizedTest
  @MethodSource("oblique")
  void smoothObliqueDiscsChangeTheirNormalSpeedOnly(double offset, double e, double mass) {
    World<String> w = Lab.lively();
    Material m = new Material(1, 0, (float) e);
    Body<String> a = ball(w, -2, 0, 1, m);
    Body<String> b = ball(w, 0, offset, mass, m);
    a.setVelocity(2, 0);
    double[] n = normal(w);
    steps(w, 120);
    double approach = 2 * n[0];
    double j = (1 + e) * approach / (1 + 1 / mass);
    double tolerance = 5e-3;
    assertEquals(2 - j * n[0], a.velocityX(), tolerance);
    assertEquals(-j * n[1], a.velocityY(), tolerance);
    assertEquals(j / mass * n[0], b.velocityX(), tolerance);
    assertEquals(j / mass * n[1], b.velocityY(), tolerance);
    assertEquals(0, a.angularVelocity(), 1e-5);
    assertEquals(offset, n[1], .05, "sine of the line of centres is offset / (2 r)");
    double lost = (1 - e * e) * approach * approach / (2 * (1 + 1 / mass));
    assertEquals(2 - lost, Lab.kinetic(w), .01, "energy");
  }

  /** The normal of the first contact that carries an impulse, filled while stepping. */
  private static double[] normal(World<String> w) {
    double[] n = new double[2];
    w.listener(
        new CollisionListener<>() {
          @Override
          public void postSolve(Collision<String> c) {
            if (c.normalImpulse(0) > 0) {
              n[0] = c.normalX();
              n[1] = c.normalY();
            }
          }
        });
    return n;
  }

  static List<Arguments> rough() {
    List<Arguments> all = new ArrayList<>();
    for (double mu : new double[] {0, .05, .1, .2, .4, 1}) {
      for (double slip : new double[] {-3, 0, 2}) {
        for (double e : new double[] {0, .5, 1}) {
          all.add(Arguments.of(mu, slip, e));
        }
      }
    }
    return all;
  }

  /**
   * A spinning disc meets a rough wall. With the slip u = vt + w r, the tangential impulse is
   * {@code min(mu (1 + e) m vn, m u / 3)}: it slides through the impact or leaves it rolling (m / 3
   * is the tangential mass of a disc, 1 / (1/m + r^2/I)).
   */
  @ParameterizedTest
  @MethodSource("rough")
  void aRoughWallTurnsADisc(double mu, double spin, double e) {
    World<String> w = Lab.lively();
    fixed(w, new Box(20, 1), 0, -1, 0, new Material(1, (float) mu, (float) e));
    Body<String> b = disc(w, 0, 1.5, .5, new Material(1, (float) mu, (float) e));
    b.setVelocity(2, -4);
    b.setAngularVelocity((float) spin);
    steps(w, 45);
    double m = b.mass();
    double slip = 2 + spin * .5;
    double j = Math.min(mu * (1 + e) * m * 4, m * Math.abs(slip) / 3) * Math.signum(slip);
    assertEquals(e * 4, b.velocityY(), .02);
    assertEquals(2 - j / m, b.velocityX(), .02);
    assertEquals(spin - j * .5 / b.inertia(), b.angularVelocity(), .04);
  }

  /** An off-centre hit: 1 / m grows by (r x n)^2 / I. */
  @ParameterizedTest
  @ValueSource(doubles = {0, .2, .5, .8})
  void anOffCentreHitTurnsABox(double arm) {
    World<String> w = Lab.lively();
    Material m = new Material(1, 0, 1);
    Body<String> rod = body(w, new Box(1, .25f), 0, 0, m);
    Body<String> b = disc(w, arm, 2, .25, m.withDensity(4));
    b.setVelocity(0, -3);
    steps(w, 60);
    double inverse = 1 / b.mass() + 1 / rod.mass() + arm * arm / rod.inertia();
    double j = 2 * 3 / inverse;
    assertEquals(-3 + j / b.mass(), b.velocityY(), .01);
    assertEquals(-j / rod.mass(), rod.velocityY(), .01);
    assertEquals(-j * arm / rod.inertia(), rod.angularVelocity(), .01);
  }

  /** Restitution mixes as the larger, friction as the geometric mean. */
  @ParameterizedTest
  @CsvSource({"0,0.8,0.8", "0.8,0,0.8", "0.3,0.6,0.6", "1,1,1", "0,0,0"})
  void restitutionMixesAsTheLarger(float one, float two, double e) {
    World<String> w = Lab.space();
    fixed(w, new Box(10, 1), 0, -1, 0, new Material(1, 0, one));
    Body<String> b = disc(w, 0, 2, .5, new Material(1, 0, two));
    b.setVelocity(0, -5);
    steps(w, 60);
    assertEquals(e * 5, b.velocityY(), .01);
  }

  /** Separated balls in a row: each hands its whole speed to the next. */
  @ParameterizedTest
  @ValueSource(ints = {2, 3, 5, 8})
  void aRowOfEqualBallsHandsTheSpeedOn(int balls) {
    World<String> w = Lab.space();
    Material m = new Material(1, 0, 1);
    List<Body<String>> row = new ArrayList<>();
    for (int i = 0; i < balls; i++) {
      row.add(disc(w, 1.2 * i, 0, .5, m));
    }
    row.get(0).setVelocity(3, 0);
    steps(w, 120);
    for (int i = 0; i + 1 < balls; i++) {
      assertEquals(0, row.get(i).velocityX(), .01, "ball " + i);
    }
    assertEquals(3, row.get(balls - 1).velocityX(), .01);
  }

  /** Newton's cradle of pendulums 3 cm apart: as many swing out as came, and as high. */
  @ParameterizedTest
  @CsvSource({"5,1", "5,2", "4,1", "3,1"})
  void aCradleSendsOutAsManyAsCame(int balls, int come) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Material m = new Material(1, 0, 1);
    List<Body<String>> row = new ArrayList<>();
    for (int i = 0; i < balls; i++) {
      double x = 1.03 * i;
      double tilt = i < come ? -.5 : 0;
      row.add(disc(w, x + 4 * Math.sin(tilt), -4 * Math.cos(tilt), .5, m));
      float ax = row.get(i).x();
      float ay = row.get(i).y();
      w.createJoint(JointDef.distance(null, row.get(i), (float) x, 0, ax, ay));
    }
    double[] high = new double[balls];
    for (int i = 0; i < 110; i++) {
      w.step(DT);
      for (int k = 0; k < balls; k++) {
        high[k] = i < 50 ? 0 : Math.max(high[k], row.get(k).x() - 1.03 * k);
      }
    }
    for (int k = 0; k < balls; k++) {
      boolean out = k >= balls - come;
      assertEquals(out ? 4 * Math.sin(.5) : 0, high[k], .2, "ball " + k);
    }
  }

  /** Two balls dropped on top of each other: the light one leaves with up to 3 v. */
  @Test
  void aLightBallOnAHeavyOneIsSlungAway() {
    World<String> w = Lab.space();
    Material m = new Material(1, 0, 1);
    fixed(w, new Box(10, 1), 0, -1, 0, m);
    Body<String> heavy = disc(w, 0, 1, .5, m.withDensity(1000));
    Body<String> light = body(w, new Circle(.25f), 0, 1.9, m);
    heavy.setVelocity(0, -4);
    light.setVelocity(0, -4);
    steps(w, 60);
    assertEquals(12, light.velocityY(), .1);
    assertEquals(4, heavy.velocityY(), .1);
  }

  /** Ballistic pendulum: clay joins, v = m v0 / (m + M). */
  @ParameterizedTest
  @ValueSource(doubles = {1, 4, 20})
  void clayCarriesTheMomentumOn(double mass) {
    World<String> w = Lab.space();
    Body<String> bullet = ball(w, -2, 0, 1, ICE);
    Body<String> block = ball(w, 1, 0, mass, ICE);
    bullet.setVelocity(6, 0);
    steps(w, 90);
    assertEquals(6 / (1 + mass), bullet.velocityX(), 5e-3);
    assertEquals(6 / (1 + mass), block.velocityX(), 5e-3);
  }
}
