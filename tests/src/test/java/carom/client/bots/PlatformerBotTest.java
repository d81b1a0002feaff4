package carom.client.bots;

import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Goal: bots of {@code platformer} play it as well as they should. Method: {@link BotMatch}. */
final class PlatformerBotTest {
  private static final BotMatch.Judge JUDGE =
      new BotMatch.Judge() {
        /** Changes with coins, flags and falls. */
        @Override
        public int state(SimulationHost s) {
          int state = 0;
          for (int id = 0; id < 2; id++) {
            state = 1_000 * state + 2 * s.player(id).score() + (s.player(id).isAlive() ? 1 : 0);
          }
          return state;
        }

        @Override
        public int points(HostPlayer p) {
          return p.score();
        }
      };

  @ParameterizedTest
  @ValueSource(strings = {"platformer", "ruins"})
  void theStrongBeatTheWeakAndNobodyIsBoredOrStuck(String level) {
    BotMatch.requireGoodPlay(level, 40, PlatformerBrain::new, JUDGE);
  }

  @ParameterizedTest
  @ValueSource(strings = {"platformer", "ruins"})
  void aRunnerAloneIsPredictedExactly(String level) {
    BotMatch.requireGoodPrediction(level, 1, PlatformerBrain::new, n -> n == 1 ? 99 : 80);
  }
}
