package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.disc;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Bodies that change their type, leave the simulation and come back, or jump. */
final class BodyChangeTest {
  private static final Material M = Material.DEFAULT;

  private static List<String> listen(World<String> w) {
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
    return heard;
  }

  @Test
  void disabledBodyIsNotThereUntilItIsEnabled() {
    World<String> w = Scenes.floor(M);
    Body<String> low = box(w, 0, .5f, .5f, .5f, M);
    Body<String> high = box(w, 0, 1.5f, .5f, .5f, M);
    List<String> heard = listen(w);
    steps(w, 30);
    low.setEnabled(false);
    assertFalse(low.isEnabled());
    assertNull(w.bodyAt(0, .4f));
    low.applyImpulse(100, 0);
    w.step(DT);
    assertEquals(List.of("begin 0-1", "begin 1-2", "end 0-1", "end 1-2"), heard);
    steps(w, 60);
    assertEquals(.5, high.y(), .01, "fell through");
    assertEquals(.5, low.y(), .01);
    assertEquals(0, low.velocityX(), 1e-3);
    low.setPose(5, 3, 0);
    low.setEnabled(true);
    assertSame(low, w.bodyAt(5, 3));
    steps(w, 120);
    assertEquals(5, low.x(), .01);
    assertEquals(.5, low.y(), .01);
    assertTrue(low.isEnabled());
  }

  @Test
  void disabledFloorLetsEverythingFallAndHoldsAgain() {
    World<String> w = Scenes.floor(M);
    Body<String> b = box(w, 0, .5f, .5f, .5f, M);
    steps(w, 10);
    w.body(0).setEnabled(false);
    steps(w, 10);
    assertTrue(b.velocityY() < -1.5);
    w.body(0).setEnabled(true);
    steps(w, 240);
    assertEquals(0, b.velocityY(), .01);
    assertEquals(.5, b.y(), .02);
  }

  @Test
  void jointsOfDisabledBodiesAreIdle() {
    World<String> w = new World<>(new WorldDef());
    Body<String> a = disc(w, 0, 0, .25f, M);
    Body<String> b = disc(w, 0, -2, .25f, M);
    w.createJoint(JointDef.revolute(null, a, 0, 0));
    Joint<String> j = w.createJoint(JointDef.distance(a, b, 0, 0, 0, -2));
    steps(w, 30);
    assertTrue(j.forceY() > 1);
    a.setEnabled(false);
    steps(w, 30);
    assertEquals(-5, b.velocityY(), .05);
    assertEquals(0, j.forceY());
    assertEquals(0, a.y(), .01);
    a.setEnabled(true);
    b.setPose(0, -2, 0);
    b.setVelocity(0, 0);
    steps(w, 60);
    assertEquals(-2, b.y(), .02);
  }

