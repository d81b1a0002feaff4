package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.box;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Box;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Shapes that are added to bodies, removed and replaced while the world runs. */
class ShapeEditTest {
  private static final Material M = Material.DEFAULT;

  private static ShapeDef square(float x, float y, float half) {
    return new ShapeDef(
        Polygon.of(x - half, y - half, x + half, y - half, x + half, y + half, x - half, y + half));
  }

  /** Notes who begins and who ceases to touch. */
  private static List<String> listen(World<String> w) {
    List<String> told = new ArrayList<>();
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            told.add(
                "begin "
                    + c.self().user()
                    + c.selfShapeIndex()
                    + " "
                    + c.other().user()
                    + c.otherShapeIndex());
          }

          @Override
          public void end(Collision<String> c) {
            told.add(
                "end "
                    + c.self().user()
                    + c.selfShapeIndex()
                    + " "
                    + c.other().user()
                    + c.otherShapeIndex());
          }
        });
    return told;
  }

  private static World<String> copyOf(World<String> w) {
    ArchiveWriter out = new ArchiveWriter();
    w.save(null).write(out);
    World<String> copy = new World<>(w.def());
    copy.restore(copy.read(new ArchiveReader(out.toBytes()), slot -> "copy"));
    return copy;
  }

  /** Two unit squares at x = 0 and x = 2 are a body of 2 kg about x = 1, by Steiner's theorem. */
  @Test
  void massCentreAndInertiaFollowTheShapes() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 3, 4, 0.5f, 0.5f, M);
    b.setVelocity(1, 0);
    b.setAngularVelocity(2);
    b.addShape(square(2, 0, 0.5f));
    assertEquals(2, b.shapeCount());
    assertEquals(2, b.mass(), 1e-6);
    assertEquals(1, b.localCenterX(), 1e-6);
    assertEquals(2 * (1 / 6.0 + 1), b.inertia(), 1e-5);
    assertEquals(3, b.x(), 1e-6);
    assertEquals(1, b.velocityAtX(3, 4), 1e-6);
    assertEquals(0, b.velocityAtY(3, 4), 1e-5);
    b.removeShape(0);
    assertEquals(1, b.mass(), 1e-6);
    assertEquals(2, b.localCenterX(), 1e-6);
    assertEquals(1 / 6.0, b.inertia(), 1e-5);
    b.replaceShape(0, new ShapeDef(new Circle(1), M.withDensity(3)));
    assertEquals(3 * Math.PI, b.mass(), 1e-4);
    assertEquals(0, b.localCenterX(), 1e-6);
    assertEquals(3, b.x(), 1e-6);
  }

  @Test
  void anOwnMassStaysWhateverTheShapes() {
    World<String> w = Scenes.space();
    Body<String> b = box(w, 0, 0, 0.5f, 0.5f, M);
    b.setMass(7, 2, 0.25f, 0);
    b.addShape(square(2, 0, 0.5f));
    b.removeShape(0);
    assertEquals(7, b.mass());
    assertEquals(2, b.inertia());
    assertEquals(0.25f, b.localCenterX());
  }

  @ParameterizedTest
  @EnumSource(BodyType.class)
  void anEditedBodyIsTheSameAsOneThatWasCreatedSo(BodyType type) {
    World<String> built = Scenes.floor(M);
    World<String> edited = Scenes.floor(M);
    ShapeDef left = square(-1, 0, 0.25f);
    ShapeDef middle = new ShapeDef(new Circle(0.5f), M.withFriction(0.1f));
    ShapeDef right = square(1, 0, 0.25f);
    ShapeDef other = new ShapeDef(new Box(0.1f, 2)).withSensor(true);
    BodyDef at = new BodyDef(type).position(2, 0.4375f);
    built.createBody(at.shape(left).shape(middle).shape(right), "built");
    Body<String> b =
        edited.createBody(
            new BodyDef(type).position(2, 0.4375f).shape(left).shape(other).shape(right), "edited");
    b.replaceShape(1, middle);
    assertEquals(built.stateHash(), edited.stateHash());
    b.addShape(other);
    assertNotEquals(built.stateHash(), edited.stateHash());
    b.removeShape(3);
    assertEquals(built.stateHash(), edited.stateHash());
    for (int i = 0; i < 120; i++) {
      built.step(DT);
      edited.step(DT);
      assertEquals(built.stateHash(), edited.stateHash(), "step=" + i);
    }
  }

  @Test
  void worldsWhoseShapesDifferHaveOtherHashes() {
    World<String> w = Scenes.space();
    World<String> v = Scenes.space();
    Body<String> b = w.createBody(new BodyDef().shape(new Box(1, 1)), "b");
    v.createBody(new BodyDef().shape(new Box(1, 1)), "b");
    assertEquals(w.stateHash(), v.stateHash());
    b.replaceShape(0, new ShapeDef(new Box(1, 1.001f)));
    assertNotEquals(w.stateHash(), v.stateHash());
  }

  /** A table on two legs: the leg that goes ends its contact, the one that stays keeps its own. */
  @Test
  void onlyTheContactsOfTheShapeThatGoesEnd() {
    World<String> w = Scenes.floor(M);
    Body<String> table =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .position(0, 0)
                .shape(square(-2, 0.25f, 0.25f))
                .shape(square(0, 0.25f, 0.25f))
                .shape(square(2, 0.25f, 0.25f)),
            "table");
    steps(w, 30);
    List<String> told = listen(w);
    table.removeShape(0);
    assertEquals(List.of("end floor0 table0"), told);
    int[] points = new int[1];
    table.forEachContact((other, nx, ny, impulse) -> points[0]++);
    assertEquals(2, points[0]);
    steps(w, 30);
    assertEquals(1, told.size(), () -> "told=" + told);
    assertEquals(0, table.angle(), 1e-3);
    assertEquals(0, table.y(), 5e-3);
  }

  @Test
  void whatStoodOnAShapeThatIsGoneFallsEvenFromSleep() {
    World<String> w = new World<>(new WorldDef());
    Body<String> ground =
        w.createBody(
            new BodyDef().shape(new ShapeDef(new Box(2, 1))).shape(square(20, -1, 1)), "ground");
    Body<String> b = box(w, 0, 1.25f, 0.25f, 0.25f, M);
    Body<String> far = box(w, 20, 0.25f, 0.25f, 0.25f, M);
    steps(w, 120);
    assertFalse(b.awake());
    assertFalse(far.awake());
    List<String> told = listen(w);
    ground.removeShape(0);
    assertEquals(List.of("end ground0 box0"), told);
    steps(w, 60);
    assertEquals(1.25 - 5, b.y(), 0.1);
    assertEquals(0.25, far.y(), 5e-3);
  }

  @ParameterizedTest
  @EnumSource(BodyType.class)
  void aShapeThatIsAddedIsFoundAndStruck(BodyType type) {
    World<String> w = new World<>(new WorldDef());
    Body<String> ground =
        w.createBody(
            new BodyDef(type).gravityScale(0).mass(1e9f, 1e9f, 0, 0).shape(square(9, -1, 1)), "g");
    Body<String> b = box(w, 0, 1.25f, 0.25f, 0.25f, M);
    Body<String> asleep =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .position(1, 1.25f)
                .shape(new Box(0.25f, 0.25f))
                .awake(false),
            "asleep");
    assertNull(w.bodyAt(0, -1));
    ground.addShape(new ShapeDef(new Box(2, 1)));
    assertSame(ground, w.bodyAt(0, -0.9f));
    steps(w, 120);
    assertEquals(1.25, b.y(), 0.01);
    assertEquals(1.25, asleep.y(), 0.01);
  }

  @Test
  void aSensorThatIsRemovedEndsItsOverlaps() {
    World<String> w = Scenes.space();
    Body<String> gate =
        w.createBody(
            new BodyDef()
                .shape(square(9, 9, 1))
                .shape(new ShapeDef(new Box(1, 1)).withSensor(true)),
            "gate");
    Body<String> b = box(w, 0, 0, 0.25f, 0.25f, M);
    List<String> told = listen(w);
    w.step(DT);
    gate.removeShape(1);
    assertEquals(List.of("begin gate1 box0", "end gate1 box0"), told);
    gate.forEachOverlap(
        other -> {
          throw new AssertionError(other);
        });
    w.step(DT);
    assertEquals(2, told.size());
    gate.addShape(new ShapeDef(new Box(1, 1)).withSensor(true));
    w.step(DT);
    assertEquals("begin gate1 box0", told.get(2));
    assertEquals(0, b.velocityX());
  }

  @Test
  void jointsStayWhereTheyWere() {
    World<String> w = new World<>(new WorldDef());
    Body<String> b = box(w, 0, -1, 0.1f, 1, M);
    Joint<String> hinge = w.createJoint(JointDef.revolute(null, b, 0, 0));
    b.addShape(square(3, 0, 0.5f));
    b.removeShape(0);
    assertTrue(hinge.isValid());
    for (int i = 0; i < 200; i++) {
      w.step(DT);
      double x = b.worldPointX(0, 1);
      double y = b.worldPointY(0, 1);
      assertTrue(Math.hypot(x, y) < 0.01, "step=" + i + " x=" + x + " y=" + y);
    }
  }

  @Test
  void callsInACallbackAddUpAndTakeEffectAfterTheStep() {
    World<String> w = Scenes.floor(M);
    Body<String> b = box(w, 0, 0.5f, 0.5f, 0.5f, M);
    ShapeDef x = square(5, 5, 0.1f);
    ShapeDef y = square(5, 6, 0.2f);
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            b.addShape(x);
            b.addShape(y);
            b.removeShape(1);
            b.setMaterial(1, M.withFriction(0.25f));
            assertThrows(IndexOutOfBoundsException.class, () -> b.removeShape(2));
            assertEquals(1, b.shapeCount());
          }
        });
    w.step(DT);
    assertEquals(2, b.shapeCount());
    assertSame(y.shape(), b.shape(1));
    assertEquals(0.25f, b.material(1).friction());
  }

  @Test
  void aBodyThatIsDestroyedInTheSameStepIsJustGone() {
    World<String> w = Scenes.floor(M);
    Body<String> b = box(w, 0, 0.5f, 0.5f, 0.5f, M);
    w.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            w.destroyBody(b);
            b.removeShape(0);
          }
        });
    w.step(DT);
    assertFalse(b.isValid());
    assertEquals(1, w.bodyCount());
    assertEquals(1, b.shapeCount());
  }

  @Test
  void aDisabledBodyGetsItsShapesToo() {
    World<String> w = Scenes.floor(M);
    Body<String> b = box(w, 0, 3, 0.5f, 0.5f, M);
    b.setEnabled(false);
    b.addShape(square(0, -2, 0.5f));
    b.removeShape(0);
    assertNull(w.bodyAt(0, 1));
    b.setEnabled(true);
    assertSame(b, w.bodyAt(0, 1));
    steps(w, 120);
    assertEquals(2.5, b.y(), 0.01);
  }

  @Test
  void whatCantBeIsRefusedAndChangesNothing() {
    World<String> w = Scenes.floor(M);
    Body<String> b = box(w, 0, 0.5f, 0.5f, 0.5f, M);
    long before = w.stateHash();
    ShapeDef line = new ShapeDef(Chain.open(0, 0, 1, 0, 2, 0));
    assertThrows(IllegalArgumentException.class, () -> b.addShape(line));
    assertThrows(IllegalArgumentException.class, () -> b.replaceShape(0, line));
    assertThrows(
        IllegalArgumentException.class,
        () -> b.replaceShape(0, new ShapeDef(new Box(1, 1), M.withDensity(0))));
    assertThrows(NullPointerException.class, () -> b.addShape(null));
    String wrong =
        assertThrows(IndexOutOfBoundsException.class, () -> b.removeShape(1)).getMessage();
    assertEquals("shape=1 is outside 0..0; see shapeCount()", wrong);
    assertThrows(IndexOutOfBoundsException.class, () -> b.replaceShape(-1, square(0, 0, 1)));
    Body<String> floor = w.body(0);
    for (int i = 0; i < 10; i++) {
      floor.addShape(new ShapeDef(row(100)));
    }
    assertThrows(IllegalArgumentException.class, () -> floor.addShape(new ShapeDef(row(100))));
    for (int i = 10; i > 0; i--) {
      floor.removeShape(i);
    }
    assertEquals(before, w.stateHash());
    w.queryAabb(
        -1,
        -1,
        1,
        1,
        found -> {
          assertThrows(IllegalStateException.class, () -> b.addShape(square(0, 0, 1)));
          return false;
        });
    w.destroyBody(floor);
    assertThrows(IllegalStateException.class, () -> floor.removeShape(0));
  }

  private static Compound row(int n) {
    List<Convex> parts = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      parts.add(new Circle(0.1f, 1000 + i, -50));
    }
    return Compound.of(parts);
  }

  @Test
  void aShapeHasAUserThatGoesWithIt() {
    World<String> w = Scenes.floor(M);
    Body<String> b =
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .position(0, 0.5f)
                .shape(square(-1, 0, 0.5f).withUser("left"))
                .shape(square(1, 0, 0.5f)),
            "b");
    steps(w, 120);
    assertFalse(b.awake());
    long before = w.stateHash();
    WorldState saved = w.save(null);
    b.setShapeUser(1, "right");
    assertFalse(b.awake());
    assertEquals(before, w.stateHash());
    assertEquals("left", b.shapeUser(0));
    ArchiveWriter out = new ArchiveWriter();
    w.save(null).write(out);
    b.removeShape(0);
    assertEquals("right", b.shapeUser(0));
    b.setMaterial(0, M.withFriction(0.1f));
    assertEquals("right", b.shapeUser(0));
    w.restore(saved);
    assertEquals("left", b.shapeUser(0));
    assertNull(b.shapeUser(1));
    b.setShapeUser(1, "again");
    w.restore(w.read(new ArchiveReader(out.toBytes()), slot -> null));
    assertEquals("left", b.shapeUser(0));
    assertEquals("again", b.shapeUser(1));
  }

  private static ShapeDef random(Random r) {
    float x = r.nextFloat() * 1.5f - 0.75f;
    float y = r.nextFloat() * 1.5f - 0.75f;
    Shape shape =
        switch (r.nextInt(3)) {
          case 0 -> new Circle(0.1f + 0.3f * r.nextFloat(), x, y);
          case 1 -> square(x, y, 0.1f + 0.3f * r.nextFloat()).shape();
          default -> Compound.of(new Circle(0.2f, x, y), new Circle(0.2f, y, x));
        };
    ShapeDef def = new ShapeDef(shape, M.withRestitution(r.nextFloat() * 0.5f));
    return r.nextInt(6) == 0 ? def.withSensor(true) : def;
  }

  private static void edit(World<String> w, Random r) {
    Body<String> b = w.body(1 + r.nextInt(w.slotCount() - 1));
    int n = b.shapeCount();
    int what = r.nextInt(n < 2 ? 2 : n > 5 ? 3 : 4);
    if (what == 0 && n <= 5) {
      b.addShape(random(r));
    } else if (what < 2) {
      b.replaceShape(r.nextInt(n), random(r));
    } else {
      b.removeShape(r.nextInt(n));
    }
  }

  private static World<String> heap(Random r) {
    World<String> w = new World<>(new WorldDef().withSleepDelay(0.2f));
    w.createBody(new BodyDef().shape(new Box(20, 1)).position(0, -1), "floor");
    w.createBody(new BodyDef().shape(random(r)).position(0, 1), "static");
    w.createBody(
        new BodyDef(BodyType.KINEMATIC).shape(random(r)).position(2, 1).angularVelocity(1), "fan");
    for (int i = 0; i < 30; i++) {
      w.createBody(
          new BodyDef(BodyType.DYNAMIC).shape(random(r)).position(i % 6 - 2.5f, 1 + i / 6), "b");
    }
    return w;
  }

  /** Saved, restored and replayed; and as bytes, in a world that never knew the shapes before. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4})
  void randomEditsReplayAndArchiveToTheBit(int seed) {
    Random r = new Random(seed);
    World<String> w = heap(r);
    for (int round = 0; round < 20; round++) {
      String at = "seed=" + seed + " round=" + round;
      WorldState saved = w.save(null);
      long editSeed = r.nextLong();
      long first = run(w, editSeed);
      long before = w.stateHash();
      World<String> copy = copyOf(w);
      assertEquals(before, copy.stateHash(), at);
      w.restore(saved);
      assertEquals(first, run(w, editSeed), at);
      for (int i = 0; i < 5; i++) {
        w.step(DT);
        copy.step(DT);
        assertEquals(w.stateHash(), copy.stateHash(), at + " step=" + i);
      }
    }
  }

  private static long run(World<String> w, long seed) {
    Random r = new Random(seed);
    for (int i = 0; i < 10; i++) {
      edit(w, r);
      w.step(DT);
    }
    edit(w, r);
    return w.stateHash();
  }

  /** The contacts of an edited world are those of one that gets its bodies' rows anew. */
  @ParameterizedTest
  @ValueSource(ints = {5, 6, 7})
  void theBroadphaseFindsWhatABruteSearchFinds(int seed) {
    Random r = new Random(seed);
    World<String> w = heap(r);
    for (int round = 0; round < 60; round++) {
      edit(w, r);
      w.step(DT);
      float x = r.nextFloat() * 8 - 4;
      float y = r.nextFloat() * 5 - 0.5f;
      List<Integer> found = new ArrayList<>();
      w.queryAabb(x, y, x + 0.5f, y + 0.5f, b -> found.add(b.index()));
      List<Integer> brute = new ArrayList<>();
      Aabb box = new Aabb();
      Transform pose = new Transform();
      w.forEachBody(
          b -> {
            boolean over = false;
            for (int i = 0; i < b.shapeCount(); i++) {
              for (Convex part : b.shape(i).parts()) {
                pose.set(b.x(), b.y(), b.cos(), b.sin());
                part.aabb(pose, box);
                over |=
                    box.minX <= x + 0.499f
                        && box.maxX >= x + 0.001f
                        && box.minY <= y + 0.499f
                        && box.maxY >= y + 0.001f;
              }
            }
            if (over) {
              brute.add(b.index());
            }
          });
      assertTrue(
          found.containsAll(brute),
          "seed=" + seed + " round=" + round + " found=" + found + " brute=" + brute);
    }
  }
}
