package carom.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.MotionLocks;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.sim.entity.AssemblyDef;
import carom.sim.entity.Entity;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Area;
import carom.sim.level.Level;
import carom.sim.near.Neighbourhood;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

/** An entity becomes one of another archetype in its place, see {@link HostEntity#become}. */
class BecomeTest {
  private static final Count HEALTH =
      Field.count("health", 0, 500).startsAt(100).of(Scope.ENTITY).to(Audience.NEAR);

  /** A crate becomes what the test says, in the callback that the test chooses. */
  private static final class Rules implements Game {
    private Archetype crate;
    private Archetype ice;
    private Archetype rock;
    private Archetype wheel;
    private Archetype fan;
    private Consumer<Entity> inInput = e -> {};
    private Consumer<Entity> inForces = e -> {};

    @Override
    public String name() {
      return "become";
    }

    @Override
    public String defaultLevel() {
      return "become";
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(HEALTH);
    }

    @Override
    public void setUp(SetUp s) {
      crate = add(s, new ArchetypeDef("crate").tag(1), new Box(0.5f, 0.5f));
      ice =
          add(
              s,
              new ArchetypeDef("ice")
                  .tag(2)
                  .linearDamping(0.25f)
                  .angularDamping(0.5f)
                  .gravityScale(0.5f)
                  .sleepSpeed(0.01f)
                  .bullet(true)
                  .motionLocks(MotionLocks.NONE.withAngularZ(true))
                  .filter(new Filter(2, -1, 0))
                  .starts(HEALTH.startsAt(300)),
              new Box(0.5f, 0.25f, 0.25f, -0.25f),
              new Circle(0.2f));
      rock = add(s, new ArchetypeDef("rock").type(BodyType.STATIC), new Circle(0.4f));
      wheel = add(s, new ArchetypeDef("wheel").type(BodyType.KINEMATIC).spin(3), new Circle(0.5f));
      fan =
          add(
              s,
              new ArchetypeDef("fan").area(Area.gravity(-90, -90, 90, 90, 0, 5)),
              new Box(0.5f, 0.5f));
      s.assembly(new AssemblyDef("pair").body("a", carOf("a"), 0, 0));
    }

    private static ArchetypeDef carOf(String name) {
      return new ArchetypeDef(name).shape(new Circle(0.3f), new Material(1, 0.5f, 0));
    }

    private static Archetype add(
        SetUp s, ArchetypeDef def, carom.physics.geometry.Shape... shapes) {
      for (carom.physics.geometry.Shape shape : shapes) {
        def.shape(shape, new Material(2, 0.1f * shapes.length, 0));
      }
      return s.archetype(def);
    }

    @Override
    public void join(Match s, Player p) {
      s.spawn(crate, 0, 2, 0, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      inInput.accept(p.entity());
    }

    @Override
    public void forces(Simulation s, Entity e) {
      inForces.accept(e);
    }
  }

  private final Rules game = new Rules();
  private final SimulationHost s = start(game, Role.AUTHORITY);

  private static SimulationHost start(Rules game, Role role) {
    String json =
        """
        {"name": "become", "game": "become", "gravity": [0, -10],
         "bounds": {"min": [-20, -8], "max": [20, 20]}, "spawns": [{"at": [0, 2]}],
         "statics": [{"at": [0, -1], "shape": {"type": "box", "width": 30, "height": 2}}]}
        """;
    try {
      Level level = Level.parse("become.json", json.getBytes(StandardCharsets.UTF_8));
      return new SimulationHost(game, level, 1, 60, role);
    } catch (carom.sim.level.LevelException e) {
      throw new AssertionError(e);
    }
  }

  private static String refused(Class<? extends Exception> why, Executable what) {
    return assertThrows(why, what).getMessage();
  }

