package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Scenes.Rng;
import carom.physics.geometry.Box;
import carom.physics.geometry.Chain;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Continuous collision depends on the state alone, is part of it, and allocates nothing. */
final class ContinuousStateTest {
  /** Bullets, plates and stirring paddles in a room. */
  private static World<String> storm() {
    World<String> w = new World<>(new WorldDef());
    w.createBody(new BodyDef().shape(Chain.loop(-8, -8, 8, -8, 8, 8, -8, 8)), "room");
    w.createBody(
        new BodyDef(BodyType.KINEMATIC)
            .shape(new Box(3, .05f))
            .shape(new Box(.05f, 3))
            .angularVelocity(30),
        "paddle");
    Rng r = new Rng(3);
    for (int i = 0; i < 120; i++) {
      w.createBody(
          new BodyDef(BodyType.DYNAMIC)
              .shape(
                  ContinuousTest.Missile.values()[i % ContinuousTest.Missile.values().length].shape,
                  new Material(1, .2f, i % 3 == 0 ? .9f : 0))
              .position(-7 + .9f * (i % 16), 3.5f + .5f * Math.floorDiv(i, 16))
              .velocity(r.in(-400, 400), r.in(-400, 400))
              .angularVelocity(r.in(-100, 100))
              .bullet(i % 2 == 0),
          "b" + i);
    }
    return w;
  }

  @Test
  void resultsDependOnTheStateAlone() {
    World<String> w = storm();
    World<String> watched = storm();
    WorldState start = w.save(null);
    List<Long> hashes = new ArrayList<>();
    WorldState middle = null;
    for (int i = 0; i < 120; i++) {
      w.step(DT);
      hashes.add(w.stateHash());
      watched.queryAabb(-1, -1, 1, 1, b -> true);
      watched.step(DT);
      assertEquals(w.stateHash(), watched.stateHash(), "queries make new boxes, tick=" + i);
      middle = i == 60 ? w.save(null) : middle;
    }
    w.restore(middle);
    for (int i = 61; i < 120; i++) {
      w.step(DT);
      assertEquals(hashes.get(i), w.stateHash(), "restored in the middle, tick=" + i);
    }
    w.createBody(new BodyDef().shape(new Box(1, 1)), "more");
    w.restore(start);
    for (int i = 0; i < 120; i++) {
      w.step(DT);
      assertEquals(hashes.get(i), w.stateHash(), "restored, tick=" + i);
    }
  }

  @Test
  void theFlagIsPartOfTheState() {
    World<String> w = Scenes.space();
    Body<String> b = Scenes.disc(w, 0, 0, .1f, Material.DEFAULT);
    long before = w.stateHash();
    WorldState s = w.save(null);
    b.setBullet(true);
    assertTrue(b.isBullet() && w.stateHash() != before);
    w.restore(s);
    assertEquals(before, w.stateHash());
    assertTrue(!b.isBullet());
  }

  @Test
  void sweepingAllocatesNothing() {
    World<String> w = storm();
    for (int i = 0; i < 6; i++) {
      w.forEachBody(b -> b.setVelocity(b.velocityX() * 3, b.velocityY() * 3));
      steps(w, 60);
    }
    var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    long least = Long.MAX_VALUE;
    for (int i = 0; i < 5; i++) {
      w.forEachBody(b -> b.setVelocity(b.velocityX() * 3, b.velocityY() * 3));
      long before = threads.getCurrentThreadAllocatedBytes();
      steps(w, 20);
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertTrue(least < 100, "bytes=" + least);
  }
}
