package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static carom.physics.truth.Lab.G;
import static carom.physics.truth.Lab.ball;
import static carom.physics.truth.Lab.box;
import static carom.physics.truth.Lab.period;
import static carom.physics.truth.Lab.seconds;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Springs of joints against the damped harmonic oscillator. */
final class SpringTest {
  private static final Material M = Material.DEFAULT;

  static List<Arguments> pairs() {
    List<Arguments> all = new ArrayList<>();
    for (double hertz : new double[] {.5, 1, 2, 5, 10}) {
      for (double ratio : new double[] {.1, 1, 10}) {
        all.add(Arguments.of(hertz, ratio));
      }
    }
    return all;
  }

  /**
   * Two bodies on a spring swing with its frequency, whatever their masses (the reduced mass is in
   * the stiffness), about their resting centre of mass, in opposite directions. Symplectic Euler
   * makes the period shorter by (w h)^2 / 24.
   */
  @ParameterizedTest
  @MethodSource("pairs")
  void twoBodiesOnASpringSwingWithItsFrequency(double hertz, double ratio) {
    World<String> w = Lab.space();
    Body<String> a = ball(w, -1, 0, 1, M);
    Body<String> b = ball(w, 1, 0, ratio, M);
    Joint<String> j =
        w.createJoint(JointDef.distance(a, b, -1, 0, 1, 0).spring((float) hertz, 0).rest(1.8f));
    double wh = 2 * Math.PI * hertz / 240;
    double expected = 1 / hertz * (1 - wh * wh / 24);
    assertEquals(expected, period(w, () -> j.coordinate() - 1.8, 6), .003 / hertz);
    double most = 0;
    double center = (-1 + ratio) / (1 + ratio);
    for (int i = 0; i < 300; i++) {
      w.step(DT);
      most = Math.max(most, Math.abs(j.coordinate() - 1.8));
      assertEquals(center, (a.x() + ratio * b.x()) / (1 + ratio), 1e-4);
    }
    assertEquals(.2, most, .01, "amplitude");
  }

  static List<Arguments> damped() {
    List<Arguments> all = new ArrayList<>();
    for (double hertz : new double[] {.5, 1, 3}) {
      for (double zeta : new double[] {.02, .1, .3, .7, 1, 2, 5}) {
        all.add(Arguments.of(hertz, zeta));
      }
    }
    return all;
  }

  /** x'' + 2 z w x' + w^2 x = 0 from rest at x0, over its whole course. */
  @ParameterizedTest
  @MethodSource("damped")
  void dampedSpringsFollowTheOscillator(double hertz, double zeta) {
    World<String> w = Lab.space();
    Body<String> b = box(w, 1, 0, .5, .5, M);
    w.createJoint(
        JointDef.prismatic(null, b, 1, 0, 1, 0).spring((float) hertz, (float) zeta).rest(-1));
    double o = 2 * Math.PI * hertz;
    for (int tick = 1; tick <= 180; tick++) {
      w.step(DT);
      assertEquals(oscillator(o, zeta, tick / 60.0), b.x(), .006 + o / 600, "tick=" + tick);
    }
  }

  private static double oscillator(double o, double zeta, double t) {
    if (zeta < 1) {
      double d = o * Math.sqrt(1 - zeta * zeta);
      return Math.exp(-zeta * o * t) * (Math.cos(d * t) + zeta * o / d * Math.sin(d * t));
    }
    if (zeta == 1) {
      return Math.exp(-o * t) * (1 + o * t);
    }
    double root = o * Math.sqrt(zeta * zeta - 1);
    double slow = -zeta * o + root;
    double fast = -zeta * o - root;
    return (slow * Math.exp(fast * t) - fast * Math.exp(slow * t)) / (slow - fast);
  }

