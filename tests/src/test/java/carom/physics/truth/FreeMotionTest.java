package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static carom.physics.truth.Lab.G;
import static carom.physics.truth.Lab.H;
import static carom.physics.truth.Lab.box;
import static carom.physics.truth.Lab.disc;
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
import carom.physics.geometry.Circle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * One body without contacts, against the exact solution of symplectic Euler: v' = v + h a, x' = x +
 * h v' (Hairer, Lubich, Wanner, "Geometric Numerical Integration", I.1).
 */
final class FreeMotionTest {
  private static final Material M = Material.DEFAULT;

  /** After n substeps v = g n h and y = g h^2 n (n + 1) / 2. */
  @ParameterizedTest
  @CsvSource({"-10,1", "-10,2", "-10,4", "-10,8", "-1.62,4", "-9.81,4", "-24.8,4", "5,4", "0,4"})
  void freeFallIsTheExactDiscreteSolution(float g, int substeps) {
    World<String> w =
        new World<>(new WorldDef().withSleeping(false).withGravity(0, g).withSubsteps(substeps));
    Body<String> b = disc(w, 0, 0, .5, M);
    for (int tick = 1; tick <= 120; tick++) {
      w.step(DT);
      double n = tick * substeps;
      double h = 1 / 60.0 / substeps;
      assertEquals(g * n * h, b.velocityY(), 1e-5 * Math.abs(g) * tick / 10 + 1e-9);
      double y = g * h * h * n * (n + 1) / 2;
      assertEquals(y, b.y(), 1e-5 * Math.abs(y) + 1e-6 * tick);
      assertEquals(0, b.x());
    }
  }

