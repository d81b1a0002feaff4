package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.disc;
import static carom.physics.Scenes.steps;
import static carom.physics.truth.Lab.period;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Joints against closed forms. */
final class JointTest {
  private static final Material M = Material.DEFAULT;

  /** Distance of the two anchors. */
  static double gap(Joint<?> j) {
    return Math.hypot(j.anchorBX() - j.anchorAX(), j.anchorBY() - j.anchorAY());
  }

  /** A physical pendulum: T = 2 pi sqrt((I + m l^2) / (m g l)), small angles. */
  @ParameterizedTest
  @ValueSource(floats = {.5f, 1, 3})
  void pendulumKeepsItsPeriodAndEnergy(float length) {
    World<String> w = new World<>(new WorldDef());
    double a = .05;
    Body<String> b =
        disc(w, (float) (length * Math.sin(a)), (float) (-length * Math.cos(a)), .2f, M);
    Joint<String> j = w.createJoint(JointDef.revolute(null, b, 0, 0));
    double l = length;
    double expected =
        2 * Math.PI * Math.sqrt((b.inertia() + b.mass() * l * l) / (b.mass() * 10 * l));
    assertEquals(expected, period(w, b::centerX, 5), .004 * expected);
    double top = 0;
    for (int i = 0; i < 600; i++) {
      w.step(DT);
      top = Math.max(top, Math.abs(b.centerX()));
      assertTrue(gap(j) < .001, "gap=" + gap(j));
    }
    assertEquals(l * Math.sin(a), top, .02 * l * a, "amplitude after all this time");
  }

  /** Swings through from the side: at the bottom v = sqrt(2 m g l / (m + I / l^2)). */
  @Test
  void pendulumFromTheSideArrivesWithItsEnergy() {
    World<String> w = new World<>(new WorldDef());
    Body<String> b = disc(w, 2, 0, .25f, M);
    w.createJoint(JointDef.revolute(null, b, 0, 0));
    double energy = b.mass() * 10 * 2;
    double fastest = 0;
    double highest = -9;
    for (int i = 0; i < 1200; i++) {
      w.step(DT);
      double v2 = b.velocityX() * b.velocityX() + b.velocityY() * b.velocityY();
      double w2 = b.angularVelocity() * b.angularVelocity();
      fastest = Math.max(fastest, .5 * (b.mass() * v2 + b.inertia() * w2));
      highest = i < 900 ? -9 : Math.max(highest, b.centerY());
    }
    assertEquals(energy, fastest, .02 * energy);
    assertEquals(0, highest, .06);
  }

  @Test
  void rodKeepsItsLengthAndReportsTheForce() {
    World<String> w = new World<>(new WorldDef());
    Body<String> b = disc(w, 0, -3, .25f, M);
    Joint<String> j = w.createJoint(JointDef.distance(null, b, 0, 0, 0, -3));
    b.setVelocity(5, 0);
    for (int i = 0; i < 300; i++) {
      w.step(DT);
      assertEquals(3, j.coordinate(), .002);
    }
    World<String> still = new World<>(new WorldDef());
    Body<String> c = disc(still, 0, -3, .25f, M);
    Joint<String> k = still.createJoint(JointDef.distance(null, c, 0, 0, 0, -3));
    steps(still, 60);
    assertEquals(10 * c.mass(), k.forceY(), 1e-3);
    assertEquals(0, k.forceX(), 1e-3);
  }

  @Test
  void ropeGoesSlackAndHolds() {
    World<String> w = new World<>(new WorldDef());
    Body<String> b = disc(w, 1, -1, .25f, M);
    Joint<String> j = w.createJoint(JointDef.rope(null, b, 0, 0, 1, -1, 3));
    steps(w, 20);
    double n = 80;
    assertEquals(-1 - 10 / 240.0 / 240 * n * (n + 1) / 2, b.y(), 1e-3, "falls freely");
    assertEquals(0, Math.hypot(j.forceX(), j.forceY()), 1e-6);
    for (int i = 0; i < 600; i++) {
      w.step(DT);
      assertTrue(j.coordinate() < 3.01, "length=" + j.coordinate());
    }
    assertTrue(j.coordinate() > 2.9);
  }

