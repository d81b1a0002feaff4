package carom.physics;

import static carom.physics.Scenes.DT;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Slice;
import carom.physics.archive.ArchiveException;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Polygon;
import carom.physics.particles.Particles;
import carom.sim.pool.ShownParticles;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneRun;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** A world as bytes goes on in another world, to the bit; and whatever else is in them is told. */
class StateBytesTest {
  /** How long a scene is compared; -Dcarom.ticks=300 for a thorough look. */
  private static final int TICKS = Integer.getInteger("carom.ticks", 60);

  private static byte[] bytes(World<?> w) {
    ArchiveWriter out = new ArchiveWriter();
    w.save(null).write(out);
    return out.toBytes();
  }

  private static void restore(World<String> w, byte[] bytes) {
    ArchiveReader in = new ArchiveReader(bytes);
    w.restore(w.read(in, slot -> w.body(slot) == null ? "read" : null));
    assertTrue(in.isEmpty());
  }

  /** All that can be seen of contacts. */
  private static List<String> contacts(World<?> w) {
    List<String> all = new ArrayList<>();
    w.forEachContact(
        (x, y, nx, ny, separation, impulse) ->
            all.add(x + " " + y + " " + nx + " " + ny + " " + separation + " " + impulse));
    all.sort(null);
    return all;
  }

  private static void assertGoOnAlike(String what, World<String> one, World<String> other, int n) {
    assertEquals(one.stateHash(), other.stateHash(), what);
    assertEquals(contacts(one), contacts(other), what);
    for (int tick = 1; tick <= n; tick++) {
      one.step(DT);
      other.step(DT);
      assertEquals(one.stateHash(), other.stateHash(), what + ", after ticks=" + tick);
    }
    assertEquals(contacts(one), contacts(other), what);
    assertArrayEquals(bytes(one), bytes(other), what);
  }

  @Test
  void everySceneOfTheLibraryGoesOnInAnEmptyWorld() {
    for (Scene scene : carom.sim.scene.Scenes.all()) {
      SceneRun run = scene.start();
      int bodies = run.world().bodyCount();
      if (bodies > 3_000) {
        continue;
      }
      run.steps(bodies > 300 ? 10 : 60);
      World<String> copy = new World<>(run.world().def());
      restore(copy, bytes(run.world()));
      run.world().listener(null);
      assertGoOnAlike(scene.name(), run.world(), copy, bodies > 300 ? 10 : TICKS);
    }
  }

  @Test
  void goldenScenesGoOnFromWhereTheyFallAsleepToo() {
    for (GoldenScenes golden : GoldenScenes.values()) {
      World<String> w = golden.start();
      for (int round = 0; round < 3; round++) {
        for (int i = 0; i < 60; i++) {
          w.step(DT);
        }
        World<String> copy = new World<>(w.def());
        restore(copy, bytes(w));
        assertGoOnAlike(golden + ", round=" + round, w, copy, 60);
      }
    }
  }

  @Test
  void whatFellAsleepWakesInTheCopyAsInTheOriginal() {
    World<String> w = Scenes.pile(40, 4);
    for (int i = 0; i < 900; i++) {
      w.step(DT);
    }
    assertTrue(w.profile().awake() < 20, "some sleep: " + w.profile());
    World<String> copy = new World<>(w.def());
    restore(copy, bytes(w));
    for (World<String> each : List.of(w, copy)) {
      each.createBody(
          new BodyDef(BodyType.DYNAMIC).shape(new Circle(0.7f)).position(0, 25).velocity(0, -20),
          "ball");
    }
    assertGoOnAlike("woken", w, copy, 300);
  }

  @Test
  void particlesGoOnInAnotherRunOfTheScene() {
    int tested = 0;
    for (Scene scene : carom.sim.scene.Scenes.all()) {
      SceneRun run = scene.start();
      if (run.particles().isEmpty()) {
        continue;
      }
      tested++;
      run.steps(15);
      SceneRun other = scene.start();
      restore(other.world(), bytes(run.world()));
      for (int i = 0; i < run.particles().size(); i++) {
        ArchiveWriter out = new ArchiveWriter();
        Particles from = run.particles().get(i).particles();
        Particles to = other.particles().get(i).particles();
        from.save(null).write(out);
        to.restore(to.read(new ArchiveReader(out.toBytes())));
        assertEquals(from.stateHash(), to.stateHash(), scene.name());
      }
      for (int tick = 0; tick < 15; tick++) {
        for (SceneRun each : List.of(run, other)) {
          for (ShownParticles some : each.particles()) {
            some.particles().step(each.world(), DT);
          }
          each.world().step(DT);
        }
        assertEquals(run.world().stateHash(), other.world().stateHash(), scene.name());
      }
    }
    assertTrue(tested > 0);
  }

  /** A world with everything in it, of few bytes. */
  private static World<String> zoo() {
    World<String> w = JointLifeTest.zoo(1);
    BodyDef ground = new BodyDef(BodyType.STATIC).position(0, -3);
    w.createBody(ground.shape(Chain.loop(-9, -1, 9, -1, 9, 1, -9, 1)), "ground");
    w.createBody(
        new BodyDef(BodyType.DYNAMIC)
            .position(1, 3)
            .bullet(true)
            .mass(2, 0.3f, 0.1f, 0)
            .shape(Compound.of(new Box(0.2f, 0.3f), new Capsule(0, 0, 1, 0, 0.1f))),
        "compound");
    w.createBody(
        new BodyDef(BodyType.DYNAMIC)
            .position(-2, 2)
            .angularVelocity(3)
            .shape(
                new ShapeDef(
                    Polygon.rounded(0.05f, 0, 0, 0.7f, 0, 0.3f, 0.6f),
                    Material.DEFAULT.withRestitution(0.4f).withTag(7),
                    new Filter(2, -1, 3),
                    false))
            .shape(new ShapeDef(new Circle(1)).withSensor(true)),
        "polygon");
    Body<String> gone = Scenes.disc(w, 4, 4, 0.3f, Material.DEFAULT);
    Scenes.disc(w, 4, 6, 0.3f, Material.DEFAULT);
    w.destroyBody(gone);
    return w;
  }

