package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.archive.ArchiveException;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Box;
import carom.physics.settings.Constant;
import carom.physics.settings.MixingRule;
import carom.physics.settings.Settings;
import java.lang.reflect.Method;
import java.util.List;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Constants that change while the world runs. */
class RedefineTest {
  private static final Material M = Material.DEFAULT;

  /** Every constant that may change, to another value. */
  static List<UnaryOperator<WorldDef>> changes() {
    return List.of(
        d -> d.withGravity(1, 3),
        d -> d.withContactHertz(20),
        d -> d.withContactDampingRatio(2),
        d -> d.withRestitutionThreshold(0.1f),
        d -> d.withMaxPushSpeed(1),
        d -> d.withSlop(0.01f),
        d -> d.withAabbMargin(0.3f),
        d -> d.withMaxSpeed(4),
        d -> d.withMaxAngularSpeed(2),
        d -> d.withJointHertz(20),
        d -> d.withJointDampingRatio(1),
        d -> d.withSleeping(false),
        d -> d.withSleepSpeed(0.2f),
        d -> d.withSleepDelay(0.1f),
        d -> d.withContinuous(false),
        d -> d.withHitSpeed(3));
  }

  private static World<String> pile() {
    World<String> w = Scenes.pile(6, 5);
    Body<String> b = box(w, 3, 6, 0.5f, 0.1f, M);
    w.createJoint(JointDef.revolute(null, b, 2.5f, 6));
    return w;
  }

  private static byte[] bytes(World<?> w) {
    ArchiveWriter out = new ArchiveWriter();
    w.save(null).write(out);
    return out.toBytes();
  }

  @ParameterizedTest
  @MethodSource("changes")
  void aWorldThatIsRedefinedGoesOnAsOneThatWasMadeSo(UnaryOperator<WorldDef> change) {
    World<String> w = pile();
    World<String> v = new World<>(change.apply(w.def()));
    fill(v);
    World<String> redefined = new World<>(w.def());
    fill(redefined);
    redefined.redefine(change.apply(w.def()));
    for (int i = 0; i < 100; i++) {
      v.step(DT);
      redefined.step(DT);
      for (int b = 0; b < v.slotCount(); b++) {
        assertEquals(v.body(b).stamp(), redefined.body(b).stamp(), "step=" + i + " body=" + b);
      }
    }
  }

  private static void fill(World<String> w) {
    w.createBody(new BodyDef().shape(new Box(50, 1)).position(0, -1), "floor");
    for (int i = 0; i < 12; i++) {
      box(w, i % 3 * 0.9f, 0.6f + Math.floorDiv(i, 3) * 1.1f, 0.5f, 0.5f, M.withRestitution(0.4f));
    }
    Body<String> b = box(w, 5, 6, 0.5f, 0.1f, M);
    w.createJoint(JointDef.revolute(null, b, 4.5f, 6));
  }

  @ParameterizedTest
  @MethodSource("changes")
  void changedConstantsAreSavedRestoredArchivedAndHashed(UnaryOperator<WorldDef> change) {
    World<String> w = pile();
    WorldDef first = w.def();
    steps(w, 20);
    long before = w.stateHash();
    WorldState saved = w.save(null);
    WorldDef other = change.apply(first);
    w.redefine(other);
    assertSame(other, w.def());
    assertNotEquals(before, w.stateHash());
    byte[] bytes = bytes(w);
    World<String> copy = new World<>(first);
    copy.restore(copy.read(new ArchiveReader(bytes), slot -> "copy"));
    assertEquals(w.stateHash(), copy.stateHash());
    for (int i = 0; i < 60; i++) {
      w.step(DT);
      copy.step(DT);
      assertEquals(w.stateHash(), copy.stateHash(), "step=" + i);
    }
    w.restore(saved);
    assertSame(first, w.def());
    assertEquals(before, w.stateHash());
    World<String> wrong = new World<>(other);
    assertThrows(
        ArchiveException.class, () -> wrong.read(new ArchiveReader(bytes), slot -> "wrong"));
  }

