package carom.sim;

import static carom.sim.field.Scope.ENTITY;
import static carom.sim.field.Scope.MATCH;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Ratio;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Goal: a game that uses fields so that clients can't predict them is told which, where and how.
 */
final class FieldUseTest {
  private static final Ratio NITRO = Field.ratio("nitro").to(Audience.OWNER).startsAt(1);
  private static final Count SECRET = Field.count("secret", 0, 9).to(Audience.NOBODY);
  private static final Count CLOCK = Field.count("clock", 0, 100_000).of(MATCH).to(Audience.ALL);
  private static final Ratio FUEL = Field.ratio("fuel").of(ENTITY).to(Audience.OWNER);

  private final Rules rules = new Rules();
  private SimulationHost s;

  private static final class Rules extends PlainGame {
    BiConsumer<Simulation, Player> input = (s, p) -> {};
    BiConsumer<Simulation, Entity> forces = (s, e) -> {};
    Consumer<Match> afterStep = s -> {};
    private Archetype disc;

    Rules() {
      super("test");
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(NITRO, SECRET, CLOCK, FUEL);
    }

    @Override
    public void setUp(SetUp s) {
      disc = s.archetype(new ArchetypeDef("disc").shape(new Circle(0.5f), new Material(1, 0, 0)));
    }

    @Override
    public void join(Match s, Player p) {
      s.spawn(disc, 3 * p.id(), 0, 0, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      input.accept(s, p);
    }

    @Override
    public void forces(Simulation s, Entity e) {
      forces.accept(s, e);
    }

    @Override
    public void afterStep(Match s) {
      afterStep.accept(s);
    }
  }

  @BeforeEach
  void begin() throws Exception {
    String json =
        "{\"name\": \"t\", \"game\": \"test\", \"gravity\": [0, 0],"
            + " \"bounds\": {\"min\": [-50, -50], \"max\": [50, 50]}}";
    Level level = Level.parse("t.json", json.getBytes(StandardCharsets.UTF_8));
    s = new SimulationHost(rules, level, 1, 60, Role.AUTHORITY);
    for (int i = 0; i < 3; i++) {
      s.join("p" + i);
    }
  }

  private void run(int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
  }

  private String onlyFinding() {
    assertEquals(1, s.findings().count());
    return s.findings().get(0);
  }

  @Test
  void whatAfterStepWritesAndInputReadsIsToldOnce() {
    run(310);
    rules.input = (sim, p) -> p.entity().setVelocity(p.get(NITRO), 0);
    rules.afterStep = sim -> sim.player(2).add(NITRO, sim.tick() % 2 == 0 ? -0.1f : 0.1f);
    run(300);
    assertEquals(
        "afterStep writes player.nitro, which input reads, so clients can't predict it; move the"
            + " write to input or make the field server-only. First seen at tick 312, player 2.",
        onlyFinding());
  }

  @Test
  void whatInputWritesItselfOrNobodyReadsOrHappensNowAndThenIsFine() {
    rules.input =
        (sim, p) -> {
          p.add(NITRO, -0.001f);
          p.entity().setVelocity(p.get(NITRO), 0);
        };
    rules.afterStep =
        sim -> {
          sim.player(1).set(SECRET, sim.tick() % 10);
          sim.set(CLOCK, sim.tick());
          if (sim.tick() % 60 == 0) {
            sim.player(0).set(NITRO, 1);
          }
        };
    run(1_200);
    assertEquals(0, s.findings().count());
  }

  @Test
  void aClockOfTheMatchThatInputReadsHasItsOwnAdvice() {
    rules.input = (sim, p) -> p.entity().setVelocity(sim.get(CLOCK) > 100 ? 1 : 0, 0);
    rules.afterStep = sim -> sim.add(CLOCK, 1);
    run(200);
    assertEquals(
        "afterStep writes match.clock, which input reads, so clients can't predict it; use"
            + " Field.countdown for a clock, or read it in afterStep. First seen at tick 1, the"
            + " match.",
        onlyFinding());
  }

  @Test
  void whatNoClientIsToldIsNotForInput() {
    rules.input = (sim, p) -> p.entity().setVelocity(p.get(SECRET), 0);
    run(20);
    assertEquals(
        "input reads player.secret, which no client is told, so clients can't predict what follows;"
            + " declare it .to(OWNER) or don't read it in input.",
        onlyFinding());
  }

  @Test
  void whatOnlyTheOwnerIsToldIsNotForForces() {
    rules.forces = (sim, e) -> e.applyForce(e.get(FUEL), 0);
    run(20);
    assertTrue(onlyFinding().startsWith("forces reads entity.fuel, which not all clients near"));
  }

  @Test
  void forcesWriteNothing() {
    rules.forces = (sim, e) -> e.set(FUEL, 0.5f);
    Throwable e = assertThrows(IllegalStateException.class, () -> s.step());
    assertEquals(
        "entity.fuel can't be written in Game.forces, which may only push its body; write it in"
            + " Game.input",
        e.getMessage());
  }
}
