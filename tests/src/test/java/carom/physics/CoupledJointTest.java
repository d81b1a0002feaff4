package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.disc;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Gears, racks and pulleys; hinges that count turns. */
class CoupledJointTest {
  private static final Material M = Material.DEFAULT;
  private static final double H = DT / 4;

  private static Joint<String> pulley(World<String> w, Body<String> a, Body<String> b, float r) {
    return w.createJoint(
        JointDef.pulley(a, b, a.x(), a.y(), b.x(), b.y(), a.x(), 10, b.x(), 10, r));
  }

  /** B sinks with a = g (mB - r mA) / (mB + r^2 mA), by v = a n h, y = a h^2 n (n + 1) / 2. */
  @ParameterizedTest
  @CsvSource({"1,1,1", "1,3,1", "3,1,1", "1,2,2", "1,9,3", "5,1,0.5"})
  void atwoodsMachineFallsByTheExactDiscreteSolution(float densityA, float densityB, float r) {
    World<String> w = new World<>(new WorldDef());
    Body<String> a = box(w, -2, 0, 0.5f, 0.5f, M.withDensity(densityA));
    Body<String> b = box(w, 2, 0, 0.5f, 0.5f, M.withDensity(densityB));
    Joint<String> rope = pulley(w, a, b, r);
    double accel = 10 * (b.mass() - r * a.mass()) / (b.mass() + r * r * a.mass());
    for (int n = 4; n <= 120; n += 4) {
      w.step(DT);
      assertEquals(-accel * n * H, b.velocityY(), 1e-4 * (1 + n * H * Math.abs(accel)));
      assertEquals(-accel * H * H * n * (n + 1) / 2, b.y(), 2e-4);
      assertEquals(-r * b.velocityY(), a.velocityY(), 1e-4 * (1 + n * H));
      assertEquals(10 + 10 * r, rope.lengthA() + r * rope.lengthB(), 1e-3);
    }
    double tension = r * a.mass() * (10 + r * accel);
    assertEquals(tension, rope.forceY(), 1e-3 * tension);
    assertEquals(0, rope.forceX(), 1e-3 * tension);
  }