  @Test
  void theBodyIsAsTheNewArchetypeSaysAndTheRestStays() {
    HostPlayer ann = s.join("Ann");
    HostEntity e = ann.entity();
    e.set(HEALTH, 42);
    e.body().setPose(1, 5, 0.5f);
    e.body().setVelocity(1, 2);
    e.body().setAngularVelocity(0);
    e.become(game.ice);
    final Body<HostEntity> made = s.spawn(game.ice, 1, 5, 0.5f, null).body();
    Body<HostEntity> body = e.body();
    assertSame(game.ice, e.archetype());
    assertEquals(2, e.tag());
    assertSame(e, ann.entity());
    assertSame(e, s.entity(e.id()));
    assertEquals(42, e.get(HEALTH));
    assertEquals(made.x(), body.x(), 1e-6f);
    assertEquals(made.y(), body.y(), 1e-6f);
    assertEquals(1, body.velocityX());
    assertEquals(2, body.velocityY());
    assertEquals(made.mass(), body.mass());
    assertEquals(made.localCenterX(), body.localCenterX());
    assertEquals(2, body.shapeCount());
    assertEquals(made.material(1), body.material(1));
    assertEquals(new Filter(2, -1, 0), body.filter(0));
    assertEquals(0.25f, body.linearDamping());
    assertEquals(0.5f, body.angularDamping());
    assertEquals(0.5f, body.gravityScale());
    assertEquals(0.01f, body.sleepSpeed());
    assertTrue(body.isBullet());
    assertTrue(body.isFixedRotation());
    e.become(game.crate);
    assertEquals(1, body.shapeCount());
    assertEquals(made.sleepSpeed() * 0 + s.world().def().sleepSpeed(), body.sleepSpeed());
    assertEquals(1, body.gravityScale());
    assertEquals(1, body.x(), 1e-5f);
  }

  @Test
  void theTypeMayChangeAndJointsStay() {
    HostEntity a = s.spawn(game.crate, -2, 5, 0, null);
    HostEntity b = s.spawn(game.crate, 0, 5, 0, null);
    Joint<HostEntity> joint = s.connect(JointDef.revolute(a.body(), b.body(), -1, 5));
    b.body().setVelocity(3, 0);
    b.become(game.rock);
    assertEquals(BodyType.STATIC, b.body().type());
    assertEquals(0, b.body().velocityX());
    for (int i = 0; i < 60; i++) {
      s.step();
    }
    assertTrue(joint.isValid());
    assertEquals(0, b.body().x());
    assertEquals(5, b.body().y());
    assertTrue(a.body().x() != -2, "it swings");
    b.become(game.wheel);
    assertEquals(3, b.body().angularVelocity());
    b.become(game.crate);
    for (int i = 0; i < 30; i++) {
      s.step();
    }
    assertTrue(b.body().y() < 4.9f, "it falls");
    assertTrue(joint.isValid());
  }

  @Test
  void anAreaComesAndGoesWithTheArchetype() {
    HostEntity e = s.spawn(game.crate, 5, 5, 0, null);
    HostEntity other = s.spawn(game.crate, -5, 5, 0, null);
    e.become(game.fan);
    s.step();
    assertTrue(other.body().velocityY() > 0, "gravity points up");
    e.become(game.crate);
    final float before = other.body().velocityY();
    s.step();
    assertTrue(other.body().velocityY() < before);
  }

  @Test
  void savedStatesAndBytesHaveTheArchetypeOfTheirTime() throws Exception {
    HostEntity e = s.join("Ann").entity();
    s.step();
    SimState before = s.save(null);
    final long hashBefore = s.stateHash();
    e.become(game.ice);
    assertNotEquals(hashBefore, s.stateHash());
    s.step();
    SimState after = s.save(null);
    final long hashAfter = s.stateHash();
    s.restore(before);
    assertSame(game.crate, e.archetype());
    assertEquals(hashBefore, s.stateHash());
    e.become(game.ice);
    s.step();
    assertEquals(hashAfter, s.stateHash());
    s.restore(before);
    ArchiveWriter bytes = new ArchiveWriter();
    after.write(bytes); // while the simulation stands elsewhere
    Rules twin = new Rules();
    SimulationHost fresh = start(twin, Role.AUTHORITY);
    fresh.restore(fresh.read(new ArchiveReader(bytes.toBytes())));
    assertSame(twin.ice, fresh.entity(e.id()).archetype());
    assertEquals(hashAfter, fresh.stateHash());
    s.restore(s.read(new ArchiveReader(bytes.toBytes())));
    assertSame(game.ice, s.entity(e.id()).archetype());
    for (int i = 0; i < 30; i++) {
      s.step();
      fresh.step();
      assertEquals(s.stateHash(), fresh.stateHash());
    }
  }

