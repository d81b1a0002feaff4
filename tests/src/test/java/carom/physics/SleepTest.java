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
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

class SleepTest {
  private static final Material M = new Material(1, .6f, 0);

  /** A stack on a floor, asleep; the floor is body 0, the lowest box body 1. */
  private static World<String> sleepingStack(int boxes) {
    World<String> w = Scenes.floor(M);
    for (int i = 0; i < boxes; i++) {
      box(w, 0, .5f + i, .5f, .5f, M);
    }
    untilAsleep(w);
    return w;
  }

  private static void untilAsleep(World<String> w) {
    for (int i = 0; i < 3000 && (i == 0 || w.profile().awake() > 0); i++) {
      w.step(DT);
    }
    assertEquals(0, w.profile().awake(), "still awake");
  }

  /** A box on a shelf that stands on nothing. */
  private static World<String> shelf(BodyType type) {
    World<String> w = new World<>(new WorldDef());
    w.createBody(new BodyDef(type).shape(new Box(2, .5f), M).position(0, -.5f), "shelf");
    box(w, 0, .5f, .5f, .5f, M);
    untilAsleep(w);
    return w;
  }

  private static String contactsOf(Body<String> body) {
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
  void hitWakesTheWholeStackInTheSameTick() {
    World<String> w = sleepingStack(6);
    Body<String> ball = disc(w, -5, 5.5f, .3f, M);
    ball.setVelocity(20, 0);
    ball.setGravityScale(0);
    Body<String> top = w.body(6);
    for (int i = 0; i < 60 && !top.awake(); i++) {
      assertEquals(0, top.velocityX());
      w.step(DT);
    }
    for (int i = 1; i <= 6; i++) {
      assertTrue(w.body(i).awake(), "box " + i);
    }
    assertTrue(top.velocityX() > .5f || ball.velocityX() == 20, "answered " + top.velocityX());
    steps(w, 2);
    assertTrue(top.velocityX() > .5f, "hit " + top.velocityX());
  }

  @Test
  void lossOfSupportWakes() {
    for (BodyType type : new BodyType[] {BodyType.STATIC, BodyType.KINEMATIC}) {
      wakes(type, "destroyed", w -> w.destroyBody(w.body(0)));
      wakes(type, "moved", w -> w.body(0).setPose(50, 0, 0));
      wakes(type, "lowered", w -> w.body(0).setPose(0, -.51f, 0));
      wakes(type, "disabled", w -> w.body(0).setEnabled(false));
      wakes(type, "filtered out", w -> w.body(0).setFilter(0, Filter.NOTHING));
      wakes(type, "filters out", w -> w.body(1).setFilter(0, Filter.NOTHING));
      wakes(type, "sensor now", w -> w.body(0).setSensor(0, true));
    }
    wakes(BodyType.STATIC, "let go", w -> w.body(0).setType(BodyType.DYNAMIC));
    wakes(BodyType.KINEMATIC, "let go", w -> w.body(0).setType(BodyType.DYNAMIC));
    wakes(BodyType.KINEMATIC, "lowered slowly", w -> w.body(0).setVelocity(0, -.01f));
  }

  private static void wakes(BodyType type, String what, Consumer<World<String>> change) {
    World<String> w = shelf(type);
    Body<String> box = w.body(1);
    float y = box.y();
    change.accept(w);
    steps(w, 30);
    assertTrue(box.awake(), type + " " + what);
    assertTrue(box.y() < y - 2e-3f, type + " " + what + " y=" + box.y());
  }

  @Test
  void kinematicBodyThatStopsAndIsTakenAwayWhileAwakeWakesToo() {
    World<String> w = shelf(BodyType.KINEMATIC);
    w.body(0).wake();
    w.step(DT);
    assertTrue(w.body(0).awake());
    assertFalse(w.body(1).awake(), "nothing happened to it");
    assertTrue(contactsOf(w.body(1)).startsWith("0 -1.0 "), contactsOf(w.body(1)));
    w.destroyBody(w.body(0));
    assertTrue(w.body(1).awake());
    World<String> moved = shelf(BodyType.KINEMATIC);
    moved.body(0).wake();
    moved.step(DT);
    moved.body(0).setPose(0, -.505f, 0);
    moved.step(DT);
    assertTrue(moved.body(1).awake());
  }

  @Test
  void kinematicLiftWakesAndKeepsAwake() {
    World<String> w = shelf(BodyType.KINEMATIC);
    w.body(0).setVelocity(0, .04f);
    steps(w, 120);
    assertTrue(w.body(1).awake());
    assertEquals(.58f, w.body(1).y(), .01f);
    w.body(0).setVelocity(0, 0);
    untilAsleep(w);
  }

  @Test
  void newStaticBodyWakesWhatItOverlaps() {
    World<String> w = sleepingStack(2);
    w.createBody(new BodyDef().shape(new Box(.5f, .5f)).position(3, .5f), "far");
    w.step(DT);
    assertFalse(w.body(1).awake());
    w.createBody(new BodyDef().shape(new Box(.5f, .5f)).position(.9f, .5f), "wall");
    w.step(DT);
    assertTrue(w.body(1).awake());
    steps(w, 60);
    assertTrue(w.body(1).x() < -.05f);
  }

  @Test
  void jointsTieIslandsAndWakeThem() {
    World<String> w = Scenes.floor(M);
    Body<String> a = box(w, 0, .5f, .5f, .5f, M);
    Body<String> b = box(w, 3, .5f, .5f, .5f, M);
    Body<String> hung = disc(w, 10, 3, .25f, M);
    Joint<String> rope = w.createJoint(JointDef.distance(null, hung, 10, 5, 10, 3));
    final Joint<String> rod = w.createJoint(JointDef.distance(a, b, 0, .5f, 3, .5f));
    untilAsleep(w);
    a.applyImpulse(0, .01f);
    assertTrue(b.awake(), "tied by the rod");
    assertFalse(hung.awake());
    untilAsleep(w);
    w.destroyJoint(rod);
    assertTrue(a.awake() && b.awake());
    untilAsleep(w);
    rope.setRest(rope.rest());
    rope.removeLimits();
    assertFalse(hung.awake(), "nothing changed");
    rope.setSpring(5, 1);
    assertTrue(hung.awake());
    untilAsleep(w);
    w.destroyJoint(rope);
    assertTrue(hung.awake());
    steps(w, 60);
    assertTrue(hung.y() < 2);
    untilAsleep(w);
    w.createJoint(JointDef.weld(a, b, 1.5f, .5f));
    assertTrue(a.awake() && b.awake());
    untilAsleep(w);
    w.body(0).setPose(0, -1.5f, 0);
    assertTrue(a.awake() && b.awake() && hung.awake());
  }

  @Test
  void movingKinematicBodyPullsASleeperByItsJoint() {
    World<String> w = new World<>(new WorldDef());
    Body<String> hook = w.createBody(new BodyDef(BodyType.KINEMATIC).position(0, 2), "hook");
    Body<String> load = disc(w, 0, 0, .5f, M);
    w.createJoint(JointDef.distance(hook, load, 0, 2, 0, 0));
    untilAsleep(w);
    hook.setVelocity(0, .02f);
    steps(w, 60);
    assertTrue(load.awake());
    assertEquals(.02f, load.y(), 5e-3f);
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
  void forcesAndVelocitiesWakeButWhatIsSetAlreadyDoesNot() {
    World<String> w = sleepingStack(2);
    Body<String> b = w.body(2);
    b.setVelocity(0, 0);
    b.setAngularVelocity(0);
    b.applyForce(0, 0);
    b.applyImpulse(0, 0, 3, 3);
    b.applyTorque(0);
    b.setPose(b.x(), b.y(), b.cos(), b.sin());
    b.setGravityScale(1);
    assertFalse(b.awake());
    List<Consumer<Body<String>>> pokes = new ArrayList<>();
    pokes.add(x -> x.applyForce(.1f, 0));
    pokes.add(x -> x.applyForce(.1f, 0, 0, 0));
    pokes.add(x -> x.applyImpulse(.001f, 0));
    pokes.add(x -> x.applyImpulse(.001f, 0, 0, 1));
    pokes.add(x -> x.applyTorque(.1f));
    pokes.add(x -> x.applyAngularImpulse(.001f));
    pokes.add(x -> x.setVelocity(.01f, 0));
    pokes.add(x -> x.setAngularVelocity(.01f));
    pokes.add(x -> x.setPose(x.x() + .001f, x.y(), 0));
    pokes.add(x -> x.setGravityScale(1.01f));
    pokes.add(Body::wake);
    for (int i = 0; i < pokes.size(); i++) {
      pokes.get(i).accept(b);
      assertTrue(b.awake() && w.body(1).awake(), "poke " + i);
      untilAsleep(w);
    }
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
  void visitorsMayWakeWhatTheyVisit() {
    World<String> w = sleepingStack(3);
    List<Integer> seen = new ArrayList<>();
    w.body(2)
        .forEachContact(
            (other, nx, ny, impulse) -> {
              other.applyImpulse(1, 0);
              seen.add(other.index());
              other.forEachContact((o, x, y, i) -> o.wake());
            });
    assertEquals(List.of(1, 3), seen);
    assertTrue(w.body(2).awake());
  }

  @Test
  void callbacksMayWakeAndPutToSleep() {
    World<String> w = sleepingStack(1);
    Body<String> sleeper = w.body(1);
    Body<String> ball = disc(w, 10, 2, .5f, M);
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            sleeper.applyImpulse(0, 3);
            assertFalse(sleeper.awake(), "takes effect at the end of the step");
          }

          @Override
          public void postSolve(Collision<String> c) {
            if (c.other() == ball) {
              ball.sleep();
            }
          }
        });
    float y = sleeper.y();
    for (int i = 0; i < 120 && !sleeper.awake(); i++) {
      w.step(DT);
    }
    assertFalse(ball.awake());
    assertEquals(y, sleeper.y());
    w.listener(null);
    w.step(DT);
    assertTrue(sleeper.velocityY() > 2.5f);
  }

  @Test
  void sleeperBehindAVetoWakesWhenTheVetoEnds() {
    World<String> w = new World<>(new WorldDef().withGravity(0, 0));
    Body<String> a = disc(w, 0, 0, .5f, M);
    Body<String> b = disc(w, .8f, 0, .5f, M);
    boolean[] solid = new boolean[1];
    w.listener(
        new CollisionListener<>() {
          @Override
          public boolean preSolve(Collision<String> c) {
            return solid[0];
          }
        });
    a.setSleepAllowed(false);
    steps(w, 60);
    assertFalse(b.awake());
    assertTrue(a.awake());
    solid[0] = true;
    w.step(DT);
    assertTrue(b.awake());
    assertEquals(0, a.velocityX(), "held back for a step");
    steps(w, 30);
    assertTrue(a.x() < -.02f && b.x() > .82f);
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
    long before = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
    for (int i = 0; i < 600; i++) {
      stepAndPoke(w, i);
    }
    long bytes = threads.getThreadAllocatedBytes(Thread.currentThread().getId()) - before;
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
