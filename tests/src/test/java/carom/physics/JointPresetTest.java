package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.disc;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Driven distances, ratchets, grooves and friction joints. */
class JointPresetTest {
  private static final Material M = Material.DEFAULT;

  @Test
  void aDistanceMotorHasItsSpeedAndItsForce() {
    World<String> w = Scenes.space();
    Body<String> fast = box(w, 3, 0, 0.5f, 0.5f, M);
    Body<String> weak = box(w, 3, 5, 0.5f, 0.5f, M);
    Joint<String> strong = w.createJoint(JointDef.distance(null, fast, 0, 0, 3, 0).motor(2, 1e6f));
    w.createJoint(JointDef.distance(null, weak, 0, 5, 3, 5).motor(100, 3));
    for (int i = 1; i <= 60; i++) {
      w.step(DT);
      assertEquals(2, fast.velocityX(), 1e-4);
      assertEquals(3 + 2 * i * DT, strong.coordinate(), 1e-3);
      assertEquals(3 * i * DT / weak.mass(), weak.velocityX(), 1e-3);
    }
    strong.setMotor(-1, 1e6f);
    steps(w, 60);
    assertEquals(4, strong.coordinate(), 1e-2);
    strong.stopMotor();
    steps(w, 60);
    assertEquals(3, strong.coordinate(), 1e-2, "a rod again, which draws to its length");
  }

  @Test
  void aDistanceMotorStopsAtItsLimitsAndStretchesItsSpring() {
    World<String> w = Scenes.space();
    Body<String> a = box(w, 3, 0, 0.5f, 0.5f, M);
    Body<String> b = box(w, 3, 5, 0.5f, 0.5f, M);
    Joint<String> stops =
        w.createJoint(JointDef.distance(null, a, 0, 0, 3, 0).limits(1, 4).motor(2, 500));
    Joint<String> sprung =
        w.createJoint(JointDef.distance(null, b, 0, 5, 3, 5).spring(1, 1).motor(50, 20));
    steps(w, 600);
    assertEquals(4, stops.coordinate(), 5e-3);
    double stiffness = b.mass() * 4 * Math.PI * Math.PI;
    assertEquals(3 + 20 / stiffness, sprung.coordinate(), 2e-3, "where the spring holds the motor");
    stops.setMotor(-2, 500);
    steps(w, 240);
    assertEquals(1, stops.coordinate(), 5e-3);
  }

  @ParameterizedTest
  @ValueSource(floats = {1, 4, 20})
  void frictionSlowsDownByItsForceAndThenHolds(float force) {
    World<String> w = Scenes.space();
    Body<String> body = box(w, 0, 0, 0.5f, 0.5f, M);
    w.createJoint(JointDef.friction(null, body, 0, 0, force, 0.5f));
    body.setVelocity(3, 4);
    body.setAngularVelocity(2);
    double m = body.mass();
    double stop = 5 * m / force;
    double still = 2 * body.inertia() / 0.5;
    for (int i = 1; i <= 600; i++) {
      w.step(DT);
      double t = i * DT;
      double speed = Math.hypot(body.velocityX(), body.velocityY());
      assertEquals(Math.max(0, 5 - force / m * t), speed, 0.05, "t=" + t);
      assertEquals(Math.max(0, 2 - 0.5 / body.inertia() * t), body.angularVelocity(), 0.02);
    }
    if (stop < 10 && still < 10) {
      assertEquals(25 * m / (2 * force), Math.hypot(body.x(), body.y()), 0.1);
      double x = body.x();
      for (int i = 0; i < 60; i++) {
        body.applyForce(0.9f * force, 0);
        w.step(DT);
      }
      assertEquals(x, body.x(), 1e-3, "a smaller force doesn't move it");
      for (int i = 0; i < 60; i++) {
        body.applyForce(1.5f * force, 0);
        w.step(DT);
      }
      assertEquals(0.5 * force / m, body.velocityX(), 0.02 * force / m);
    }
  }

