package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.threads.WorkerThreads;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Bodies of which axes are locked: nothing moves them along these, and they move freely else. */
class MotionLocksTest {
  private static final Material M = Material.DEFAULT;
  private static final MotionLocks X = new MotionLocks(true, false, false);
  private static final MotionLocks Y = new MotionLocks(false, true, false);
  private static final MotionLocks XY = new MotionLocks(true, true, false);
  private static final MotionLocks ALL = new MotionLocks(true, true, true);

  private static Body<String> locked(World<String> w, float x, float y, MotionLocks locks) {
    return w.createBody(
        new BodyDef(BodyType.DYNAMIC).position(x, y).shape(new Box(0.5f, 0.5f)).motionLocks(locks),
        "locked");
  }

  @Test
  void gravityForcesAndImpulsesMoveItAlongTheFreeAxisOnly() {
    World<String> w = new World<>(new WorldDef());
    Body<String> x = locked(w, 0.1f, 5, X);
    Body<String> y = locked(w, 9.1f, 5.3f, Y);
    for (int i = 0; i < 60; i++) {
      x.applyForce(7, 1);
      y.applyForce(1, 7);
      x.applyImpulse(0.5f, 0, 0.1f, 5.5f);
      y.applyImpulse(0, 0.5f);
      w.step(DT);
    }
    assertEquals(0.1f, x.x());
    assertEquals(5.3f, y.y());
    assertEquals(-9, x.velocityY(), 1e-3);
    assertEquals(1, y.velocityX(), 1e-3);
    assertNotEquals(0, x.angularVelocity());
  }

  @Test
  void whoSetsAVelocityMovesItAtThatOne() {
    World<String> w = new World<>(new WorldDef());
    Body<String> b = locked(w, 0, 0, Y);
    b.setLinearDamping(3);
    b.setVelocity(0, 1.5f);
    steps(w, 120);
    assertEquals(1.5f, b.velocityY());
    assertEquals(3, b.y(), 1e-4);
    b.setMotionLocks(MotionLocks.NONE);
    steps(w, 1);
    assertTrue(b.velocityY() < 1.4f);
    b.setMotionLocks(XY);
    assertEquals(0, b.velocityY());
    assertEquals(XY, b.motionLocks());
    assertFalse(b.isFixedRotation());
    b.setFixedRotation(true);
    assertEquals(ALL, b.motionLocks());
    b.setMotionLocks(X);
    assertFalse(b.isFixedRotation());
    assertThrows(NullPointerException.class, () -> b.setMotionLocks(null));
  }

  /** To what falls on it, a body locked along y is a floor, however much heavier that is. */
  @ParameterizedTest
  @ValueSource(floats = {1, 10, 1000})
  void whatFallsOnALockedBodyLandsAsOnTheGround(float density) {
    World<String> w = new World<>(new WorldDef());
    Body<String> shelf = locked(w, 0, -0.5f, new MotionLocks(false, true, true));
    Body<String> b = box(w, 0, 2.25f, 0.25f, 0.25f, M.withDensity(density));
    World<String> g = Scenes.floor(M);
    Body<String> onGround = box(g, 0, 2.25f, 0.25f, 0.25f, M.withDensity(density));
    for (int i = 0; i < 240; i++) {
      w.step(DT);
      g.step(DT);
      assertEquals(-0.5f, shelf.y());
      assertEquals(onGround.y(), b.y(), 5e-3, "step=" + i);
    }
    assertFalse(b.awake());
  }

  /** e = 1 against an immovable body turns the speed round. */
  @Test
  void aBallBouncesOffALockedBodyAsOffAWall() {
    World<String> w = Scenes.space();
    locked(w, 0, 0, X);
    Body<String> ball = Scenes.disc(w, -3, 0, 0.25f, M.withRestitution(1).withFriction(0));
    ball.setVelocity(6, 0);
    steps(w, 60);
    assertEquals(-6, ball.velocityX(), 1e-3);
    assertEquals(0, ball.velocityY(), 1e-4);
  }

