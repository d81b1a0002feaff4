package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.disc;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Allocations;
import carom.physics.geometry.Circle;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How joints come and go, and what is saved of them. */
final class JointLifeTest {
  private static final Material M = Material.DEFAULT;

  /** A load that grows by 10 N a second breaks a rope of 25 N when it weighs more than that. */
  @Test
  void breaksAboveItsForceAndTellsSo() {
    World<String> w = new World<>(new WorldDef());
    Body<String> b = disc(w, 0, -1, .5f, M);
    Joint<String> j =
        w.createJoint(JointDef.distance(null, b, 0, 0, 0, -1).breaksAt(25, Float.MAX_VALUE));
    List<String> heard = new ArrayList<>();
    w.jointListener(
        broken -> {
          assertSame(j, broken);
          assertTrue(broken.isValid());
          assertSame(b, broken.bodyB());
          assertTrue(broken.forceY() > 25 && broken.forceY() < 26, "force=" + broken.forceY());
          heard.add("broke");
          w.destroyBody(b);
        });
    double weight = b.mass() * 10;
    int tick = 0;
    while (j.isValid()) {
      b.applyForce(0, -10 * tick / 60f);
      w.step(DT);
      tick++;
      assertTrue(tick < 200);
    }
    assertEquals((25 - weight) / 10 * 60, tick, 4);
    assertEquals(List.of("broke"), heard);
    assertFalse(b.isValid());
    assertEquals(0, w.jointCount());
    assertThrows(IllegalStateException.class, j::forceX);
  }

  @Test
  void whatAGameSetsCanBeReadBack() {
    World<String> w = new World<>(new WorldDef());
    Body<String> b = disc(w, 0, -1, .5f, M);
    Joint<String> wheel = w.createJoint(JointDef.wheel(null, b, 0, -1, 0, 1));
    wheel.setMotor(-3, 40);
    wheel.setSpring(4, .7f);
    assertEquals(-3, wheel.motorSpeed());
    assertEquals(40, wheel.motorMax());
    assertEquals(4, wheel.springHertz());
    assertEquals(.7f, wheel.springDamping());
    Joint<String> mouse = w.createJoint(JointDef.mouse(b, 0, -1, 100));
    mouse.setTarget(2, 3);
    assertEquals(2, mouse.targetX());
    assertEquals(3, mouse.targetY());
    assertThrows(IllegalStateException.class, wheel::targetX);
    assertThrows(IllegalStateException.class, wheel::targetY);
  }

