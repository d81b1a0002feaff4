package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.playground.PlaygroundFields;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: bots of {@code playground} play well, and each predicts what it does. Method: matches of a
 * strong bot against a weak one for 12 s, see {@link BotMatch}; docs/games/PLAYGROUND.md has the
 * figures.
 */
final class PlaygroundBotTest {
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 2).withLoss(2).withSeed(Stepper.SEED);

  /** Points and things that are picked up or made count as what happens. */
  private static final class Judge implements BotMatch.Judge {
    private final boolean[] holds = new boolean[2];
    private final int[] pickedUp = new int[2];

    @Override
    public int state(SimulationHost s) {
      return 31 * state(s.player(0)) + state(s.player(1));
    }

    private int state(HostPlayer p) {
      boolean now = p.get(PlaygroundFields.HELD) != null;
      pickedUp[p.id()] += now && !holds[p.id()] ? 1 : 0;
      holds[p.id()] = now;
      return 7_919 * pickedUp[p.id()] + p.score();
    }

    @Override
    public int acts(HostPlayer p) {
      return 31 * state(p) + p.get(PlaygroundFields.THINGS);
    }

    @Override
    public int points(HostPlayer p) {
      return p.score();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"sandbox", "harbour"})
  void theStrongBeatTheWeakAndNobodyIsBoredOrStuck(String name) {
    BotMatch.requireGoodPlay(name, 12, PlaygroundBrain::new, new Judge());
  }

  @ParameterizedTest
  @ValueSource(strings = {"sandbox", "harbour"})
  void aPlayerAloneIsPredictedExactlyAndManyNearlySo(String name) throws Exception {
    for (int players = 1; players <= (BotMatch.MATCHES == 0 ? 2 : 4); players *= 2) {
      try (Stepper stepper = Stepper.of(Level.builtIn(name), ServerConfig.defaults())) {
        for (int i = 0; i < players; i++) {
          Bot bot = new Bot(Stepper.SEED + i, new PlaygroundBrain(Strength.MEDIUM));
          stepper.add("b" + i, FAR.withSeed(Stepper.SEED + i), bot);
        }
        double seconds = BotMatch.MATCHES == 0 ? 7 : 60;
        stepper.run(seconds);
        double least = 100;
        long corrections = 0;
        for (SimulatedClient client : stepper.clients()) {
          least = Math.min(least, client.rightPercent());
          corrections += client.corrections();
        }
        String about =
            String.format(
                Locale.ROOT,
                "%s players=%d right>=%.2f %% corrections=%.1f/min",
                name,
                players,
                least,
                corrections * 60 / seconds / players);
        if (BotMatch.MATCHES > 0) {
          System.out.println(about);
        }
        assertTrue(least > (players == 1 ? 99 : 95), about);
        assertTrue(stepper.findings().isEmpty(), () -> stepper.findings().toString());
      }
    }
  }
}
