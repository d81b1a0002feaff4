package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.disc;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class SleepTest {
  static final Material M = new Material(1, .6f, 0);

  /** A stack on a floor, asleep; the floor is body 0, the lowest box body 1. */
  static World<String> sleepingStack(int boxes) {
    World<String> w = Scenes.floor(M);
    for (int i = 0; i < boxes; i++) {
      box(w, 0, .5f + i, .5f, .5f, M);
    }
    untilAsleep(w);
    return w;
  }

  static void untilAsleep(World<String> w) {
    for (int i = 0; i < 3000 && (i == 0 || w.profile().awake() > 0); i++) {
      w.step(DT);
    }
    assertEquals(0, w.profile().awake(), "still awake");
  }

  static String contactsOf(Body<String> body) {
    StringBuilder text = new StringBuilder();
    body.forEachContact(
        (other, nx, ny, impulse) ->
            text.append(other.index()).append(' ').append(ny).append(' ').append(impulse));
    return text.toString();
  }

  @Test
  void pileFallsAsleepAndStaysExactlyStill() {
    World<String> w = Scenes.pile(80, 5);
    untilAsleep(w);
    long hash = w.stateHash();
    w.forEachBody(
        b -> {
          assertFalse(b.awake());
          assertEquals(0, b.velocityX());
          assertEquals(0, b.velocityY());
          assertEquals(0, b.angularVelocity());
        });
    steps(w, 200);
    assertEquals(hash, w.stateHash());
    assertEquals(0, w.profile().pairs());
  }

  @Test
  void whatRunsStaysAwake() {
    World<String> w = new World<>(new WorldDef());
    Material belt = M.withTangentSpeed(.01f);
    w.createBody(new BodyDef().shape(new Box(5, .5f), belt).position(0, -.5f), "belt");
    Body<String> carried = box(w, 0, .5f, .5f, .5f, M);
    Body<String> hand =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC).shape(new Box(.5f, .05f), M).position(20, 0), "hand");
    w.createJoint(JointDef.revolute(null, hand, 20, 0).motor(.01f, 100));
    steps(w, 120);
    assertTrue(carried.awake() && Math.abs(carried.x()) > .01f, "x=" + carried.x());
    assertEquals(.02f, hand.angle(), 1e-3f);
  }

  @Test
  void whoMayNotSleepKeepsItsIslandAwake() {
    World<String> w = Scenes.floor(M);
    Body<String> low = box(w, 0, .5f, .5f, .5f, M);
    Body<String> high =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(.5f, .5f), M)
                .position(0, 1.5f)
                .sleepAllowed(false),
            "high");
    Body<String> apart = box(w, 5, .5f, .5f, .5f, M);
    steps(w, 120);
    assertTrue(low.awake() && high.awake());
    assertFalse(apart.awake());
    low.sleep();
    assertTrue(low.awake());
    high.setSleepAllowed(true);
    untilAsleep(w);
    high.setSleepAllowed(false);
    assertTrue(low.awake());
  }

  @Test
  void steadyForceIsNoRest() {
    World<String> w = Scenes.floor(M);
    Body<String> b = box(w, 0, .5f, .5f, .5f, M);
    for (int i = 0; i < 120; i++) {
      b.applyForce(.5f, 0);
      w.step(DT);
    }
    assertTrue(b.awake());
  }

  @Test
  void sleepPutsTheIslandToSleepAtOnce() {
    World<String> w = Scenes.stack(3);
    Body<String> other = disc(w, 20, 30, .5f, M);
    w.step(DT);
    w.body(1).sleep();
    for (int i = 1; i <= 3; i++) {
      assertFalse(w.body(i).awake());
    }
    assertTrue(other.awake());
    w.step(DT);
    other.sleep();
    float y = other.y();
    steps(w, 10);
    assertEquals(y, other.y());
    other.wake();
    steps(w, 10);
    assertTrue(other.y() < y);
  }

  @Test
  void levelMayStartAsleep() {
    World<String> w = Scenes.floor(M);
    for (int i = 0; i < 180; i++) {
      w.createBody(
          new BodyDef(BodyType.DYNAMIC)
              .shape(new Box(.5f, .5f), M)
              .position(-90 + 2 * (i / 2), .5f + i % 2)
              .awake(false),
          "b" + i);
    }
    w.step(DT);
    assertEquals(0, w.profile().awake());
    Body<String> ball = disc(w, -90, 3, .5f, M);
    steps(w, 30);
    assertTrue(w.body(1).awake() && w.body(2).awake());
    assertEquals(1.5f, w.body(2).y(), .02f);
    assertTrue(w.profile().awake() <= 3);
    w.destroyBody(ball);
    untilAsleep(w);
  }

  @Test
  void worldMayKeepEverythingAwake() {
    World<String> w = Scenes.floor(M, new WorldDef().withSleeping(false));
    Body<String> b = box(w, 0, .5f, .5f, .5f, M);
    steps(w, 200);
    b.sleep();
    assertTrue(b.awake());
  }

  @Test
  void sensorsKeepTheirOverlapsThroughSleepWithoutEvents() {
    World<String> w = Scenes.floor(M);
    ShapeDef zone = new ShapeDef(new Box(2, 2), M).withSensor(true);
    Body<String> gate = w.createBody(new BodyDef().shape(zone).position(0, 1), "gate");
    Body<String> b = box(w, 0, .5f, .5f, .5f, M);
    List<String> heard = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            heard.add("begin " + c.self().index() + "-" + c.other().index());
          }

          @Override
          public void end(Collision<String> c) {
            heard.add("end " + c.self().index() + "-" + c.other().index());
          }
        });
    w.step(DT);
    assertEquals(List.of("begin 0-2", "begin 1-2"), heard);
    heard.clear();
    untilAsleep(w);
    steps(w, 30);
    List<String> inside = new ArrayList<>();
    gate.forEachOverlap(o -> inside.add(o.user()));
    b.forEachOverlap(o -> inside.add(o.user()));
    assertEquals(List.of("box", "gate"), inside);
    b.wake();
    steps(w, 3);
    untilAsleep(w);
    assertEquals(List.of(), heard);
    gate.setPose(20, 0, 0);
    w.step(DT);
    assertEquals(List.of("end 1-2"), heard);
  }

  @Test
  void contactsOfSleepersAreThoseOfTheirLastStep() {
    World<String> w = Scenes.stack(3);
    String before = "";
    while (w.body(1).awake()) {
      w.step(DT);
      before = contactsOf(w.body(0)) + contactsOf(w.body(1)) + contactsOf(w.body(3));
    }
    int[] points = new int[2];
    w.forEachContact((x, y, nx, ny, s, impulse) -> points[0]++);
    steps(w, 10);
    w.forEachContact((x, y, nx, ny, s, impulse) -> points[1]++);
    assertEquals(before, contactsOf(w.body(0)) + contactsOf(w.body(1)) + contactsOf(w.body(3)));
    assertEquals(6, points[0]);
    assertEquals(6, points[1]);
    w.body(2).wake();
    assertEquals(before, contactsOf(w.body(0)) + contactsOf(w.body(1)) + contactsOf(w.body(3)));
  }

  @Test
  void sleepChangesNoRestingPlace() {
    World<String> on = Scenes.pyramid(8);
    World<String> off = Scenes.pyramid(8, new WorldDef().withSleeping(false));
    untilAsleep(on);
    steps(off, 600);
    for (int i = 0; i < on.slotCount(); i++) {
      assertEquals(off.body(i).x(), on.body(i).x(), .01f, "box " + i);
      assertEquals(off.body(i).y(), on.body(i).y(), .01f, "box " + i);
      assertEquals(off.body(i).angle(), on.body(i).angle(), 5e-3f, "box " + i);
    }
  }

  @Test
  void steadyStepsWithSleepersAllocateNothing() {
    World<String> w = sleepingStack(5);
    Body<String> ball = disc(w, 20, 10, .5f, new Material(1, 0, 1));
    ball.setSleepAllowed(false);
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) java.lang.management.ManagementFactory.getThreadMXBean();
    for (int i = 0; i < 2000; i++) {
      stepAndPoke(w, i);
    }
    long before = threads.getCurrentThreadAllocatedBytes();
    for (int i = 0; i < 600; i++) {
      stepAndPoke(w, i);
    }
    long bytes = threads.getCurrentThreadAllocatedBytes() - before;
    assertTrue(bytes < 2000, "bytes=" + bytes);
  }

  private static void stepAndPoke(World<String> w, int i) {
    if (i % 100 == 0) {
      w.body(3).wake();
    }
    w.body(1).forEachContact((other, nx, ny, impulse) -> {});
    w.step(DT);
  }
}