  @Test
  void frictionAgainstABodyThatMovesTakesAlong() {
    World<String> w = Scenes.space();
    Body<String> belt =
        w.createBody(new BodyDef(BodyType.KINEMATIC).velocity(3, 0).shape(new Box(20, 2)), "belt");
    Body<String> body = box(w, 0, 0, 0.5f, 0.5f, M);
    w.createJoint(JointDef.friction(belt, body, 0, 0, 2, 1).collideConnected(false));
    steps(w, 30);
    assertEquals(2 * 30 * DT / body.mass(), body.velocityX(), 1e-2);
    steps(w, 300);
    assertEquals(3, body.velocityX(), 1e-3);
    assertEquals(0, body.angularVelocity(), 1e-3);
  }

  @Test
  void frictionBetweenTwoBodiesKeepsMomentum() {
    World<String> w = Scenes.space();
    Body<String> a = box(w, 0, 0, 3, 0.5f, M);
    Body<String> b = box(w, 1, 0.2f, 0.5f, 0.5f, M);
    w.createJoint(JointDef.friction(a, b, 1, 0.2f, 3, 1).collideConnected(false));
    b.setVelocity(4, 1);
    b.setAngularVelocity(3);
    double px = b.mass() * 4;
    double l = b.mass() * (1 * 1 - 0.2 * 4) + b.inertia() * 3;
    steps(w, 300);
    assertEquals(px, a.mass() * a.velocityX() + b.mass() * b.velocityX(), 1e-3 * px);
    double now = a.inertia() * a.angularVelocity() + b.inertia() * b.angularVelocity();
    now += a.mass() * (a.x() * a.velocityY() - a.y() * a.velocityX());
    now += b.mass() * (b.x() * b.velocityY() - b.y() * b.velocityX());
    assertEquals(l, now, 0.02 * Math.abs(l));
    assertEquals(a.angularVelocity(), b.angularVelocity(), 1e-2);
  }

  @ParameterizedTest
  @ValueSource(floats = {0.3f, -0.3f, 1.7f, -2.5f})
  void aRatchetTurnsOneWay(float tooth) {
    World<String> w = Scenes.space();
    Body<String> wheel = disc(w, 0, 0, 1, M);
    Joint<String> ratchet = w.createJoint(JointDef.ratchet(null, wheel, 0, 0, tooth));
    float way = Math.signum(tooth);
    wheel.setAngularVelocity(-way * 3);
    steps(w, 60);
    assertEquals(0, ratchet.angle(), 0.01, "it doesn't turn back at all");
    wheel.setAngularVelocity(way * 3.07f);
    steps(w, 600);
    double turned = ratchet.coordinate();
    assertEquals(way * 30.7, turned, 0.1, "it turns freely, over full turns");
    double teeth = Math.floor(turned / tooth);
    assertEquals(teeth * tooth, ratchet.toothAngle(), 1e-3);
    wheel.setAngularVelocity(0);
    for (int i = 0; i < 600; i++) {
      wheel.applyTorque(-way * 20);
      w.step(DT);
    }
    assertEquals(teeth * tooth, ratchet.coordinate(), 0.01, "it holds at the last tooth");
    assertEquals(tooth, ratchet.ratio());
  }

  @Test
  void aMotorWindsARatchetUpAgainstAWeight() {
    World<String> w = new World<>(new WorldDef());
    Body<String> arm = box(w, 1, 0, 1, 0.1f, M);
    Joint<String> ratchet = w.createJoint(JointDef.ratchet(null, arm, 0, 0, 0.1f).motor(1, 1000));
    steps(w, 60);
    assertEquals(1, ratchet.angle(), 0.02);
    ratchet.stopMotor();
    steps(w, 300);
    assertEquals(ratchet.toothAngle(), ratchet.angle(), 0.02);
    assertTrue(ratchet.angle() > 0.85, "angle=" + ratchet.angle());
    assertThrows(IllegalStateException.class, () -> ratchet.setLimits(-1, 1));
    Body<String> other = box(w, 5, 0, 1, 0.1f, M);
    assertThrows(
        IllegalStateException.class, () -> JointDef.ratchet(null, other, 5, 0, 1).limits(-1, 1));
    assertThrows(IllegalArgumentException.class, () -> JointDef.ratchet(null, other, 5, 0, 0));
    Joint<String> hinge = w.createJoint(JointDef.revolute(null, other, 5, 0));
    assertThrows(IllegalStateException.class, hinge::toothAngle);
  }

