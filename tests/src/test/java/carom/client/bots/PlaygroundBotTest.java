package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.playground.PlaygroundFields;
import carom.game.playground.PlaygroundGame;
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
 * Goal: bots of {@code playground} play well, and each predicts what it does. Method: matches of a
 * strong bot against a weak one on a usual line, in virtual time, for 12 s; {@code
 * -Dcarom.matches=10} plays as many to their end on each level and requires eight wins.
 * docs/games/PLAYGROUND.md has the figures.
 */
final class PlaygroundBotTest {
  private static final int MATCHES = Integer.getInteger("carom.matches", 0);
  private static final Impairment LINE =
      Impairment.NONE.withLatency(25, 2).withLoss(0.5).withSeed(Stepper.SEED);
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 2).withLoss(2).withSeed(Stepper.SEED);

  /** What happened in a match. */
  private static final class Played {
    private int strong;
    private int weak;
    private double seconds;
    private int happened;
    private double longestQuiet;
    private double longestStuck;
    private String how = "";

    @Override
    public String toString() {
      return String.format(
          Locale.ROOT,
          "strong=%d weak=%d seconds=%.0f events=%d quiet=%.1f stuck=%.1f%s",
          strong,
          weak,
          seconds,
          happened,
          longestQuiet,
          longestStuck,
          how);
    }
  }

  /** What a player was a moment ago. */
  private static final class Watched {
    private int score;
    private int things;
    private boolean grabs;
    private float x;
    private float y;
    private double actedAt;

    /** Returns whether the player won a point or grabbed something. */
    boolean look(HostPlayer p, double now) {
      boolean picksUp = p.get(PlaygroundFields.HELD) != null && !grabs;
      boolean happened = p.score() != score || picksUp;
      boolean makes = p.get(PlaygroundFields.THINGS) != things;
      grabs = p.get(PlaygroundFields.HELD) != null;
      score = p.score();
      things = p.get(PlaygroundFields.THINGS);
      if (happened || makes || Math.hypot(p.entity().x() - x, p.entity().y() - y) > 1) {
        x = p.entity().x();
        y = p.entity().y();
        actedAt = now;
      }
      return happened;
    }
  }

  private static String how(HostPlayer p) {
    return " "
        + p.get(PlaygroundFields.BASKETS)
        + "/"
        + p.get(PlaygroundFields.TOWER)
        + "/"
        + p.get(PlaygroundFields.STAR_SECONDS);
  }

  private static Played play(Level level, long seed, boolean strongFirst, double seconds) {
    Played played = new Played();
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      for (int i = 0; i < 2; i++) {
        Strength strength = strongFirst == (i == 0) ? Strength.STRONG : Strength.WEAK;
        stepper.add("b" + i, LINE.withSeed(i), new Bot(seed + i, new PlaygroundBrain(strength)));
        stepper.run(0.3); // so that ids are in this order
      }
      SimulationHost s = stepper.room().simulation();
      Watched[] watched = {new Watched(), new Watched()};
      while (MatchClock.phase(s) != MatchPhase.PLAYING) {
        stepper.step(5);
      }
      double begin = stepper.nowNs() / 1e9;
      double lastAt = begin;
      watched[0].actedAt = begin;
      watched[1].actedAt = begin;
      while (MatchClock.isPlaying(s) && played.seconds < seconds) {
        stepper.step(5);
        double now = stepper.nowNs() / 1e9;
        for (int i = 0; i < 2; i++) {
          if (watched[i].look(s.player(i), now)) {
            played.happened++;
            lastAt = now;
          }
          played.longestStuck = Math.max(played.longestStuck, now - watched[i].actedAt);
        }
        played.longestQuiet = Math.max(played.longestQuiet, now - lastAt);
        played.seconds = now - begin;
      }
      HostPlayer strong = s.player(strongFirst ? 0 : 1);
      HostPlayer weak = s.player(strongFirst ? 1 : 0);
      played.strong = strong.score();
      played.weak = weak.score();
      played.how = how(strong) + how(weak);
      if (!MatchClock.isPlaying(s) && played.strong != played.weak) {
        assertEquals((played.strong > played.weak ? strong : weak).id(), MatchClock.winner(s));
      }
    }
    return played;
  }

  @ParameterizedTest
  @ValueSource(strings = {"sandbox", "harbour"})
  void theStrongBeatTheWeakAndNobodyIsBoredOrStuck(String name) throws Exception {
    int won = 0;
    for (int i = 0; i < Math.max(1, MATCHES); i++) {
      boolean strongFirst = i % 2 == 0;
      double seconds = MATCHES == 0 ? 12 : 3 * PlaygroundGame.CONTEST_SECONDS + 1;
      Played played = play(Level.builtIn(name), Stepper.SEED + 10L * i, strongFirst, seconds);
      if (MATCHES > 0) {
        System.out.println(name + " " + i + " " + played);
      }
      won += played.strong > played.weak ? 1 : 0;
      assertTrue(played.longestQuiet <= 10, played.toString());
      assertTrue(played.longestStuck <= 5, played.toString());
    }
    assertTrue(won >= Math.ceil(0.8 * MATCHES), "won=" + won + " of " + MATCHES);
  }

  @ParameterizedTest
  @ValueSource(strings = {"sandbox", "harbour"})
  void aPlayerAloneIsPredictedExactlyAndManyNearlySo(String name) throws Exception {
    for (int players = 1; players <= (MATCHES == 0 ? 2 : 4); players *= 2) {
      try (Stepper stepper = Stepper.of(Level.builtIn(name), ServerConfig.defaults())) {
        for (int i = 0; i < players; i++) {
          Bot bot = new Bot(Stepper.SEED + i, new PlaygroundBrain(Strength.MEDIUM));
          stepper.add("b" + i, FAR.withSeed(Stepper.SEED + i), bot);
        }
        double seconds = MATCHES == 0 ? 10 : 60;
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
        assertTrue(least > (players == 1 ? 99 : 95), about);
        assertTrue(stepper.findings().isEmpty(), () -> stepper.findings().toString());
      }
    }
  }
}
