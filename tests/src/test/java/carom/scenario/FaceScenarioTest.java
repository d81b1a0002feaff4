package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.physics.Filter;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Contact;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/**
 * Goal: a game that does to bodies and contacts all that a sealed world allows is predicted, and
 * what can't be is told. Method: real server and clients in virtual time at 150 ms and 2 % loss,
 * the clients' own counts.
 */
class FaceScenarioTest {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);

  private static final String JSON =
      """
      {"name": "allowed", "game": "allowed", "gravity": [0, -10],
       "bounds": {"min": [-20, -8], "max": [20, 20]}, "spawns": [{"at": [-6, 3]}],
       "statics": [
         {"at": [0, -6], "shape": {"type": "box", "width": 40, "height": 2}},
         {"at": [-13, 5], "shape": {"type": "box", "width": 2, "height": 20}},
         {"at": [13, 5], "shape": {"type": "box", "width": 2, "height": 20}},
         {"at": [0, -3], "shape": {"type": "box", "width": 6, "height": 1}}],
       "bodies": [{"at": [-3, 1], "shape": {"type": "box", "width": 1, "height": 1}, "tag": 1,
         "material": {"density": 0.5}, "repeat": {"columns": 5, "rows": 2, "step": [1.5, 1.5]}}]}
      """;

  /** Uses what may be used. A player tows a ball now and then, until {@code input} unhooks it. */
  private static final class AllowedGame implements Game {
    private final List<EntityJoint> found = new ArrayList<>();
    private final AtomicInteger unhooked;
    private final AtomicInteger overrides;
    private Archetype flyer;
    private Archetype ghost;
    private boolean serves;

    /** Counts what the server's instance does, so that nothing is allowed and unused. */
    AllowedGame(AtomicInteger unhooked, AtomicInteger overrides) {
      this.unhooked = unhooked;
      this.overrides = overrides;
    }

    @Override
    public String name() {
      return "allowed";
    }

    @Override
    public String defaultLevel() {
      return "allowed";
    }

    @Override
    public void setUp(SetUp s) {
      flyer =
          s.archetype(
              new ArchetypeDef("flyer")
                  .bullet(true)
                  .shape(new Box(0.5f, 0.5f), new Material(0.5f, 0.4f, 0.2f)));
      ghost =
          s.archetype(
              new ArchetypeDef("ball")
                  .filter(new Filter(2, -1, 0))
                  .shape(new Circle(0.4f), new Material(0.5f, 0.4f, 0.5f)));
    }

    @Override
    public void begin(Match s) {
      serves = true;
    }

    @Override
    public void join(Match s, Player p) {
      s.spawn(flyer, -6, 3, 0, p);
      s.spawn(ghost, -7, 3, 0, p);
      for (int i = 0; i < 4; i++) {
        s.spawn(ghost, 2 * i - 3, 6, 0, null);
      }
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      Entity body = p.entity();
      body.seekVelocity(in.moveX() * 5, body.velocityY(), 6);
      if (in.moveY() > 0.3f) {
        body.applyForce(0, 16 * body.mass());
        body.applyTorque(0.2f);
      }
      found.clear();
      body.forEachJoint(found::add);
      if (!found.isEmpty() && s.tick() % 200 == 0) {
        found.get(0).destroy();
        count(unhooked);
      }
    }

    private static Archetype kind(Entity body) {
      return body.archetype();
    }

    private void count(AtomicInteger what) {
      if (serves) {
        what.incrementAndGet();
      }
    }

    @Override
    public boolean collision(Simulation s, Contact c) {
      if (c.other().archetype().tag() == 1) {
        c.setFriction(s.tick() / 100 % 2 == 0 ? 0.05f : 0.9f);
        c.setRestitution(0.4f);
        count(overrides);
      }
      if (c.self().isLevel() && s.tick() / 150 % 2 == 0) {
        c.setTangentSpeed(1.5f);
      }
      boolean own = kind(c.self()) == flyer || kind(c.other()) == flyer;
      boolean ball = kind(c.self()) == ghost || kind(c.other()) == ghost;
      return !own || !ball || s.tick() / 120 % 2 == 0;
    }

    @Override
    public void afterStep(Match s) {
      for (Entity e : s.entities()) {
        if (e.isOwned()) {
          continue;
        }
        switch ((s.tick() + 17 * e.id()) % 240) {
          case 20 -> e.applyImpulse(0.5f, 1, e.x() + 0.2f, e.y());
          case 60 -> e.setAngularVelocity(2);
          case 100 -> e.setVelocity(e.id() % 3 - 1, 5);
          case 140 -> e.applyAngularImpulse(0.1f);
          case 180 -> e.wake();
          case 220 -> e.teleport(e.id() % 5 - 2, 8, 0);
          default -> {}
        }
      }
      for (Player p : s.players()) {
        if (s.tick() % 200 == 100) {
          tow(s, p);
        }
      }
    }

    private void tow(Match s, Player p) {
      for (Entity e : s.entities()) {
        if (e.archetype() == ghost && e.owner() == p) {
          Entity body = p.entity();
          e.teleport(body.x() - 1, body.y(), 0);
          s.connect(body, e, (a, b) -> JointDef.revolute(a, b, body.x() - 1, body.y()));
        }
      }
    }
  }

  @Test
  void whatASealedWorldAllowsIsPredictedOrTold() throws Exception {
    AtomicInteger unhooked = new AtomicInteger();
    AtomicInteger overrides = new AtomicInteger();
    Games.add(() -> new AllowedGame(unhooked, overrides));
    Level level = Level.parse("allowed.json", JSON.getBytes(StandardCharsets.UTF_8));
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      ClientConfig config = ClientConfig.of("p").with(ClientConfig.PREDICTION, PredictionMode.ALL);
      SimulatedClient client = stepper.add(config, FAR, Scripts.wander(Stepper.SEED));
      stepper.awaitPlaying(client);
      stepper.run(3);
      final long awake = client.stats().awakeBodies();
      final long exact = client.stats().exactBodies();
      final long told = client.stats().toldBodies();
      stepper.run(30);
      long toldBodies = client.stats().toldBodies() - told;
      long awakeBodies = client.stats().awakeBodies() - awake;
      long wrong = awakeBodies - (client.stats().exactBodies() - exact);
      double right = 100 - 100.0 * wrong / (awakeBodies + toldBodies);
      String about =
          "right or told="
              + right
              + " % of "
              + (awakeBodies + toldBodies)
              + " told="
              + toldBodies
              + " "
              + stepper.describe();
      assertTrue(awakeBodies > 3_500, about);
      assertTrue(right >= 99, about);
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), about);
      assertEquals(0, stepper.room().simulation().findings().count(), about);
      assertTrue(unhooked.get() >= 8, "unhooked=" + unhooked);
      assertTrue(overrides.get() > 1_000, "overrides=" + overrides);
    }
  }
}