  @Test
  void aGrooveGuidesAPointAndEndsAndLetsTurn() {
    World<String> w = new World<>(new WorldDef());
    Body<String> body = box(w, 3, 4, 0.3f, 0.3f, M);
    Joint<String> groove = w.createJoint(JointDef.groove(null, body, 0, 0, 6, 8, 3, 4));
    body.setAngularVelocity(2);
    for (int i = 1; i <= 60; i++) {
      w.step(DT);
      assertEquals(0, 0.8 * body.x() - 0.6 * body.y(), 5e-3, "it is in the groove");
    }
    // Down a slope of 0.8 from the middle: s = g sin t^2 / 2.
    assertEquals(-4, groove.coordinate(), 0.1);
    assertEquals(2, body.angularVelocity(), 1e-3);
    steps(w, 120);
    assertEquals(-5, groove.coordinate(), 5e-3);
    assertEquals(0, body.x(), 5e-3);
    body.setVelocity(12, 16);
    float highest = 0;
    for (int i = 0; i < 120; i++) {
      w.step(DT);
      highest = Math.max(highest, groove.coordinate());
    }
    assertEquals(5, highest, 0.02, "the other end stops it, too");
  }

  @Test
  void aPointBesideItsGrooveIsDrawnIn() {
    World<String> w = Scenes.space();
    Body<String> plate = box(w, 0, 0, 3, 3, M.withDensity(10));
    Body<String> body = disc(w, 1, 0.3f, 0.2f, M);
    w.createJoint(JointDef.groove(plate, body, -2, 0, 2, 0, 1, 0.3f));
    plate.setAngularVelocity(1);
    steps(w, 120);
    double across = -plate.sin() * (body.x() - plate.x()) + plate.cos() * (body.y() - plate.y());
    double along = plate.cos() * (body.x() - plate.x()) + plate.sin() * (body.y() - plate.y());
    assertEquals(0, across, 0.01);
    assertTrue(along > 1 && along < 2.02, "it is flung outwards: along=" + along);
    Body<String> last = body;
    assertThrows(
        IllegalArgumentException.class, () -> JointDef.groove(null, last, 1, 1, 1, 1, 1, 1));
  }

  @Test
  void savedStatesGoOnToTheBit() {
    World<String> w = new World<>(new WorldDef());
    Body<String> wheel = disc(w, 0, 5, 1, M);
    Joint<String> ratchet = w.createJoint(JointDef.ratchet(null, wheel, 0, 5, 0.2f).motor(4, 100));
    Body<String> slider = box(w, 5, 5, 0.3f, 0.3f, M);
    w.createJoint(JointDef.groove(null, slider, 3, 4, 8, 6, 5, 5));
    w.createJoint(JointDef.friction(null, slider, 5, 5, 2, 0.1f));
    Body<String> piston = box(w, 12, 5, 0.3f, 0.3f, M);
    w.createJoint(JointDef.distance(null, piston, 12, 8, 12, 5).limits(1, 4).motor(1, 500));
    steps(w, 100);
    WorldState saved = w.save(null);
    long[] hashes = new long[200];
    for (int i = 0; i < hashes.length; i++) {
      run(w, ratchet, i);
      hashes[i] = w.stateHash();
    }
    assertTrue(ratchet.toothAngle() > 2);
    w.restore(saved);
    for (int i = 0; i < hashes.length; i++) {
      run(w, ratchet, i);
      assertEquals(hashes[i], w.stateHash(), "step " + i);
    }
    assertFalse(ratchet.isDriven());
  }

  private static void run(World<String> w, Joint<String> ratchet, int step) {
    if (step == 50) {
      ratchet.stopMotor();
      ratchet.bodyB().setAngularVelocity(-3);
    }
    w.step(DT);
  }
}
