package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.InputSource;
import carom.client.PredictionMode;
import carom.client.view.ClientView;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.server.CaromMain;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.Game;
import carom.sim.Role;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Area;
import carom.sim.level.Level;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: entities that become other archetypes are predicted where {@code input} lets them, told
 * where the rules do, and nobody sees a wrong one for long. Method: real server and clients in
 * virtual time at 150 ms and 2 % loss, the clients' own counts.
 */
class BecomeScenarioTest {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);

  /** A client may show what was true this long ago, seconds. */
  private static final double LATE = 0.4;

  private static final String JSON =
      """
      {"name": "become", "game": "become", "gravity": [0, -10],
       "bounds": {"min": [-20, -8], "max": [20, 20]},
       "spawns": [{"at": [-6, 3]}, {"at": [6, 3]}],
       "statics": [
         {"at": [0, -6], "shape": {"type": "box", "width": 40, "height": 2}},
         {"at": [-13, 5], "shape": {"type": "box", "width": 2, "height": 20}},
         {"at": [13, 5], "shape": {"type": "box", "width": 2, "height": 20}}]}
      """;

  /** What the rules do besides the players' crouching. */
  private enum Rule {
    NOTHING,
    CRATES_CHANGE,
    GRAVITY_CHANGES
  }

  /** Players crouch while they hold a key. Crates turn to ice, ghosts and rock, one by one. */
  private static final class Crouching implements Game {
    private final Rule rule;
    private Archetype standing;
    private Archetype crouched;
    private Archetype crate;
    private Archetype ice;
    private Archetype ghost;
    private Archetype rock;
    private Archetype earth;
    private Archetype moon;

    Crouching(Rule rule) {
      this.rule = rule;
    }

    @Override
    public String name() {
      return "become";
    }

    @Override
    public String defaultLevel() {
      return "become";
    }

    @Override
    public void setUp(Simulation s) {
      Material skin = new Material(1, 0.4f, 0);
      standing = add(s, new ArchetypeDef("standing").fixedRotation(true), 0.4f, 0.9f, 0.9f, skin);
      crouched = add(s, new ArchetypeDef("crouched").fixedRotation(true), 0.4f, 0.5f, 0.5f, skin);
      crate = add(s, new ArchetypeDef("crate"), 0.5f, 0.5f, 0, new Material(0.5f, 0.5f, 0.1f));
      ice = add(s, new ArchetypeDef("ice"), 0.6f, 0.4f, 0.1f, new Material(0.3f, 0.01f, 0));
      Filter floorOnly = new Filter(2, ~2, 0);
      ghost = add(s, new ArchetypeDef("ghost").filter(floorOnly), 0.5f, 0.5f, 0, skin);
      rock = add(s, new ArchetypeDef("rock").type(BodyType.STATIC), 0.5f, 0.5f, 0, skin);
      earth = weather(s, "earth", -10);
      moon = weather(s, "moon", -2);
      for (int i = 0; s.role() == Role.AUTHORITY && i < 10 && rule != Rule.NOTHING; i++) {
        int row = i / 5;
        s.spawn(crate, i % 5 * 1.5f - 3, 1 + row * 1.5f, 0, null);
      }
      if (s.role() == Role.AUTHORITY && rule == Rule.GRAVITY_CHANGES) {
        s.spawn(earth, 0, 15, 0, null);
      }
    }

    private static Archetype add(
        Simulation s, ArchetypeDef def, float halfWidth, float halfHeight, float up, Material m) {
      return s.archetypes().add(def.shape(new Box(halfWidth, halfHeight, 0, up), m));
    }

    private static Archetype weather(Simulation s, String name, float gravity) {
      return s.archetypes()
          .add(
              new ArchetypeDef(name)
                  .type(BodyType.STATIC)
                  .sensor(true)
                  .shape(new Circle(0.1f), new Material(1, 0, 0))
                  .area(Area.gravity(-60, -60, 60, 60, 0, gravity)));
    }

    @Override
    public void join(Simulation s, Player p) {
      s.spawn(standing, p.id() % 2 == 0 ? -6 : 6, 0, 0, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      p.body().become(in.held(Input.ACTION) ? crouched : standing);
      Body<Entity> body = p.body().body();
      body.seekVelocity(in.moveX() * 5, body.velocityY(), 6 * body.mass());
      if (in.held(Input.JUMP) && Math.abs(body.velocityY()) < 0.1f) {
        body.setVelocity(body.velocityX(), 5);
      }
    }

    @Override
    public void beforeStep(Simulation s) {
      for (int id = 0; rule == Rule.CRATES_CHANGE && id < s.entityCapacity(); id++) {
        Entity e = s.entity(id);
        if (e != null && e.ownerId() == Entity.NO_OWNER && (s.tick() + 31 * id) % 310 == 0) {
          e.become(e.archetype() == crate ? ice : crate);
        }
      }
    }

    @Override
    public void afterStep(Simulation s) {
      for (int id = 0; rule != Rule.NOTHING && id < s.entityCapacity(); id++) {
        Entity e = s.entity(id);
        if (e == null || e.ownerId() != Entity.NO_OWNER) {
          continue;
        }
        int phase = (s.tick() + 31 * id) % 310;
        if (rule == Rule.GRAVITY_CHANGES) {
          if (e.archetype().area() != null && s.tick() % 150 == 0) {
            e.become(e.archetype() == earth ? moon : earth);
          }
        } else if (phase == 80) {
          e.become(ghost);
        } else if (phase == 160) {
          e.become(rock);
        } else if (phase == 240) {
          e.become(crate);
        }
      }
    }
  }

  private static Stepper start(Rule rule) throws Exception {
    Games.add(() -> new Crouching(rule));
    Level level = Level.parse("become.json", JSON.getBytes(StandardCharsets.UTF_8));
    return Stepper.of(level, ServerConfig.defaults());
  }

  private static SimulatedClient add(Stepper stepper, String name, long seed, InputSource script) {
    ClientConfig config = ClientConfig.of(name).withPrediction(PredictionMode.ALL);
    SimulatedClient client = stepper.add(config, FAR.withSeed(seed), script);
    stepper.awaitPlaying(client);
    return client;
  }

  @Test
  void whoCrouchesAloneIsPredictedWithoutDelay() throws Exception {
    // Goal: the own picture crouches in the tick of the key, and nothing is ever corrected.
    try (Stepper stepper = start(Rule.NOTHING)) {
      boolean[] crouches = {false};
      InputSource script =
          (view, tick, out) -> {
            crouches[0] = tick / 25 % 2 == 0;
            out.hold(Input.ACTION, crouches[0]).move(tick / 40 % 3 - 1, 0);
          };
      SimulatedClient ann = add(stepper, "Ann", 1, script);
      stepper.run(2);
      final long corrections = ann.stats().corrections();
      final long compared = ann.stats().compared();
      int changes = 0;
      String last = "";
      for (int i = 0; i < 60 * 12; i++) {
        stepper.run(1 / 60.0);
        String drawn = ann.view().own().archetype().name();
        assertEquals(crouches[0] ? "crouched" : "standing", drawn, stepper.describe());
        changes += drawn.equals(last) ? 0 : 1;
        last = drawn;
      }
      assertTrue(changes > 20, "changes=" + changes);
      assertEquals(corrections, ann.stats().corrections(), stepper.describe());
      assertTrue(ann.stats().compared() - compared > 150, stepper.describe());
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), stepper.describe());
    }
  }

  @Test
  void whatTwoPlayersAndTheRulesChangeIsPredictedOrTold(@TempDir Path folder) throws Exception {
    Path file;
    try (Stepper stepper = start(Rule.CRATES_CHANGE)) {
      file = stepper.server().record(folder).get(0);
      SimulatedClient ann = add(stepper, "Ann", 1, Scripts.wander(1));
      SimulatedClient ben = add(stepper, "Ben", 2, Scripts.wander(2));
      stepper.run(3);
      requireRight(stepper, ann, ben, "crates change");
      SimulatedClient late = add(stepper, "Late", 3, InputSource.IDLE);
      stepper.run(1);
      Seen seen = new Seen();
      for (int i = 0; i < 300; i++) {
        stepper.run(1 / 60.0);
        seen.check(stepper, ann, ben, late);
      }
      assertTrue(seen.kinds.size() >= 6, seen.kinds::toString);
    }
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int status =
        CaromMain.run(new PrintWriter(out), new PrintWriter(err), "replay", file.toString());
    assertEquals(0, status, err::toString);
    assertTrue(out.toString().contains("OK: "), out::toString);
  }

  @Test
  void anotherGravityForAllBeginsInTheMiddleOfAMatch() throws Exception {
    try (Stepper stepper = start(Rule.GRAVITY_CHANGES)) {
      SimulatedClient ann = add(stepper, "Ann", 1, Scripts.wander(1));
      SimulatedClient ben = add(stepper, "Ben", 2, Scripts.wander(2));
      stepper.run(3);
      requireRight(stepper, ann, ben, "gravity changes");
    }
  }

  /** Requires that nearly all that both predict in 20 seconds is right, or told. */
  private static void requireRight(
      Stepper stepper, SimulatedClient ann, SimulatedClient ben, String what) {
    SimulatedClient[] clients = {ann, ben};
    long[] before = new long[6];
    for (int i = 0; i < 2; i++) {
      before[3 * i] = clients[i].stats().awakeBodies();
      before[3 * i + 1] = clients[i].stats().exactBodies();
      before[3 * i + 2] = clients[i].stats().toldBodies();
    }
    final long full = stepper.count(Counter.NEAR_DISAGREEMENTS);
    Seen seen = new Seen();
    for (int i = 0; i < 60 * 20; i++) {
      stepper.run(1 / 60.0);
      seen.check(stepper, ann, ben);
    }
    for (int i = 0; i < 2; i++) {
      long awake = clients[i].stats().awakeBodies() - before[3 * i];
      long wrong = awake - (clients[i].stats().exactBodies() - before[3 * i + 1]);
      long told = clients[i].stats().toldBodies() - before[3 * i + 2];
      double right = 100 - 100.0 * wrong / (awake + told);
      String about =
          String.format(
              Locale.ROOT,
              "%s: %s right or told=%.2f %% of %d, told=%d fullUpdates=%d late=%.2f s %s",
              what,
              i == 0 ? "Ann" : "Ben",
              right,
              awake + told,
              told,
              stepper.count(Counter.NEAR_DISAGREEMENTS) - full,
              seen.latest,
              stepper.describe());
      assertTrue(awake > 3_500, about);
      assertTrue(right >= 99, about);
      assertTrue(told > 10, about);
    }
    assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), what);
    assertEquals(0, stepper.room().simulation().findings().count(), what);
  }

  /** Compares the archetypes that clients show with what the server had a short time ago. */
  private static final class Seen {
    /** By entity and archetype: when the server had it last, seconds. */
    private final Map<String, Double> last = new HashMap<>();

    private final Map<String, Integer> kinds = new HashMap<>();
    private double now;
    private double latest;

    void check(Stepper stepper, SimulatedClient... clients) {
      now += 1 / 60.0;
      Simulation s = stepper.room().simulation();
      for (int id = 0; id < s.entityCapacity(); id++) {
        if (s.entity(id) != null) {
          last.put(id + s.entity(id).archetype().name(), now);
        }
      }
      for (int i = 0; now > LATE && i < clients.length; i++) {
        ClientView view = clients[i].view();
        for (int k = 0; k < view.entityCount(); k++) {
          ClientView.Drawn drawn = view.entity(k);
          if (drawn == view.own()) {
            continue; // ahead of the server
          }
          String what = drawn.archetype().name();
          Double had = last.get(drawn.id() + what);
          Entity e = s.entity(drawn.id());
          assertNotNull(e, drawn.id() + " " + stepper.describe());
          if (e.ownerId() == Entity.NO_OWNER) {
            assertNotNull(had, clients[i].name() + " shows " + what + " " + e);
            latest = Math.max(latest, now - had);
            assertTrue(now - had <= LATE, clients[i].name() + " shows " + what + " late " + e);
            kinds.merge(clients[i].name() + what, 1, Integer::sum);
          }
        }
      }
    }
  }
}