  /** The origin and its velocity stay, whatever happens to the centre of mass. */
  @Test
  void typeChangesKeepOriginAndVelocity() {
    World<String> w = Scenes.space();
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.KINEMATIC)
                .shape(new Box(.5f, .5f, 2, 0), M.withDensity(3))
                .position(1, 1)
                .angle(1)
                .velocity(1, 2)
                .angularVelocity(3),
            "b");
    assertEquals(0, b.mass());
    b.setType(BodyType.DYNAMIC);
    assertSame(BodyType.DYNAMIC, b.type());
    assertEquals(3, b.mass(), 1e-5);
    assertEquals(1, b.x(), 1e-6);
    assertEquals(1, b.y(), 1e-6);
    assertEquals(1 + 2 * Math.cos(1), b.centerX(), 1e-5);
    assertEquals(1 - 3 * 2 * Math.sin(1), b.velocityX(), 1e-5);
    assertEquals(2 + 3 * 2 * Math.cos(1), b.velocityY(), 1e-5);
    b.setType(BodyType.KINEMATIC);
    assertEquals(1, b.velocityX(), 1e-5);
    assertEquals(2, b.velocityY(), 1e-5);
    assertEquals(3, b.angularVelocity());
    assertEquals(1, b.centerX(), 1e-6);
    b.setType(BodyType.STATIC);
    assertEquals(0, b.velocityX());
    b.setVelocity(5, 5);
    steps(w, 10);
    assertEquals(1, b.x(), 1e-6);
  }

  @Test
  void brickOfAWallFallsWhenItBecomesDynamic() {
    World<String> w = Scenes.floor(M);
    Body<String> brick = w.createBody(new BodyDef().shape(new Box(.5f, .5f)).position(0, 3), "b");
    Body<String> top = disc(w, 0, 4, .5f, M);
    List<String> heard = listen(w);
    steps(w, 30);
    assertEquals(4, top.y(), .01);
    brick.setType(BodyType.DYNAMIC);
    steps(w, 120);
    assertEquals(.5, brick.y(), .02);
    assertEquals(List.of("begin 1-2", "begin 0-1"), heard.subList(0, 2));
    brick.setType(BodyType.STATIC);
    float y = brick.y();
    brick.applyImpulse(50, 50);
    steps(w, 60);
    assertEquals(y, brick.y(), 1e-6);
    assertTrue(heard.contains("end 0-1"), "static bodies don't touch each other");
  }

  @Test
  void changesInCallbacksWaitForTheEndOfTheStep() {
    World<String> w = Scenes.floor(M);
    Body<String> a = disc(w, 0, .5f, .5f, M);
    Body<String> b = disc(w, 3, .5f, .5f, M);
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            if (c.other() == a) {
              a.setEnabled(false);
              assertTrue(a.isEnabled());
            } else {
              b.setType(BodyType.STATIC);
              assertSame(BodyType.DYNAMIC, b.type());
            }
          }
        });
    w.step(DT);
    assertFalse(a.isEnabled());
    assertSame(BodyType.STATIC, b.type());
    steps(w, 5);
    w.destroyBody(a);
    assertEquals(2, w.bodyCount());
    assertSame(BodyType.DYNAMIC, a.type());
    assertThrows(IllegalStateException.class, () -> a.setEnabled(true));
  }

  @Test
  void massIsNeededToBecomeDynamic() {
    World<String> w = Scenes.space();
    Body<String> b =
        w.createBody(new BodyDef().shape(new Circle(1), M.withDensity(0)), "weightless");
    String message =
        assertThrows(IllegalArgumentException.class, () -> b.setType(BodyType.DYNAMIC))
            .getMessage();
    assertTrue(message.contains("mass=0.0"), message);
    assertSame(BodyType.STATIC, b.type());
  }

  /** A jump ends the old contacts and finds the new ones in the next step. */
  @Test
  void teleportRefreshesContacts() {
    World<String> w = Scenes.floor(M);
    Body<String> shelf = w.createBody(new BodyDef().shape(new Box(1, 1)).position(50, 50), "shelf");
    Body<String> b = box(w, 0, .5f, .5f, .5f, M);
    List<String> heard = listen(w);
    steps(w, 30);
    b.setPose(50, 51.5f, 0);
    w.step(DT);
    assertEquals(List.of("begin 0-2", "end 0-2", "begin 1-2"), heard);
    shelf.setPose(80, 0, 0);
    w.step(DT);
    assertEquals("end 1-2", heard.get(3));
    steps(w, 30);
    assertTrue(b.y() < 50.5);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void restoreContinuesBitForBit(long seed) {
    World<String> w = Scenes.pile(50, seed);
    Scenes.Rng r = new Scenes.Rng(seed);
    WorldState s = null;
    for (int round = 0; round < 8; round++) {
      steps(w, r.below(20));
      s = w.save(s);
      long at = w.stateHash();
      long choice = r.next();
      long[] expected = play(w, choice);
      play(w, r.next());
      w.restore(s);
      assertEquals(at, w.stateHash());
      long[] actual = play(w, choice);
      for (int i = 0; i < expected.length; i++) {
        assertEquals(expected[i], actual[i], "seed=" + seed + " round=" + round + " step=" + i);
      }
    }
  }

  private static long[] play(World<String> w, long choice) {
    Scenes.Rng r = new Scenes.Rng(choice);
    long[] hashes = new long[25];
    BodyType[] types = BodyType.values();
    for (int i = 0; i < hashes.length; i++) {
      Body<String> b = w.body(r.below(w.slotCount()));
      switch (r.below(4)) {
        case 0 -> b.setEnabled(!b.isEnabled());
        case 1 -> b.setType(types[r.below(3)]);
        case 2 -> b.setPose(r.in(-4, 4), r.in(0, 8), r.in(-3, 3));
        default -> {}
      }
      w.step(DT);
      hashes[i] = w.stateHash();
    }
    return hashes;
  }

  @Test
  void hashSeesWhetherABodyIsEnabled() {
    World<String> w = Scenes.stack(2);
    long before = w.stateHash();
    w.body(1).setEnabled(false);
    assertNotEquals(before, w.stateHash());
    w.body(1).setEnabled(true);
    assertEquals(before, w.stateHash());
  }
}
