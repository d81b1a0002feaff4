package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Field;
import carom.sim.field.Ratio;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.phase.Findings;
import carom.testkit.Scripts;
import carom.testkit.Stepper;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: a game that is legal but unwise, since its rules write what its input reads, is told so
 * once, and never that somebody computed wrongly. Method: real server and clients in virtual time
 * at 150 ms and 2 % loss.
 */
class MisuseScenarioTest {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(Stepper.SEED);

  private static final Ratio NITRO = Field.ratio("nitro").to(Audience.OWNER).startsAt(1);

  /** The nitro grows after each step, and input drives with it. */
  public static final class Unwise extends PlainGame {
    private Archetype disc;

    public Unwise() {
      super("unwise");
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(NITRO);
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
      Entity body = p.entity();
      float speed = 3 + 4 * p.get(NITRO);
      body.seekVelocity(in.moveX() * speed, in.moveY() * speed, 10);
      if (in.moveX() > 0.2f) {
        p.add(NITRO, -0.02f);
      }
    }

    @Override
    public void afterStep(Match s) {
      for (Player p : s.players()) {
        p.add(NITRO, 0.007f);
      }
    }
  }

  private static Level level() throws Exception {
    Games.add(Unwise::new);
    String json =
        "{\"name\": \"u\", \"game\": \"unwise\", \"gravity\": [0, 0],"
            + " \"bounds\": {\"min\": [-50, -50], \"max\": [50, 50]}}";
    return Level.parse("unwise.json", json.getBytes(StandardCharsets.UTF_8));
  }

  @Test
  void aFieldThatAfterStepWritesAndInputReadsIsToldOnceAndNeverAsAnError() throws Exception {
    try (Stepper stepper = Stepper.of(level(), ServerConfig.defaults())) {
      stepper.join("p", FAR, Scripts.wander(Stepper.SEED));
      stepper.join("q", FAR, Scripts.wander(Stepper.SEED + 1));
      stepper.run(30);
      Findings findings = stepper.room().simulation().findings();
      assertEquals(1, findings.count());
      String text = findings.get(0);
      assertTrue(
          text.startsWith(
              "afterStep writes player.nitro, which input reads, so clients can't predict it; move"
                  + " the write to input or make the field server-only. First seen at tick "),
          text);
      assertEquals(1, stepper.count(Counter.UNPREDICTABLE));
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), stepper.describe());
    }
  }
}
