package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.SimulationHost;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.Ratio;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: what {@code input} does in a sensor of the level is predicted, and what {@code entered}
 * does is told. Method: discs that wander over nitro pads and coins, in virtual time at 150 ms and
 * 2 % loss.
 */
class TriggerScenarioTest {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);

  private static final Ratio NITRO = Field.ratio("nitro");
  private static final Flag ON_PAD = Field.flag("onPad");
  private static final Count STARTS = Field.count("starts", 0, 1_000_000);

  /** Pads give nitro at once; coins count a point. */
  private static final class Pads extends PlainGame {
    private Archetype disc;
    private Archetype coin;

    Pads() {
      super("pads");
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(NITRO, ON_PAD, STARTS);
    }

    @Override
    public void setUp(SetUp s) {
      Material skin = new Material(1, 0, 0);
      disc = s.archetype(new ArchetypeDef("disc").shape(new Circle(0.5f), skin));
      coin =
          s.archetype(
              new ArchetypeDef("coin")
                  .type(BodyType.STATIC)
                  .sensor(true)
                  .shape(new Circle(0.4f), skin));
    }

    @Override
    public void join(Match s, Player p) {
      s.spawn(disc, 3 * p.id(), 4, 0, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      boolean pad = p.entity().isInside("pad");
      if (pad && !p.get(ON_PAD)) {
        p.set(NITRO, 1f);
        p.add(STARTS, 1);
      } else {
        p.add(NITRO, -0.01f);
      }
      p.set(ON_PAD, pad);
      Entity body = p.entity();
      float speed = 4 + 8 * p.get(NITRO);
      body.seekVelocity(in.moveX() * speed, in.moveY() * speed, 10);
    }

    @Override
    public void beforeStep(Match s) {
      if (s.tick() % 60 == 1 && s.entityCount() < 20) {
        s.spawn(coin, s.random().between(-8, 8), s.random().between(-6, 6), 0, null);
      }
    }

    @Override
    public void entered(Match s, Entity sensor, Entity visitor) {
      if (sensor.archetype() == coin) {
        s.addScore(visitor.owner(), 1);
        sensor.despawn();
      }
    }
  }

  private static Level level() throws Exception {
    String json =
        """
        {"name": "Pads", "game": "pads", "gravity": [0, 0],
         "bounds": {"min": [-12, -9], "max": [12, 9]},
         "statics": [
          {"at": [0, 8.5], "shape": {"type": "box", "width": 24, "height": 1},
           "repeat": {"rows": 2, "step": [0, -17]}},
          {"at": [11.5, 0], "shape": {"type": "box", "width": 1, "height": 18},
           "repeat": {"columns": 2, "step": [-23, 0]}},
          {"name": "pad", "at": [-6, 0], "sensor": true,
           "shape": {"type": "box", "width": 2, "height": 3},
           "repeat": {"columns": 4, "step": [4, 0]}}]}
        """;
    return Level.parse("pads.json", json.getBytes(StandardCharsets.UTF_8));
  }

  @Test
  void padsArePredictedAndCoinsAreTold() throws Exception {
    Games.add(Pads::new);
    try (Stepper stepper = Stepper.of(level(), ServerConfig.defaults())) {
      SimulatedClient p = stepper.join("p", FAR, Scripts.wander(Stepper.SEED));
      stepper.join("q", FAR, Scripts.wander(Stepper.SEED + 1));
      stepper.run(30);
      SimulationHost s = stepper.room().simulation();
      assertEquals(0, s.findings().count(), () -> s.findings().get(0));
      assertTrue(s.player(0).get(STARTS) > 5, "starts=" + s.player(0).get(STARTS));
      assertTrue(s.player(0).score() > 0, "score=" + s.player(0).score());
      assertTrue(p.rightPercent() > 99, "right=" + p.rightPercent());
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), stepper.describe());
    }
  }
}
