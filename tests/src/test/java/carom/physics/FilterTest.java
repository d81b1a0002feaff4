package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Filters and sensors. */
final class FilterTest {
  private static Body<String> disc(World<String> w, float x, float y, ShapeDef shape) {
    return w.createBody(new BodyDef(BodyType.DYNAMIC).shape(shape).position(x, y), "disc");
  }

  private static ShapeDef shape(Filter filter) {
    return new ShapeDef(new Circle(.5f)).withFilter(filter);
  }

  @Test
  void filtersMeetByGroupElseByCategoryAndMask() {
    Filter ghost = new Filter(2, ~2);
    assertTrue(Filter.DEFAULT.meets(ghost));
    assertFalse(ghost.meets(ghost));
    assertTrue(ghost.withGroup(1).meets(ghost.withGroup(1)));
    assertFalse(ghost.withGroup(1).meets(ghost.withGroup(2)));
    assertFalse(Filter.DEFAULT.withGroup(-1).meets(Filter.DEFAULT.withGroup(-1)));
    assertTrue(Filter.DEFAULT.withGroup(-1).meets(Filter.DEFAULT.withGroup(-2)));
    assertFalse(Filter.NOTHING.meets(Filter.DEFAULT));
    assertFalse(Filter.DEFAULT.meets(Filter.NOTHING));
    Filter oneSided = new Filter(4, 1);
    assertFalse(oneSided.meets(new Filter(1, 2)), "both masks must agree");
    assertThrows(IllegalArgumentException.class, () -> shape(null));
  }

  @Test
  void filteredShapesPassThroughAndOthersDoNot() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    Body<String> ghost = disc(w, 0, 2, shape(new Filter(2, 2)));
    Body<String> solid = disc(w, 3, 2, shape(new Filter(2, 1)));
    Body<String> a = disc(w, 6, .5f, shape(Filter.DEFAULT.withGroup(-7)));
    Body<String> b = disc(w, 6, 2, shape(Filter.DEFAULT.withGroup(-7)));
    steps(w, 120);
    assertTrue(ghost.y() < -10, "ghost y=" + ghost.y());
    assertEquals(.5, solid.y(), .01);
    assertEquals(.5, a.y(), .01);
    assertEquals(.5, b.y(), .01);
    assertEquals(new Filter(2, 2), ghost.filter(0));
  }

  /** A disc falls through a sensor: entered once, left once, and its fall is not disturbed. */
  @Test
  void sensorHearsEnterAndLeaveAndPushesNothing() {
    World<String> w = new World<>(new WorldDef());
    Body<String> gate =
        w.createBody(new BodyDef().shape(new ShapeDef(new Box(2, .5f)).withSensor(true)), "gate");
    Body<String> b = disc(w, 0, 5, shape(Filter.DEFAULT));
    World<String> free = new World<>(new WorldDef());
    Body<String> twin = disc(free, 0, 5, shape(Filter.DEFAULT));
    List<String> heard = new ArrayList<>();
    List<Boolean> inside = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            assertTrue(c.isSensor());
            assertEquals(0, c.pointCount());
            heard.add("enter " + c.self().user());
            assertTrue(c.other().y() < 1 && c.other().y() > .7, "y=" + c.other().y());
          }

          @Override
          public void end(Collision<String> c) {
            assertTrue(c.isSensor());
            heard.add("leave " + c.self().user());
            assertTrue(c.other().y() < -1 && c.other().y() > -1.3, "y=" + c.other().y());
          }

          @Override
          public boolean preSolve(Collision<String> c) {
            throw new AssertionError("a sensor has nothing to solve");
          }

          @Override
          public void postSolve(Collision<String> c) {
            throw new AssertionError("a sensor has nothing to solve");
          }
        });
    for (int i = 0; i < 90; i++) {
      boolean[] seen = new boolean[2];
      b.forEachOverlap(
          other -> {
            seen[0] = other == gate;
            return true;
          });
      gate.forEachOverlap(
          other -> {
            seen[1] = other == b;
            return true;
          });
      assertEquals(seen[0], seen[1]);
      inside.add(seen[0]);
      b.forEachContact((other, nx, ny, impulse) -> heard.add("contact"));
      w.step(DT);
      free.step(DT);
      assertEquals(twin.y(), b.y());
    }
    assertEquals(List.of("enter gate", "leave gate"), heard);
    assertTrue(inside.contains(true));
    assertFalse(inside.get(89));
  }

  @Test
  void sensorIsLeftWhenItsVisitorIsDestroyed() {
    World<String> w = Scenes.space();
    w.createBody(new BodyDef().shape(new ShapeDef(new Box(2, 2)).withSensor(true)), "gate");
    Body<String> b = disc(w, 0, 0, shape(Filter.DEFAULT));
    disc(w, 0, 0, shape(Filter.DEFAULT).withSensor(true));
    List<String> heard = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            heard.add("enter " + c.self().index() + "-" + c.other().index());
          }

          @Override
          public void end(Collision<String> c) {
            heard.add("leave " + c.self().index() + "-" + c.other().index());
          }
        });
    w.step(DT);
    assertEquals(List.of("enter 0-1", "enter 1-2"), heard, "sensors don't notice each other");
    w.destroyBody(b);
    assertEquals(List.of("enter 0-1", "enter 1-2", "leave 0-1", "leave 1-2"), heard);
  }

  @Test
  void sensorsAreRestoredBitForBit() {
    World<String> w = Scenes.pile(30, 8);
    w.createBody(
        new BodyDef()
            .shape(new ShapeDef(new Box(3, 1)).withSensor(true).withFilter(new Filter(8, 1)))
            .position(0, 2),
        "gate");
    int[] events = new int[1];
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            events[0] += c.isSensor() ? 1 : 0;
          }

          @Override
          public void end(Collision<String> c) {
            events[0] += c.isSensor() ? 1000 : 0;
          }
        });
    steps(w, 70);
    WorldState s = w.save(null);
    events[0] = 0;
    steps(w, 60);
    long hash = w.stateHash();
    int heard = events[0];
    assertTrue(heard > 1000, "events=" + heard);
    w.restore(s);
    events[0] = 0;
    steps(w, 60);
    assertEquals(hash, w.stateHash());
    assertEquals(heard, events[0]);
  }

  @Test
  void hashSeesFiltersSensorsAndSurfaces() {
    long plain = hash(new ShapeDef(new Circle(1)));
    assertEquals(plain, hash(new ShapeDef(new Circle(1), Material.DEFAULT)));
    assertEquals(plain, hash(new ShapeDef(new Circle(1), Material.DEFAULT.withTag(5))));
    assertNotEquals(plain, hash(new ShapeDef(new Circle(1)).withSensor(true)));
    assertNotEquals(plain, hash(new ShapeDef(new Circle(1)).withFilter(new Filter(1, 1))));
    assertNotEquals(
        plain, hash(new ShapeDef(new Circle(1), Material.DEFAULT.withRollingResistance(.1f))));
    assertNotEquals(plain, hash(new ShapeDef(new Circle(1), Material.DEFAULT.withTangentSpeed(1))));
  }

  private static long hash(ShapeDef shape) {
    World<String> w = Scenes.space();
    disc(w, 0, 0, shape);
    return w.stateHash();
  }
}