  @Test
  void handlesThatAreKnownStayAndOthersComeWithTheirUsers() {
    World<String> w = zoo();
    Body<String> first = w.body(0);
    Joint<String> joint = w.joint(0);
    byte[] bytes = bytes(w);
    long hash = w.stateHash();
    Body<String> late = Scenes.disc(w, 9, 9, 0.3f, Material.DEFAULT);
    w.step(DT);
    w.destroyJoint(joint);
    restore(w, bytes);
    assertEquals(hash, w.stateHash());
    assertSame(first, w.body(0));
    assertFalse(late.isValid());
    assertTrue(w.joint(0).isValid());

    World<String> copy = new World<>(w.def());
    restore(copy, bytes);
    w.forEachBody(
        b -> {
          Body<String> c = copy.body(b.index());
          assertNotNull(c);
          assertEquals("read", c.user());
          assertEquals(b.type(), c.type());
          assertEquals(b.shapeCount(), c.shapeCount());
          assertEquals(b.mass(), c.mass());
          assertEquals(b.x(), c.x());
        });
    assertEquals(w.jointCount(), copy.jointCount());
    Scenes.disc(w, 5, 9, 0.3f, Material.DEFAULT);
    Scenes.disc(copy, 5, 9, 0.3f, Material.DEFAULT);
    assertGoOnAlike("with a newcomer", w, copy, 120);
  }

  @Test
  void theWorldOfAnotherDefinitionOrFormatIsRefused() {
    byte[] bytes = bytes(zoo());
    World<String> other = new World<>(new WorldDef().withGravity(0, -9));
    String message = assertThrows(ArchiveException.class, () -> restore(other, bytes)).getMessage();
    assertTrue(message.contains("WorldDef"), message);
    assertEquals(0, other.bodyCount());
    bytes[3]++;
    message = assertThrows(ArchiveException.class, () -> restore(zoo(), bytes)).getMessage();
    assertTrue(message.contains("format of the state"), message);
  }

  @Test
  void theWorldOfAnotherPhysicsVersionIsReadAndSaysSo() {
    World<String> saved = zoo();
    byte[] bytes = bytes(saved);
    bytes[7]++;
    World<String> world = zoo();
    WorldState state = world.read(new ArchiveReader(bytes), slot -> null);
    assertEquals(World.PHYSICS_VERSION + 1, state.physicsVersion());
    world.restore(state);
    assertEquals(saved.stateHash(), world.stateHash());
    assertEquals(World.PHYSICS_VERSION, world.save(null).physicsVersion());
    assertEquals(World.PHYSICS_VERSION, world.save(state).physicsVersion());
  }

  /** One wrong byte, or several, or an end too early: refused, or a world that can be stepped. */
  @Test
  void damagedBytesAreRefusedOrCanBeStepped() {
    World<String> zoo = zoo();
    for (int i = 0; i < 40; i++) {
      zoo.step(DT);
    }
    byte[] good = bytes(zoo);
    long seed = Long.getLong("carom.seed", 5);
    Random random = new Random(seed);
    int read = 0;
    int rounds = (int) Slice.of(500, 1_500);
    for (int round = 0; round < rounds; round++) {
      byte[] bytes = good.clone();
      int flips = 1 + random.nextInt(3);
      for (int i = 0; i < flips; i++) {
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
      }
      int length = random.nextInt(20) == 0 ? random.nextInt(bytes.length) : bytes.length;
      World<String> w = new World<>(zoo.def());
      try {
        w.restore(w.read(new ArchiveReader(bytes, length), slot -> "read"));
        read++;
        for (int i = 0; i < 3; i++) {
          w.step(DT);
        }
        w.stateHash();
      } catch (ArchiveException e) {
        assertEquals(0, w.bodyCount());
      } catch (RuntimeException | Error e) {
        throw new AssertionError("seed=" + seed + " round=" + round, e);
      }
    }
    assertTrue(read > 0.1 * rounds && read < 0.9 * rounds, "read=" + read);
  }

  /** What the API refuses to set, an archive can't bring in either. */
  @Test
  void whatNobodyMaySetIsRefused() {
    World<String> w = zoo();
    int hinge = 0;
    w.dynamics().joints().hertz[hinge] = 1_001;
    w.dynamics().joints().coldChanged();
    byte[] joint = bytes(w);
    w.dynamics().joints().hertz[hinge] = 1_000;
    w.dynamics().joints().coldChanged();
    byte[] allowed = bytes(w);
    w.store().linearDamping[0] = -1;
    w.store().coldChanged();
    byte[] body = bytes(w);
    World<String> other = zoo();
    restore(other, allowed);
    assertRefused(other, joint, "hertz=1001.0 of joint=0 is outside 0..1000.0");
    assertRefused(other, body, "damping of body=0 is negative");
  }

  private static void assertRefused(World<String> w, byte[] bytes, String why) {
    ArchiveException e = assertThrows(ArchiveException.class, () -> restore(w, bytes));
    assertTrue(e.getMessage().contains(why), e.getMessage());
  }
}
