package carom.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityHit;
import carom.sim.entity.HostEntity;
import carom.sim.event.Audience;
import carom.sim.field.Field;
import carom.sim.field.Ratio;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Area;
import carom.sim.level.Level;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import org.junit.jupiter.api.Test;

/** {@link Game#forces} and areas in a simulation without a network. */
final class ForcesTest {
  private static final float DT = 1 / 60f;
  private static final Ratio POWER = Field.ratio("power").of(Scope.ENTITY).to(Audience.NEAR);

  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  private final Rules rules = new Rules();

  /** A game whose forces a test gives. */
  private static final class Rules extends PlainGame {
    BiConsumer<Simulation, Entity> forces = (s, e) -> {};
    Archetype crate;
    Archetype marked;
    Archetype post;
    Archetype magnet;
    Archetype switched;
    List<Field<?>> fields = List.of(POWER);

    Rules() {
      super("test");
    }

    @Override
    public List<Field<?>> fields() {
      return fields;
    }

    @Override
    public void setUp(SetUp s) {
      crate = s.archetype(new ArchetypeDef("crate").shape(new Box(0.5f, 0.5f), wood()));
      marked = s.archetype(new ArchetypeDef("marked").tag(7).shape(new Box(0.5f, 0.5f), wood()));
      post =
          s.archetype(
              new ArchetypeDef("post").type(BodyType.KINEMATIC).shape(new Box(0.5f, 0.5f), wood()));
      magnet =
          s.archetype(
              new ArchetypeDef("magnet")
                  .type(BodyType.KINEMATIC)
                  .sensor(true)
                  .shape(new Circle(0.2f), wood())
                  .area(Area.attractor(0, 0, 6, 20)));
      switched =
          s.archetype(
              new ArchetypeDef("switched")
                  .type(BodyType.KINEMATIC)
                  .sensor(true)
                  .shape(new Circle(0.2f), wood())
                  .area(Area.attractor(0, 0, 6, 20), POWER));
    }

    private static Material wood() {
      return new Material(1, 0.5f, 0);
    }

    @Override
    public void forces(Simulation s, Entity e) {
      forces.accept(s, e);
    }
  }

  private SimulationHost simulation(float gravityY, String areas) throws Exception {
    String json =
        "{\"name\": \"t\", \"game\": \"test\", \"gravity\": [0, "
            + gravityY
            + "], \"bounds\": {\"min\": [-50, -50], \"max\": [50, 50]}, \"areas\": ["
            + areas
            + "], \"statics\": [{\"at\": [0, -1], \"shape\": {\"type\": \"box\", \"width\": 90,"
            + " \"height\": 2}}]}";
    Level level = Level.parse("t.json", json.getBytes(StandardCharsets.UTF_8));
    return new SimulationHost(rules, level, 1, 60, Role.AUTHORITY);
  }

  private static void run(SimulationHost s, int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
  }

  @Test
  void everyAwakeDynamicEntityIsVisitedOncePerTickAndNothingElse() throws Exception {
    SimulationHost s = simulation(0, "");
    HostEntity awake = s.spawn(rules.crate, 0, 5, 0, null);
    HostEntity asleep = s.spawn(rules.crate, 4, 5, 0, null);
    s.spawn(rules.post, 8, 5, 0, null);
    awake.body().setVelocity(1, 0);
    asleep.body().sleep();
    List<HostEntity> visited = new ArrayList<>();
    rules.forces = (sim, e) -> visited.add((HostEntity) e);
    run(s, 2);
    assertEquals(List.of(awake, awake), visited);
  }

  @Test
  void aForceActsInTheStepOfItsTick() throws Exception {
    SimulationHost s = simulation(0, "");
    HostEntity crate = s.spawn(rules.crate, 0, 5, 0, null);
    rules.forces = (sim, e) -> e.applyForce(3, 0);
    s.step();
    assertEquals(3 * DT / crate.body().mass(), crate.body().velocityX(), 1e-6);
  }