  @ParameterizedTest
  @CsvSource({"1,0", "3,0", "8,0"})
  void undampedSpringKeepsFrequencyAndAmplitude(float hertz, float zeta) {
    World<String> w = Scenes.space();
    Body<String> a = disc(w, -1, 0, .5f, M);
    Body<String> b = disc(w, 1, 0, .5f, new Material(3, 0, 0));
    Joint<String> j =
        w.createJoint(JointDef.distance(a, b, -1, 0, 1, 0).spring(hertz, zeta).rest(1.8f));
    double exact = 1 / hertz;
    double discrete = 2 * Math.PI * hertz / 240;
    assertEquals(
        exact, period(w, () -> j.coordinate() - 1.8, 5), exact * (.001 + discrete * discrete / 20));
    double top = 0;
    for (int i = 0; i < 300; i++) {
      w.step(DT);
      top = Math.max(top, j.coordinate());
    }
    assertEquals(2, top, .01);
    assertEquals(0, a.mass() * a.velocityX() + b.mass() * b.velocityX(), 1e-4);
  }

  /** Amplitudes shrink by exp(-2 pi zeta / sqrt(1 - zeta^2)) per period. */
  @ParameterizedTest
  @ValueSource(floats = {.05f, .1f, .2f})
  void dampingRatioIsTheDecrement(float zeta) {
    World<String> w = Scenes.space();
    Body<String> b = disc(w, 1, 0, .5f, M);
    Joint<String> j =
        w.createJoint(JointDef.prismatic(null, b, 1, 0, 1, 0).spring(1, zeta).rest(-1));
    double[] peaks = new double[3];
    int found = 0;
    double before = 9;
    double last = j.coordinate() + 1;
    boolean rising = false;
    for (int i = 0; i < 400 && found < 3; i++) {
      w.step(DT);
      double now = j.coordinate() + 1;
      if (rising && now < last) {
        peaks[found++] = last;
      }
      rising = now > last;
      before = last;
      last = now;
    }
    assertTrue(before < 9);
    double expected = Math.exp(-2 * Math.PI * zeta / Math.sqrt(1 - zeta * zeta));
    assertEquals(expected, peaks[0], .03 * expected);
    assertEquals(expected, peaks[1] / peaks[0], .03 * expected);
  }

  @Test
  void revoluteLimitsHold() {
    World<String> w = new World<>(new WorldDef());
    Body<String> b = box(w, 1, 0, 1, .1f, M);
    Joint<String> j = w.createJoint(JointDef.revolute(null, b, 0, 0).limits(-.5f, .25f));
    float least = 0;
    for (int i = 0; i < 240; i++) {
      w.step(DT);
      least = Math.min(least, j.angle());
    }
    assertEquals(-.5, j.angle(), .01);
    assertTrue(least > -.53, "least=" + least);
    b.setAngularVelocity(20);
    b.setVelocity(0, 20);
    float most = -9;
    for (int i = 0; i < 60; i++) {
      w.step(DT);
      most = Math.max(most, j.angle());
    }
    assertTrue(most > .2 && most < .29, "most=" + most);
    assertTrue(gap(j) < .01);
  }

  @Test
  void motorReachesItsSpeedUnderItsTorque() {
    World<String> w = Scenes.space();
    Body<String> b = disc(w, 0, 0, .5f, M);
    double torque = b.inertia() * 2;
    Joint<String> j = w.createJoint(JointDef.revolute(null, b, 0, 0).motor(3, (float) torque));
    steps(w, 60);
    assertEquals(2, b.angularVelocity(), 1e-3, "torque / inertia * time");
    assertEquals(torque, j.torque(), 1e-4);
    steps(w, 60);
    assertEquals(3, b.angularVelocity(), 1e-4);
    assertEquals(0, j.torque(), 1e-4);
    j.stopMotor();
    b.setAngularVelocity(1);
    steps(w, 10);
    assertEquals(1, b.angularVelocity(), 1e-5);
  }

