package carom.client.bots;

import carom.game.cars.CarsFields;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: bots of {@code cars} race well, and each predicts its car. Method: {@link BotMatch} lets a
 * strong bot race against a weak one. docs/games/CARS.md has the figures.
 */
final class CarsBotTest {
  /** Counts gates passed, and nitro gained by a ring, a flight or a flip. */
  private static final class Judge implements BotMatch.Judge {
    private final int[] gates = new int[2];
    private final float[] nitro = {1, 1};
    private int happened;

    @Override
    public int state(SimulationHost s) {
      for (int i = 0; i < 2; i++) {
        HostPlayer p = s.player(i);
        int gate = 100 * p.get(CarsFields.LAP) + p.get(CarsFields.GATE);
        happened += gate != gates[i] || p.get(CarsFields.NITRO) > nitro[i] ? 1 : 0;
        gates[i] = gate;
        nitro[i] = p.get(CarsFields.NITRO);
      }
      return happened;
    }

    @Override
    public int points(HostPlayer p) {
      return -p.get(CarsFields.PLACE);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"cars", "quarry"})
  void theStrongBeatTheWeakAndNobodyIsBoredOrStuck(String level) {
    BotMatch.requireGoodPlay(level, 24, CarsBrain::new, new Judge());
  }

  @ParameterizedTest
  @ValueSource(strings = {"cars", "quarry"})
  void aCarAloneIsPredictedExactlyAndManyNearlySo(String level) {
    BotMatch.requireGoodPrediction(level, 2, CarsBrain::new, players -> players == 1 ? 100 : 95);
  }
}
