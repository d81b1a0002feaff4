package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.geometry.Box;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Events read after a step are those that a listener hears in it. */
final class EventListsTest {
  private final EventLists<String> events = new EventLists<>();

  private World<String> listening(World<String> w) {
    w.eventLists(events);
    return w;
  }

  private static String name(String what, Body<String> a, int i, Body<String> b, int j) {
    return what + " " + a.index() + "." + i + " " + b.index() + "." + j;
  }

  private static List<String> told(ContactEventList<String> list, String what) {
    List<String> all = new ArrayList<>();
    for (int i = 0; i < list.count(); i++) {
      String name = name(what, list.self(i), list.selfShape(i), list.other(i), list.otherShape(i));
      all.add(
          what.equals("end")
              ? name
              : name + " " + list.normalX(i) + " " + list.x(i) + " " + list.speed(i));
    }
    return all;
  }

  @Test
  void theListsHoldWhatAListenerHearsInTheSameOrder() {
    World<String> w = listening(Scenes.pile(80, 6));
    List<String> begins = new ArrayList<>();
    List<String> ends = new ArrayList<>();
    List<String> hits = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          private String name(String what, Collision<String> c) {
            return EventListsTest.name(
                what, c.self(), c.selfShapeIndex(), c.other(), c.otherShapeIndex());
          }

          @Override
          public void begin(Collision<String> c) {
            begins.add(name("begin", c) + " " + c.normalX() + " " + c.pointX(0) + " 0.0");
          }

          @Override
          public void end(Collision<String> c) {
            ends.add(name("end", c));
          }

          @Override
          public void hit(Collision<String> c) {
            hits.add(name("hit", c) + " " + c.normalX() + " " + c.hitX() + " " + c.hitSpeed());
          }
        });
    int heard = 0;
    for (int tick = 0; tick < 120; tick++) {
      begins.clear();
      ends.clear();
      hits.clear();
      w.step(DT);
      assertEquals(begins, told(events.begins(), "begin"));
      assertEquals(ends, told(events.ends(), "end"));
      assertEquals(hits, told(events.hits(), "hit"));
      heard += Math.min(1, begins.size()) + Math.min(1, ends.size()) + Math.min(1, hits.size());
    }
    assertTrue(heard > 100, "ticks with events: " + heard);
  }

  @Test
  void listsAloneWorkAndChangeNoBit() {
    World<String> plain = Scenes.pile(80, 6);
    World<String> listed = listening(Scenes.pile(80, 6));
    int hits = 0;
    for (int tick = 0; tick < 120; tick++) {
      plain.step(DT);
      listed.step(DT);
      hits += events.hits().count();
      assertEquals(plain.stateHash(), listed.stateHash(), "tick=" + tick);
    }
    assertTrue(hits > 20, "hits=" + hits);
    for (int i = 0; i < events.hits().count(); i++) {
      assertTrue(events.hits().impulse(i) > 0);
    }
  }

  @Test
  void sensorsHaveListsOfTheirOwn() {
    World<String> w = listening(new World<>(new WorldDef()));
    Body<String> sensor =
        w.createBody(new BodyDef().shape(new ShapeDef(new Box(5, 1)).withSensor(true)), "sensor");
    Body<String> disc = Scenes.disc(w, 0, 3, .5f, Material.DEFAULT);
    int began = 0;
    int ended = 0;
    for (int i = 0; i < 120; i++) {
      w.step(DT);
      for (int k = 0; k < events.sensorBegins().count(); k++, began++) {
        assertSame(sensor, events.sensorBegins().self(k));
        assertSame(disc, events.sensorBegins().other(k));
        assertEquals(0, events.sensorBegins().normalY(k));
      }
      ended += events.sensorEnds().count();
      assertEquals(0, events.begins().count() + events.ends().count());
    }
    assertEquals(1, began);
    assertEquals(1, ended);
  }

  @Test
  void aBodyDestroyedBetweenStepsEndsItsContactsInTheNextStepsLists() {
    World<String> w = listening(Scenes.floor(Material.DEFAULT));
    Body<String> lower = Scenes.box(w, 0, .5f, .5f, .5f, Material.DEFAULT);
    Body<String> upper = Scenes.box(w, 0, 1.5f, .5f, .5f, Material.DEFAULT);
    steps(w, 5);
    w.destroyBody(lower);
    assertEquals(0, events.ends().count(), "the lists are those of the last step");
    Body<String> next = Scenes.disc(w, 9, .5f, .5f, Material.DEFAULT);
    assertEquals(lower.index(), next.index(), "the slot is used again");
    w.step(DT);
    assertEquals(2, events.ends().count());
    assertSame(lower, events.ends().other(0));
    assertSame(lower, events.ends().self(1));
    assertSame(upper, events.ends().other(1));
    assertFalse(events.ends().other(0).isValid());
    assertEquals("box", events.ends().other(0).user());
    w.step(DT);
    assertEquals(0, events.ends().count(), "each step begins with empty lists");
  }

  @Test
  void aBodyThatACallbackDestroysEndsInTheListsOfThatStep() {
    World<String> w = listening(Scenes.floor(Material.DEFAULT));
    Body<String> box = Scenes.box(w, 0, .5f, .5f, .5f, Material.DEFAULT);
    w.listener(
        new CollisionListener<>() {
          @Override
          public void postSolve(Collision<String> c) {
            if (c.other().isValid()) {
              w.destroyBody(c.other());
            }
          }
        });
    w.step(DT);
    assertEquals(1, events.ends().count());
    assertSame(box, events.ends().other(0));
    assertFalse(box.isValid());
  }

  @Test
  void jointsThatBreakAreListedWithWhatBrokeThem() {
    World<String> w = listening(new World<>(new WorldDef()));
    Body<String> post = w.createBody(new BodyDef(), "post");
    Body<String> load = Scenes.disc(w, 1, 0, .5f, Material.DEFAULT);
    Joint<String> joint =
        w.createJoint(JointDef.revolute(post, load, 0, 0).breaksAt(1, Float.POSITIVE_INFINITY));
    int steps = 0;
    while (events.breaks().count() == 0 && steps++ < 60) {
      w.step(DT);
    }
    assertEquals(1, events.breaks().count());
    assertSame(joint, events.breaks().joint(0));
    assertFalse(joint.isValid());
    assertSame(post, events.breaks().bodyA(0));
    assertSame(load, events.breaks().bodyB(0));
    assertTrue(Math.hypot(events.breaks().forceX(0), events.breaks().forceY(0)) > 1);
    w.step(DT);
    assertEquals(0, events.breaks().count());
  }

  @Test
  void restoringEmptiesTheLists() {
    World<String> w = listening(Scenes.floor(Material.DEFAULT));
    Scenes.box(w, 0, .5f, .5f, .5f, Material.DEFAULT);
    WorldState s = w.save(null);
    w.step(DT);
    assertEquals(1, events.begins().count());
    w.restore(s);
    assertEquals(0, events.begins().count());
    w.step(DT);
    assertEquals(1, events.begins().count());
    w.eventLists(null);
    w.step(DT);
    assertEquals(1, events.begins().count(), "nobody fills them any longer");
  }

  @Test
  void aSteadyStepAllocatesNothing() {
    World<String> w =
        listening(Scenes.floor(new Material(1, 0, 1), new WorldDef().withSleeping(false)));
    w.createBody(
        new BodyDef().shape(new ShapeDef(new Box(9, .1f)).withSensor(true)).position(0, 1), "gate");
    for (int i = 0; i < 12; i++) {
      Scenes.disc(w, i - 6, 2 + .1f * i, .3f, new Material(1, 0, 1));
    }
    steps(w, 3_000);
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long least = Long.MAX_VALUE;
    int events = 0;
    for (int round = 0; round < 10 && least > 0; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 100; i++) {
        w.step(DT);
        events += this.events.hits().count() + this.events.sensorEnds().count();
      }
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertTrue(events > 20, "events=" + events);
    assertEquals(0, least);
  }

  @Test
  void anEventThatIsNotThereIsRefusedByNumber() {
    listening(Scenes.floor(Material.DEFAULT)).step(DT);
    String message =
        assertThrows(IndexOutOfBoundsException.class, () -> events.hits().self(0)).getMessage();
    assertEquals("event=0 is outside 0..-1; see count()", message);
    assertThrows(IndexOutOfBoundsException.class, () -> events.breaks().joint(-1));
  }
}
