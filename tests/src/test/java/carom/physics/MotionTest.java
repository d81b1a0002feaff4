package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import org.junit.jupiter.api.Test;

/** Bodies without contacts against closed forms. */
final class MotionTest {
  private static final Material M = Material.DEFAULT;

  /** Symplectic Euler after n substeps: v = g n h, x = x0 + v0 n h + g h^2 n (n + 1) / 2. */
  @Test
  void fallsAsTheExactDiscreteSolution() {
    World<String> w = new World<>(new WorldDef());
    Body<String> b = Scenes.disc(w, 1, 100, .5f, M);
    b.setVelocity(3, 4);
    for (int tick = 1; tick <= 240; tick++) {
      w.step(DT);
      int n = 4 * tick;
      double h = DT / 4.0;
      assertEquals(4 - 10 * n * h, b.velocityY(), 1e-4 * tick);
      assertEquals(100 + 4 * n * h - 10 * h * h * n * (n + 1) / 2, b.y(), 1e-4 * tick);
      assertEquals(1 + 3 * n * h, b.x(), 1e-5 * tick);
    }
  }

  @Test
  void dampingDividesVelocityEachSubstep() {
    World<String> w = Scenes.space();
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Circle(1), M)
                .velocity(10, 0)
                .angularVelocity(8)
                .linearDamping(2)
                .angularDamping(3),
            null);
    steps(w, 60);
    assertEquals(10 * Math.pow(1 / (1 + 2 / 240.0), 240), b.velocityX(), 1e-3);
    assertEquals(8 * Math.pow(1 / (1 + 3 / 240.0), 240), b.angularVelocity(), 1e-3);
  }

  @Test
  void gravityScaleScalesGravity() {
    World<String> w = new World<>(new WorldDef());
    Body<String> b = Scenes.disc(w, 0, 0, 1, M);
    b.setGravityScale(-0.5f);
    steps(w, 60);
    assertEquals(5, b.velocityY(), 1e-3);
  }

  @Test
  void forceActsForOneStepAndIsForgotten() {
    World<String> w = Scenes.space();
    Body<String> b = Scenes.box(w, 0, 0, .5f, .5f, M);
    b.applyForce(60, 0);
    assertEquals(0, b.velocityX());
    w.step(DT);
    assertEquals(1, b.velocityX(), 1e-5);
    w.step(DT);
    assertEquals(1, b.velocityX(), 1e-5);
  }

  @Test
  void forcesAddUp() {
    World<String> w = Scenes.space();
    Body<String> b = Scenes.box(w, 0, 0, .5f, .5f, M);
    b.applyForce(60, 0);
    b.applyForce(-30, 12);
    w.step(DT);
    assertEquals(.5, b.velocityX(), 1e-5);
    assertEquals(.2, b.velocityY(), 1e-5);
  }

  @Test
  void offCentreImpulseMovesAndTurns() {
    World<String> w = Scenes.space();
    Body<String> b = Scenes.box(w, 5, 3, 1, .5f, M);
    assertEquals(2, b.mass(), 1e-6);
    double inertia = 2 * (4 + 1) / 12.0;
    assertEquals(inertia, b.inertia(), 1e-6);
    b.applyImpulse(0, 4, 6, 3);
    w.step(DT);
    assertEquals(2, b.velocityY(), 1e-5);
    assertEquals(4 / inertia, b.angularVelocity(), 1e-5);
  }

  @Test
  void forceWithPointOfApplicationMakesTorque() {
    World<String> w = Scenes.space();
    Body<String> b = Scenes.box(w, 0, 0, 1, .5f, M);
    b.applyForce(12, 0, 0, .5f);
    w.step(DT);
    assertEquals(0.1, b.velocityX(), 1e-5);
    assertEquals(-.5 * 12 / b.inertia() / 60, b.angularVelocity(), 1e-5);
  }

  @Test
  void torqueAndAngularImpulseTurn() {
    World<String> w = Scenes.space();
    Body<String> b = Scenes.box(w, 0, 0, 1, .5f, M);
    b.applyTorque(6);
    b.applyAngularImpulse(.5f);
    w.step(DT);
    assertEquals((6 / 60f + .5f) / b.inertia(), b.angularVelocity(), 1e-5);
  }

  @Test
  void rotatesByTheAngleItShould() {
    World<String> w = Scenes.space();
    Body<String> b = Scenes.box(w, 0, 0, 1, .5f, M);
    b.setAngularVelocity(3);
    steps(w, 60);
    assertEquals(Math.sin(3), b.sin(), 1e-4);
    assertEquals(Math.cos(3), b.cos(), 1e-4);
    b.setAngularVelocity(60);
    steps(w, 60);
    assertEquals(1, b.cos() * b.cos() + b.sin() * b.sin(), 1e-6);
    assertEquals(Math.sin(63), b.sin(), 0.01);
  }

  @Test
  void originCirclesAroundTheCentreOfMass() {
    World<String> w = Scenes.space();
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC).shape(new Circle(.5f, 2, 0), M).angularVelocity(1), null);
    assertEquals(2, b.centerX(), 1e-6);
    assertEquals(0, b.x(), 1e-6);
    steps(w, 60);
    assertEquals(2, b.centerX(), 1e-6);
    assertEquals(2 - 2 * Math.cos(1), b.x(), 1e-3);
    assertEquals(-2 * Math.sin(1), b.y(), 1e-3);
  }

  @Test
  void fixedRotationNeverTurns() {
    World<String> w = Scenes.floor(M);
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(.2f, 1), M)
                .position(0, 1)
                .fixedRotation(true),
            null);
    for (int i = 0; i < 120; i++) {
      b.applyImpulse(0.1f, 0, 0, 2);
      b.applyTorque(100);
      w.step(DT);
    }
    assertEquals(0, b.sin());
    assertEquals(0, b.angularVelocity());
    assertTrue(b.x() > 0.1);
  }

  @Test
  void staticBodiesIgnoreForces() {
    World<String> w = new World<>(new WorldDef());
    Body<String> b = w.createBody(new BodyDef().shape(new Box(1, 1), M), null);
    b.applyForce(1e6f, 0, 0, 1);
    b.applyImpulse(1e6f, 0, 0, 1);
    b.applyTorque(1e6f);
    b.applyAngularImpulse(1e6f);
    b.setVelocity(5, 5);
    long before = w.stateHash();
    steps(w, 10);
    assertEquals(0, b.x());
    assertEquals(0, b.velocityX());
    assertEquals(before, w.stateHash());
  }

  @Test
  void kinematicBodyKeepsItsVelocityAndPushes() {
    World<String> w = Scenes.floor(new Material(1, 0, 0));
    Body<String> pusher =
        w.createBody(
            new BodyDef(BodyType.KINEMATIC).shape(new Box(.5f, .5f)).position(-3, 1).velocity(2, 0),
            null);
    Body<String> b = Scenes.box(w, 0, .5f, .5f, .5f, new Material(100, .1f, 0));
    pusher.applyForce(1e5f, 0);
    steps(w, 180);
    assertEquals(3, pusher.x(), 1e-4);
    assertEquals(2, pusher.velocityX());
    assertEquals(4, b.x(), 0.01);
    assertEquals(2, b.velocityX(), 0.01);
  }

  /** F = k (goal - v) acts over whole steps: the difference shrinks by 1 - k dt / m. */
  @Test
  void seekVelocityConvergesAsTheClosedForm() {
    World<String> w = Scenes.space();
    Body<String> b = Scenes.box(w, 0, 0, .5f, .5f, M);
    for (int i = 1; i <= 60; i++) {
      b.seekVelocity(4, -2, 6);
      w.step(DT);
      double left = Math.pow(1 - 6 / 60.0, i);
      assertEquals(4 * (1 - left), b.velocityX(), 1e-4);
      assertEquals(-2 * (1 - left), b.velocityY(), 1e-4);
    }
    b.seekVelocity(0, 0, 1e6f, DT);
    w.step(DT);
    assertEquals(0, b.velocityX(), 1e-5);
  }

  @Test
  void speedIsCutAtTheWorldsMaximum() {
    World<String> w = new World<>(new WorldDef().withGravity(0, 0).withMaxSpeed(50));
    Body<String> b = Scenes.box(w, 0, 0, .5f, .5f, M);
    b.setVelocity(300, 400);
    b.setAngularVelocity(-1e4f);
    w.step(DT);
    assertEquals(30, b.velocityX(), 1e-3);
    assertEquals(40, b.velocityY(), 1e-3);
    assertEquals(-250, b.angularVelocity(), 1e-3);
  }
}