  @Test
  void breaksAboveItsTorque() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, .5f, .5f, M);
    Joint<String> j =
        w.createJoint(JointDef.weld(null, b, 0, 0).breaksAt(Float.POSITIVE_INFINITY, 2));
    b.applyTorque(1.9f);
    w.step(DT);
    assertTrue(j.isValid());
    for (int i = 0; i < 5; i++) {
      b.applyTorque(2.5f);
      w.step(DT);
    }
    assertFalse(j.isValid());
  }

  @Test
  void jointsDieWithTheirBodies() {
    World<String> w = Scenes.space();
    Body<String> a = disc(w, 0, 0, .5f, M);
    Body<String> b = disc(w, 2, 0, .5f, M);
    Body<String> c = disc(w, 4, 0, .5f, M);
    Joint<String> ab = w.createJoint(JointDef.distance(a, b, 0, 0, 2, 0));
    Joint<String> bc = w.createJoint(JointDef.distance(b, c, 2, 0, 4, 0));
    Joint<String> ca = w.createJoint(JointDef.distance(c, a, 4, 0, 0, 0));
    List<Joint<String>> seen = new ArrayList<>();
    b.forEachJoint(seen::add);
    assertEquals(List.of(bc, ab), seen);
    w.destroyBody(b);
    assertFalse(ab.isValid());
    assertFalse(bc.isValid());
    assertTrue(ca.isValid());
    assertSame(ca, w.joint(ca.index()));
    seen.clear();
    a.forEachJoint(seen::add);
    assertEquals(List.of(ca), seen);
    w.destroyJoint(ca);
    assertEquals(0, w.jointCount());
    Joint<String> again = w.createJoint(JointDef.distance(a, c, 0, 0, 4, 0));
    assertEquals(ca.index(), again.index());
    assertFalse(ca.isValid());
    assertThrows(IllegalStateException.class, () -> w.destroyJoint(ca));
    w.step(DT);
  }

  /** In callbacks: made at once, destroyed at the end of the step. */
  @Test
  void callbacksMayMakeAndDestroyJoints() {
    World<String> w = Scenes.floor(M);
    Body<String> b = disc(w, 0, .52f, .5f, M);
    Body<String> c = disc(w, 5, 8, .5f, M);
    Joint<String> old = w.createJoint(JointDef.distance(b, c, 0, .5f, 5, 8));
    List<String> heard = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> x) {
            heard.add("begin");
            if (heard.size() > 1) {
              return;
            }
            w.destroyJoint(old);
            w.destroyJoint(old);
            assertTrue(old.isValid());
            w.createJoint(JointDef.weld(x.self(), x.other(), 0, 0));
          }

          @Override
          public void end(Collision<String> x) {
            heard.add("end");
          }
        });
    steps(w, 5);
    assertFalse(old.isValid());
    assertEquals(List.of("begin", "end"), heard, "glued bodies no longer collide");
    assertEquals(1, w.jointCount());
    w.destroyJoint(w.joint(1));
    steps(w, 5);
    assertEquals(List.of("begin", "end", "begin"), heard, "they do again");
  }

  /** Bodies and joints of all kinds, hanging and colliding. */
  static World<String> zoo(long seed) {
    World<String> w = Scenes.pile(40, seed);
    Scenes.Rng r = new Scenes.Rng(seed);
    for (int i = 3; i + 1 < 40; i++) {
      add(w, w.body(i), w.body(i + 1), i, r);
    }
    return w;
  }

  private static void add(World<String> w, Body<String> a, Body<String> b, int kind, Scenes.Rng r) {
    float x = .5f * (a.centerX() + b.centerX());
    float y = .5f * (a.centerY() + b.centerY());
    float bx = b.centerX();
    float by = b.centerY();
    JointDef<String> d =
        switch (kind % 9) {
          case 0 -> JointDef.revolute(a, b, x, y).limits(-1, 1).spring(2, .1f);
          case 1 -> JointDef.revolute(a, b, x, y).motor(3, 5).breaksAt(60, 50);
          case 2 -> JointDef.distance(a, b, a.x(), a.y(), bx, by).breaksAt(80, 80);
          case 3 -> JointDef.rope(a, b, a.x(), a.y(), bx, by, 2).collideConnected(true);
          case 4 -> JointDef.prismatic(a, b, x, y, 1, 1).limits(-1, 1).motor(1, 9).spring(1, 1);
          case 5 -> JointDef.weld(a, b, x, y).angularSpring(4, .3f).spring(30, 1);
          case 6 -> JointDef.wheel(a, b, bx, by, 0, 1).spring(3, .5f).limits(-.2f, .2f).motor(5, 2);
          case 7 -> JointDef.motor(a, b, 20, 20);
          default -> JointDef.mouse(b, bx, by, 30);
        };
    Joint<String> j = w.createJoint(d);
    if (j.type() == JointType.MOUSE) {
      j.setTarget(r.in(-4, 4), r.in(0, 8));
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void restoreContinuesBitForBit(long seed) {
    World<String> w = zoo(seed);
    Scenes.Rng r = new Scenes.Rng(seed + 50);
    WorldState s = null;
    for (int round = 0; round < 6; round++) {
      String where = "seed=" + seed + " round=" + round;
      steps(w, r.below(30));
      s = w.save(s);
      long at = w.stateHash();
      long choice = r.next();
      long[] expected = play(w, choice);
      play(w, r.next());
      play(w, r.next());
      w.restore(s);
      assertEquals(at, w.stateHash(), where);
      long[] actual = play(w, choice);
      for (int i = 0; i < expected.length; i++) {
        assertEquals(expected[i], actual[i], where + " step=" + i);
      }
    }
    assertTrue(w.jointCount() > 5);
  }

  /** Twenty steps in which bodies and joints come and go. */
  private static long[] play(World<String> w, long choice) {
    Scenes.Rng r = new Scenes.Rng(choice);
    long[] hashes = new long[20];
    for (int i = 0; i < hashes.length; i++) {
      switch (r.below(5)) {
        case 0 -> {
          Joint<String> j = w.joint(r.below(60));
          if (j != null) {
            w.destroyJoint(j);
          }
        }
        case 1 -> {
          Body<String> a = w.body(3 + r.below(40));
          Body<String> b = disc(w, r.in(-4, 4), r.in(2, 9), .3f, M);
          if (a != null) {
            add(w, a, b, r.below(9), r);
          }
        }
        case 2 -> {
          Body<String> b = w.body(3 + r.below(60));
          if (b != null) {
            w.destroyBody(b);
          }
        }
        default -> {}
      }
      w.step(DT);
      hashes[i] = w.stateHash();
    }
    return hashes;
  }

  @Test
  void restoreBringsHandlesBack() {
    World<String> w = Scenes.space();
    Body<String> a = disc(w, 0, 0, .5f, M);
    Joint<String> j = w.createJoint(JointDef.revolute(null, a, 0, 0));
    WorldState s = w.save(null);
    w.destroyBody(a);
    assertFalse(j.isValid());
    w.restore(s);
    assertTrue(j.isValid());
    assertSame(j, w.joint(0));
    assertSame(a, j.bodyB());
    assertSame(null, j.bodyA());
    WorldState empty = Scenes.space().save(null);
    assertThrows(IllegalArgumentException.class, () -> w.restore(empty));
  }

  /** A slot that only an undone future used begins again with its first generation. */
  @Test
  void undoneBodiesLeaveNoGenerationBehind() {
    World<String> w = Scenes.space();
    WorldState s = w.save(null);
    Body<String> a = w.createBody(new BodyDef(BodyType.DYNAMIC).shape(new Circle(1)), "a");
    long once = w.stateHash();
    w.destroyBody(a);
    w.restore(s);
    w.createBody(new BodyDef(BodyType.DYNAMIC).shape(new Circle(1)), "a");
    assertEquals(once, w.stateHash());
  }

  @Test
  void hashSeesWhatIsSet() {
    World<String> w = Scenes.space();
    Body<String> a = disc(w, 0, 0, .5f, M);
    long bare = w.stateHash();
    Joint<String> j = w.createJoint(JointDef.revolute(null, a, 0, 0));
    long plain = w.stateHash();
    assertNotEquals(bare, plain);
    j.setMotor(1, 1);
    long driven = w.stateHash();
    assertNotEquals(plain, driven);
    j.setMotor(1, Math.nextUp(1f));
    assertNotEquals(driven, w.stateHash());
  }

  @Test
  void steadyTickAllocatesNothing() {
    World<String> w = zoo(9);
    WorldState s = null;
    for (int i = 0; i < 600; i++) {
      w.step(DT);
      s = w.save(s);
      w.restore(s);
      w.stateHash();
    }
    WorldState state = s;
    long least =
        Allocations.least(
            5,
            () -> {
              for (int i = 0; i < 60; i++) {
                w.step(DT);
                w.save(state);
                w.restore(state);
                w.stateHash();
              }
            });
    assertTrue(least < 200, "bytes in 60 steps: " + least);
  }

  @Test
  void brokenBodyInfectsNobody() {
    World<String> w = zoo(4);
    for (int i = 0; i < 30; i++) {
      Body<String> b = w.body(3 + i);
      b.applyForce(1e20f, 1e20f);
      b.applyImpulse(-1e20f, 1e20f);
      b.applyTorque(1e20f);
      w.step(DT);
    }
    steps(w, 120);
    w.forEachBody(
        b -> {
          assertTrue(Math.abs(b.x()) <= 1e7f && Math.abs(b.y()) <= 1e7f, b.toString());
          assertTrue(Float.isFinite(b.velocityX()) && Math.abs(b.angle()) <= 4, b.toString());
        });
    w.forEachJoint(j -> assertTrue(Float.isFinite(j.forceX() + j.torque()), j.toString()));
  }

  /** A link that is teleported far away comes back, and the chain doesn't blow up. */
  @ParameterizedTest
  @ValueSource(strings = {"weld", "hinge", "rod"})
  void tornChainCloses(String kind) {
    World<String> w = Scenes.space();
    List<Body<String>> links = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      links.add(Scenes.box(w, i, 0, .5f, .3f, M));
      if (i > 0) {
        Body<String> a = links.get(i - 1);
        Body<String> b = links.get(i);
        w.createJoint(
            switch (kind) {
              case "weld" -> JointDef.weld(a, b, i - .5f, 0);
              case "hinge" -> JointDef.revolute(a, b, i - .5f, 0);
              default -> JointDef.distance(a, b, i - .75f, 0, i - .25f, 0);
            });
      }
    }
    links.get(2).setPose(-60, 55, 2);
    for (int i = 0; i < 900; i++) {
      w.step(DT);
      w.forEachBody(b -> assertTrue(Math.abs(b.x()) + Math.abs(b.y()) < 200, b.toString()));
    }
    for (int i = 1; i < 5; i++) {
      float dx = links.get(i).x() - links.get(i - 1).x();
      float dy = links.get(i).y() - links.get(i - 1).y();
      assertTrue(dx * dx + dy * dy < 1.6 * 1.6, kind + " link=" + i + " dx=" + dx + " dy=" + dy);
    }
  }

  @Test
  void refusesWhatMakesNoSense() {
    World<String> w = Scenes.space();
    Body<String> a = disc(w, 0, 0, .5f, M);
    Body<String> b = disc(w, 2, 0, .5f, M);
    refused("bodyB=null", () -> JointDef.revolute(a, null, 0, 0));
    refused("bodyA=bodyB", () -> JointDef.revolute(a, a, 0, 0));
    refused("anchorAX=NaN", () -> JointDef.revolute(a, b, Float.NaN, 0));
    refused("axisX=0.0", () -> JointDef.prismatic(a, b, 0, 0, 0, 0));
    refused("upper=-1.0", () -> JointDef.revolute(a, b, 0, 0).limits(0, -1));
    refused("lower=-20000.0", () -> JointDef.revolute(a, b, 0, 0).limits(-2e4f, 0));
    refused("hertz=-1.0", () -> JointDef.weld(a, b, 0, 0).spring(-1, 0));
    refused("force=NaN", () -> JointDef.weld(a, b, 0, 0).breaksAt(Float.NaN, 0));
    Body<String> foreign = disc(Scenes.space(), 0, 0, 1, M);
    refused("another world", () -> w.createJoint(JointDef.weld(a, foreign, 0, 0)));
    assertThrows(IllegalStateException.class, () -> JointDef.weld(a, b, 0, 0).motor(1, 1));
    Joint<String> j = w.createJoint(JointDef.weld(a, b, 0, 0));
    assertThrows(IllegalStateException.class, () -> j.setMotor(1, 1));
    assertThrows(IllegalStateException.class, () -> j.setTarget(1, 1));
    refused("hertz=NaN", () -> j.setSpring(Float.NaN, 0));
    w.destroyBody(b);
    assertThrows(IllegalStateException.class, () -> w.createJoint(JointDef.weld(a, b, 0, 0)));
    assertEquals(0, w.jointCount());
  }

  private static void refused(String part, Runnable call) {
    String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
    assertTrue(message.contains(part), message);
  }

  /** What a rod pulled before it got limits, a motor or a spring isn't pulled any more. */
  @ParameterizedTest
  @ValueSource(strings = {"limits", "motor", "spring"})
  void aRodThatIsNoneAnyMoreLetsGo(String what) {
    World<String> w = new World<>(new WorldDef());
    Body<String> ball = disc(w, 0, -1, .2f, Material.DEFAULT);
    Joint<String> rod = w.createJoint(JointDef.distance(null, ball, 0, 0, 0, -1));
    steps(w, 30);
    switch (what) {
      case "limits" -> rod.setLimits(0, 9);
      case "motor" -> rod.setMotor(0, 0);
      default -> rod.setSpring(0, 0);
    }
    steps(w, 30);
    assertEquals(-1 - .5 * 10 * .25, ball.y(), .02);
  }
}