  @Test
  void angularSpringOfAHingeHasItsFrequency() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 1, 0, 1, .2f, M);
    Joint<String> j = w.createJoint(JointDef.revolute(null, b, 0, 0).spring(2, 0).rest(.3f));
    // The spring's mass is that of the free body; the hinge adds m l^2.
    double slower = Math.sqrt((b.inertia() + b.mass()) / b.inertia());
    assertEquals(.5 * slower, period(w, () -> j.angle() - .3, 4), .01);
  }

  @Test
  void sliderStaysOnItsAxis() {
    World<String> w = new World<>(new WorldDef());
    Body<String> b = box(w, 0, 0, .5f, .25f, M);
    Joint<String> j =
        w.createJoint(JointDef.prismatic(null, b, 0, 0, 3, 4).limits(-2, 1).motor(0, 0));
    b.setAngularVelocity(5);
    steps(w, 60);
    assertEquals(-2, j.coordinate(), .01);
    assertEquals(0, b.angle(), .005);
    assertEquals(0, b.x() * .8 - b.y() * .6, .005);
    j.setMotor(2, 100);
    steps(w, 60);
    assertEquals(0, j.coordinate(), .05);
    assertEquals(1.2, b.velocityX(), .01);
    assertEquals(1.6, b.velocityY(), .01);
    steps(w, 60);
    assertEquals(1, j.coordinate(), .01);
    j.setMotor(0, 3);
    j.removeLimits();
    steps(w, 30);
    assertEquals(3, Math.abs(j.forceX() * .6 + j.forceY() * .8), .05, "weak motor gives its most");
  }

  @Test
  void weldIsStiffAndSoftWeldSwings() {
    World<String> w = new World<>(new WorldDef());
    Body<String> last = null;
    for (int i = 0; i < 5; i++) {
      Body<String> b = box(w, .5f + i, 0, .5f, .25f, M);
      w.createJoint(JointDef.weld(last, b, i, 0));
      last = b;
    }
    steps(w, 240);
    assertTrue(Math.abs(last.angle()) < .04, "angle=" + last.angle());
    assertTrue(last.y() > -.15, "y=" + last.y());
    assertEquals(0, last.velocityY(), .01);
    World<String> space = Scenes.space();
    Body<String> b = box(space, 0, 0, .5f, .5f, M);
    Joint<String> j =
        space.createJoint(JointDef.weld(null, b, 0, 0).angularSpring(2, 0).spring(1, 0));
    b.setAngularVelocity(1);
    assertEquals(.5, period(space, j::angle, 4), .003);
    b.setVelocity(0, 1);
    assertEquals(1, period(space, b::y, 4), .003);
  }

  /** The spring carries the car: it sinks by g / (2 pi f)^2; the motor drives it on the floor. */
  @Test
  void wheelsCarryAndDriveACar() {
    World<String> w = Scenes.floor(new Material(1, 1, 0));
    Body<String> car = box(w, 0, 1.5f, 1.5f, .25f, M);
    Joint<String> first = null;
    for (int side = -1; side <= 1; side += 2) {
      Body<String> wheel = disc(w, side, .5f, .5f, new Material(1, 1, 0));
      Joint<String> j =
          w.createJoint(JointDef.wheel(car, wheel, side, .5f, 0, 1).spring(4, .7f).motor(0, 200));
      first = first == null ? j : first;
    }
    steps(w, 240);
    double rise = first.coordinate();
    assertTrue(rise > 0 && rise < .1, "rise=" + rise);
    // Each spring bears half the car.
    assertEquals(-.5 * car.mass() * 10, first.forceY(), .02 * car.mass() * 10);
    assertEquals(0, car.angle(), .001);
    w.forEachJoint(j -> j.setMotor(-6, 50));
    steps(w, 300);
    assertEquals(3, car.velocityX(), .05);
    assertEquals(rise, first.coordinate(), .02);
  }

  @Test
  void mouseDragsWithBoundedForce() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, .5f, .5f, M);
    Joint<String> j = w.createJoint(JointDef.mouse(b, 0, 0, 4).spring(.5f, 1));
    j.setTarget(10, 0);
    for (int i = 0; i < 60; i++) {
      w.step(DT);
      assertTrue(Math.hypot(j.forceX(), j.forceY()) < 4.0001);
    }
    assertEquals(4, b.velocityX(), .01, "F / m * t");
    steps(w, 600);
    assertEquals(10, b.x(), .01);
    assertEquals(0, b.velocityX(), .05);
  }

  @Test
  void motorJointDrawsToAPose() {
    World<String> w = new World<>(new WorldDef());
    Body<String> b = box(w, 0, 0, .5f, .5f, M);
    Joint<String> j = w.createJoint(JointDef.motor(null, b, 100, 10));
    steps(w, 60);
    assertEquals(0, b.y(), .01);
    j.setTarget(3, 2);
    j.setTargetAngle(1);
    steps(w, 300);
    assertEquals(3, b.x(), .01);
    assertEquals(2, b.y(), .01);
    assertEquals(1, b.angle(), .01);
    b.applyForce(0, -1000);
    w.step(DT);
    assertTrue(Math.hypot(j.forceX(), j.forceY()) < 100.01);
  }

  /** Momentum and angular momentum of a free body pair stay. */
  @Test
  void jointsKeepMomentum() {
    World<String> w = Scenes.space();
    Body<String> a = box(w, -1, 0, 1, .3f, M);
    Body<String> b = box(w, 1, 0, 1, .3f, new Material(2, 0, 0));
    w.createJoint(JointDef.revolute(a, b, 0, 0));
    a.setVelocity(1, 2);
    b.setAngularVelocity(4);
    double before = spin(a) + spin(b);
    steps(w, 300);
    assertEquals(a.mass() * 1, a.mass() * a.velocityX() + b.mass() * b.velocityX(), 1e-3);
    assertEquals(a.mass() * 2, a.mass() * a.velocityY() + b.mass() * b.velocityY(), 1e-3);
    assertEquals(before, spin(a) + spin(b), .02 * Math.abs(before));
  }

  private static double spin(Body<?> b) {
    return b.inertia() * b.angularVelocity()
        + b.mass() * (b.centerX() * b.velocityY() - b.centerY() * b.velocityX());
  }

  @Test
  void chainOfAHundredLinksHolds() {
    World<String> w = new World<>(new WorldDef());
    Body<String> last = null;
    for (int i = 0; i < 100; i++) {
      Body<String> b = box(w, .5f + i, 0, .5f, .1f, M);
      w.createJoint(JointDef.revolute(last, b, i, 0));
      last = b;
    }
    double worst = 0;
    for (int i = 0; i < 900; i++) {
      w.step(DT);
      for (int k = 0; k < w.jointCount(); k++) {
        worst = Math.max(worst, gap(w.joint(k)));
      }
    }
    assertTrue(worst < .6, "gap=" + worst);
  }

  static World<String> grid(int n) {
    World<String> w = new World<>(new WorldDef());
    Filter apart = Filter.DEFAULT.withGroup(-1);
    for (int k = 0; k < n; k++) {
      for (int i = 0; i < n; i++) {
        boolean fixed = i == 0 && k >= n / 2 - 3 && k <= n / 2 + 3;
        w.createBody(
            new BodyDef(fixed ? BodyType.STATIC : BodyType.DYNAMIC)
                .shape(new Circle(.4f), M, apart)
                .position(k, -i),
            null);
        if (i > 0) {
          w.createJoint(JointDef.revolute(w.body(k * n + i - 1), w.body(k * n + i), k, -i + .5f));
        }
        if (k > 0) {
          w.createJoint(JointDef.revolute(w.body((k - 1) * n + i), w.body(k * n + i), k - .5f, -i));
        }
      }
    }
    return w;
  }

  /** SCENES' joint_grid: 19,800 hinges on 10,000 discs. */
  @Test
  void netOfTenThousandHolds() {
    World<String> w = grid(100);
    assertEquals(19_800, w.jointCount());
    steps(w, 300);
    double worst = 0;
    for (int k = 0; k < w.jointCount(); k++) {
      worst = Math.max(worst, gap(w.joint(k)));
    }
    assertTrue(worst < .6, "gap=" + worst);
  }

  @Test
  void connectedBodiesCollideOnlyWhenAsked() {
    for (boolean collide : new boolean[] {false, true}) {
      World<String> w = Scenes.space();
      Body<String> a = w.createBody(new BodyDef().shape(new Box(.5f, .5f)), "a");
      Body<String> b = disc(w, 3, 0, .5f, M);
      w.createJoint(JointDef.rope(a, b, 0, 0, 3, 0, 4).collideConnected(collide));
      b.setVelocity(-3, 0);
      steps(w, 90);
      assertEquals(collide, b.x() > .9, "x=" + b.x());
    }
  }
}