  /** y = vy t - g t (t + h) / 2, so it is back at its height at t = 2 vy / g - h. */
  @ParameterizedTest
  @ValueSource(doubles = {15, 30, 45, 60, 75, 90})
  void projectileFliesItsParabola(double degrees) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> b = disc(w, 0, 0, .5, M);
    double vx = 15 * Math.cos(Math.toRadians(degrees));
    double vy = 15 * Math.sin(Math.toRadians(degrees));
    b.setVelocity((float) vx, (float) vy);
    double top = 0;
    double range = -1;
    double lastX = 0;
    double lastY = 0;
    for (int tick = 1; range < 0; tick++) {
      w.step(DT);
      double t = tick / 60.0;
      assertEquals(vy * t - G * t * (t + H) / 2, b.y(), 3e-5 * tick, "tick=" + tick);
      assertEquals(vx * t, b.x(), 1e-5 * tick, "tick=" + tick);
      top = Math.max(top, b.y());
      if (b.y() < 0) {
        range = lastX + (b.x() - lastX) * lastY / (lastY - b.y());
      }
      lastX = b.x();
      lastY = b.y();
    }
    assertEquals(vy * vy / (2 * G), top, vy * H, "v^2 / 2g, first order in h");
    assertEquals(vx * (2 * vy / G - H), range, .005 * vx, "range");
  }

  /** Each substep divides by 1 + h c (implicit Euler, stable for any c). */
  @ParameterizedTest
  @CsvSource({"0.1,0", "0.5,2", "2,0.5", "10,3", "100,50", "10000,10000", "0,0"})
  void dampingDividesOncePerSubstep(float linear, float angular) {
    World<String> w = Lab.space();
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Circle(1))
                .velocity(6, -8)
                .angularVelocity(5)
                .linearDamping(linear)
                .angularDamping(angular),
            null);
    for (int tick = 1; tick <= 60; tick++) {
      w.step(DT);
      double left = Math.pow(1 + H * linear, -4 * tick);
      assertEquals(6 * left, b.velocityX(), 1e-4 * left + 1e-9);
      assertEquals(-8 * left, b.velocityY(), 1e-4 * left + 1e-9);
      double turns = Math.pow(1 + H * angular, -4 * tick);
      assertEquals(5 * turns, b.angularVelocity(), 1e-4 * turns + 1e-9);
    }
  }

  /** The fixed point of v' = (v + h g) / (1 + h c) is g / c, without a discretisation error. */
  @ParameterizedTest
  @ValueSource(floats = {.5f, 1, 4, 20})
  void fallsAtTheTerminalVelocity(float c) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> b =
        w.createBody(new BodyDef(BodyType.DYNAMIC).shape(new Circle(.5f)).linearDamping(c), null);
    steps(w, (int) (60 * 15 / Math.min(c, 4)));
    assertEquals(-G / c, b.velocityY(), 1e-4 * G / c);
  }

  @ParameterizedTest
  @ValueSource(floats = {-2, -1, 0, .25f, 1, 3})
  void gravityScaleIsAFactor(float factor) {
    World<String> w = new World<>(new WorldDef().withSleeping(false).withGravity(3, -10));
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC).shape(new Circle(.5f)).gravityScale(factor), null);
    steps(w, 60);
    assertEquals(3 * factor, b.velocityX(), 1e-4);
    assertEquals(-10 * factor, b.velocityY(), 2e-4);
  }

  /** F = m a for shapes of any mass: v = F t / m, x = F / m t (t + h) / 2. */
  @ParameterizedTest
  @EnumSource(Lab.Solid.class)
  void aSteadyForceAcceleratesByForceOverMass(Lab.Solid solid) {
    World<String> w = Lab.space();
    Body<String> b = Lab.body(w, solid.shape, 0, 0, M.withDensity(2.5f));
    for (int tick = 1; tick <= 60; tick++) {
      b.applyForce(7, -3);
      w.step(DT);
      double t = tick / 60.0;
      assertEquals(7 / b.mass() * t, b.velocityX(), 1e-5);
      assertEquals(-3 / b.mass() * t * (t + H) / 2, b.centerY(), 1e-5);
      assertEquals(0, b.angularVelocity());
    }
  }

  /** tau = I alpha: w = tau t / I, angle = tau / I t (t + h) / 2. */
  @ParameterizedTest
  @EnumSource(Lab.Solid.class)
  void aSteadyTorqueTurnsByTorqueOverInertia(Lab.Solid solid) {
    World<String> w = Lab.space();
    Body<String> b = Lab.body(w, solid.shape, 0, 0, M.withDensity(2.5f));
    double alpha = .3 / b.inertia();
    for (int tick = 1; tick <= 60; tick++) {
      b.applyTorque(.3f);
      w.step(DT);
      double t = tick / 60.0;
      assertEquals(alpha * t, b.angularVelocity(), 1e-5 * (1 + alpha));
      assertEquals(alpha * t * (t + H) / 2, b.angle(), 1e-4 * (1 + alpha));
      assertEquals(0, b.velocityX());
    }
  }

  /** v = J / m and w = r x J / I, wherever the impulse acts. */
  @ParameterizedTest
  @CsvSource({
    "0,4,1,0",
    "0,4,-1,0",
    "4,0,0,1",
    "4,0,0,-1",
    "3,4,3,4",
    "2,-1,.5,.25",
    "0,5,0,7",
    "-1,-1,9,-9"
  })
  void anOffCentreImpulseMovesAndTurns(float jx, float jy, float rx, float ry) {
    World<String> w = Lab.space();
    Body<String> b = box(w, 20, -10, 1, .5, M.withDensity(3));
    b.applyImpulse(jx, jy, 20 + rx, -10 + ry);
    w.step(DT);
    assertEquals(jx / b.mass(), b.velocityX(), 1e-6);
    assertEquals(jy / b.mass(), b.velocityY(), 1e-6);
    assertEquals((rx * jy - ry * jx) / b.inertia(), b.angularVelocity(), 1e-5);
  }

  /** The point at distance I / (m r) beyond the centre stays: the centre of percussion. */
  @ParameterizedTest
  @ValueSource(doubles = {.25, .5, 1, 2})
  void aRodTurnsAboutTheCentreOfPercussion(double r) {
    World<String> w = Lab.space();
    Body<String> b = box(w, 0, 0, 2, .1, M);
    b.applyImpulse(0, 1, (float) r, 0);
    w.step(DT);
    double still = -b.inertia() / (b.mass() * r);
    assertEquals(0, b.velocityY() + b.angularVelocity() * still, 1e-5);
    assertEquals(-4 * (1 + .0025) / (3 * r), still, 1e-4, "rod: I = m (L^2 + d^2) / 12");
  }

  /** angle = w t; the rotation by h w is exact up to (h w)^5 / 120 per substep. */
  @ParameterizedTest
  @ValueSource(floats = {-40, -3, -.1f, 0, .01f, 1, 6.2831855f, 20, 60, 120})
  void aFreeBodyTurnsEvenly(float spin) {
    World<String> w = Lab.space();
    Body<String> b = box(w, 3, 4, 1, .3, M);
    b.setAngularVelocity(spin);
    steps(w, 120);
    double a = Math.abs(spin) * H;
    double tolerance = 480 * Math.pow(a, 5) / 60 + 1e-4;
    assertEquals(0, Math.abs(Math.IEEEremainder(b.angle() - 2.0 * spin, 2 * Math.PI)), tolerance);
    assertEquals(spin, b.angularVelocity());
    assertEquals(3, b.centerX());
    assertEquals(1, Math.hypot(b.cos(), b.sin()), 1e-6);
  }

  /** The centre of mass of a lopsided body keeps its line while the body tumbles. */
  @ParameterizedTest
  @ValueSource(floats = {.5f, 3, 12})
  void aTumblingBodysCentreKeepsItsLine(float spin) {
    World<String> w = Lab.space();
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(1, .1f))
                .shape(new Circle(.4f, 1, 0), M.withDensity(5))
                .velocity(2, 1)
                .angularVelocity(spin),
            null);
    double x = b.centerX();
    double y = b.centerY();
    assertTrue(x > .5);
    steps(w, 240);
    assertEquals(x + 8, b.centerX(), 1e-4);
    assertEquals(y + 4, b.centerY(), 1e-4);
    double arm = Math.hypot(b.x() - b.centerX(), b.y() - b.centerY());
    assertEquals(Math.hypot(x, y), arm, 1e-5, "the origin stays where it is in the body");
  }

  /**
   * A force F = -k r is held for a step dt of n substeps: x' = (1 - q k / m) x + dt v with q = h^2
   * n (n + 1) / 2, v' = v - dt k / m x. The map is followed exactly, its slow gain of energy
   * included.
   */
  @ParameterizedTest
  @ValueSource(doubles = {1, 10, 60})
  void aSpringMadeOfUserForcesFollowsItsMap(double k) {
    World<String> w = Lab.space();
    Body<String> b = box(w, 1, 0, .5, .5, M);
    double x = 1;
    double v = 0;
    for (int tick = 0; tick < 240; tick++) {
      b.applyForce((float) -k * b.x(), 0);
      w.step(DT);
      double a = -k * x / b.mass();
      x += v / 60 + a * 10 * H * H;
      v += a / 60;
      assertEquals(x, b.x(), 2e-4, "tick=" + tick);
      assertEquals(v, b.velocityX(), 2e-4 * Math.sqrt(k), "tick=" + tick);
    }
  }

  /**
   * Kepler: the orbit closes after T = 2 pi sqrt(a^3 / k), a the half axis, for any eccentricity.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0, .2, .4, .6})
  void aPlanetKeepsKeplersThirdLaw(double eccentricity) {
    World<String> w =
        new World<>(new WorldDef().withSleeping(false).withGravity(0, 0).withSubsteps(1));
    Body<String> b = box(w, 10 * (1 - eccentricity), 0, .5, .5, M);
    double k = 1000;
    double fastest = Math.sqrt(k / 10 * (1 + eccentricity) / (1 - eccentricity));
    b.setVelocity(0, (float) fastest);
    double spin = b.x() * fastest;
    double expected = 2 * Math.PI * Math.sqrt(1000 / k);
    double last = 0;
    double back = 0;
    for (int tick = 1; back == 0; tick++) {
      double r = Math.hypot(b.x(), b.y());
      double f = -k * b.mass() / (r * r * r);
      b.applyForce((float) (f * b.x()), (float) (f * b.y()));
      w.step(DT);
      if (last < 0 && b.y() >= 0) {
        back = (tick - b.y() / (b.y() - last)) / 60;
      }
      last = b.y();
    }
    assertEquals(expected, back, .01 * expected);
    double now = b.x() * (double) b.velocityY() - b.y() * (double) b.velocityX();
    assertEquals(spin, now, .005 * spin, "second law");
  }

  @ParameterizedTest
  @EnumSource(
      value = BodyType.class,
      names = {"STATIC", "KINEMATIC"})
  void forcesDoNothingToWhatIsNotDynamic(BodyType type) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> b =
        w.createBody(new BodyDef(type).shape(new Box(1, 1)).position(2, 3), "immovable");
    long before = w.stateHash();
    b.applyForce(100, 100);
    b.applyForce(100, 100, 5, 5);
    b.applyImpulse(100, 100);
    b.applyImpulse(100, 100, 5, 5);
    b.applyTorque(100);
    b.applyAngularImpulse(100);
    assertEquals(before, w.stateHash());
    steps(w, 30);
    assertEquals(2, b.x());
    assertEquals(3, b.y());
    assertEquals(0, b.angle());
  }

  @Test
  void forcesAreForgottenAfterOneStep() {
    World<String> w = Lab.space();
    Body<String> b = box(w, 0, 0, .5, .5, M);
    b.applyForce(60, 0);
    b.applyTorque(10);
    b.applyImpulse(0, 2);
    w.step(DT);
    float vx = b.velocityX();
    float spin = b.angularVelocity();
    steps(w, 30);
    assertEquals(vx, b.velocityX());
    assertEquals(2, b.velocityY(), 1e-6);
    assertEquals(spin, b.angularVelocity());
  }

  /** Velocities are the same seen from a moving frame: Galilean invariance. */
  @ParameterizedTest
  @ValueSource(floats = {-30, 0, 7, 100})
  void physicsIsTheSameInAMovingFrame(float frame) {
    World<String> w = Lab.lively();
    Body<String> a = Lab.ball(w, 0, 0, 1, new Material(1, 0, .5f));
    Body<String> b = Lab.ball(w, 3, 0, 2, new Material(1, 0, .5f));
    a.setVelocity(4 + frame, 0);
    b.setVelocity(frame, 0);
    steps(w, 90);
    assertEquals(0 + frame, a.velocityX(), 1e-3);
    assertEquals(2 + frame, b.velocityX(), 1e-3);
  }
}
