package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.cars.CarsFields;
import carom.game.cars.CarsGame;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: bots of {@code cars} race well, and each predicts its car. Method: races of a strong bot
 * against a weak one on a usual line, in virtual time, for 24 s; {@code -Dcarom.matches=10} plays
 * as many to their end on each level and requires eight wins. docs/games/CARS.md has the figures.
 */
final class CarsBotTest {
  private static final int MATCHES = Integer.getInteger("carom.matches", 0);
  private static final Impairment LINE =
      Impairment.NONE.withLatency(25, 2).withLoss(0.5).withSeed(Stepper.SEED);
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 2).withLoss(2).withSeed(Stepper.SEED);

  /** What happened in a race. */
  private static final class Played {
    private boolean strongLeads;
    private double seconds;
    private int happened;
    private double longestQuiet;
    private double longestStuck;

    @Override
    public String toString() {
      return String.format(
          Locale.ROOT,
          "strongLeads=%b seconds=%.0f events=%d quiet=%.1f stuck=%.1f",
          strongLeads,
          seconds,
          happened,
          longestQuiet,
          longestStuck);
    }
  }

  /** What a player was a moment ago. */
  private static final class Watched {
    private int lap = 1;
    private int gate;
    private float nitro = 1;
    private float x;
    private float y;
    private double movedAt;

    /** Returns whether the player passed a gate, or gained nitro by a ring, a flight or a flip. */
    boolean look(HostPlayer p, double now) {
      boolean happened =
          p.get(CarsFields.LAP) != lap
              || p.get(CarsFields.GATE) != gate
              || p.get(CarsFields.NITRO) > nitro;
      lap = p.get(CarsFields.LAP);
      gate = p.get(CarsFields.GATE);
      nitro = p.get(CarsFields.NITRO);
      if (Math.hypot(p.entity().x() - x, p.entity().y() - y) > 1) {
        x = p.entity().x();
        y = p.entity().y();
        movedAt = now;
      }
      return happened;
    }
  }

  private static Played play(Level level, long seed, boolean strongFirst, double seconds) {
    Played played = new Played();
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      for (int i = 0; i < 2; i++) {
        Strength strength = strongFirst == (i == 0) ? Strength.STRONG : Strength.WEAK;
        stepper.add("b" + i, LINE.withSeed(i), new Bot(seed + i, new CarsBrain(strength)));
        stepper.run(0.3); // so that ids are in this order
      }
      SimulationHost s = stepper.room().simulation();
      Watched[] watched = {new Watched(), new Watched()};
      while (MatchClock.phase(s) != MatchPhase.PLAYING) {
        stepper.step(5);
      }
      double begin = stepper.nowNs() / 1e9;
      double lastAt = begin;
      watched[0].movedAt = begin;
      watched[1].movedAt = begin;
      while (MatchClock.isPlaying(s) && played.seconds < seconds) {
        stepper.step(5);
        double now = stepper.nowNs() / 1e9;
        for (int i = 0; i < 2; i++) {
          if (watched[i].look(s.player(i), now)) {
            played.happened++;
            lastAt = now;
          }
          played.longestStuck = Math.max(played.longestStuck, now - watched[i].movedAt);
        }
        played.longestQuiet = Math.max(played.longestQuiet, now - lastAt);
        played.seconds = now - begin;
      }
      played.strongLeads = s.player(strongFirst ? 0 : 1).get(CarsFields.PLACE) == 1;
      if (!MatchClock.isPlaying(s)) {
        assertEquals(played.strongLeads == strongFirst ? 0 : 1, MatchClock.winner(s));
      }
    }
    return played;
  }

  @ParameterizedTest
  @ValueSource(strings = {"cars", "quarry"})
  void theStrongBeatTheWeakAndNobodyIsBoredOrStuck(String name) throws Exception {
    int won = 0;
    for (int i = 0; i < Math.max(1, MATCHES); i++) {
      boolean strongFirst = i % 2 == 0; // neither place of the grid is the better one
      double seconds = MATCHES == 0 ? 24 : CarsGame.MATCH_SECONDS;
      Played played = play(Level.builtIn(name), Stepper.SEED + 10L * i, strongFirst, seconds);
      if (MATCHES > 0) {
        System.out.println(name + " " + i + " " + played);
      }
      won += played.strongLeads ? 1 : 0;
      assertTrue(played.longestQuiet <= 10, played.toString());
      assertTrue(played.longestStuck <= 5, played.toString());
    }
    assertTrue(won >= Math.ceil(0.8 * MATCHES), "won=" + won + " of " + MATCHES);
  }

  @ParameterizedTest
  @ValueSource(strings = {"cars", "quarry"})
  void aCarAloneIsPredictedExactlyAndManyNearlySo(String name) throws Exception {
    for (int players = MATCHES == 0 ? 2 : 1; players <= (MATCHES == 0 ? 2 : 4); players *= 2) {
      try (Stepper stepper = Stepper.of(Level.builtIn(name), ServerConfig.defaults())) {
        for (int i = 0; i < players; i++) {
          Bot bot = new Bot(Stepper.SEED + i, new CarsBrain(Strength.MEDIUM));
          stepper.add("b" + i, FAR.withSeed(Stepper.SEED + i), bot);
        }
        double seconds = MATCHES == 0 ? 20 : 60;
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
        if (MATCHES > 0) {
          System.out.println(about);
        }
        assertTrue(least > (players == 1 ? 99.9 : 95), about);
        assertTrue(players > 1 || corrections == 0, about);
        assertTrue(stepper.findings().isEmpty(), () -> stepper.findings().toString());
      }
    }
  }
}