  @Test
  void whatAClientCannotDoIsRefusedByName() throws Exception {
    SimulationHost s = simulation(0, "");
    s.spawn(rules.crate, 0, 5, 0, null);
    rules.forces = (sim, e) -> e.despawn();
    IllegalStateException e = assertThrows(IllegalStateException.class, s::step);
    assertTrue(e.getMessage().startsWith("despawn can't be called in Game.forces"), e::getMessage);
    rules.forces = (sim, entity) -> {};
    s.step();
  }

  @Test
  void forcesThatTouchAnotherBodyAreFoundOnce() throws Exception {
    SimulationHost s = simulation(0, "");
    final HostEntity one = s.spawn(rules.crate, 0, 5, 0, null);
    final HostEntity other = s.spawn(rules.marked, 5, 5, 0, null);
    rules.forces = (sim, e) -> e.applyForce(1, 0);
    run(s, 100);
    assertEquals(0, s.findings().count());
    rules.forces =
        (sim, e) -> {
          if (e == one) {
            other.body().applyForce(1, 0);
          }
        };
    run(s, 100);
    assertEquals(1, s.findings().count());
    String text = s.findings().get(0);
    assertTrue(text.startsWith("forces of entity 0 (crate) changes another body"), text);
  }

  @Test
  void queriesSeeTheLevelAlone() throws Exception {
    SimulationHost s = simulation(0, "");
    final HostEntity low = s.spawn(rules.crate, 0, 2, 0, null);
    s.spawn(rules.crate, 0, 6, 0, null);
    List<Entity> seen = new ArrayList<>();
    EntityHit hit = new EntityHit();
    rules.forces =
        (sim, e) -> {
          assertTrue(sim.queries().rayClosest(0, 4, 0, -20, null, hit));
          seen.add(hit.entity());
          sim.queries().overlaps(new Box(1, 4.5f), 0, 3.5f, 0, null, at -> seen.add(at.entity()));
        };
    s.step();
    assertEquals(4, seen.size());
    seen.forEach(e -> assertTrue(e.isLevel()));
    assertTrue(s.queries().rayClosest(0, 4, 0, -20, null, hit));
    assertEquals(low, hit.entity());
  }

  @Test
  void anAreaActsOnTheTagItNamesOnly() throws Exception {
    SimulationHost s =
        simulation(
            0,
            "{\"type\": \"wind\", \"min\": [-9, 1], \"max\": [9, 9], \"velocity\": [5, 0], \"tag\":"
                + " 7}");
    HostEntity crate = s.spawn(rules.crate, -3, 5, 0, null);
    HostEntity marked = s.spawn(rules.marked, 3, 5, 0, null);
    run(s, 30);
    assertEquals(0, crate.body().velocityX());
    assertEquals(5 * (1 - Math.pow(1 / (1 + DT), 30)), marked.body().velocityX(), 1e-3);
  }

  @Test
  void gravityOfAnAreaReplacesTheWorlds() throws Exception {
    SimulationHost s =
        simulation(
            -10,
            "{\"type\": \"gravity\", \"min\": [-9, 1], \"max\": [9, 20], \"gravity\": [2, 4]}");
    HostEntity inside = s.spawn(rules.crate, 0, 5, 0, null);
    HostEntity outside = s.spawn(rules.crate, 20, 5, 0, null);
    s.step();
    assertEquals(2 * DT, inside.body().velocityX(), 1e-5);
    assertEquals(4 * DT, inside.body().velocityY(), 1e-5);
    assertEquals(-10 * DT, outside.body().velocityY(), 1e-5);
  }

  @Test
  void aCrateFloatsInWaterAndFallsAsleepThere() throws Exception {
    SimulationHost s =
        simulation(
            -10,
            "{\"type\": \"water\", \"min\": [-40, 0], \"max\": [40, 6], \"density\": 2,"
                + " \"drag\": 3, \"angularDrag\": 3}");
    HostEntity crate = s.spawn(rules.crate, 0, 5, 0.3f, null);
    run(s, 900);
    assertEquals(6, crate.body().y(), 0.05, "half of it is under water");
    assertFalse(crate.body().awake());
  }