  /** A weight on a spring sinks by g / w^2, whatever it weighs. */
  @ParameterizedTest
  @CsvSource({"1,1", "1,100", "2,0.01", "5,1", "8,50"})
  void aWeightSinksByGravityOverOmegaSquared(double hertz, double mass) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> b = ball(w, 0, 0, mass, M);
    Joint<String> j =
        w.createJoint(JointDef.prismatic(null, b, 0, 0, 0, 1).spring((float) hertz, .8f));
    seconds(w, 10);
    double o = 2 * Math.PI * hertz;
    assertEquals(-G / (o * o), b.y(), .01 * G / (o * o));
    assertEquals(mass * G, j.forceY(), .01 * mass * G);
    assertEquals(0, b.velocityY(), 1e-3);
  }

  /** The wheel's suspension, seen from a car that can't move. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 3, 6})
  void aSuspensionSwingsWithItsFrequency(double hertz) {
    World<String> w = Lab.space();
    Body<String> b = ball(w, 0, 0, 2, M);
    Joint<String> j = w.createJoint(JointDef.wheel(null, b, 0, 0, 0, 1).spring((float) hertz, 0));
    b.setVelocity(0, .5f);
    b.setAngularVelocity(7);
    assertEquals(1 / hertz, period(w, j::coordinate, 5), .004 / hertz);
    assertEquals(0, b.x(), 1e-4, "stays on the axis");
    assertEquals(7, b.angularVelocity(), 1e-3, "and turns freely");
  }

  /** Angular springs: of a hinge, a weld, a motor joint. */
  @ParameterizedTest
  @CsvSource({"hinge,1", "hinge,4", "weld,1", "weld,4", "motor,1", "motor,4"})
  void angularSpringsSwingWithTheirFrequency(String kind, float hertz) {
    World<String> w = Lab.space();
    Body<String> b = box(w, 0, 0, 1, .2, M);
    Joint<String> j =
        w.createJoint(
            switch (kind) {
              case "hinge" -> JointDef.<String>revolute(null, b, 0, 0).spring(hertz, 0);
              case "weld" -> JointDef.<String>weld(null, b, 0, 0).angularSpring(hertz, 0);
              default ->
                  JointDef.<String>motor(null, b, 1e6f, 1e6f).angularSpring(hertz, 0).spring(5, 1);
            });
    b.setAngularVelocity(.5f);
    assertEquals(1 / hertz, period(w, j::angle, 5), .004 / hertz);
  }

  /** Springs of the point: of a weld, a mouse, a motor joint. */
  @ParameterizedTest
  @CsvSource({"weld,1", "weld,4", "mouse,1", "mouse,4", "motor,1", "motor,4"})
  void pointSpringsSwingWithTheirFrequency(String kind, float hertz) {
    World<String> w = Lab.space();
    Body<String> b = box(w, 0, 0, 1, .2, M);
    w.createJoint(
        switch (kind) {
          case "weld" -> JointDef.<String>weld(null, b, 0, 0).spring(hertz, 0);
          case "mouse" -> JointDef.<String>mouse(b, 0, 0, 1e6f).spring(hertz, 0);
          default -> JointDef.<String>motor(null, b, 1e6f, 1e6f).spring(hertz, 0);
        });
    b.setVelocity(.3f, .5f);
    assertEquals(1 / hertz, period(w, b::y, 5), .004 / hertz);
  }

  /** Critically damped it arrives without overshooting: by 1 % after 6.6 / w. */
  @ParameterizedTest
  @ValueSource(floats = {1, 3, 5, 10})
  void aMouseDrawsWithoutOvershooting(float hertz) {
    World<String> w = Lab.space();
    Body<String> b = box(w, 0, 0, .5, .5, M);
    Joint<String> j = w.createJoint(JointDef.mouse(b, 0, 0, 1e6f).spring(hertz, 1));
    j.setTarget(3, -2);
    double most = 0;
    double arrived = 0;
    for (int i = 1; i <= 180; i++) {
      w.step(DT);
      most = Math.max(most, b.x());
      if (arrived == 0 && b.x() > 2.97) {
        arrived = i / 60.0;
      }
    }
    assertTrue(most < 3.01, "most=" + most);
    assertEquals(6.64 / (2 * Math.PI * hertz), arrived, .03);
    assertEquals(-2, b.y(), .01);
  }

  /**
   * The resonance of a shaken spring: driven at its frequency, the amplitude grows by pi / period.
   */
  @ParameterizedTest
  @CsvSource({"1,1,true", "1,2.5,false", "1,0.3,false"})
  void springsResonateAtTheirFrequency(float own, double driven, boolean grows) {
    World<String> w = Lab.space();
    Body<String> base =
        w.createBody(new BodyDef(BodyType.KINEMATIC).shape(new Box(.1f, .1f)), "base");
    Body<String> b = box(w, 0, 3, .5, .5, M);
    w.createJoint(JointDef.prismatic(base, b, 0, 3, 0, 1).spring(own, 0));
    double most = 0;
    for (int i = 0; i < 480; i++) {
      double t = i / 60.0;
      double o = 2 * Math.PI * driven;
      base.setVelocity(0, (float) (.1 * o * Math.cos(o * t)));
      w.step(DT);
      most = Math.max(most, Math.abs(b.y() - base.y() - 3));
    }
    assertEquals(grows, most > 1.5, "most=" + most);
    if (grows) {
      assertEquals(.1 * Math.PI * 8, most, .3, "x = A/2 w t");
    }
  }
}
