package carom.client.bots;

import carom.game.rockets.RocketFields;
import carom.sim.SimulationHost;
import carom.sim.entity.Entity;
import carom.sim.entity.HostPlayer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Goal: bots of {@code rockets} play it, and each predicts its ship. Method: {@link BotMatch}. */
final class RocketBotTest {
  private static final BotMatch.Judge JUDGE =
      new BotMatch.Judge() {
        /** Changes with hits, wrecks, rocks that break and weapons that are taken. */
        @Override
        public int state(SimulationHost s) {
          int state = 0;
          for (int id = 0; id < 2; id++) {
            HostPlayer p = s.player(id);
            state = 31 * state + p.get(RocketFields.HEALTH);
            state = 31 * state + p.get(RocketFields.WEAPON).ordinal();
          }
          for (Entity e : s.entities()) {
            state += e.archetype().name().startsWith("rock.") ? 1_000_003 : 0;
          }
          return state;
        }

        @Override
        public int points(HostPlayer p) {
          return 1_000 * p.score() + p.get(RocketFields.HEALTH);
        }
      };

  @ParameterizedTest
  @ValueSource(strings = {"rockets", "orbit"})
  void theStrongBeatTheWeakAndNobodyIsBoredOrStuck(String level) {
    BotMatch.requireGoodPlay(level, 25, RocketBrain::new, JUDGE);
  }

  @ParameterizedTest
  @ValueSource(strings = {"rockets", "orbit"})
  void aShipAloneIsPredictedExactlyAndManyNearlySo(String level) {
    BotMatch.requireGoodPrediction(level, 2, RocketBrain::new, n -> n == 1 ? 99 : 80);
  }
}
