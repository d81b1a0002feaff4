package carom.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.ChainDef;
import carom.physics.Collision;
import carom.physics.Filter;
import carom.physics.Joint;
import carom.physics.Material;
import carom.physics.MotionLocks;
import carom.physics.ShapeDef;
import carom.physics.World;
import carom.physics.WorldState;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.rows.BodyRow;
import carom.physics.rows.ExactRows;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.ruling.InterferenceLog;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What a game does to the shared world reaches clients or is refused by name. */
class SealedWorldTest {
  /** Calls that clients hear of or make alike, and how. */
  private static final Map<String, Set<String>> SHARED =
      Map.of(
          "in exact rows and rulings",
          Set.of(
              "Body.setPose",
              "Body.setCenterPose",
              "Body.setVelocity",
              "Body.setAngularVelocity",
              "Body.moveTo",
              "Body.seekVelocity",
              "Body.applyForce",
              "Body.applyAmbientForce",
              "Body.applyTorque",
              "Body.applyImpulse",
              "Body.applyAngularImpulse",
              "Body.writeRow",
              "Body.wake",
              "Body.sleep"),
          "in rows of joints, and watched",
          Set.of(
              "Joint.setMotor",
              "Joint.stopMotor",
              "Joint.setLimits",
              "Joint.removeLimits",
              "Joint.setSpring",
              "Joint.removeSpring",
              "Joint.setRest",
              "Joint.setTarget",
              "Joint.setTargetAngle",
              "World.createJoint",
              "World.destroyJoint"),
          "of one step, in Game.collision, which both sides run",
          Set.of("Collision.setFriction", "Collision.setRestitution", "Collision.setTangentSpeed"));

  /** Calls that change nothing that decides the future. */
  private static final Map<String, Set<String>> HARMLESS =
      Map.of(
          "results are the same with any",
          Set.of("World.workers"),
          "only tells",
          Set.of("World.eventLists", "World.stageListener"),
          "a variable of the game's, which acts on nothing",
          Set.of("Body.setShapeUser"),
          "refuses itself: the world is sealed already",
          Set.of("World.seal"),
          "only reads",
          Set.of(
              "Body.aabb",
              "Body.readRow",
              "Body.forEachContact",
              "Body.forEachJoint",
              "Body.forEachOverlap",
              "World.readJoint",
              "World.readMotions",
              "World.refuseDuringQuery",
              "World.queryAabb",
              "World.forEachJoint",
              "World.forEachBody",
              "World.forEachAwake",
              "World.forEachContact",
              "World.forEachTreeCell",
              "World.forEachAabb"));

  private static final class Rules implements Game {
    private final boolean changesStatics;
    private Archetype disc;

    Rules(boolean changesStatics) {
      this.changesStatics = changesStatics;
    }

    @Override
    public String name() {
      return "sealed";
    }

    @Override
    public String defaultLevel() {
      return "sealed";
    }

    @Override
    public void setUp(SimulationHost s) {
      disc =
          s.archetypes()
              .add(
                  new ArchetypeDef("disc")
                      .shape(new Circle(0.5f), new Material(1, 0.5f, 0))
                      .bullet(true)
                      .filter(new Filter(2, 1, 0)));
      Body<HostEntity> floor = s.statics().get(0).body();
      if (changesStatics) {
        floor.setMaterial(0, new Material(1, 0, 1));
        floor.setFilter(0, new Filter(4, -1, 0));
        floor.setSensor(0, true);
        floor.setEnabled(false);
        floor.setPose(1, -2, 0);
        floor.setCenterPose(1, -3, 1, 0);
        s.world().collisionFilter((a, i, b, j) -> true);
      }
      assertRefused("setType", () -> floor.setType(BodyType.KINEMATIC));
    }

    @Override
    public void join(SimulationHost s, HostPlayer p) {
      s.spawn(disc, 0, 2, 0, p);
    }

    @Override
    public void input(SimulationHost s, HostPlayer p, Input in) {
      p.body().body().applyForce(in.moveX(), in.moveY());
    }
  }

  private static SimulationHost start(Rules game, Role role) throws Exception {
    String json =
        """
        {"name": "sealed", "game": "sealed", "gravity": [0, -10],
         "bounds": {"min": [-20, -8], "max": [20, 20]}, "spawns": [{"at": [0, 2]}],
         "statics": [{"at": [0, -1], "shape": {"type": "box", "width": 30, "height": 2}}]}
        """;
    Level level = Level.parse("sealed.json", json.getBytes(StandardCharsets.UTF_8));
    return new SimulationHost(game, level, 1, 60, role);
  }

  private static void assertRefused(String call, Executable what) {
    String text = assertThrows(IllegalStateException.class, what, call).getMessage();
    assertTrue(text.startsWith(call + " is not possible in this world: "), text);
    assertFalse(text.endsWith(": null"), text);
  }