  @Test
  void aRopeSlackensWhereARodPushes() {
    for (boolean slack : new boolean[] {true, false}) {
      World<String> w = Scenes.floor(M);
      Body<String> a = box(w, -2, 5, 0.5f, 0.5f, M);
      Body<String> b = box(w, 2, 0.5f, 0.5f, 0.5f, M.withDensity(50));
      JointDef<String> d = JointDef.pulley(a, b, -2, 5, 2, 0.5f, -2, 10, 2, 10, 1);
      Joint<String> rope = w.createJoint(slack ? d.limits(0, 14.5f) : d);
      a.setVelocity(0, 5);
      steps(w, 20);
      double length = rope.lengthA() + rope.lengthB();
      if (slack) {
        assertTrue(length < 14, "length=" + length);
        steps(w, 120);
        assertEquals(14.5, rope.coordinate(), 0.01, "and is taut again");
      } else {
        assertEquals(14.5, length, 0.02);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(floats = {1, -1, 2, -0.5f, 7.3f})
  void gearsTurnByTheirRatioAndShareTheTorque(float ratio) {
    World<String> w = Scenes.space();
    Body<String> a = disc(w, 0, 0, 1, M);
    Body<String> b = disc(w, 2, 0, 0.7f, M);
    w.createJoint(JointDef.revolute(null, a, 0, 0));
    w.createJoint(JointDef.revolute(null, b, 2, 0));
    Joint<String> gear = w.createJoint(JointDef.gear(a, b, ratio));
    double alpha = 3 / (a.inertia() + ratio * ratio * b.inertia());
    for (int i = 1; i <= 60; i++) {
      a.applyTorque(3);
      w.step(DT);
      assertEquals(alpha * i / 60, a.angularVelocity(), 1e-4 * alpha);
      assertEquals(ratio * a.angularVelocity(), b.angularVelocity(), 1e-4);
    }
    assertEquals(b.inertia() * ratio * alpha, gear.torque(), 1e-3 * Math.abs(gear.torque()));
    assertEquals(ratio, gear.ratio());
  }

  @Test
  void aThousandTurnsDontDrift() {
    World<String> w = Scenes.space();
    Body<String> a = disc(w, 0, 0, 1, M);
    Body<String> b = disc(w, 2, 0, 0.5f, M);
    w.createJoint(JointDef.revolute(null, a, 0, 0).motor(50, 1000));
    w.createJoint(JointDef.revolute(null, b, 2, 0));
    Joint<String> gear = w.createJoint(JointDef.gear(a, b, -2));
    steps(w, 3600 * 2);
    assertTrue(gear.coordinate() < -11_000, "turned by " + gear.coordinate());
    assertEquals(0, Math.sin(b.angle() + 2 * a.angle()), 1e-3);
    assertEquals(1, Math.cos(b.angle() + 2 * a.angle()), 1e-3);
  }

  /** a = r T / (I + r^2 m), and the rack is where the pinion has rolled it. */
  @ParameterizedTest
  @ValueSource(floats = {0.5f, -0.5f, 2})
  void aRackMovesByWhatThePinionTurns(float r) {
    World<String> w = Scenes.space();
    Body<String> pinion = disc(w, 0, 0, 0.5f, M);
    Body<String> rack = box(w, 0, -1, 4, 0.2f, M);
    w.createJoint(JointDef.revolute(null, pinion, 0, 0));
    w.createJoint(JointDef.prismatic(null, rack, 0, -1, 1, 0));
    Joint<String> joint = w.createJoint(JointDef.rack(pinion, rack, 1, 0, r));
    double accel = r * 5 / (pinion.inertia() + r * r * rack.mass());
    for (int i = 1; i <= 240; i++) {
      pinion.applyTorque(5);
      w.step(DT);
      assertEquals(accel * i / 60, rack.velocityX(), 1e-3 * Math.abs(accel) * i / 60 + 1e-4);
    }
    double turned = rack.x() / r;
    assertEquals(Math.cos(turned), pinion.cos(), 2e-3);
    assertEquals(Math.sin(turned), pinion.sin(), 2e-3);
    assertEquals(rack.x(), joint.coordinate(), 1e-4);
    assertTrue(Math.abs(turned) > 3, "turned by " + turned);
  }

  @Test
  void aHingeHoldsLimitsBeyondATurn() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, 1, 0.2f, M);
    Joint<String> hinge =
        w.createJoint(JointDef.revolute(null, b, 0, 0).limits(-4, 20).motor(5, 100));
    float last = 0;
    for (int i = 0; i < 420; i++) {
      w.step(DT);
      assertEquals(last, hinge.angle(), 0.5, "no jump");
      last = hinge.angle();
    }
    assertEquals(20, hinge.angle(), 0.02);
    hinge.setMotor(-5, 100);
    steps(w, 600);
    assertEquals(-4, hinge.angle(), 0.02);
  }

  @Test
  void aSpringWindsUpOverTurns() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, 1, 0.2f, M);
    Joint<String> hinge = w.createJoint(JointDef.revolute(null, b, 0, 0).rest(15).spring(0.5f, 1));
    steps(w, 900);
    assertEquals(15, hinge.angle(), 0.01);
    hinge.setRest(-9);
    steps(w, 900);
    assertEquals(-9, hinge.angle(), 0.01);
  }

  private static World<String> machine() {
    World<String> w = Scenes.pile(20, 4);
    Body<String> a = disc(w, 20, 0, 1, M);
    Body<String> b = disc(w, 23, 0, 1, M);
    Body<String> c = box(w, 20, -3, 2, 0.2f, M);
    Body<String> d = box(w, 26, 5, 0.5f, 0.5f, M);
    w.createJoint(JointDef.revolute(null, a, 20, 0).limits(-50, 50).motor(9, 500));
    w.createJoint(JointDef.revolute(null, b, 23, 0));
    w.createJoint(JointDef.prismatic(null, c, 20, -3, 1, 0));
    w.createJoint(JointDef.gear(a, b, -1.5f));
    w.createJoint(JointDef.rack(b, c, 1, 0, 0.1f));
    w.createJoint(JointDef.pulley(c, d, 20, -3, 26, 5, 15, -3, 26, 10, 1).limits(0, 15));
    return w;
  }

  @Test
  void everyTurnIsSavedAndRestored() {
    World<String> w = machine();
    steps(w, 100);
    WorldState state = w.save(null);
    long saved = w.stateHash();
    steps(w, 150);
    long later = w.stateHash();
    w.restore(state);
    assertEquals(saved, w.stateHash());
    steps(w, 150);
    assertEquals(later, w.stateHash());
    World<String> again = machine();
    steps(again, 250);
    assertEquals(later, again.stateHash());
  }

  @Test
  void whatIsPulledTooHardBreaks() {
    World<String> w = new World<>(new WorldDef());
    Body<String> a = box(w, -2, 0, 0.5f, 0.5f, M);
    Body<String> b = box(w, 2, 0, 0.5f, 0.5f, M);
    JointDef<String> d = JointDef.pulley(a, b, -2, 0, 2, 0, -2, 10, 2, 10, 1);
    Joint<String> rope = w.createJoint(d.breaksAt(12, 1));
    steps(w, 30);
    assertTrue(rope.isValid(), "10 N hang there");
    a.applyForce(0, -5);
    b.applyForce(0, -5);
    w.step(DT);
    assertFalse(rope.isValid());
  }

  @Test
  void impossibleRatiosAndPlacesAreRefused() {
    World<String> w = Scenes.space();
    Body<String> a = disc(w, 0, 0, 1, M);
    Body<String> b = disc(w, 3, 0, 1, M);
    for (float bad : new float[] {Float.NaN, Float.POSITIVE_INFINITY, 0, 1e30f, 1e-30f}) {
      refused("ratio=" + bad, () -> JointDef.gear(a, b, bad));
      refused("ratio=" + bad, () -> JointDef.rack(a, b, 1, 0, bad));
      refused("ratio=" + bad, () -> JointDef.pulley(a, b, 0, 0, 3, 0, 0, 5, 3, 5, bad));
    }
    refused("ratio=-1.0", () -> JointDef.pulley(a, b, 0, 0, 3, 0, 0, 5, 3, 5, -1));
    refused("bodyA=null", () -> JointDef.gear(null, b, 1));
    refused("axisX=0.0", () -> JointDef.rack(a, b, 0, 0, 1));
    refused("groundAX=NaN", () -> JointDef.pulley(a, b, 0, 0, 3, 0, Float.NaN, 5, 3, 5, 1));
    refused("groundBY=NaN", () -> JointDef.pulley(a, b, 0, 0, 3, 0, 0, 5, 3, Float.NaN, 1));
    Joint<String> gear = w.createJoint(JointDef.gear(a, b, 1));
    assertThrows(IllegalStateException.class, () -> gear.setLimits(0, 1));
    assertThrows(IllegalStateException.class, () -> gear.setMotor(0, 1));
    assertThrows(IllegalStateException.class, () -> gear.setSpring(1, 1));
    assertThrows(IllegalStateException.class, gear::lengthA);
  }

  private static void refused(String part, Runnable call) {
    String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
    assertTrue(message.contains(part), message);
  }
}
