package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static carom.physics.truth.Lab.G;
import static carom.physics.truth.Lab.box;
import static carom.physics.truth.Lab.disc;
import static carom.physics.truth.Lab.kinetic;
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
import carom.physics.geometry.Circle;
import carom.physics.geometry.Shape;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pendulums on rods and hinges. */
final class PendulumTest {
  private static final Material M = Material.DEFAULT;

  /** Arithmetic-geometric mean. */
  private static double agm(double a, double b) {
    while (Math.abs(a - b) > 1e-12) {
      double mean = (a + b) / 2;
      b = Math.sqrt(a * b);
      a = mean;
    }
    return a;
  }

  static List<Arguments> swings() {
    List<Arguments> all = new ArrayList<>();
    for (double amplitude : new double[] {.05, .3, .8, 1.2, Math.PI / 2, 2, 2.5}) {
      for (double length : new double[] {1, 3}) {
        all.add(Arguments.of(amplitude, length));
      }
    }
    return all;
  }

  /**
   * At any amplitude A the period is {@code T = 2 pi sqrt(l / g) / agm(1, cos(A / 2))}, Gauss' form
   * of the complete elliptic integral, the limit of 1 + A^2/16 + 11 A^4/3072 + ... On a rod a body
   * doesn't turn: a point mass.
   */
  @ParameterizedTest
  @MethodSource("swings")
  void aMassOnARodHasThePeriodOfItsAmplitude(double amplitude, double length) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    double x = length * Math.sin(amplitude);
    Body<String> b = disc(w, x, -length * Math.cos(amplitude), .1, M);
    w.createJoint(JointDef.distance(null, b, 0, 0, b.x(), b.y()));
    double expected = 2 * Math.PI * Math.sqrt(length / G) / agm(1, Math.cos(amplitude / 2));
    assertEquals(expected, period(w, b::centerX, 3), .005 * expected);
    assertEquals(0, b.angularVelocity(), 1e-3);
  }

  /** With its own inertia: l is replaced by (I + m l^2) / (m l). */
  @ParameterizedTest
  @MethodSource("swings")
  void aMassOnAHingeHasThePeriodOfItsReducedLength(double amplitude, double length) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    double x = length * Math.sin(amplitude);
    Body<String> b = disc(w, x, -length * Math.cos(amplitude), .5, M);
    w.createJoint(JointDef.revolute(null, b, 0, 0));
    double reduced = length + b.inertia() / (b.mass() * length);
    double expected = 2 * Math.PI * Math.sqrt(reduced / G) / agm(1, Math.cos(amplitude / 2));
    double tolerance = amplitude > 2.2 ? .02 : .005;
    assertEquals(expected, period(w, b::centerX, 3), tolerance * expected);
  }

  /** A rod on its end: I = m L^2 / 3 about the hinge. */
  @ParameterizedTest
  @ValueSource(doubles = {.5, 1, 2})
  void aRodOnItsEndSwingsAsAPhysicalPendulum(double half) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> b = box(w, 0, -half, .05, half, M);
    w.createJoint(JointDef.revolute(null, b, 0, 0));
    b.setVelocity((float) (.1 * half), 0);
    b.setAngularVelocity(.1f);
    double inertia = b.inertia() + b.mass() * half * half;
    assertEquals(b.mass() * 4 * half * half / 3, inertia, .01 * inertia);
    double expected = 2 * Math.PI * Math.sqrt(inertia / (b.mass() * G * half));
    assertEquals(expected, period(w, b::centerX, 4), .005 * expected);
  }

  /** Energy neither grows nor leaks noticeably: at most 2 % in 20 s. */
  @ParameterizedTest
  @CsvSource({"0.3,rod", "1.5,rod", "2.5,rod", "0.3,hinge", "1.5,hinge", "2.5,hinge"})
  void pendulumsKeepTheirEnergy(double amplitude, String kind) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    double x = 2 * Math.sin(amplitude);
    Body<String> b = disc(w, x, -2 * Math.cos(amplitude), .25, M);
    if ("rod".equals(kind)) {
      w.createJoint(JointDef.distance(null, b, 0, 0, b.x(), b.y()));
    } else {
      w.createJoint(JointDef.revolute(null, b, 0, 0));
    }
    double whole = b.mass() * G * (b.y() + 2);
    for (int i = 0; i < 1200; i++) {
      w.step(DT);
      double energy = kinetic(b) + b.mass() * G * (b.y() + 2);
      assertEquals(whole, energy, .02 * whole + .02, "tick=" + i);
    }
  }

  /** T = m (g cos + v^2 / l): at the bottom of a fall from the side 3 m g. */
  @ParameterizedTest
  @ValueSource(doubles = {.5, 1, Math.PI / 2})
  void theRodPullsWithWeightAndCentripetalForce(double amplitude) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> b = disc(w, 2 * Math.sin(amplitude), -2 * Math.cos(amplitude), .25, M);
    Joint<String> j = w.createJoint(JointDef.distance(null, b, 0, 0, b.x(), b.y()));
    double most = 0;
    for (int i = 0; i < 200; i++) {
      w.step(DT);
      most = Math.max(most, Math.hypot(j.forceX(), j.forceY()));
    }
    double expected = b.mass() * G * (3 - 2 * Math.cos(amplitude));
    assertEquals(expected, most, .03 * expected);
  }

  /** Two coupled pendulums hand their energy over and back: beats. */
  @Test
  void coupledPendulumsBeat() {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> a = disc(w, -1 + 4 * Math.sin(.1), -4 * Math.cos(.1), .2, M);
    Body<String> b = disc(w, 1, -4, .2, M);
    w.createJoint(JointDef.distance(null, a, -1, 0, a.x(), a.y()));
    w.createJoint(JointDef.distance(null, b, 1, 0, 1, -4));
    // m (2 pi f)^2 with the reduced mass m / 2; the modes are g / l and g / l + 2 k / m.
    double f = .1;
    double stiff = Math.pow(2 * Math.PI * f, 2) / 2;
    w.createJoint(JointDef.distance(a, b, a.x(), a.y(), b.x(), b.y()).spring((float) f, 0).rest(2));
    double slow = Math.sqrt(G / 4);
    double fast = Math.sqrt(G / 4 + 2 * stiff);
    double half = Math.PI / (fast - slow);
    seconds(w, half * .85);
    double most = 0;
    double mostA = 0;
    for (int i = 0; i < half * .3 * 60; i++) {
      w.step(DT);
      most = Math.max(most, Math.abs(b.x() - 1));
    }
    for (int i = 0; i < half * 60; i++) {
      w.step(DT);
      mostA = i < half * 50 ? 0 : Math.max(mostA, Math.abs(a.x() + 1));
    }
    assertEquals(4 * Math.sin(.1), most, .04, "all of it has gone over");
    assertEquals(4 * Math.sin(.1), mostA, .04, "and comes back");
  }

  /** A double pendulum is chaotic, but its energy isn't. */
  @Test
  void aDoublePendulumKeepsItsEnergy() {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> a = disc(w, 1, 0, .1, M);
    Body<String> b = disc(w, 2, 0, .1, M);
    w.createJoint(JointDef.revolute(null, a, 0, 0));
    w.createJoint(JointDef.revolute(a, b, 1, 0));
    double scale = a.mass() * G * 6;
    double before = Lab.energy(w);
    double worst = 0;
    for (int i = 0; i < 1200; i++) {
      w.step(DT);
      worst = Math.max(worst, Math.abs(Lab.energy(w) - before));
    }
    assertTrue(worst < .06 * scale, "worst=" + worst / scale);
  }

  /** Ballistic pendulum: h = (m v / (m + M))^2 / 2g. */
  @Test
  void aBallisticPendulumRisesByTheMomentumItCaught() {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    Body<String> block = upright(w, new Box(.5f, .5f), 0, 3);
    w.createJoint(JointDef.distance(null, block, 0, 0, 0, -4));
    Body<String> bullet = upright(w, new Circle(.1f), -.65, 30);
    bullet.setVelocity(12, 0);
    double top = -4;
    boolean welded = false;
    for (int i = 0; i < 90; i++) {
      w.step(DT);
      if (!welded && bullet.velocityX() < 9) {
        welded = true;
        w.createJoint(JointDef.weld(block, bullet, bullet.x(), bullet.y()));
      }
      top = Math.max(top, block.y());
    }
    double v = 12 * bullet.mass() / (bullet.mass() + block.mass());
    assertEquals(v * v / (2 * G), top + 4, .05 * v * v / (2 * G));
  }

  /** What can't turn takes no energy into its rotation. */
  private static Body<String> upright(World<String> w, Shape shape, double x, float density) {
    return w.createBody(
        new BodyDef(BodyType.DYNAMIC)
            .shape(shape, new Material(density, 0, 0))
            .position((float) x, -4)
            .fixedRotation(true),
        "upright");
  }

  /** A conserving orbit on a rope: the hammer flies with its tangential speed when let go. */
  @Test
  void aHammerFliesTangentiallyWhenLetGo() {
    World<String> w = Lab.space();
    Body<String> b = disc(w, 2, 0, .2, M);
    Joint<String> j = w.createJoint(JointDef.distance(null, b, 0, 0, 2, 0));
    b.setVelocity(0, 5);
    seconds(w, 5);
    assertEquals(5, Lab.speed(b), .05, "no force along the way");
    double x = b.x();
    double y = b.y();
    double dot = x * b.velocityX() + y * b.velocityY();
    assertEquals(0, dot / 10, .03, "tangential");
    w.destroyJoint(j);
    float vx = b.velocityX();
    seconds(w, 1);
    assertEquals(x + vx, b.x(), 1e-4);
    assertEquals(vx, b.velocityX());
  }
}
