package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.threads.WorkerThreads;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** What a listener sets for one contact acts there, in that step, and leaves nothing behind. */
final class ContactOverrideTest {
  private static CollisionListener<String> preSolve(Consumer<Collision<String>> what) {
    return new CollisionListener<>() {
      @Override
      public boolean preSolve(Collision<String> c) {
        what.accept(c);
        return true;
      }
    };
  }

  @Test
  void frictionSetForAContactHoldsWhatWouldSlide() {
    World<String> w = new World<>(new WorldDef().withGravity(5, -10));
    w.createBody(Scenes.floorDef(Material.DEFAULT.withFriction(.1f)), "floor");
    Body<String> held = Scenes.box(w, 0, .2f, .5f, .2f, Material.DEFAULT.withFriction(.1f));
    Body<String> slides = Scenes.box(w, 5, .2f, .5f, .2f, Material.DEFAULT.withFriction(.1f));
    w.listener(
        preSolve(
            c -> {
              if (c.other() == held) {
                c.setFriction(2);
              }
            }));
    steps(w, 120);
    assertEquals(0, held.x(), .05f);
    // a = 5 - 0.1 * 10
    assertEquals(5 + .5f * 4 * 4, slides.x(), .1f);
    w.listener(null);
    held.wake();
    float before = held.x();
    steps(w, 60);
    assertTrue(held.x() - before > 1, "x=" + held.x() + ": without a listener it slides, too");
  }

  @Test
  void restitutionSetForAContactThrowsBack() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> ball = Scenes.disc(w, 0, 3, .5f, Material.DEFAULT);
    float[] highest = {0};
    boolean[] bounced = {false};
    w.listener(
        preSolve(
            c -> {
              assertEquals(0, c.restitution(), "each step begins with that of the shapes");
              c.setRestitution(1);
              assertEquals(1, c.restitution());
              bounced[0] = true;
            }));
    for (int i = 0; i < 90; i++) {
      w.step(DT);
      highest[0] = bounced[0] ? Math.max(highest[0], ball.y()) : 0;
    }
    assertEquals(3, highest[0], .1f);
  }

  @Test
  void tangentSpeedDrivesToTheRightWhicheverBodyIsSelf() {
    for (boolean floorFirst : new boolean[] {true, false}) {
      World<String> w = new World<>(new WorldDef());
      if (floorFirst) {
        w.createBody(Scenes.floorDef(Material.DEFAULT), "floor");
      }
      Body<String> box = Scenes.box(w, 0, .2f, .5f, .2f, Material.DEFAULT);
      if (!floorFirst) {
        w.createBody(Scenes.floorDef(Material.DEFAULT), "floor");
      }
      w.listener(preSolve(c -> c.setTangentSpeed(2)));
      steps(w, 120);
      assertEquals(2, box.velocityX(), .01f, "floorFirst=" + floorFirst);
    }
  }

  private static World<String> pile(CollisionListener<String> listener) {
    World<String> w = Scenes.pile(60, 3);
    w.listener(listener);
    return w;
  }

  private static final CollisionListener<String> ICE =
      preSolve(
          c -> {
            if ((c.self().index() + c.other().index()) % 3 == 0) {
              c.setFriction(0);
              c.setRestitution(.5f);
              c.setTangentSpeed(1);
            }
          });

  @Test
  void aRestoredAndACopiedWorldGoOnAlike() {
    World<String> w = pile(ICE);
    steps(w, 50);
    WorldState s = w.save(null);
    List<Long> hashes = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      w.step(DT);
      w.save(null); // shares the arrays that the next step's overrides write
      hashes.add(w.stateHash());
    }
    w.restore(s);
    for (long hash : hashes) {
      w.step(DT);
      assertEquals(hash, w.stateHash());
    }
  }

  @Test
  void workersChangeNoBit() {
    try (WorkerThreads workers = new WorkerThreads(2)) {
      World<String> one = Scenes.pile(800, 3);
      World<String> two = Scenes.pile(800, 3);
      two.workers(workers);
      one.listener(ICE);
      two.listener(ICE);
      for (int i = 0; i < 60; i++) {
        one.step(DT);
        two.step(DT);
        assertEquals(one.stateHash(), two.stateHash(), "tick=" + i);
      }
    }
  }

  @Test
  void settingWhatTheShapesHaveChangesNoBit() {
    World<String> plain = pile(null);
    World<String> set =
        pile(
            preSolve(
                c -> {
                  c.setFriction(c.friction());
                  c.setRestitution(c.restitution());
                  c.setTangentSpeed(c.tangentSpeed());
                }));
    for (int i = 0; i < 100; i++) {
      plain.step(DT);
      set.step(DT);
      assertEquals(plain.stateHash(), set.stateHash(), "tick=" + i);
    }
  }

  @Test
  void postSolveSeesWhatActed() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Scenes.box(w, 0, .5f, .5f, .5f, Material.DEFAULT);
    float[] seen = new float[2];
    w.listener(
        new CollisionListener<>() {
          @Override
          public boolean preSolve(Collision<String> c) {
            c.setFriction(.25f);
            return true;
          }

          @Override
          public void postSolve(Collision<String> c) {
            seen[0] = c.friction();
          }
        });
    w.step(DT);
    assertEquals(.25f, seen[0]);
  }

  @Test
  void otherMomentsAndBadNumbersAreRefusedByName() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Scenes.box(w, 0, .5f, .5f, .5f, Material.DEFAULT);
    List<String> told = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            told.add(message(IllegalStateException.class, () -> c.setFriction(1)));
          }

          @Override
          public boolean preSolve(Collision<String> c) {
            told.add(message(IllegalArgumentException.class, () -> c.setFriction(-1)));
            told.add(message(IllegalArgumentException.class, () -> c.setRestitution(3)));
            told.add(message(IllegalArgumentException.class, () -> c.setTangentSpeed(Float.NaN)));
            return true;
          }

          @Override
          public void postSolve(Collision<String> c) {
            told.add(message(IllegalStateException.class, () -> c.setTangentSpeed(1)));
          }
        });
    w.step(DT);
    assertEquals("setFriction is possible in preSolve only", told.get(0));
    assertTrue(told.get(1).startsWith("friction=-1.0 is outside 0.0..100.0"), told.get(1));
    assertTrue(told.get(2).startsWith("restitution=3.0 is outside 0.0..2.0"), told.get(2));
    assertTrue(told.get(3).startsWith("tangentSpeed=NaN"), told.get(3));
    assertEquals("setTangentSpeed is possible in preSolve only", told.get(4));
  }

  private static String message(Class<? extends RuntimeException> type, Runnable call) {
    return assertThrows(type, call::run).getMessage();
  }
}
