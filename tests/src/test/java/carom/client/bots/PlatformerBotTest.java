package carom.client.bots;

import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import org.junit.jupiter.api.Test;

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

  @Test
  void theStrongBeatTheWeakAndNobodyIsBoredOrStuck() {
    BotMatch.requireGoodPlay("platformer", 40, PlatformerBrain::new, JUDGE);
  }

  @Test
  void aRunnerAloneIsPredictedExactly() {
    BotMatch.requireGoodPrediction("platformer", 1, PlatformerBrain::new, n -> n == 1 ? 99 : 80);
  }
}