  @Test
  void aCarriedAreaWakesWhatItReachesWhenItComesMovesAndGoes() throws Exception {
    SimulationHost s = simulation(0, "");
    HostEntity crate = s.spawn(rules.crate, 0, 5, 0, null);
    crate.body().sleep();
    HostEntity magnet = s.spawn(rules.magnet, 3, 5, 0, null);
    assertTrue(crate.body().awake(), "it came");
    s.step();
    assertEquals(20 * DT, crate.body().velocityX(), 1e-4);
    crate.body().setVelocity(0, 0);
    crate.body().sleep();
    s.step();
    assertFalse(crate.body().awake(), "it stands still");
    magnet.body().setVelocity(0.1f, 0);
    s.step();
    assertTrue(crate.body().awake(), "it moves");
    magnet.body().setVelocity(0, 0);
    crate.body().setVelocity(0, 0);
    crate.body().sleep();
    s.despawn(magnet);
    assertTrue(crate.body().awake(), "it is gone");
    s.step();
    assertEquals(0, crate.body().velocityX());
  }

  @Test
  void aFieldSwitchesACarriedAreaAndSaysHowStrongItIs() throws Exception {
    SimulationHost s = simulation(0, "");
    final HostEntity crate = s.spawn(rules.crate, 0, 5, 0, null);
    final HostEntity magnet = s.spawn(rules.switched, 3, 5, 0, null);
    crate.body().sleep();
    run(s, 3);
    assertFalse(crate.body().awake(), "it is off");
    magnet.set(POWER, 0.5f);
    s.step();
    assertEquals(0.5f * 20 * DT, crate.body().velocityX(), 1e-4);
    magnet.set(POWER, 0);
    s.step();
    assertEquals(0.5f * 20 * DT, crate.body().velocityX(), 1e-4);
  }

  @Test
  void aPowerMustBeAFieldOfEntitiesThatAllNearAreToldAndThatIsDeclared() {
    Ratio secret = Field.ratio("power").of(Scope.ENTITY).to(Audience.OWNER);
    Throwable e =
        assertThrows(
            IllegalArgumentException.class,
            () -> new ArchetypeDef("fan").area(Area.attractor(0, 0, 6, 20), secret));
    assertTrue(e.getMessage().contains("declare it .of(ENTITY).to(NEAR)"), e.getMessage());
    rules.fields = List.of();
    e = assertThrows(IllegalArgumentException.class, () -> simulation(0, ""));
    assertEquals(
        "archetype=switched: field entity.power isn't declared; return it from Game.fields",
        e.getMessage());
  }

  @Test
  void aRestoredSimulationHasTheAreasOfItsCarriers() throws Exception {
    SimulationHost s = simulation(0, "");
    HostEntity crate = s.spawn(rules.crate, 0, 5, 0, null);
    SimState without = s.save(null);
    s.spawn(rules.magnet, 3, 5, 0, null);
    SimState with = s.save(null);
    run(s, 10);
    long hash = s.stateHash();
    s.restore(without);
    run(s, 10);
    assertEquals(0, crate.body().velocityX());
    s.restore(with);
    run(s, 10);
    assertEquals(hash, s.stateHash());
  }

  @Test
  void areasAndForcesAllocateNothing() throws Exception {
    SimulationHost s =
        simulation(
            -10,
            "{\"type\": \"water\", \"min\": [-40, 0], \"max\": [40, 6], \"density\": 2},{\"type\":"
                + " \"wind\", \"min\": [-40, 0], \"max\": [40, 9], \"velocity\": [3, 0]},{\"type\":"
                + " \"attractor\", \"at\": [0, 5], \"range\": 20, \"strength\": 5, \"swirl\": 4}");
    for (int i = 0; i < 20; i++) {
      s.spawn(i % 2 == 0 ? rules.crate : rules.marked, i - 10, 5, 0, null);
    }
    s.spawn(rules.magnet, 0, 3, 0, null).body().setVelocity(0.1f, 0);
    rules.forces = (sim, e) -> e.applyAmbientForce(0, 1, 0);
    run(s, 600);
    SimState state = s.save(null);
    long least = Long.MAX_VALUE;
    for (int round = 0; round < 5; round++) {
      long before = THREADS.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 50; i++) {
        s.step();
        s.save(state);
        s.restore(state);
      }
      least = Math.min(least, THREADS.getCurrentThreadAllocatedBytes() - before);
    }
    assertTrue(least < 512, "bytes=" + least + " in 50 ticks");
  }
}
