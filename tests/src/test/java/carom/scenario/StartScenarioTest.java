package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.fixtures.PlainGame;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.server.config.ServerConfig;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.Role;
import carom.sim.SetUp;
import carom.sim.SimState;
import carom.sim.Simulation;
import carom.sim.SimulationHost;
import carom.sim.entity.Entity;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Choice;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.Ratio;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Goal: archetypes and level files say with what fields begin, and all sides agree. Method: a game
 * with three kinds of crates; the server's values against those of clients, in virtual time.
 */
final class StartScenarioTest {
  private static final Count HEALTH =
      Field.count("health", -10, 900).of(Scope.ENTITY).to(Audience.ALL).startsAt(100);
  private static final Ratio FUEL = Field.ratio("fuel").of(Scope.ENTITY);
  private static final Flag LOCKED = Field.flag("locked").of(Scope.ENTITY);
  private static final Choice<Audience> SORT =
      Field.choice("sort", Audience.class).of(Scope.ENTITY);

  /** Discs hit crates; each hit costs the crate a point, and every crate can die and come back. */
  public static final class Crates extends PlainGame {
    private Archetype disc;
    private Archetype tank;

    public Crates() {
      super("crates");
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(HEALTH, FUEL, LOCKED, SORT);
    }

    @Override
    public void setUp(SetUp s) {
      disc = s.archetype(def("disc").starts(FUEL.startsAt(0.5f)));
      tank = s.archetype(def("tank").starts(HEALTH.startsAt(500), FUEL.startsAt(1)));
    }

    private static ArchetypeDef def(String name) {
      return new ArchetypeDef(name).shape(new Circle(0.5f), new Material(1, 0, 0));
    }

    @Override
    public void join(Match s, Player p) {
      s.spawn(disc, 3 * p.id(), 0, 0, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      p.entity().seekVelocity(4 * in.moveX(), 4 * in.moveY(), 10);
      if (in.moveX() > 0) {
        p.entity().add(FUEL, -0.01f);
      }
    }

    @Override
    public void afterStep(Match s) {
      if (s.tick() % 60 != 0) {
        return;
      }
      Entity made = s.spawn(tank, s.random().between(-20, 20), 12, 0, null);
      made.set(HEALTH, s.tick() % 120 == 0 ? 100 : 499); // one of them as every other entity begins
      for (Entity e : s.entities()) {
        if (e.archetype() == tank && e != made && s.random().between(0, 1) < 0.3f) {
          e.despawn();
        } else if (e != null && s.random().between(0, 1) < 0.1f) {
          e.resetFields();
        }
      }
    }
  }

  private static Level level(String fields) throws Exception {
    String json =
        """
        {"name": "crates", "game": "crates", "gravity": [0, 0],
         "bounds": {"min": [-50, -50], "max": [50, 50]},
         "bodies": [
          {"at": [5, 5], "shape": {"type": "box", "width": 1, "height": 1}, "repeat": {"rows": 2,
           "columns": 3, "step": [2, 2]},
           "fields": %s}]}
        """
            .formatted(fields);
    return Level.parse("crates.json", json.getBytes(StandardCharsets.UTF_8));
  }

  private static Level good() throws Exception {
    return level("{\"health\": 7, \"locked\": true, \"sort\": \"OWNER\", \"fuel\": 0.25}");
  }