  @Test
  void aClientThatTakesTheRowsOverGoesOnAlike() {
    // Goal: whatever an entity became, exact rows say so, with fields that begin otherwise. Method:
    // crates in a heap become others at random; a client takes all over now and then.
    Rules twin = new Rules();
    SimulationHost client = start(twin, Role.PREDICTION);
    Neighbourhood here = new Neighbourhood();
    Neighbourhood there = new Neighbourhood();
    List<HostEntity> heap = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      int row = i / 4;
      heap.add(s.spawn(game.crate, i % 4 * 1.02f, 0.5f + row * 1.01f, 0, null));
    }
    List<Archetype> kinds = List.of(game.crate, game.ice, game.rock, game.wheel, game.crate);
    long seed = Long.getLong("carom.seed", System.nanoTime());
    java.util.Random random = new java.util.Random(seed);
    int alike = 0;
    for (int tick = 0; tick < 600; tick++) {
      if (tick % 20 == 0) {
        HostEntity e = heap.get(random.nextInt(heap.size()));
        e.become(kinds.get(random.nextInt(kinds.size())));
        there.readAll(s);
        client.mirror().tick(s.tick());
        there.write(client, id -> HostEntity.NO_OWNER);
        assertEquals(
            e.archetype().index(), client.entity(e.id()).archetype().index(), "seed=" + seed);
        assertEquals(e.get(HEALTH), client.entity(e.id()).get(HEALTH), "seed=" + seed);
      }
      s.step();
      client.step();
      there.readAll(s);
      here.readAll(client);
      assertEquals(there.hash(), here.hash(), "seed=" + seed + " tick=" + tick);
      alike += there.rows().contacts().count();
    }
    assertTrue(alike > 2_000, "contacts=" + alike);
  }

  @Test
  void nonsenseIsRefusedWithTheReason() {
    HostEntity e = s.spawn(game.crate, 0, 5, 0, null);
    final Rules other = new Rules();
    start(other, Role.AUTHORITY);
    String text = refused(IllegalArgumentException.class, () -> e.become(other.ice));
    assertEquals(
        "archetype=ice#2 isn't one of this simulation; register it by archetypes().add in"
            + " Game.setUp",
        text);
    HostEntity floor = s.statics().get(0);
    text = refused(IllegalStateException.class, () -> floor.become(game.ice));
    assertTrue(text.startsWith("entity=" + floor + " is static geometry of the level"), text);
    HostEntity root = s.spawn(s.assemblies().all().get(0), 5, 5, 0, null);
    text = refused(IllegalStateException.class, () -> root.become(game.ice));
    assertTrue(text.startsWith("entity=" + root + " is the root of an assembly"), text);
    s.despawn(e);
    text = refused(IllegalStateException.class, () -> e.become(game.ice));
    assertEquals("entity=" + e + " was despawned; ask Simulation.entity", text);
    assertThrows(NullPointerException.class, () -> root.become(null));
    s.join("Ann");
    game.inForces = body -> body.become(game.ice);
    text = refused(IllegalStateException.class, s::step);
    assertTrue(text.startsWith("become can't be called in Game.forces"), text);
  }

  @Test
  void inputMayLetItsBodyBecomeAnother() {
    HostPlayer ann = s.join("Ann");
    game.inInput = e -> e.become(s.tick() % 2 == 0 ? game.ice : game.crate);
    for (int i = 0; i < 20; i++) {
      s.step();
      assertSame(s.tick() % 2 == 0 ? game.ice : game.crate, ann.entity().archetype());
    }
  }
}
