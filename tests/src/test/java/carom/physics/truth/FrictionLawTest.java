package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static carom.physics.truth.Lab.G;
import static carom.physics.truth.Lab.H;
import static carom.physics.truth.Lab.body;
import static carom.physics.truth.Lab.box;
import static carom.physics.truth.Lab.disc;
import static carom.physics.truth.Lab.fixed;
import static carom.physics.truth.Lab.seconds;
import static carom.physics.truth.Lab.speed;
import static carom.physics.truth.Lab.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Coulomb friction: |T| <= mu N, against the motion while sliding (any book of mechanics). */
final class FrictionLawTest {
  /** Low, so that nothing tips over before it slides. */
  private static final Box PLANK = new Box(1, .1f);

  private static Material rough(double mu) {
    return new Material(1, (float) mu, 0);
  }

  static List<Arguments> slopes() {
    List<Arguments> all = new ArrayList<>();
    for (double mu : new double[] {.05, .1, .2, .3, .4, .6, .8, 1, 1.5, 2}) {
      for (double side : new double[] {.9, .99, 1.01, 1.1, 1.5}) {
        all.add(Arguments.of(mu, side));
      }
    }
    return all;
  }

  /**
   * A body on a slope stays below tan(angle) = mu, and above it slides with a = g (sin - mu cos);
   * within 1 % of the angle's tangent on either side.
   */
  @ParameterizedTest
  @MethodSource("slopes")
  void slopesHoldUpToTheFrictionAngle(double mu, double side) {
    double angle = Math.atan(mu * side);
    World<String> w = Lab.slope(angle, rough(mu));
    Body<String> b = body(w, PLANK, 0, .1, rough(mu));
    seconds(w, 1);
    checkSlide(w, b, angle, mu, side);
  }

