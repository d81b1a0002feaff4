package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.disc;
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
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Mass, materials, filters and the like, changed while the world runs. */
class RuntimeChangeTest {
  private static final Material M = Material.DEFAULT;

  @Test
  void ownMassAnswersForcesAndTorques() {
    World<String> w = Scenes.space();
    Body<String> b =
        w.createBody(new BodyDef(BodyType.DYNAMIC).shape(new Box(1, 1)).mass(5, 3, 0.5f, 0), "own");
    assertTrue(b.hasOwnMass());
    assertEquals(5, b.mass());
    assertEquals(3, b.inertia());
    assertEquals(0.5f, b.centerX());
    b.applyForce(10, 0);
    b.applyTorque(6);
    w.step(DT);
    assertEquals(10 / 5.0 / 60, b.velocityX(), 1e-6);
    assertEquals(6 / 3.0 / 60, b.angularVelocity(), 1e-6);
  }

  @Test
  void aForceOnTheMiddleOfALoadedDieTurnsIt() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, 1, 1, M);
    b.setMass(2, 4, 0, -0.5f);
    b.applyForce(3, 0, 0, 0);
    w.step(DT);
    assertEquals(-0.5 * 3 / 4 / 60, b.angularVelocity(), 1e-6);
  }

  @Test
  void computedMassComesBackBitForBit() {
    World<String> w = Scenes.pile(8, 3);
    Body<String> b = w.body(6);
    long before = w.stateHash();
    float mass = b.mass();
    float inertia = b.inertia();
    float x = b.localCenterX();
    b.setMass(9, 9, 0.1f, 0.2f);
    assertNotEquals(before, w.stateHash());
    b.computeMass();
    assertFalse(b.hasOwnMass());
    assertEquals(mass, b.mass());
    assertEquals(inertia, b.inertia());
    assertEquals(x, b.localCenterX());
  }

  @Test
  void originAndItsVelocityStayWhenTheCentreMoves() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 3, 2, 1, 1, M);
    b.setPose(3, 2, 0.7f);
    b.setVelocity(1, 2);
    b.setAngularVelocity(4);
    b.setMass(1, 1, 0.5f, -0.25f);
    assertEquals(3, b.x(), 1e-6);
    assertEquals(2, b.y(), 1e-6);
    double rx = b.centerX() - b.x();
    double ry = b.centerY() - b.y();
    assertEquals(1, b.velocityX() + 4 * ry, 1e-5);
    assertEquals(2, b.velocityY() - 4 * rx, 1e-5);
    assertEquals(Math.hypot(0.5, 0.25), Math.hypot(rx, ry), 1e-6);
  }

  @Test
  void ownMassOutlivesAChangeOfType() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, 1, 1, M);
    b.setType(BodyType.STATIC);
    b.setMass(7, 2, 0, 0);
    assertEquals(0, b.mass());
    b.setType(BodyType.DYNAMIC);
    assertEquals(7, b.mass());
    assertEquals(2, b.inertia());
  }

  @Test
  void fixedRotationStopsAndCanBeFreed() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, 1, 0.5f, M);
    float inertia = b.inertia();
    b.setAngularVelocity(3);
    b.setFixedRotation(true);
    assertTrue(b.isFixedRotation());
    assertEquals(0, b.angularVelocity());
    b.applyTorque(100);
    w.step(DT);
    assertEquals(0, b.angularVelocity());
    b.setFixedRotation(false);
    assertEquals(inertia, b.inertia());
    b.applyTorque(100);
    w.step(DT);
    assertEquals(100 / inertia / 60, b.angularVelocity(), 1e-5);
  }

  @Test
  void densityChangesMassUnlessItIsTheBodysOwn() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, 1, 1, M);
    assertEquals(4, b.mass(), 1e-6);
    b.setMaterial(0, M.withDensity(3));
    assertEquals(12, b.mass(), 1e-5);
    assertEquals(3, b.material(0).density());
    b.setMass(1, 1, 0, 0);
    b.setMaterial(0, M.withDensity(5));
    assertEquals(1, b.mass());
    b.computeMass();
    assertEquals(20, b.mass(), 1e-5);
  }

  /** Slides v^2 / (2 mu g) further from where its friction changed. */
  @ParameterizedTest
  @ValueSource(floats = {0.2f, 0.5f})
  void frictionChangesWhileItSlides(float friction) {
    World<String> w = Scenes.floor(M.withFriction(1));
    Body<String> b = box(w, 0, 0.5f, 0.5f, 0.5f, M.withFriction(0));
    b.setVelocity(4, 0);
    steps(w, 60);
    assertEquals(4, b.velocityX(), 1e-3);
    b.setMaterial(0, M.withFriction(friction * friction));
    float from = b.x();
    steps(w, 300);
    assertEquals(16 / (2 * friction * 10), b.x() - from, 0.06);
  }

  @Test
  void aRestingBodyIsCarriedOffWhenTheBeltStarts() {
    World<String> w = Scenes.floor(M);
    Body<String> b = box(w, 0, 0.5f, 0.5f, 0.5f, M);
    steps(w, 120);
    w.body(0).setMaterial(0, M.withTangentSpeed(2));
    steps(w, 60);
    assertEquals(2, b.velocityX(), 0.01);
    w.body(0).setMaterial(0, M);
    steps(w, 60);
    assertEquals(0, b.velocityX(), 0.01);
  }

  @Test
  void aFilterLetsARestingBodyFallAndHoldsItAgain() {
    World<String> w = Scenes.floor(M);
    Body<String> b = disc(w, 0, 0.5f, 0.5f, M);
    List<String> heard = listen(w);
    steps(w, 120);
    b.setFilter(0, Filter.NOTHING);
    assertEquals(Filter.NOTHING, b.filter(0));
    w.step(DT);
    assertEquals(List.of("begin", "end"), heard);
    steps(w, 30);
    assertTrue(b.y() < 0);
    b.setPose(0, 1, 0);
    b.setVelocity(0, 0);
    b.setFilter(0, Filter.DEFAULT);
    steps(w, 120);
    assertEquals(0.5, b.y(), 0.01);
  }

  @Test
  void aSensorEndsWhatItTouchedAndNoticesItInstead() {
    World<String> w = Scenes.space();
    Body<String> a = disc(w, 0, 0, 0.5f, M);
    disc(w, 0.99f, 0, 0.5f, M);
    List<String> heard = listen(w);
    w.step(DT);
    a.setSensor(0, true);
    assertEquals(List.of("begin", "end"), heard);
    assertTrue(a.sensor(0));
    a.setPose(0.4f, 0, 0);
    w.step(DT);
    assertEquals(List.of("begin", "end", "begin sensor"), heard);
    a.setSensor(0, false);
    w.step(DT);
    assertEquals(List.of("begin", "end", "begin sensor", "end sensor", "begin"), heard);
  }

  private static List<String> listen(World<String> w) {
    List<String> heard = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            heard.add(c.isSensor() ? "begin sensor" : "begin");
          }

          @Override
          public void end(Collision<String> c) {
            heard.add(c.isSensor() ? "end sensor" : "end");
          }
        });
    return heard;
  }

  @Test
  void callbacksChangeTheirBodiesAtTheEndOfTheStepAllAtOnce() {
    World<String> w = Scenes.floor(M);
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Circle(0.5f))
                .shape(new Circle(0.5f, 1, 0))
                .position(0, 0.5f),
            "two");
    float mass = b.mass();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            if (!b.material(0).equals(M)) {
              return;
            }
            b.setMaterial(0, M.withDensity(2));
            b.setMaterial(1, M.withDensity(2).withTag(7));
            b.setFixedRotation(true);
            assertEquals(mass, b.mass());
            assertFalse(b.isFixedRotation());
          }
        });
    w.step(DT);
    assertEquals(2 * mass, b.mass(), 1e-5);
    assertEquals(2, b.material(0).density());
    assertEquals(7, b.material(1).tag());
    assertTrue(b.isFixedRotation());
  }

  @Test
  void everyChangeIsSavedRestoredAndHashed() {
    List<Consumer<Body<String>>> changes =
        List.of(
            b -> b.setMass(2, 3, 0, 0.1f),
            b -> b.setFixedRotation(true),
            b -> b.setMaterial(0, M.withFriction(0.1f)),
            b -> b.setMaterial(0, M.withRestitution(0.1f)),
            b -> b.setMaterial(0, M.withRollingResistance(0.1f)),
            b -> b.setMaterial(0, M.withTangentSpeed(1)),
            b -> b.setMaterial(0, M.withDensity(3)),
            b -> b.setFilter(0, new Filter(2, 3)),
            b -> b.setSensor(0, true),
            b -> b.setLinearDamping(1),
            b -> b.setAngularDamping(1),
            b -> b.setGravityScale(0.5f),
            b -> b.setBullet(true));
    for (int i = 0; i < changes.size(); i++) {
      World<String> w = Scenes.pile(40, 11);
      steps(w, 60);
      Body<String> b = w.body(20);
      WorldState before = w.save(null);
      long hash = w.stateHash();
      changes.get(i).accept(b);
      assertNotEquals(hash, w.stateHash(), "change " + i);
      WorldState after = w.save(null);
      steps(w, 60);
      long changed = w.stateHash();
      w.restore(before);
      assertEquals(hash, w.stateHash(), "change " + i);
      steps(w, 60);
      assertNotEquals(changed, w.stateHash(), "change " + i);
      w.restore(after);
      steps(w, 60);
      assertEquals(changed, w.stateHash(), "change " + i);
    }
  }

  @Test
  void restoringBringsOldMaterialsBack() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, 1, 1, M);
    WorldState before = w.save(null);
    b.setMaterial(0, M.withFriction(0.1f));
    b.setMass(5, 5, 0, 0);
    WorldState after = w.save(null);
    w.restore(before);
    assertEquals(0.6f, b.material(0).friction());
    assertFalse(b.hasOwnMass());
    w.restore(after);
    assertEquals(0.1f, b.material(0).friction());
    assertTrue(b.hasOwnMass());
  }

  static List<Float> absurd() {
    return List.of(Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, 1e30f, -1e30f);
  }

  @ParameterizedTest
  @MethodSource("absurd")
  void absurdMassIsRefusedByName(float bad) {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, 1, 1, M);
    long hash = w.stateHash();
    refused("mass=" + bad, () -> b.setMass(bad, 1, 0, 0));
    refused("inertia=" + bad, () -> b.setMass(1, bad, 0, 0));
    refused("centerX=" + bad, () -> b.setMass(1, 1, bad, 0));
    refused("centerY=" + bad, () -> b.setMass(1, 1, 0, bad));
    refused("mass=" + bad, () -> new BodyDef().mass(bad, 1, 0, 0));
    refused("density=" + bad, () -> b.setMaterial(0, M.withDensity(bad)));
    refused("hitSpeed=" + bad, () -> new WorldDef().withHitSpeed(bad));
    assertEquals(hash, w.stateHash());
  }

  @Test
  void impossibleChangesAreRefusedAndLeaveNoTrace() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, 1, 1, M);
    long hash = w.stateHash();
    refused("mass=0.0", () -> b.setMass(0, 1, 0, 0));
    refused("inertia=-1.0", () -> b.setMass(1, -1, 0, 0));
    refused("mass=0.0", () -> b.setMaterial(0, M.withDensity(0)));
    refused("material=null", () -> b.setMaterial(0, null));
    refused("filter=null", () -> b.setFilter(0, null));
    Exception e = assertThrows(IndexOutOfBoundsException.class, () -> b.setSensor(1, true));
    assertTrue(e.getMessage().contains("shape=1"), e.getMessage());
    w.queryAabb(
        -1,
        -1,
        1,
        1,
        found -> {
          assertThrows(IllegalStateException.class, () -> found.setMass(1, 1, 0, 0));
          assertThrows(IllegalStateException.class, () -> found.setFixedRotation(true));
          assertThrows(IllegalStateException.class, () -> found.setSensor(0, true));
          return true;
        });
    assertEquals(hash, w.stateHash());
    assertEquals(M, b.material(0));
  }

  private static void refused(String part, Runnable call) {
    String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
    assertTrue(message.contains(part), message);
  }
}
