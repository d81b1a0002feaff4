package carom.scenario;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Goal: two who push the same crates predict each other in every bit, if nothing is lost. Method:
 * one pushes, the other turns round after some ticks, again and again, and so leaves and comes
 * back; in virtual time.
 */
final class PartnerScenarioTest {
  private static final class PushGame extends PlainGame {
    private Archetype box;

    PushGame() {
      super("partners");
    }

    @Override
    public void setUp(SetUp s) {
      box =
          s.archetype(
              new ArchetypeDef("box").shape(new Box(0.5f, 0.5f), new Material(1, 0.4f, 0.2f)));
    }

    @Override
    public void join(Match m, Player p) {
      m.spawn(box, p.id() == 0 ? -3 : 3, 0, 0, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      p.entity().seekVelocity(in.moveX() * 5, in.moveY() * 5, 6);
    }
  }

  static Stream<Arguments> lines() {
    int drawn = 2 + new Random(Stepper.SEED ^ System.nanoTime()).nextInt(60);
    return Stream.of(0, 25, 75)
        .flatMap(ms -> Stream.of(0, 1, 10, 30, drawn).map(ticks -> Arguments.of(ms, ticks)));
  }

  @ParameterizedTest(name = "latencyMs={0} ticks={1}")
  @MethodSource("lines")
  void partnersArePredictedInEveryBit(int latencyMs, int ticks) throws Exception {
    Games.add(PushGame::new);
    String crate = "{\"shape\": {\"type\": \"box\", \"width\": 1, \"height\": 1}, \"at\": [%s, 0]}";
    String json =
        """
        {"name": "partners", "game": "partners", "gravity": [0, 0],
         "bounds": {"min": [-90, -9], "max": [90, 9]}, "bodies": [%s, %s, %s]}
        """
            .formatted(crate.formatted("-1.1"), crate.formatted("0"), crate.formatted("1.1"));
    Level level = Level.parse("partners.json", json.getBytes(UTF_8));
    Impairment line = Impairment.NONE.withLatency(latencyMs, 0);
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      SimulatedClient p = stepper.add("p", line, (view, tick, out) -> out.move(1, 0));
      stepper.run(1);
      SimulatedClient q =
          stepper.add(
              "q",
              line,
              (view, tick, out) -> out.move(ticks > 0 && tick / ticks % 2 == 1 ? 1 : -1, 0));
      stepper.run(4);
      final long before = p.corrections() + q.corrections();
      stepper.run(8);
      assertEquals(before, p.corrections() + q.corrections(), stepper::describe);
      assertEquals(0, stepper.count(Counter.DIVERGENCES_UNEXPLAINED), stepper::describe);
      assertTrue(p.stats().awakeBodies() > 1_000, stepper::describe);
    }
  }
}
