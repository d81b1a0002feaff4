package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static carom.physics.truth.Lab.G;
import static carom.physics.truth.Lab.ball;
import static carom.physics.truth.Lab.box;
import static carom.physics.truth.Lab.disc;
import static carom.physics.truth.Lab.seconds;
import static carom.physics.truth.Lab.steps;
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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Rods, ropes, hinges, sliders, welds, wheels: what they hold, and with which force. */
final class JointLawTest {
  private static final Material M = Material.DEFAULT;

  /** A slack rope doesn't act; a taut one is as long as it is, whatever hangs on it. */
  @ParameterizedTest
  @CsvSource({"1,0.1", "1,1", "3,1", "3,100", "8,10"})
  void ropesAreSlackOrTaut(double length, double mass) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> b = ball(w, .5, -.2, mass, M);
    Joint<String> j = w.createJoint(JointDef.rope(null, b, 0, 0, .5f, -.2f, (float) length));
    double longest = 0;
    for (int i = 0; i < 1200; i++) {
      w.step(DT);
      longest = Math.max(longest, j.coordinate());
      if (j.coordinate() < .95 * length) {
        assertEquals(0, Math.hypot(j.forceX(), j.forceY()), 1e-3 * mass, "slack");
      }
    }
    assertTrue(longest < 1.01 * length, "longest=" + longest);
    assertTrue(longest > .99 * length, "longest=" + longest);
  }

  /** A rod under tension and under pressure: its length within 1 mm, its force the load. */
  @ParameterizedTest
  @CsvSource({"1,-1", "1,1", "50,-1", "50,1", "0.02,1"})
  void rodsBearTheirLoad(double mass, int side) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> b = ball(w, 0, 2 * side, mass, M);
    Joint<String> j = w.createJoint(JointDef.distance(null, b, 0, 0, 0, 2 * side));
    for (int i = 0; i < 300; i++) {
      w.step(DT);
      assertEquals(2, j.coordinate(), 1e-3);
    }
    assertEquals(mass * G, j.forceY(), 2e-3 * mass * G);
  }

  /** tau = I alpha up to the speed, then no more torque. */
  @ParameterizedTest
  @CsvSource({"1,5", "2,-5", "10,40", "0.5,1"})
  void hingeMotorsAccelerateByTorqueOverInertia(double alpha, float goal) {
    World<String> w = Lab.space();
    Body<String> b = disc(w, 0, 0, .5, M);
    float torque = (float) (alpha * b.inertia());
    Joint<String> j = w.createJoint(JointDef.revolute(null, b, 0, 0).motor(goal, torque));
    double time = Math.abs(goal) / alpha;
    int half = (int) (time * 30);
    steps(w, half);
    double expected = Math.signum(goal) * alpha * half / 60;
    assertEquals(expected, b.angularVelocity(), 1e-3 * Math.abs(goal));
    assertEquals(Math.signum(goal) * torque, j.torque(), 1e-3 * torque);
    seconds(w, time);
    assertEquals(goal, b.angularVelocity(), 1e-3 * Math.abs(goal));
    assertEquals(0, j.torque(), 1e-3 * torque);
  }

  /** Off the hinge: I + m l^2. */
  @ParameterizedTest
  @ValueSource(doubles = {.5, 1, 2})
  void leversNeedTheTorqueOfSteiner(double arm) {
    World<String> w = Lab.space();
    Body<String> b = disc(w, arm, 0, .25, M);
    double inertia = b.inertia() + b.mass() * arm * arm;
    w.createJoint(JointDef.revolute(null, b, 0, 0).motor(100, (float) inertia));
    seconds(w, 1);
    assertEquals(1, b.angularVelocity(), .01);
  }

  /** Two discs on one hinge with a motor between them: opposite spins, by their inertia. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 5, 50})
  void motorsTurnBothBodies(double ratio) {
    World<String> w = Lab.space();
    Body<String> a = ball(w, 0, 0, 1, M);
    Body<String> b = ball(w, 0, 0, ratio, M);
    w.createJoint(JointDef.revolute(a, b, 0, 0).motor(4, 1e6f));
    seconds(w, 1);
    assertEquals(4, b.angularVelocity() - a.angularVelocity(), 1e-3);
    double spin = a.inertia() * a.angularVelocity() + b.inertia() * b.angularVelocity();
    assertEquals(0, spin, 1e-5 * ratio);
  }

  /** Limits stop, and bear what lies on them. */
  @ParameterizedTest
  @CsvSource({"-0.5,0.5", "-0.01,1", "-1,-0.2", "-2,0", "-3,3"})
  void hingeLimitsHold(float lower, float upper) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> b = box(w, 1, 0, 1, .1, M);
    Joint<String> j = w.createJoint(JointDef.revolute(null, b, 0, 0).limits(lower, upper));
    seconds(w, 1);
    float least = 9;
    float most = -9;
    for (int i = 0; i < 600; i++) {
      w.step(DT);
      least = Math.min(least, j.angle());
      most = Math.max(most, j.angle());
    }
    assertTrue(least > lower - .02, "least=" + least);
    assertTrue(most < upper + .02, "most=" + most);
    if (lower > -1) {
      assertEquals(lower, j.angle(), .01);
    }
  }

  /** A slider on a slope: a = g sin, until its stop; there the force is the component's. */
  @ParameterizedTest
  @ValueSource(doubles = {.2, .7, 1.2, 1.5})
  void slidersFallAlongTheirAxis(double angle) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> b = box(w, 0, 0, .5, .25, M);
    float ax = (float) Math.cos(angle);
    float ay = (float) -Math.sin(angle);
    Joint<String> j = w.createJoint(JointDef.prismatic(null, b, 0, 0, ax, ay).limits(-1, 20));
    seconds(w, 1);
    double a = G * Math.sin(angle);
    assertEquals(a, Lab.speed(b), .003 * a);
    assertEquals(a / 2 * (1 + Lab.H), j.coordinate(), .004 * a);
    assertEquals(0, b.angle(), 2e-3);
    double across = -b.x() * ay + b.y() * ax;
    assertEquals(0, across, 2e-3);
    assertEquals(b.mass() * G * Math.cos(angle), j.forceX() * -ay + j.forceY() * ax, .02);
    seconds(w, 8);
    assertEquals(20, j.coordinate(), .01, "stop");
    assertEquals(0, Lab.speed(b), .01);
    assertEquals(-b.mass() * a, j.forceX() * ax + j.forceY() * ay, .01 * b.mass() * a);
  }

  /** F = m a up to the speed; a weaker motor than the weight lets it sink with F / m - g. */
  @ParameterizedTest
  @CsvSource({"15,5", "20,5", "5,5", "10,5"})
  void sliderMotorsLiftByForceOverMass(double force, float goal) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> b = box(w, 0, 0, .5, .5, M);
    w.createJoint(JointDef.prismatic(null, b, 0, 0, 0, 1).motor(goal, (float) force));
    seconds(w, .5);
    assertEquals((force - G) * .5, b.velocityY(), .01);
    seconds(w, 3);
    assertEquals(force > G ? goal : (force - G) * 3.5, b.velocityY(), .05);
  }

  /** A welded cantilever bears force and torque of its weight: m g and m g L / 2. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 4, 8})
  void cantileversBearTheirWeight(int beams) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Joint<String> root = null;
    Body<String> last = null;
    double mass = 0;
    for (int i = 0; i < beams; i++) {
      Body<String> b = box(w, .5 + i, 0, .5, .25, M);
      Joint<String> j = w.createJoint(JointDef.weld(last, b, i, 0));
      root = root == null ? j : root;
      last = b;
      mass += b.mass();
    }
    seconds(w, 8 + 2 * beams);
    double sag = -last.y();
    assertTrue(sag >= 0 && sag < .0015 * beams * beams * beams + .002, "sag=" + sag);
    assertEquals(0, last.velocityY(), .01);
    assertEquals(mass * G, root.forceY(), .02 * mass * G);
    double torque = mass * G * beams / 2;
    assertEquals(torque, root.torque(), .03 * torque);
  }

  /** A seesaw is in balance when m1 l1 = m2 l2, and tips otherwise. */
  @ParameterizedTest
  @CsvSource({"1,2,2,1,0", "1,3,3,1,0", "1,2,2,1.1,-1", "1,2.2,2,1,1"})
  void leversBalanceByArmTimesWeight(double m1, double l1, double m2, double l2, int tips) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> beam = box(w, 0, 0, 4, .1, M);
    w.createJoint(JointDef.revolute(null, beam, 0, 0));
    Body<String> a = ball(w, -l1, 0, m1, M);
    Body<String> b = ball(w, l2, 0, m2, M);
    w.createJoint(JointDef.weld(beam, a, (float) -l1, 0));
    w.createJoint(JointDef.weld(beam, b, (float) l2, 0));
    seconds(w, 1);
    if (tips == 0) {
      assertEquals(0, beam.angle(), .01);
    } else {
      assertTrue(tips * beam.angle() > .02, "angle=" + beam.angle());
    }
  }

  /** A chain hangs with the tension of what hangs below each link. */
  @ParameterizedTest
  @ValueSource(ints = {2, 5, 10})
  void hangingChainsPullWithWhatHangsBelow(int links) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> last = null;
    for (int i = 0; i < links; i++) {
      Body<String> b = box(w, 0, -.5 - i, .1, .5, M);
      w.createJoint(JointDef.revolute(last, b, 0, -i));
      last = b;
    }
    seconds(w, 5);
    for (int i = 0; i < links; i++) {
      double load = (links - i) * last.mass() * G;
      assertEquals(load, w.joint(i).forceY(), .01 * load, "link " + i);
    }
  }

  /** Catenary: the ends of a chain between two points pull with half its weight upwards. */
  @Test
  void aHangingBridgeCarriesHalfItsWeightAtEachEnd() {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> last = null;
    int links = 20;
    for (int i = 0; i < links; i++) {
      Body<String> b =
          w.createBody(
              new BodyDef(BodyType.DYNAMIC)
                  .shape(new Box(.5f, .1f))
                  .position(.5f + i, 0)
                  .linearDamping(1)
                  .angularDamping(1),
              "link");
      w.createJoint(JointDef.revolute(last, b, i, 0));
      last = b;
    }
    Joint<String> end = w.createJoint(JointDef.mouse(last, links, 0, 1e6f).spring(20, 1));
    end.setTarget(16, 0);
    seconds(w, 25);
    double half = links * last.mass() * G / 2;
    assertEquals(half, w.joint(0).forceY(), .03 * half);
    assertEquals(half, end.forceY(), .03 * half);
    assertEquals(-w.joint(0).forceX(), end.forceX(), .03 * half, "equal pull at both ends");
    assertEquals(w.body(9).y(), w.body(10).y(), .05, "symmetric");
  }

  /** The joint's force at break is what it was said to bear. */
  @ParameterizedTest
  @CsvSource({"0.9,true", "1.1,false", "2,false"})
  void jointsBreakAboveTheirForce(double share, boolean breaks) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> b = ball(w, 0, -1, 2, M);
    Joint<String> j =
        w.createJoint(
            JointDef.distance(null, b, 0, 0, 0, -1)
                .breaksAt((float) (share * 2 * G), Float.POSITIVE_INFINITY));
    seconds(w, 2);
    assertEquals(breaks, !j.isValid());
  }
}