  /** Returns each refused call of the public face, by its name, with a way to make it. */
  private static Map<String, Executable> refused(SimulationHost s, HostEntity e) {
    Body<HostEntity> b = e.body();
    World<HostEntity> w = s.world();
    ShapeDef shape = new ShapeDef(new Circle(1));
    WorldState state = w.save(null);
    Map<String, Executable> calls = new TreeMap<>();
    calls.put("Body.addShape", () -> b.addShape(shape));
    calls.put("Body.removeShape", () -> b.removeShape(0));
    calls.put("Body.replaceShape", () -> b.replaceShape(0, shape));
    calls.put("Body.become", () -> b.become(new BodyDef(BodyType.STATIC)));
    calls.put("Body.setMotionLocks", () -> b.setMotionLocks(MotionLocks.NONE));
    calls.put("Body.setFixedRotation", () -> b.setFixedRotation(true));
    calls.put("Body.setType", () -> b.setType(BodyType.STATIC));
    calls.put("Body.setEnabled", () -> b.setEnabled(false));
    calls.put("Body.setMass", () -> b.setMass(3, 1, 0, 0));
    calls.put("Body.computeMass", b::computeMass);
    calls.put("Body.setMaterial", () -> b.setMaterial(0, new Material(1, 1, 1)));
    calls.put("Body.setFilter", () -> b.setFilter(0, Filter.NOTHING));
    calls.put("Body.refilter", b::refilter);
    calls.put("Body.setSensor", () -> b.setSensor(0, true));
    calls.put("Body.setBullet", () -> b.setBullet(false));
    calls.put("Body.setGravityScale", () -> b.setGravityScale(0));
    calls.put("Body.setLinearDamping", () -> b.setLinearDamping(1));
    calls.put("Body.setAngularDamping", () -> b.setAngularDamping(1));
    calls.put("Body.setSleepAllowed", () -> b.setSleepAllowed(false));
    calls.put("Body.setSleepSpeed", () -> b.setSleepSpeed(1));
    calls.put("World.createBody", () -> w.createBody(new BodyDef(BodyType.STATIC), null));
    calls.put(
        "World.createChain",
        () -> w.createChain(ChainDef.open(0, 0, 1, 0), new BodyDef(BodyType.STATIC), null));
    calls.put("World.destroyBody", () -> w.destroyBody(b));
    calls.put("World.redefine", () -> w.redefine(w.def().withGravity(0, 1)));
    calls.put("World.collisionFilter", () -> w.collisionFilter((x, i, y, j) -> false));
    calls.put("World.listener", () -> w.listener(null));
    calls.put("World.jointListener", () -> w.jointListener(null));
    calls.put("World.queryScope", () -> w.queryScope(null));
    calls.put("World.step", () -> w.step(1 / 60f));
    calls.put("World.restore", () -> w.restore(state));
    calls.put("World.writeRows", () -> w.writeRows(new ExactRows()));
    calls.put("World.destroyJoints", w::destroyJoints);
    calls.put("World.sortFreeBodies", w::sortFreeBodies);
    return calls;
  }

  private static HostEntity spawn(SimulationHost s, Rules game) {
    return s.role() == Role.AUTHORITY
        ? s.spawn(game.disc, 0, 5, 0, null)
        : s.mirror().spawn(0, 0, game.disc, 0, 5, 0, HostEntity.NO_OWNER, false);
  }

  @ParameterizedTest
  @EnumSource(Role.class)
  void whatClientsDontLearnOfIsRefusedByNameAndChangesNothing(Role role) throws Exception {
    Rules game = new Rules(false);
    SimulationHost s = start(game, role);
    HostEntity e = spawn(s, game);
    s.step();
    long before = s.stateHash();
    Map<String, Executable> calls = refused(s, e);
    for (Map.Entry<String, Executable> call : calls.entrySet()) {
      String name = call.getKey().substring(call.getKey().indexOf('.') + 1);
      assertRefused(name, call.getValue());
      assertEquals(before, s.stateHash(), name);
    }
    Body<HostEntity> floor = s.statics().get(0).body();
    int[] row = new int[BodyRow.INTS];
    floor.readRow(row, 0);
    assertRefused("setPose", () -> floor.setPose(1, 0, 0));
    assertRefused("setCenterPose", () -> floor.setCenterPose(1, 0, 1, 0));
    assertRefused("writeRow", () -> floor.writeRow(row, 0));
    assertRefused("setMaterial", () -> floor.setMaterial(0, new Material(1, 1, 1)));
    assertEquals(before, s.stateHash());
    e.body().setPose(1, 5, 0);
    e.body().setVelocity(1, 0);
    s.step();
    assertEquals(1, e.body().x(), 0.1f);
    assertRefused("setPose", () -> s.statics().get(0).teleport(1, 0, 0));
    assertEquals(0, floor.x());
  }