  /** Along the free axis it is as heavy as it is: equal masses exchange their speeds. */
  @Test
  void alongTheFreeAxisItIsAnOrdinaryBody() {
    World<String> w = Scenes.space();
    Body<String> b = locked(w, 0, 0, Y);
    Body<String> other =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .position(-3, 0)
                .shape(new Box(0.5f, 0.5f), M.withRestitution(1).withFriction(0))
                .velocity(4, 0),
            "other");
    steps(w, 60);
    assertEquals(4, b.velocityX(), 1e-2);
    assertEquals(0, other.velocityX(), 1e-2);
  }

  /** A belt of friction drags a shelf along the free axis: momentum goes over. */
  @Test
  void frictionMovesItAlongTheFreeAxis() {
    World<String> w = new World<>(new WorldDef());
    Body<String> shelf =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .position(0, -0.5f)
                .shape(new Box(10, 0.5f))
                .motionLocks(new MotionLocks(false, true, true)),
            "shelf");
    Body<String> b = box(w, 0, 0.5f, 0.5f, 0.5f, M.withFriction(0.9f));
    b.setVelocity(3, 0);
    steps(w, 240);
    double common = 3 * b.mass() / (b.mass() + shelf.mass());
    assertEquals(common, b.velocityX(), 0.02);
    assertEquals(common, shelf.velocityX(), 0.02);
    assertEquals(-0.5f, shelf.y());
  }

  /** A mill wheel: hung in the air by its locks, it turns when something falls on its rim. */
  @Test
  void aWheelLockedAlongBothAxesTurnsInPlace() {
    World<String> w = new World<>(new WorldDef());
    Body<String> wheel =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC).position(2, 3).shape(new Box(2, 0.1f)).motionLocks(XY),
            "wheel");
    Scenes.disc(w, 3.5f, 4, 0.2f, M.withDensity(20));
    steps(w, 60);
    assertEquals(2f, wheel.x());
    assertEquals(3f, wheel.y());
    assertTrue(wheel.angularVelocity() < -0.5f, () -> "w=" + wheel.angularVelocity());
  }

  /** Two bodies that can't give way overlap: nothing to solve, no absurd impulse, nothing moves. */
  @Test
  void whatIsLockedIntoTheGroundStays() {
    World<String> w = Scenes.floor(M.withRestitution(1));
    Body<String> b = locked(w, 0, 0.3f, new MotionLocks(false, true, true));
    b.setVelocity(1, 0);
    steps(w, 60);
    assertEquals(0.3f, b.y());
    b.forEachContact((other, nx, ny, impulse) -> assertEquals(0, impulse, 1e-6));
    assertEquals(1, b.velocityX(), 0.01);
    b.setMotionLocks(MotionLocks.NONE);
    steps(w, 120);
    assertEquals(0.5, b.y(), 0.01);
  }

  @Test
  void aFastBodyIsStoppedAndKeepsItsAxis() {
    World<String> w = new World<>(new WorldDef());
    w.createBody(new BodyDef().position(20, 0).shape(new Box(0.05f, 5)), "wall");
    Body<String> lift =
        w.createBody(
            new BodyDef(BodyType.KINEMATIC)
                .position(40, 0)
                .shape(new Box(0.05f, 5))
                .velocity(0, 40),
            "lift");
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .position(0, 0.3f)
                .shape(new Circle(0.1f))
                .bullet(true)
                .velocity(900, 0)
                .motionLocks(Y),
            "bullet");
    Body<String> second =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .position(30, 0.7f)
                .shape(new Circle(0.1f))
                .bullet(true)
                .velocity(900, 0)
                .motionLocks(Y),
            "second");
    for (int i = 0; i < 5; i++) {
      w.step(DT);
      assertEquals(0.3f, b.y(), "step=" + i);
      assertEquals(0.7f, second.y(), "step=" + i);
    }
    assertTrue(b.x() < 20, () -> "x=" + b.x());
    assertTrue(second.x() < 40, () -> "x=" + second.x());
    assertEquals(40f, lift.velocityY());
  }

  /**
   * A pendulum on a cart that is locked along y: the joint holds, and the cart keeps its height.
   */
  @Test
  void aJointMovesALockedBodyAlongItsFreeAxisOnly() {
    World<String> w = new World<>(new WorldDef());
    Body<String> cart = locked(w, 0, 2, new MotionLocks(false, true, true));
    Body<String> bob = Scenes.disc(w, 1.5f, 2, 0.2f, M.withDensity(10));
    w.createJoint(JointDef.revolute(cart, bob, 0, 2));
    double worst = 0;
    for (int i = 0; i < 600; i++) {
      w.step(DT);
      assertEquals(2f, cart.y(), "step=" + i);
      double length = Math.hypot(bob.x() - cart.x(), bob.y() - cart.y());
      worst = Math.max(worst, Math.abs(length - 1.5));
    }
    assertTrue(worst < 0.03, "worst=" + worst);
    // No outer force acts along x: the common centre stays.
    double centre = (cart.x() * cart.mass() + bob.x() * bob.mass()) / (cart.mass() + bob.mass());
    assertEquals(1.5 * bob.mass() / (cart.mass() + bob.mass()), centre, 0.05);
  }

  private static World<String> crowd(Random r, int n) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    w.createBody(new BodyDef().shape(new Box(60, 1)).position(0, -1), "floor");
    for (int i = 0; i < n; i++) {
      MotionLocks locks =
          r.nextInt(5) > 0
              ? MotionLocks.NONE
              : new MotionLocks(r.nextBoolean(), r.nextBoolean(), r.nextBoolean());
      BodyDef def =
          new BodyDef(BodyType.DYNAMIC).position(i % 40 - 20, 0.5f + Math.floorDiv(i, 40));
      def.motionLocks(locks);
      w.createBody(
          r.nextBoolean() ? def.shape(new Circle(0.5f)) : def.shape(new Box(0.48f, 0.48f)), "b");
    }
    return w;
  }

  /**
   * Blocks of eight contacts and more are solved by vectors where there are some: nothing shows.
   */
  @ParameterizedTest
  @ValueSource(ints = {1, 2})
  void inACrowdEveryLockHoldsToTheBit(int seed) {
    Random r = new Random(seed);
    World<String> w = crowd(r, 1200);
    World<String> shared = crowd(new Random(seed), 1200);
    try (WorkerThreads threads = new WorkerThreads(2)) {
      shared.workers(threads);
      List<float[]> starts = new ArrayList<>();
      w.forEachBody(b -> starts.add(new float[] {b.x(), b.y(), b.cos()}));
      for (int i = 0; i < 100; i++) {
        w.step(DT);
        shared.step(DT);
        assertEquals(w.stateHash(), shared.stateHash(), "seed=" + seed + " step=" + i);
      }
      w.forEachBody(
          b -> {
            float[] start = starts.get(b.index());
            MotionLocks locks = b.motionLocks();
            assertTrue(!locks.linearX() || b.x() == start[0], () -> "seed=" + seed + " " + b);
            assertTrue(!locks.linearY() || b.y() == start[1], () -> "seed=" + seed + " " + b);
            assertTrue(!locks.angularZ() || b.cos() == start[2], () -> "seed=" + seed + " " + b);
          });
    }
  }

  @Test
  void locksAreSavedRestoredArchivedAndHashed() {
    World<String> w = Scenes.floor(M);
    Body<String> b = box(w, 0, 3, 0.5f, 0.5f, M);
    box(w, 0, 5, 0.5f, 0.5f, M);
    WorldState free = w.save(null);
    long before = w.stateHash();
    b.setMotionLocks(Y);
    long locked = w.stateHash();
    assertNotEquals(before, locked);
    ArchiveWriter out = new ArchiveWriter();
    w.save(null).write(out);
    World<String> copy = new World<>(w.def());
    copy.restore(copy.read(new ArchiveReader(out.toBytes()), slot -> "copy"));
    assertEquals(locked, copy.stateHash());
    for (int i = 0; i < 120; i++) {
      w.step(DT);
      copy.step(DT);
      assertEquals(w.stateHash(), copy.stateHash(), "step=" + i);
    }
    assertEquals(3f, b.y());
    w.restore(free);
    assertEquals(before, w.stateHash());
    assertEquals(MotionLocks.NONE, b.motionLocks());
  }

  @Test
  void inACallbackTheLastWordCounts() {
    World<String> w = Scenes.floor(M);
    Body<String> b = box(w, 0, 0.5f, 0.5f, 0.5f, M);
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            b.setMotionLocks(X);
            b.setFixedRotation(true);
            assertEquals(MotionLocks.NONE, b.motionLocks());
          }
        });
    w.step(DT);
    assertEquals(X.withAngularZ(true), b.motionLocks());
  }
}