  @Test
  void aLevelStartsTheFieldsOfItsBodies() throws Exception {
    SimulationHost s = new SimulationHost(new Crates(), good(), 1, 60, Role.AUTHORITY);
    for (int id = 0; id < 6; id++) {
      HostEntity crate = s.entity(id);
      assertEquals(7, crate.get(HEALTH));
      assertEquals(0.25f, crate.get(FUEL), 1e-4);
      assertTrue(crate.get(LOCKED));
      assertEquals(Audience.OWNER, crate.get(SORT));
    }
    HostEntity disc = s.join(0, "Ann").entity();
    assertEquals(100, disc.get(HEALTH));
    assertEquals(0.5f, disc.get(FUEL), 1e-4);
    s.entity(3).add(HEALTH, 40);
    final SimState state = s.save(null);
    s.entity(3).resetFields();
    assertEquals(7, s.entity(3).get(HEALTH));
    s.restore(state);
    assertEquals(47, s.entity(3).get(HEALTH));
    s.entity(3).resetFields();
    assertEquals(7, s.entity(3).get(HEALTH), "a restored entity knows its start");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "{\"helth\": 1} | crates.json:6:24: bodies[0].fields.helth isn't a field of the game's"
            + " entities; did you mean \"health\"?",
        "{\"health\": 901} | bodies[0].fields.health: entity.health=901 is outside count -10..900",
        "{\"health\": 1.5} | entity.health=1.5 is outside count -10..900",
        "{\"health\": true} | entity.health=true is outside count -10..900",
        "{\"fuel\": -1} | entity.fuel=-1.0 is outside",
        "{\"locked\": 1} | entity.locked=1.0 is outside flag; write true or false",
        "{\"sort\": \"owner\"} | entity.sort=owner is outside choice",
      })
  void aStartThatAFieldCanNotHaveIsRefusedByItsPlace(String fields, String problem)
      throws Exception {
    Level level = level(fields);
    String message =
        assertThrows(
                IllegalArgumentException.class,
                () -> new SimulationHost(new Crates(), level, 1, 60, Role.AUTHORITY))
            .getMessage();
    assertTrue(message.contains(problem), message);
  }

  @Test
  void anArchetypeCanNotStartAFieldThatIsDeclaredOtherwise() throws Exception {
    Game game =
        new Game() {
          @Override
          public String name() {
            return "other";
          }

          @Override
          public String defaultLevel() {
            return "other";
          }

          @Override
          public List<Field<?>> fields() {
            return List.of(HEALTH);
          }

          @Override
          public void setUp(SetUp s) {
            Count other = Field.count("health", 0, 5).of(Scope.ENTITY).to(Audience.ALL);
            s.archetype(Crates.def("x").starts(other.startsAt(3)));
          }

          @Override
          public void join(Match s, Player p) {}

          @Override
          public void input(Simulation s, Player p, Input in) {}
        };
    Level level = level("{}");
    String message =
        assertThrows(
                IllegalArgumentException.class,
                () -> new SimulationHost(game, level, 1, 60, Role.AUTHORITY))
            .getMessage();
    assertTrue(message.contains("\"entity.health count 0..5 to ALL starts 3\""), message);
    assertTrue(message.contains("\"entity.health count -10..900 to ALL starts 100\""), message);
  }

  @Test
  void clientsSeeEveryStartAndEveryChangeOverABadNetwork() throws Exception {
    Games.add(Crates::new);
    Impairment bad = Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);
    try (Stepper stepper = Stepper.of(good(), ServerConfig.defaults())) {
      SimulatedClient ann = stepper.join("Ann", bad, Scripts.wander(Stepper.SEED));
      stepper.join("Bob", bad, Scripts.wander(Stepper.SEED + 1));
      int seen = 0;
      for (int round = 0; round < 40; round++) {
        stepper.run(0.65); // values stay for a second, so most have arrived
        SimulationHost s = stepper.room().simulation();
        if (s.tick() % 60 < 30) {
          continue;
        }
        ClientView view = ann.view();
        for (int i = 0; i < view.entityCount(); i++) {
          Drawn drawn = view.entity(i);
          HostEntity entity = s.entity(drawn.id());
          if (entity != null && entity.ownerId() == HostEntity.NO_OWNER) {
            String about = "tick=" + s.tick() + " " + entity;
            assertEquals(entity.get(HEALTH), view.fields(drawn).get(HEALTH), about);
            assertEquals(entity.get(SORT), view.fields(drawn).get(SORT), about);
            assertEquals(entity.get(FUEL), view.fields(drawn).get(FUEL), about);
            seen++;
          }
        }
      }
      assertTrue(seen > 100, "seen=" + seen);
    }
  }
}
