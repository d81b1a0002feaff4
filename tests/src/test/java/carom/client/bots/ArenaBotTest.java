package carom.client.bots;

import carom.sim.SimulationHost;
import carom.sim.entity.Entity;
import carom.sim.entity.HostPlayer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Goal: bots of {@code arena} play it as well as they should. Method: {@link BotMatch}. */
final class ArenaBotTest {
  /** Size of a cell of the pitch, metres: a ball that goes to another was hit. */
  private static final float CELL = 3;

  private static final BotMatch.Judge JUDGE =
      new BotMatch.Judge() {
        /** Changes with goals and with balls that go elsewhere. */
        @Override
        public int state(SimulationHost s) {
          int state = 0;
          for (Entity e : s.entities()) {
            if (e.archetype().name().endsWith("ball")) {
              state += Math.round(e.x() / CELL) + 1_000 * Math.round(e.y() / CELL);
            }
          }
          return state;
        }

        @Override
        public int points(HostPlayer p) {
          return p.score();
        }
      };

  @ParameterizedTest
  @ValueSource(strings = {"arena", "rink"})
  void theStrongBeatTheWeakAndNobodyIsBoredOrStuck(String level) {
    BotMatch.requireGoodPlay(level, 40, ArenaBrain::new, JUDGE);
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "rink"})
  void boostAndBentBallsArePredicted(String level) {
    BotMatch.requireGoodPrediction(level, 2, ArenaBrain::new, players -> 94);
  }
}
