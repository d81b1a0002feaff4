package carom.scenario;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.fixtures.PlainGame;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: a button that goes down or up is predicted as exactly as one that is held, though no field
 * says what was held before. Method: two wanderers who jump when a button goes down and are thrown
 * when another goes up, in virtual time at 150 ms.
 */
class PressScenarioTest {
  private static final class PressGame extends PlainGame {
    private static final Flag JUMP = Field.flag("jumpHeld").to(Audience.NEAR);
    private static final Flag ACTION = Field.flag("actionHeld").to(Audience.NEAR);

    private final boolean byFields;
    private Archetype box;

    private PressGame(boolean byFields) {
      super(byFields ? "presses-fields" : "presses");
      this.byFields = byFields;
    }

    @Override
    public List<Field<?>> fields() {
      return byFields ? List.of(JUMP, ACTION) : List.of();
    }

    @Override
    public void setUp(SetUp s) {
      box =
          s.archetype(
              new ArchetypeDef("box").shape(new Box(0.5f, 0.5f), new Material(1, 0.4f, 0.2f)));
    }

    @Override
    public void join(Match m, Player p) {
      m.spawn(box, p.id() % 2 == 0 ? -4 : 4, 3, 0, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      p.entity().seekVelocity(in.moveX() * 5, p.entity().velocityY(), 6);
      boolean jumps = in.pressed(Input.JUMP);
      boolean goes = in.released(Input.ACTION);
      if (byFields) {
        jumps = in.held(Input.JUMP) && !p.get(JUMP);
        goes = !in.held(Input.ACTION) && p.get(ACTION);
        p.set(JUMP, in.held(Input.JUMP));
        p.set(ACTION, in.held(Input.ACTION));
      }
      if (jumps) {
        p.entity().applyImpulse(0, 4 * p.entity().mass());
      }
      if (goes) {
        p.entity().applyImpulse(2 * p.entity().mass(), p.entity().mass());
      }
    }
  }

  private static Level level(boolean byFields) throws Exception {
    Games.add(() -> new PressGame(byFields));
    String json =
        """
        {"name": "presses", "game": "%s", "gravity": [0, -10],
         "bounds": {"min": [-20, -8], "max": [20, 20]},
         "statics": [
           {"at": [0, -6], "shape": {"type": "box", "width": 40, "height": 2}},
           {"at": [-13, 5], "shape": {"type": "box", "width": 2, "height": 24}},
           {"at": [13, 5], "shape": {"type": "box", "width": 2, "height": 24}}]}
        """
            .formatted(byFields ? "presses-fields" : "presses");
    return Level.parse("presses.json", json.getBytes(UTF_8));
  }

  @ParameterizedTest(name = "loss={0} %")
  @ValueSource(ints = {0, 2, 10})
  void pressesArePredictedAsWellAsByFields(int loss) throws Exception {
    double fields = right(true, loss);
    double presses = right(false, loss);
    assertTrue(presses > 98 && presses > fields - 0.2, "fields=" + fields + " presses=" + presses);
  }

  /** Returns the percentage of the awake bodies that a client predicts in every bit. */
  private static double right(boolean byFields, int loss) throws Exception {
    Impairment line = Impairment.NONE.withLatency(75, 0).withLoss(loss).withSeed(Stepper.SEED);
    try (Stepper stepper = Stepper.of(level(byFields), ServerConfig.defaults())) {
      SimulatedClient[] clients = new SimulatedClient[2];
      for (int i = 0; i < 2; i++) {
        ClientConfig config =
            ClientConfig.of("p" + i).with(ClientConfig.PREDICTION, PredictionMode.ALL);
        clients[i] = stepper.add(config, line, Scripts.wander(Stepper.SEED + i));
      }
      stepper.awaitPlaying(clients[0]);
      stepper.awaitPlaying(clients[1]);
      stepper.run(3);
      final long before = clients[0].stats().awakeBodies();
      final long exact = clients[0].stats().exactBodies();
      stepper.run(60);
      long awake = clients[0].stats().awakeBodies() - before;
      assertTrue(awake > 2_000, stepper.describe());
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), stepper.describe());
      return 100.0 * (clients[0].stats().exactBodies() - exact) / awake;
    }
  }
}
