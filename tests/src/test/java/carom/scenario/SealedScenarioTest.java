package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.physics.Body;
import carom.physics.Collision;
import carom.physics.Filter;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.Game;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.sim.entity.HostPlayer;
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
class SealedScenarioTest {
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
    private final List<Joint<HostEntity>> found = new ArrayList<>();
    private final AtomicInteger unhooked;
    private final AtomicInteger overrides;
    private Archetype flyer;
    private Archetype ghost;

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
    public void setUp(SimulationHost s) {
      s.statics().get(0).body().setMaterial(0, new Material(1, 0.1f, 0.3f));
      s.statics().get(3).body().setFilter(0, new Filter(8, ~2, 0)); // lets balls pass
      s.world().collisionFilter((a, i, b, j) -> kind(a) != ghost || kind(b) != ghost);
      flyer =
          s.archetypes()
              .add(
                  new ArchetypeDef("flyer")
                      .bullet(true)
                      .shape(new Box(0.5f, 0.5f), new Material(0.5f, 0.4f, 0.2f)));
      ghost =
          s.archetypes()
              .add(
                  new ArchetypeDef("ball")
                      .filter(new Filter(2, -1, 0))
                      .shape(new Circle(0.4f), new Material(0.5f, 0.4f, 0.5f)));
    }

    @Override
    public void join(SimulationHost s, HostPlayer p) {
      s.spawn(flyer, -6, 3, 0, p);
      s.spawn(ghost, -7, 3, 0, p);
      for (int i = 0; i < 4; i++) {
        s.spawn(ghost, 2 * i - 3, 6, 0, null);
      }
    }

    @Override
    public void input(SimulationHost s, HostPlayer p, Input in) {
      Body<HostEntity> body = p.body().body();
      body.seekVelocity(in.moveX() * 5, body.velocityY(), 6 * body.mass());
      if (in.moveY() > 0.3f) {
        body.applyForce(0, 16 * body.mass());
        body.applyTorque(0.2f);
      }
      found.clear();
      body.forEachJoint(found::add);
      if (!found.isEmpty() && s.tick() % 200 == 0) {
        s.world().destroyJoint(found.get(0));
        count(s, unhooked);
      }
    }

    private static Archetype kind(Body<HostEntity> body) {
      return body.user().archetype();
    }

    private static void count(SimulationHost s, AtomicInteger what) {
      if (s.role() == Role.AUTHORITY) {
        what.incrementAndGet();
      }
    }

    @Override
    public boolean collision(SimulationHost s, Collision<HostEntity> c) {
      if (c.other().user().archetype().tag() == 1) {
        c.setFriction(s.tick() / 100 % 2 == 0 ? 0.05f : 0.9f);
        c.setRestitution(0.4f);
        count(s, overrides);
      }
      if (c.self().user().isLevel() && s.tick() / 150 % 2 == 0) {
        c.setTangentSpeed(1.5f);
      }
      boolean own = kind(c.self()) == flyer || kind(c.other()) == flyer;
      boolean ball = kind(c.self()) == ghost || kind(c.other()) == ghost;
      return !own || !ball || s.tick() / 120 % 2 == 0;
    }

    @Override
    public void afterStep(SimulationHost s) {
      for (int id = 0; id < s.entityCapacity(); id++) {
        HostEntity e = s.entity(id);
        if (e == null || e.ownerId() != HostEntity.NO_OWNER) {
          continue;
        }
        Body<HostEntity> body = e.body();
        switch ((s.tick() + 17 * id) % 240) {
          case 20 -> body.applyImpulse(0.5f, 1, body.x() + 0.2f, body.y());
          case 60 -> body.setAngularVelocity(2);
          case 100 -> body.setVelocity(id % 3 - 1, 5);
          case 140 -> body.setPose(body.x(), body.y() + 0.3f, body.angle());
          case 180 -> body.wake();
          case 200 -> body.sleep();
          case 220 -> e.teleport(id % 5 - 2, 8, 0);
          default -> {}
        }
      }
      for (int id = 0; s.tick() % 200 == 100 && id < s.playerCapacity(); id++) {
        tow(s, s.player(id));
      }
    }

    private void tow(SimulationHost s, HostPlayer p) {
      for (int id = 0; p != null && id < s.entityCapacity(); id++) {
        HostEntity e = s.entity(id);
        if (e != null && e.archetype() == ghost && e.ownerId() == p.id()) {
          Body<HostEntity> body = p.body().body();
          e.teleport(body.x() - 1, body.y(), 0);
          s.connect(JointDef.revolute(body, e.body(), body.x() - 1, body.y()));
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