  @Test
  void thereAndBackIsTheWorldAsItWasMade() {
    World<String> w = pile();
    long before = w.stateHash();
    WorldDef first = w.def();
    w.redefine(first.withHitSpeed(9));
    assertNotEquals(before, w.stateHash());
    w.redefine(new WorldDef().withHitSpeed(first.hitSpeed()));
    assertEquals(before, w.stateHash());
  }

  @Test
  void gravityWakesAndPullsTheOtherWay() {
    World<String> w = Scenes.floor(M);
    Body<String> b = box(w, 0, 0.5f, 0.5f, 0.5f, M);
    steps(w, 60);
    assertFalse(b.awake());
    w.redefine(w.def().withSleepDelay(2));
    assertFalse(b.awake());
    w.redefine(w.def().withGravity(0, 5));
    assertTrue(b.awake());
    float start = b.y();
    steps(w, 60);
    assertEquals(5, b.velocityY(), 0.05);
    assertEquals(start + 2.5, b.y(), 0.05);
    assertEquals(5, w.gravityY());
  }

  @Test
  void whereSleepingEndsAllWake() {
    World<String> w = Scenes.floor(M);
    Body<String> b = box(w, 0, 0.5f, 0.5f, 0.5f, M);
    steps(w, 60);
    assertFalse(b.awake());
    w.redefine(w.def().withSleeping(false));
    assertTrue(b.awake());
    steps(w, 120);
    assertTrue(b.awake());
    w.redefine(w.def().withSleeping(true));
    steps(w, 60);
    assertFalse(b.awake());
  }

  @Test
  void whatAStepHasMeasuredWithStays() {
    World<String> w = pile();
    long before = w.stateHash();
    WorldDef d = w.def();
    String why =
        assertThrows(IllegalArgumentException.class, () -> w.redefine(d.withSubsteps(8)))
            .getMessage();
    assertTrue(why.startsWith("substeps=8 differs from 4 and can't be changed"), why);
    assertThrows(IllegalArgumentException.class, () -> w.redefine(d.withSpeculativeDistance(0.5f)));
    assertThrows(
        IllegalArgumentException.class,
        () -> w.redefine(d.withIntegrator(Integrator.EXPLICIT_EULER)));
    w.queryAabb(
        -1,
        -1,
        1,
        1,
        b -> {
          assertThrows(IllegalStateException.class, () -> w.redefine(d.withHitSpeed(3)));
          return false;
        });
    w.listener(
        new CollisionListener<>() {
          @Override
          public void postSolve(Collision<String> c) {
            assertThrows(IllegalStateException.class, () -> w.redefine(d.withHitSpeed(3)));
          }
        });
    assertEquals(before, w.stateHash());
  }

  @Test
  void everyConstantIsTakenOver() throws Exception {
    WorldDef all = new WorldDef();
    for (UnaryOperator<WorldDef> change : changes()) {
      all = change.apply(all);
    }
    all =
        all.withSubsteps(7)
            .withSpeculativeDistance(0.5f)
            .withIntegrator(Integrator.EXPLICIT_EULER)
            .withFrictionMixing(MixingRule.MIN)
            .withRestitutionMixing(MixingRule.MULTIPLY);
    Settings live = new WorldDef().live();
    Settings fresh = new WorldDef().live();
    live.take(all);
    for (Constant constant : Constant.values()) {
      String name = constant.label();
      if (constant == Constant.INTEGRATOR) {
        name = "explicitEuler";
      }
      Method getter = Settings.class.getMethod(name);
      assertEquals(getter.invoke(all), getter.invoke(live), name);
      assertNotEquals(
          getter.invoke(fresh), getter.invoke(live), name + " isn't in the test's list");
    }
  }
}
