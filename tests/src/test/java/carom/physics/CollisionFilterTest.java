package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.threads.WorkerThreads;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A program's own rule of which shapes meet. */
final class CollisionFilterTest {
  private static final CollisionFilter<String> NO_DISCS =
      (self, i, other, j) -> !self.user().equals("disc") || !other.user().equals("disc");

  private static List<String> told(World<String> w) {
    List<String> told = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            told.add("begin " + c.self().index() + " " + c.other().index());
          }

          @Override
          public void end(Collision<String> c) {
            told.add("end " + c.self().index() + " " + c.other().index());
          }
        });
    return told;
  }

  @Test
  void refusedShapesPassThroughAndOthersDoNot() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    w.collisionFilter(NO_DISCS);
    Body<String> low = Scenes.disc(w, 0, .5f, .5f, Material.DEFAULT);
    Body<String> high = Scenes.disc(w, 0, 3, .5f, Material.DEFAULT);
    Body<String> box = Scenes.box(w, 0, 6, .5f, .5f, Material.DEFAULT);
    List<String> told = told(w);
    steps(w, 120);
    assertEquals(.5, low.y(), .01);
    assertEquals(.5, high.y(), .01);
    assertTrue(box.y() > 1.2f, "the box lies on them: y=" + box.y());
    assertFalse(told.contains("begin " + low.index() + " " + high.index()), told.toString());
  }

  @Test
  void itIsAskedAboutShapesInTheOrderOfTheBodiesOnTheSteppingThread() {
    World<String> w = new World<>(new WorldDef());
    Body<String> upper =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Circle(.5f))
                .shape(new Box(.2f, .2f, 2, 0))
                .position(0, .5f),
            "upper");
    Body<String> floor = w.createBody(Scenes.floorDef(Material.DEFAULT), "floor");
    Thread thread = Thread.currentThread();
    List<Integer> shapes = new ArrayList<>();
    w.collisionFilter(
        (self, i, other, j) -> {
          assertSame(thread, Thread.currentThread());
          assertSame(upper, self);
          assertSame(floor, other);
          assertEquals(0, j);
          shapes.add(i);
          return i == 1;
        });
    steps(w, 60);
    assertTrue(shapes.contains(0) && shapes.contains(1), shapes.toString());
    assertTrue(upper.y() < .3f, "only the box holds it: y=" + upper.y());
  }

  @Test
  void refilterEndsAndBeginsContactsInTheNextStep() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> a = Scenes.disc(w, 0, .5f, .5f, Material.DEFAULT);
    Body<String> b = Scenes.disc(w, 0, 1.5f, .5f, Material.DEFAULT);
    boolean[] together = {true};
    w.collisionFilter((self, i, other, j) -> together[0] || self.user().equals("floor"));
    List<String> told = told(w);
    steps(w, 300);
    String pair = " " + a.index() + " " + b.index();
    assertTrue(told.contains("begin" + pair), told.toString());
    assertFalse(a.awake(), "they sleep");
    told.clear();

    together[0] = false;
    steps(w, 10);
    assertTrue(told.isEmpty(), "nobody asked again: " + told);
    b.refilter();
    assertTrue(a.awake());
    w.step(DT);
    assertEquals(List.of("end" + pair), told);
    steps(w, 60);
    assertEquals(.5, b.y(), .01);

    told.clear();
    together[0] = true;
    a.refilter();
    w.step(DT);
    assertEquals(List.of("begin" + pair), told);
  }

  @Test
  void aFilterSetOnARunningWorldWakesAndAsksAboutAllPairs() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> low = Scenes.disc(w, 0, .5f, .5f, Material.DEFAULT);
    Body<String> high = Scenes.disc(w, 0, 1.5f, .5f, Material.DEFAULT);
    steps(w, 300);
    assertFalse(high.awake());
    w.collisionFilter(NO_DISCS);
    steps(w, 120);
    assertEquals(.5, high.y(), .01);
    w.collisionFilter(null);
    steps(w, 60);
    double apart = Math.hypot(high.x() - low.x(), high.y() - low.y());
    assertTrue(apart > .9, "pushed apart: " + apart);
  }

  @Test
  void sensorsAndBulletsObey() {
    World<String> w = new World<>(new WorldDef().withGravity(0, 0));
    w.collisionFilter((self, i, other, j) -> !self.user().equals("ghost"));
    w.createBody(
        new BodyDef().shape(new ShapeDef(new Box(1, 5)).withSensor(true)).position(-5, 0), "ghost");
    w.createBody(new BodyDef().shape(new Box(.05f, 5)), "ghost");
    w.createBody(new BodyDef().shape(new Box(.05f, 5)).position(20, 0), "wall");
    List<String> told = told(w);
    Body<String> bullet =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Circle(.1f))
                .position(-10, 0)
                .velocity(400, 0)
                .bullet(true),
            "bullet");
    steps(w, 60);
    assertTrue(bullet.x() < 20, "the wall stops it: x=" + bullet.x());
    assertEquals(List.of("begin 2 3"), told.stream().distinct().limit(1).toList());
    assertFalse(told.contains("begin 0 3"), told.toString());
  }

  @Test
  void aConstantAnswerGivesTheSameBitsAfterRestoringAndWithWorkers() {
    CollisionFilter<String> some = (self, i, other, j) -> (self.index() + other.index()) % 5 > 0;
    try (WorkerThreads workers = new WorkerThreads(2)) {
      World<String> w = Scenes.pile(800, 9);
      World<String> shared = Scenes.pile(800, 9);
      shared.workers(workers);
      w.collisionFilter(some);
      shared.collisionFilter(some);
      steps(w, 40);
      steps(shared, 40);
      WorldState s = w.save(null);
      List<Long> hashes = new ArrayList<>();
      for (int i = 0; i < 30; i++) {
        w.step(DT);
        shared.step(DT);
        hashes.add(w.stateHash());
        assertEquals(w.stateHash(), shared.stateHash(), "tick=" + i);
      }
      w.restore(s);
      for (long hash : hashes) {
        w.step(DT);
        assertEquals(hash, w.stateHash());
      }
    }
  }

  @Test
  void aFilterOfAlwaysYesChangesNoBit() {
    World<String> plain = Scenes.pile(60, 4);
    World<String> asked = Scenes.pile(60, 4);
    asked.collisionFilter((self, i, other, j) -> true);
    for (int i = 0; i < 120; i++) {
      plain.step(DT);
      asked.step(DT);
      assertEquals(plain.stateHash(), asked.stateHash(), "tick=" + i);
    }
  }

  @Test
  void aFilterThatChangesTheWorldIsRefused() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Scenes.disc(w, 0, .5f, .5f, Material.DEFAULT);
    w.collisionFilter(
        (self, i, other, j) -> {
          String message =
              assertThrows(IllegalStateException.class, () -> w.destroyBody(other)).getMessage();
          assertEquals(
              "destroyBody is not possible while a query or a collision filter runs; remember what"
                  + " it finds, and change the world afterwards",
              message);
          assertThrows(IllegalStateException.class, () -> w.bodyAt(0, 0));
          assertThrows(IllegalStateException.class, other::refilter);
          return true;
        });
    w.step(DT);
    assertEquals(2, w.bodyCount());
  }
}
