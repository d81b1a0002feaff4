package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.disc;
import static carom.physics.Scenes.steps;
import static carom.physics.SleepTest.M;
import static carom.physics.SleepTest.contactsOf;
import static carom.physics.SleepTest.sleepingStack;
import static carom.physics.SleepTest.untilAsleep;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** What wakes sleeping bodies: hits, lost support, joints, forces and callbacks. */
class WakeTest {
  /** A box on a shelf that stands on nothing. */
  private static World<String> shelf(BodyType type) {
    World<String> w = new World<>(new WorldDef());
    w.createBody(new BodyDef(type).shape(new Box(2, .5f), M).position(0, -.5f), "shelf");
    box(w, 0, .5f, .5f, .5f, M);
    untilAsleep(w);
    return w;
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
}
