package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.disc;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What a listener hears, and what it may do. */
final class CallbackTest {
  /** Writes down what it hears. */
  private static class Log implements CollisionListener<String> {
    final List<String> lines = new ArrayList<>();
    double impulse;

    @Override
    public void begin(Collision<String> c) {
      lines.add("begin " + c.self().index() + "-" + c.other().index());
    }

    @Override
    public void end(Collision<String> c) {
      lines.add("end " + c.self().index() + "-" + c.other().index());
    }

    @Override
    public boolean preSolve(Collision<String> c) {
      lines.add("pre " + c.self().index() + "-" + c.other().index());
      return true;
    }

    @Override
    public void postSolve(Collision<String> c) {
      lines.add("post " + c.self().index() + "-" + c.other().index());
      for (int i = 0; i < c.pointCount(); i++) {
        impulse += c.normalImpulse(i);
      }
    }
  }

  @Test
  void callsComeInCanonicalOrder() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    box(w, 3, .5f, .5f, .5f, Material.DEFAULT);
    box(w, 0, .5f, .5f, .5f, Material.DEFAULT);
    Log log = new Log();
    w.listener(log);
    w.step(DT);
    assertEquals(
        List.of("begin 0-1", "pre 0-1", "begin 0-2", "pre 0-2", "post 0-1", "post 0-2"), log.lines);
    log.lines.clear();
    w.body(1).setPose(3, 10, 0);
    w.step(DT);
    assertEquals(List.of("end 0-1", "pre 0-2", "post 0-2"), log.lines);
  }

  @Test
  void restingBodyReceivesItsWeightEachStep() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> b = box(w, 0, .5f, .5f, .5f, new Material(3, .5f, 0));
    b.setSleepAllowed(false);
    steps(w, 120);
    Log log = new Log();
    w.listener(log);
    w.step(DT);
    assertEquals(3 * 10 / 60.0, log.impulse, 1e-3);
    int[] calls = new int[1];
    b.forEachContact(
        (other, nx, ny, impulse) -> {
          calls[0]++;
          assertSame(w.body(0), other);
          assertEquals(-1, ny, 1e-6);
          assertEquals(0.5, impulse, 1e-3);
        });
    assertEquals(1, calls[0]);
    w.body(0).forEachContact((other, nx, ny, impulse) -> assertEquals(1, ny, 1e-6));
  }

  @Test
  void bounceReportsTheMomentumItTurned() {
    World<String> w = Scenes.space();
    Material m = new Material(1, 0, 1);
    w.createBody(new BodyDef().shape(new Box(1, 5), m), null);
    Body<String> b = disc(w, 5, 0, .5f, m);
    b.setVelocity(-6, 0);
    Log log = new Log();
    w.listener(log);
    steps(w, 60);
    assertEquals(6, b.velocityX(), 1e-3);
    assertEquals(2 * 6 * b.mass(), log.impulse, 1e-3);
  }

  @Test
  void vetoLetsBodiesPassInTheSameTick() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> b = disc(w, 0, 3, .5f, Material.DEFAULT);
    w.listener(
        new CollisionListener<>() {
          @Override
          public boolean preSolve(Collision<String> c) {
            return false;
          }
        });
    steps(w, 60);
    assertEquals(-10, b.velocityY(), 1e-2);
    assertTrue(b.y() < -1.5);
  }

  @Test
  void mtvMovesSelfOutOfOther() {
    World<String> w = Scenes.space();
    Body<String> a = box(w, 0, 0, .5f, .5f, Material.DEFAULT);
    Body<String> b = box(w, .9f, .1f, .5f, .5f, Material.DEFAULT);
    int[] calls = new int[1];
    w.listener(
        new CollisionListener<>() {
          @Override
          public boolean preSolve(Collision<String> c) {
            calls[0]++;
            assertSame(a, c.self());
            assertSame(b, c.other());
            assertSame(b, c.other(a));
            assertSame(a.shape(0), c.selfShape());
            assertSame(b.shape(0), c.otherShape());
            assertEquals(-.1, c.mtvX(), 1e-5);
            assertEquals(0, c.mtvY(), 1e-5);
            assertEquals(1, c.normalX(), 1e-6);
            assertEquals(2, c.pointCount());
            assertEquals(.45, c.pointX(0), 0.06);
            return true;
          }
        });
    w.step(DT);
    assertEquals(1, calls[0]);
  }

  @Test
  void bodiesMayBeCreatedAndDestroyedInCallbacks() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> b = disc(w, 0, .5f, .5f, Material.DEFAULT);
    List<Body<String>> made = new ArrayList<>();
    List<String> ends = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            if (made.isEmpty()) {
              made.add(disc(w, 5, 3, .25f, Material.DEFAULT));
              for (int i = 0; i < 100; i++) {
                disc(w, 10 + i, 3, .25f, Material.DEFAULT);
              }
              w.destroyBody(c.other());
              w.destroyBody(c.other());
              assertTrue(c.other().isValid(), "destroyed only at the end of the step");
              assertThrows(IllegalStateException.class, () -> w.step(DT));
              assertThrows(IllegalStateException.class, () -> w.save(null));
            }
          }

          @Override
          public void end(Collision<String> c) {
            ends.add(c.self().index() + "-" + c.other().index());
          }
        });
    w.step(DT);
    assertFalse(b.isValid());
    assertEquals(List.of("0-1"), ends);
    assertThrows(IllegalStateException.class, b::x);
    assertEquals(102, w.bodyCount());
    steps(w, 120);
    assertEquals(.25, made.get(0).y(), 0.02);
  }

  @Test
  void callbacksMayPushBodies() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> b = disc(w, 0, .5f, .5f, Material.DEFAULT);
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            c.other().applyImpulse(0, 5 * c.other().mass());
          }
        });
    w.step(DT);
    assertEquals(5 - 10 / 60.0, b.velocityY(), 1e-3);
  }

  @Test
  void queriesFindBodiesByBoxAndPoint() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> a = disc(w, 0, 5, .5f, Material.DEFAULT);
    disc(w, 3, 5, .5f, Material.DEFAULT);
    List<Integer> found = new ArrayList<>();
    w.queryAabb(-1, -1, 2, 10, b -> found.add(b.index()));
    assertEquals(List.of(0, 1), found);
    assertSame(a, w.bodyAt(0, 5.4f));
    assertEquals(null, w.bodyAt(.45f, 5.45f));
    a.setPose(20, 20, 0);
    assertSame(a, w.bodyAt(20, 20));
    assertThrows(
        IllegalStateException.class,
        () ->
            w.queryAabb(
                -1,
                -1,
                50,
                50,
                b -> {
                  w.destroyBody(b);
                  return true;
                }));
    assertNotNull(w.body(0));
  }

  @Test
  void refusesWhatIsNoNumberAndNamesIt() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> b = disc(w, 0, 5, .5f, Material.DEFAULT);
    refused("x=NaN", () -> b.setPose(Float.NaN, 0, 0));
    refused("x=2.0E7", () -> b.setPose(2e7f, 0, 0));
    refused("velocityY=Infinity", () -> b.setVelocity(0, Float.POSITIVE_INFINITY));
    refused("angularVelocity=200000.0", () -> b.setAngularVelocity(2e5f));
    refused("forceX=NaN", () -> b.applyForce(Float.NaN, 0));
    refused("impulseY=NaN", () -> b.applyImpulse(0, Float.NaN));
    refused("dtSeconds=0.0", () -> w.step(0));
    refused("dtSeconds=0.2", () -> w.step(0.2f));
    refused("density=-1.0", () -> new Material(-1, 0, 0));
    refused("cos=NaN", () -> b.setPose(0, 0, Float.NaN, 0));
    refused("mass=0.0", () -> disc(w, 0, 0, 1, new Material(0, 0, 0)));
    assertEquals(5, b.y());
    w.step(DT);
  }

  private static void refused(String part, Runnable call) {
    String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
    assertTrue(message.contains(part), message);
  }

  @Test
  void brokenBodyInfectsNobody() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> b = disc(w, 0, .5f, .5f, Material.DEFAULT);
    disc(w, 0, 1.5f, .5f, Material.DEFAULT);
    for (int i = 0; i < 20; i++) {
      b.applyForce(1e20f, 1e20f);
      b.applyImpulse(-1e20f, 1e20f);
      b.applyTorque(1e20f);
      w.step(DT);
    }
    steps(w, 60);
    w.forEachBody(
        other -> {
          assertTrue(Math.abs(other.x()) <= 1e7f && Math.abs(other.y()) <= 1e7f, other.toString());
          assertTrue(Math.abs(other.angle()) <= 4);
          assertTrue(Math.abs(other.velocityX()) <= w.def().maxSpeed() + 1);
        });
  }

  @Test
  void handlesOfDestroyedBodiesStayInvalidWhenTheSlotIsUsedAgain() {
    World<String> w = Scenes.space();
    Body<String> a = disc(w, 0, 0, 1, Material.DEFAULT);
    w.destroyBody(a);
    Body<String> b = w.createBody(new BodyDef(BodyType.DYNAMIC).shape(new Circle(1)), "another");
    assertEquals(a.index(), b.index());
    assertFalse(a.isValid());
    assertTrue(b.isValid());
    assertThrows(IllegalStateException.class, () -> w.destroyBody(a));
    assertSame(b, w.body(b.index()));
  }
}