  @Test
  void refusalsSayWhatToDoInstead() throws Exception {
    Rules game = new Rules(false);
    SimulationHost s = start(game, Role.AUTHORITY);
    Map<String, Executable> calls = refused(s, spawn(s, game));
    Map<String, String> advice =
        Map.of(
            "Body.setBullet", "let the entity become another archetype, see ArchetypeDef.bullet",
            "Body.become", "call Entity.become",
            "Body.setFilter", "let Game.collision return false",
            "Body.setGravityScale", "use an area of another gravity",
            "World.createBody", "call Simulation.spawn",
            "World.destroyBody", "call Simulation.despawn",
            "World.collisionFilter", "let Game.collision return false",
            "World.listener", "override Game.collision",
            "World.step", "call Simulation.step");
    advice.forEach(
        (call, way) -> {
          String text = assertThrows(IllegalStateException.class, calls.get(call)).getMessage();
          assertTrue(text.contains(way), text);
        });
  }

  /** Someone who adds a way to change a world decides here whether clients hear of it. */
  @Test
  void everyMutatorIsSharedRefusedOrHarmless() throws Exception {
    Rules game = new Rules(false);
    SimulationHost s = start(game, Role.AUTHORITY);
    Set<String> known = new TreeSet<>(refused(s, spawn(s, game)).keySet());
    SHARED.values().forEach(known::addAll);
    HARMLESS.values().forEach(known::addAll);
    int sets = 0;
    for (Set<String> each : SHARED.values()) {
      sets += each.size();
    }
    for (Set<String> each : HARMLESS.values()) {
      sets += each.size();
    }
    assertEquals(known.size(), refused(s, s.entity(0)).size() + sets, "a call is in two lists");
    Set<String> mutators = new TreeSet<>();
    for (Class<?> of : new Class<?>[] {World.class, Body.class, Joint.class, Collision.class}) {
      for (Method m : of.getDeclaredMethods()) {
        boolean open = Modifier.isPublic(m.getModifiers()) && !m.isSynthetic();
        boolean acts = m.getReturnType() == void.class || m.getName().startsWith("create");
        if (open && acts) {
          mutators.add(of.getSimpleName() + "." + m.getName());
        }
      }
    }
    assertEquals(mutators, known);
  }

  @ParameterizedTest
  @EnumSource(Role.class)
  void staticsMayBeChangedWhileBothSidesSetUp(Role role) throws Exception {
    SimulationHost s = start(new Rules(true), role);
    Body<HostEntity> floor = s.statics().get(0).body();
    assertEquals(1, floor.material(0).restitution());
    assertEquals(4, floor.filter(0).category());
    assertTrue(floor.sensor(0));
    assertFalse(floor.isEnabled());
    assertEquals(-3, floor.y());
    assertRefused("setEnabled", () -> floor.setEnabled(true));
    assertRefused("collisionFilter", () -> s.world().collisionFilter(null));
  }

  @Test
  void archetypesSayWhichBodiesAreBulletsAndWhatTheyMeet() throws Exception {
    Rules game = new Rules(false);
    SimulationHost s = start(game, Role.AUTHORITY);
    Body<HostEntity> b = spawn(s, game).body();
    assertTrue(b.isBullet());
    assertEquals(new Filter(2, 1, 0), b.filter(0));
  }

  @Test
  void aBodyThatIsMoreThanItsArchetypeIsFoundOnceAClientPredictsIt() throws Exception {
    Rules game = new Rules(false);
    SimulationHost s = start(game, Role.AUTHORITY);
    InterferenceLog log = s.interference();
    log.watch(spawn(s, game));
    log.watch(s.spawn(game.disc, game.disc.body(3, 5, 1).velocity(1, 2)));
    assertEquals(0, s.findings().count(), "places and velocities are told");
    HostEntity plain = s.spawn(game.disc, game.disc.body(6, 5, 1).bullet(false));
    assertEquals(0, s.findings().count(), "nobody predicts it");
    log.watch(plain);
    log.watch(plain);
    assertEquals(1, s.findings().count());
    String text = s.findings().get(0);
    assertTrue(text.contains("(disc) another bullet than its archetype"), text);
    log.watch(
        s.spawn(
            game.disc,
            new BodyDef().bullet(true).position(9, 5).shape(new ShapeDef(new Box(1, 1)))));
    assertTrue(s.findings().get(1).contains("another material than"), s.findings().get(1));
    assertNotNull(plain.body());
    assertNull(s.player(0));
  }
}