  /** The same with a turned floor instead of turned gravity. */
  @ParameterizedTest
  @MethodSource("slopes")
  void turnedFloorsHoldUpToTheFrictionAngle(double mu, double side) {
    double angle = Math.atan(mu * side);
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    fixed(w, new Box(500, 1, 0, -1), 0, 0, -angle, rough(mu));
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(PLANK, rough(mu))
                .position((float) (.1 * Math.sin(angle)), (float) (.1 * Math.cos(angle)))
                .angle((float) -angle),
            "plank");
    seconds(w, 1);
    checkSlide(w, b, angle, mu, side);
  }

  private static void checkSlide(
      World<String> w, Body<String> b, double angle, double mu, double side) {
    double v = speed(b);
    seconds(w, 2);
    if (side < 1) {
      assertEquals(0, speed(b), 2e-3, "holds");
    } else {
      double a = G * (Math.sin(angle) - mu * Math.cos(angle));
      double whole = G * Math.sin(angle);
      assertEquals(2 * a, speed(b) - v, .001 * 2 * whole, "slides, error against the pull");
    }
  }

  static List<Arguments> surfaces() {
    List<Arguments> all = new ArrayList<>();
    Shape[] floors = {
      new Box(500, 1, 0, -1),
      new Segment(500, 0, -500, 0),
      Chain.open(-500, 0, 0, 0, 500, 0),
      new Capsule(-500, -1, 500, -1, 1),
      Polygon.of(-500, 0, -500, -2, 500, -2, 500, 0)
    };
    Shape[] riders = {
      PLANK,
      new Capsule(-1, 0, 1, 0, .1f),
      Polygon.of(-1, -.1f, 1, -.1f, .8f, .1f, -.8f, .1f),
      Polygon.rounded(.05f, -.95f, -.05f, .95f, -.05f, .95f, .05f, -.95f, .05f)
    };
    for (Shape floor : floors) {
      for (Shape rider : riders) {
        all.add(Arguments.of(floor, rider));
      }
    }
    return all;
  }

  /** The law doesn't depend on the shapes. */
  @ParameterizedTest
  @MethodSource("surfaces")
  void frictionIsTheSameForAllShapes(Shape floor, Shape rider) {
    for (double side : new double[] {.98, 1.02, 1.4}) {
      double angle = Math.atan(.5 * side);
      World<String> w =
          new World<>(
              new WorldDef()
                  .withSleeping(false)
                  .withGravity((float) (G * Math.sin(angle)), (float) (-G * Math.cos(angle))));
      fixed(w, floor, 0, 0, 0, rough(.5));
      Body<String> b = body(w, rider, -40, .1, rough(.5));
      seconds(w, 1);
      double v = b.velocityX();
      seconds(w, 2);
      double a = side < 1 ? 0 : G * (Math.sin(angle) - .5 * Math.cos(angle));
      assertEquals(2 * a, b.velocityX() - v, .02, floor + " side=" + side);
    }
  }

  /** Friction mixes as the geometric mean. */
  @ParameterizedTest
  @CsvSource({"0.2,0.8", "0.1,0.9", "1,0.25", "0.5,0.5", "0,1"})
  void frictionMixesAsTheGeometricMean(double one, double two) {
    double mu = Math.sqrt(one * two);
    World<String> w = Lab.floor(rough(one));
    Body<String> b = body(w, PLANK, 0, .1, rough(two));
    steps(w, 10);
    b.setVelocity(8, 0);
    seconds(w, .5);
    assertEquals(8 - mu * G * .5, b.velocityX(), .03);
  }

  static List<Arguments> throwsOver() {
    List<Arguments> all = new ArrayList<>();
    for (double mu : new double[] {.1, .3, .6, 1}) {
      for (double v : new double[] {1, 3, 6, 12}) {
        all.add(Arguments.of(mu, v));
      }
    }
    return all;
  }

  /** s = v^2 / (2 mu g), less v h / 2 by the discretisation; then it stands still. */
  @ParameterizedTest
  @MethodSource("throwsOver")
  void slidingBodiesStopAfterTheStoppingDistance(double mu, double v) {
    World<String> w = Lab.floor(rough(mu));
    Body<String> b = body(w, PLANK, 0, .1, rough(mu));
    steps(w, 30);
    double x = b.x();
    b.setVelocity((float) v, 0);
    seconds(w, v / (mu * G) + 1);
    double expected = v * v / (2 * mu * G) - v * H / 2;
    assertEquals(expected, b.x() - x, .01 * expected + .002);
    assertEquals(0, speed(b), 5e-4);
    double stands = b.x();
    seconds(w, 2);
    assertEquals(stands, b.x(), 1e-3);
  }

  /** A pull below mu m g moves nothing; above it a = F / m - mu g. */
  @ParameterizedTest
  @CsvSource({"0.3,0.99", "0.3,1.01", "0.3,2", "0.7,0.99", "0.7,1.01", "0.7,1.5", "0.7,4"})
  void aPullMovesOnlyBeyondFriction(double mu, double share) {
    World<String> w = Lab.floor(rough(mu));
    Body<String> b = body(w, PLANK, 0, .1, rough(mu));
    steps(w, 30);
    double x = b.x();
    for (int i = 0; i < 120; i++) {
      b.applyForce((float) (share * mu * b.mass() * G), 0);
      w.step(DT);
    }
    double a = Math.max(0, share - 1) * mu * G;
    assertEquals(2 * a, b.velocityX(), .002 * mu * G * 2 * share);
    assertEquals(2 * a, b.x() - x, .005 * mu * G * 2 * share + .001);
  }

  /** Pressed against a wall with N it stays while mu N > m g. */
  @ParameterizedTest
  @ValueSource(doubles = {.5, .97, 1.03, 2})
  void aPressedBodyHangsOnAWall(double share) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    fixed(w, new Box(1, 50), 1, 0, 0, rough(.5));
    Body<String> b = body(w, new Box(.1f, 1), -.1, 0, rough(.5));
    for (int i = 0; i < 120; i++) {
      b.applyForce((float) (share * b.mass() * G / .5), 0);
      w.step(DT);
    }
    assertEquals(-Math.max(0, 1 - share) * G * 2, b.velocityY(), .3);
    assertEquals(share > 1, Math.abs(b.velocityY()) < .01, "v=" + b.velocityY());
  }

  /** Friction between two bodies is between them: a1 = -mu g, a2 = mu g m1 / m2. */
  @ParameterizedTest
  @ValueSource(doubles = {.5, 1, 4})
  void aSlidingBodyDragsWhatItLiesOn(double ratio) {
    World<String> w = Lab.floor(rough(0));
    Body<String> sledge = body(w, new Box(4, .2f), 0, .2, rough(.4));
    double density = .5 / (2 * .2 * ratio) * 8 * .4 * .25;
    Body<String> load = body(w, new Box(1, .1f), 0, .5, rough(.4).withDensity((float) density));
    steps(w, 30);
    load.setVelocity(2, 0);
    seconds(w, .2);
    double v = 2 - .4 * G * .2;
    assertEquals(v, load.velocityX(), .02);
    assertEquals(.4 * G * .2 * load.mass() / sledge.mass(), sledge.velocityX(), .02);
    seconds(w, 3);
    double common = 2 * load.mass() / (load.mass() + sledge.mass());
    assertEquals(common, load.velocityX(), .01, "momentum, in the end together");
    assertEquals(common, sledge.velocityX(), .01);
  }

  /** a = mu g until it runs along; nothing is gained beyond. */
  @ParameterizedTest
  @CsvSource({"0.2,2", "0.2,-2", "0.5,5", "0.5,-1", "1,3"})
  void conveyorsCarryUpToTheirSpeed(double mu, double speed) {
    World<String> w = Lab.floor(rough(mu).withTangentSpeed((float) speed));
    Body<String> b = body(w, PLANK, 0, .1, rough(mu));
    steps(w, 30);
    b.setVelocity(0, 0);
    double v = b.velocityX();
    seconds(w, .1);
    assertEquals(v + Math.signum(speed) * mu * G * .1, b.velocityX(), .02);
    seconds(w, 3);
    assertEquals(speed, b.velocityX(), 1e-3);
  }

  /** A kinematic platform takes along what stands on it, without touching its own speed. */
  @ParameterizedTest
  @CsvSource({"2,0", "-3,0", "0,1", "0,-1", "1,1"})
  void movingPlatformsCarryTheirRiders(float vx, float vy) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> platform =
        w.createBody(
            new BodyDef(BodyType.KINEMATIC)
                .shape(new Box(30, .5f), rough(.8))
                .position(0, -.5f)
                .velocity(vx, vy),
            "platform");
    Body<String> b = body(w, new Box(.5f, .5f), 0, .5, rough(.8));
    b.setVelocity(0, vy);
    seconds(w, 3);
    assertEquals(vx, b.velocityX(), 1e-3);
    assertEquals(vy, b.velocityY(), 1e-3);
    assertEquals(vx, platform.velocityX());
    assertEquals(1, b.y() - platform.y(), .005);
    double slipped = Math.abs(vx) * Math.abs(vx) / (2 * .8 * G);
    assertEquals(slipped, Math.abs(b.x() - platform.x()), .02 + .02 * slipped);
  }

  /** A kinematic pusher is stronger than any mass. */
  @ParameterizedTest
  @ValueSource(floats = {.1f, 1, 100, 10_000})
  void kinematicBodiesPushWhateverIsInTheWay(float density) {
    World<String> w = Lab.floor(rough(.3));
    Body<String> b = body(w, PLANK, 0, .1, rough(.3).withDensity(density));
    Body<String> pusher =
        w.createBody(
            new BodyDef(BodyType.KINEMATIC)
                .shape(new Box(.1f, .5f), rough(0))
                .position(-3, .55f)
                .velocity(1, 0),
            "pusher");
    seconds(w, 6);
    assertEquals(3, pusher.x(), 1e-4);
    assertEquals(4.1, b.x(), .02);
    assertEquals(1, b.velocityX(), .01);
  }

  static List<Arguments> rolling() {
    List<Arguments> all = new ArrayList<>();
    for (double angle : new double[] {.05, .2, .4, .6}) {
      for (double mu : new double[] {.1, .3, .6, 1}) {
        all.add(Arguments.of(angle, mu));
      }
    }
    return all;
  }

  /**
   * A disc rolls with a = 2/3 g sin while tan(angle) <= 3 mu; beyond it slips, with a = g (sin - mu
   * cos) and a spin that grows with 2 mu g cos / r.
   */
  @ParameterizedTest
  @MethodSource("rolling")
  void discsRollOrSlipDownSlopes(double angle, double mu) {
    World<String> w = Lab.slope(angle, rough(mu));
    Body<String> b = disc(w, 0, .5, .5, rough(mu));
    seconds(w, .5);
    double v = b.velocityX();
    double spin = b.angularVelocity();
    seconds(w, 1);
    boolean rolls = Math.tan(angle) < 3 * mu;
    double a = rolls ? G * Math.sin(angle) * 2 / 3 : G * (Math.sin(angle) - mu * Math.cos(angle));
    double turn = rolls ? a / .5 : 2 * mu * G * Math.cos(angle) / .5;
    assertEquals(a, b.velocityX() - v, .01 * a);
    assertEquals(-turn, b.angularVelocity() - spin, .01 * turn);
  }

  static List<Arguments> bowling() {
    List<Arguments> all = new ArrayList<>();
    for (double mu : new double[] {.1, .3, .8}) {
      for (double spin : new double[] {0, 6, 10, -6}) {
        all.add(Arguments.of(mu, spin));
      }
    }
    return all;
  }

  /**
   * Bowling: thrown with v and the spin w it slides until it rolls with {@code v' = 2/3 v - r w /
   * 3} (angular momentum about the ground, I = m r^2 / 2), at the time {@code |v + r w| / (3 mu
   * g)}. Strong backspin brings it back.
   */
  @ParameterizedTest
  @MethodSource("bowling")
  void aThrownDiscGoesOverToRolling(double mu, double spin) {
    World<String> w = Lab.floor(rough(mu));
    Body<String> b = disc(w, 0, .5, .5, rough(mu));
    steps(w, 30);
    b.setVelocity(6, 0);
    b.setAngularVelocity((float) spin);
    double slip = 6 + .5 * spin;
    double time = Math.abs(slip) / (3 * mu * G);
    seconds(w, time / 2);
    double sign = Math.signum(slip);
    double ticks = Math.round(time / 2 * 60) / 60.0;
    assertEquals(6 - sign * mu * G * ticks, b.velocityX(), .07, "still slips");
    seconds(w, time / 2 + .5);
    double rolls = (2 * 6 - .5 * spin) / 3;
    assertEquals(rolls, b.velocityX(), .03);
    assertEquals(-rolls / .5, b.angularVelocity(), .06);
    seconds(w, 2);
    assertEquals(rolls, b.velocityX(), .03, "and keeps rolling");
  }

  /** Two thirds of c g, and it holds on slopes below tan(angle) = c. */
  @ParameterizedTest
  @CsvSource({"0.02,4", "0.05,4", "0.1,6"})
  void rollingResistanceBrakes(float c, float v) {
    World<String> w = Lab.floor(rough(1));
    Body<String> b = disc(w, 0, .5, .5, rough(1).withRollingResistance(c));
    steps(w, 30);
    b.setVelocity(v, 0);
    b.setAngularVelocity(-v / .5f);
    seconds(w, 1);
    assertEquals(v - 2 / 3.0 * c * G, b.velocityX(), .02);
    seconds(w, v / (2 / 3.0 * c * G));
    assertEquals(0, b.velocityX(), 1e-3);
  }

  /** A cube tips over its edge where tan(angle) is above its width by its height. */
  @ParameterizedTest
  @CsvSource({"0.5,1,0.45", "0.5,1,0.55", "1,1,0.95", "1,1,1.05", "0.3,1.2,0.22", "0.3,1.2,0.28"})
  void tallBodiesTipOver(double hw, double hh, double slope) {
    World<String> w = Lab.slope(Math.atan(slope), rough(4));
    Body<String> b = box(w, 0, hh, hw, hh, rough(4));
    double farthest = 0;
    for (int i = 0; i < 360; i++) {
      w.step(DT);
      farthest = Math.max(farthest, Math.abs(b.angle()));
    }
    assertEquals(slope > hw / hh, farthest > .5, "angle=" + farthest);
  }

  @Test
  void frictionNeverAddsEnergy() {
    World<String> w = Lab.floor(rough(.5));
    for (int i = 0; i < 10; i++) {
      Body<String> b = body(w, Lab.Solid.values()[i % 5].shape, 3 * i, 1 + i * .2, rough(.5));
      b.setVelocity(5 - i, 2);
      b.setAngularVelocity(i - 5);
    }
    double last = Lab.energy(w);
    for (int i = 0; i < 300; i++) {
      w.step(DT);
      double now = Lab.energy(w);
      assertTrue(now < last + .002 * Math.abs(last), "tick=" + i + " " + last + " " + now);
      last = now;
    }
  }
}
