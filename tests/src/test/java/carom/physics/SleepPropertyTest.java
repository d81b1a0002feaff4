package carom.physics;

import static carom.physics.Scenes.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.dynamics.Dynamics;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.math.Aabb;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Random pokes at worlds that fall asleep and wake. */
class SleepPropertyTest {
  private static final int BODIES = 40;

  /** Stacks, a bridge of joints, a lift, a sensor and a platform that is open now and then. */
  private static World<String> world() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    w.createBody(new BodyDef(BodyType.KINEMATIC).shape(new Box(2, .2f)).position(-8, .3f), "lift");
    w.createBody(
        new BodyDef()
            .shape(new ShapeDef(new Box(2, 1), Material.DEFAULT).withSensor(true))
            .position(0, 1),
        "gate");
    w.createBody(new BodyDef().shape(new Box(2, .2f)).position(6, 2), "shelf");
    for (int i = 0; i < BODIES; i++) {
      BodyDef d =
          new BodyDef(BodyType.DYNAMIC)
              .position(-8 + (i % 8) * 2.1f, .6f + Math.floorDiv(i, 8) * 1.05f);
      w.createBody(i % 3 == 0 ? d.shape(new Circle(.5f)) : d.shape(new Box(.5f, .5f)), "b" + i);
    }
    for (int i = 0; i < 3; i++) {
      w.createJoint(JointDef.weld(w.body(36 + i), w.body(37 + i), 0, 5));
    }
    w.listener(new Platform());
    return w;
  }

  /** Lets the shelf through for some ticks; depends on the world's state alone. */
  private static final class Platform implements CollisionListener<String> {
    @Override
    public boolean preSolve(Collision<String> c) {
      Body<String> shelf = c.self().user().equals("shelf") ? c.self() : c.other();
      return !shelf.user().equals("shelf") || shelf.x() > 5.5f;
    }
  }

  /** One random change of the world, decided by the generator alone. */
  private static void poke(World<String> w, Scenes.Rng r) {
    Body<String> b = w.body(1 + r.below(w.slotCount() - 1));
    if (b == null) {
      return;
    }
    switch (r.below(16)) {
      case 0 -> b.applyImpulse(r.in(-3, 3), r.in(-3, 3));
      case 1 -> b.setPose(r.in(-9, 9), r.in(1, 6), r.in(-3, 3));
      case 2 -> b.setVelocity(r.in(-3, 3), r.in(-3, 3));
      case 3 -> b.setEnabled(!b.isEnabled());
      case 4 -> {
        if (b.user().startsWith("b")) {
          b.setType(BodyType.values()[r.below(3)]);
        }
      }
      case 5 -> b.sleep();
      case 6 -> b.wake();
      case 7 -> w.body(1).setVelocity(0, r.in(-.2f, .2f));
      case 8 -> w.body(1).setVelocity(0, 0);
      case 9 -> w.body(1).setPose(-8 + r.in(-1, 1), r.in(0, .5f), 0);
      case 10 -> w.body(3).setPose(6 - r.below(2), 2, 0);
      case 11 -> b.setSleepAllowed(r.below(4) > 0);
      case 12 -> w.body(2).setPose(r.in(-5, 5), 1, 0);
      case 13 -> {
        Joint<String> joint = w.joint(r.below(3));
        if (joint != null) {
          w.destroyJoint(joint);
        } else {
          Body<String> other = w.body(4 + r.below(BODIES));
          if (other != null && other != b) {
            w.createJoint(JointDef.distance(b, other, b.x(), b.y(), other.x(), other.y()));
          }
        }
      }
      case 14 -> {
        if (b.user().startsWith("b")) {
          w.destroyBody(b);
        }
      }
      default ->
          w.createBody(
              new BodyDef(BodyType.DYNAMIC)
                  .shape(new Circle(.4f))
                  .position(r.in(-9, 9), r.in(1, 6))
                  .awake(r.below(2) == 0),
              "bnew");
    }
  }

  /** What must hold between steps. */
  private static void check(World<String> w, String when) {
    Dynamics d = w.dynamics();
    BodyStore s = d.bodies();
    int awake = 0;
    for (int i = 0; i < s.slots(); i++) {
      Body<String> b = w.body(i);
      if (b == null) {
        continue;
      }
      awake += b.awake() ? 1 : 0;
      if (s.asleep(i)) {
        assertEquals(0, s.vx[i], when);
        assertEquals(0, s.vy[i], when);
        assertEquals(0, s.w[i], when);
        assertFalse(s.disabled(i) || s.type[i] == BodyStore.STATIC, when);
      }
      if (b.isEnabled()) {
        Aabb box = new Aabb();
        b.aabb(box);
        boolean[] found = new boolean[1];
        w.queryAabb(
            box.minX,
            box.minY,
            box.maxX,
            box.maxY,
            o -> {
              found[0] |= o == b;
              return true;
            });
        assertTrue(found[0], when + " not found " + b);
      }
    }
    assertEquals(awake, w.profile().awake(), when);
    ContactTable asleep = d.sleepingContacts();
    for (int row = 0; row < asleep.count(); row++) {
      if (!asleep.unused(row)) {
        Body<String> a = w.body(asleep.bodyA(row));
        Body<String> b = w.body(asleep.bodyB(row));
        assertFalse(a.awake() || b.awake(), when + " row of somebody awake: " + a + b);
      }
    }
  }

  /** After a step, nothing awake that moves leans on a sleeper, vetoes apart. */
  private static void checkTouching(World<String> w, String when) {
    Dynamics d = w.dynamics();
    ContactTable rows = d.contacts();
    for (int row = 0; row < rows.count(); row++) {
      Body<String> a = w.body(rows.bodyA(row));
      Body<String> b = w.body(rows.bodyB(row));
      assertTrue(
          !d.contacts().touches(row) || a.awake() || b.awake(),
          when + " row of nobody awake: " + a + b);
      if (rows.touches(row)
          && !rows.sensor(row)
          && a.type() == BodyType.DYNAMIC
          && b.type() == BodyType.DYNAMIC) {
        assertEquals(a.awake(), b.awake(), when + " " + a + b);
      }
    }
  }

  @Test
  void treesListsAndContactsAgreeWhateverHappens() {
    for (long seed = 1; seed <= 12; seed++) {
      Scenes.Rng r = new Scenes.Rng(seed);
      World<String> w = world();
      for (int i = 0; i < 600; i++) {
        String when = "seed=" + seed + " step=" + i;
        if (r.below(20) == 0) {
          poke(w, r);
          check(w, when + " poked");
        }
        w.step(DT);
        check(w, when);
        checkTouching(w, when);
      }
    }
  }

  @Test
  void savedAtAnyTickItGoesOnAsItDid() {
    for (long seed = 1; seed <= 10; seed++) {
      World<String> w = world();
      Scenes.Rng r = new Scenes.Rng(seed * 77);
      int warm = r.below(120);
      for (int i = 0; i < warm; i++) {
        w.step(DT);
      }
      WorldState state = null;
      for (int round = 0; round < 6; round++) {
        long pokes = seed * 1000 + round;
        int steps = 20 + r.below(80);
        state = w.save(state);
        long[] first = run(w, pokes, steps);
        w.restore(state);
        long[] again = run(w, pokes, steps);
        assertTrue(
            Arrays.equals(first, again),
            "seed=" + seed + " round=" + round + " step=" + Arrays.mismatch(first, again));
      }
    }
  }

  private static long[] run(World<String> w, long seed, int steps) {
    Scenes.Rng r = new Scenes.Rng(seed);
    long[] hashes = new long[steps];
    for (int i = 0; i < steps; i++) {
      if (r.below(12) == 0) {
        poke(w, r);
      }
      w.step(DT);
      hashes[i] = w.stateHash();
    }
    return hashes;
  }

  @Test
  void savingAndRestoringOnTheWayChangesNothing() {
    for (long seed = 1; seed <= 6; seed++) {
      World<String> calm = world();
      World<String> busy = world();
      Scenes.Rng pokes = new Scenes.Rng(seed);
      Scenes.Rng samePokes = new Scenes.Rng(seed);
      Scenes.Rng detours = new Scenes.Rng(seed + 100);
      WorldState state = null;
      List<String> trace = new ArrayList<>();
      for (int i = 0; i < 400; i++) {
        if (i % 25 == 24) {
          poke(calm, pokes);
          poke(busy, samePokes);
        }
        if (detours.below(15) == 0) {
          state = busy.save(state);
          run(busy, detours.below(1000), detours.below(60));
          busy.restore(state);
          trace.add("" + i);
        }
        calm.step(DT);
        busy.step(DT);
        assertEquals(
            calm.stateHash(), busy.stateHash(), "seed=" + seed + " step=" + i + " " + trace);
      }
    }
  }
}
