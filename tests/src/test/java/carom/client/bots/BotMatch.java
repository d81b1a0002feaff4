package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.MatchClock;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.ToIntFunction;

/**
 * A match of two bots, on a usual line and in virtual time, and what happened in it. {@code
 * -Dcarom.matches=10} plays as many to their end and requires eight wins; the pages of the games
 * have the figures.
 */
final class BotMatch {
  /** Matches to play; 0 for the beginning of one. */
  static final int MATCHES = Integer.getInteger("carom.matches", 0);

  private static final Impairment LINE =
      Impairment.NONE.withLatency(25, 2).withLoss(0.5).withSeed(Stepper.SEED);
  private static final Impairment FAR =
      Impairment.NONE.withLatency(75, 2).withLoss(2).withSeed(Stepper.SEED);

  private int winner;
  private boolean isOver;
  private double seconds;
  private int happened;
  private double longestQuiet;
  private double longestStuck;

  private BotMatch() {}

  /** The rules by which a game's matches are judged. */
  interface Judge {
    /** Returns a number that changes whenever something happens. */
    int state(SimulationHost s);

    /** Returns how far a player is, of a match that isn't played to its end. */
    int points(HostPlayer p);

    /** Returns a number that changes whenever a player does something that needs no way. */
    default int acts(HostPlayer p) {
      return 0;
    }

    /** Returns whether a player has a reason to stay where it is. */
    default boolean mayStay(HostPlayer p) {
      return p.entity() == null;
    }
  }

  /** Requires that strong bots beat weak ones, and that nobody is bored or stuck for long. */
  static void requireGoodPlay(
      String level, double slice, Function<Strength, BotBrain> brains, Judge judge) {
    int won = 0;
    for (int i = 0; i < Math.max(1, MATCHES); i++) {
      boolean strongFirst = i % 2 == 0; // neither seat is the better one
      double seconds = MATCHES == 0 ? slice : 1_000;
      BotMatch m = new BotMatch();
      m.play(level(level), Stepper.SEED + 10L * i, strongFirst, seconds, brains, judge);
      if (MATCHES > 0) {
        System.out.println(level + " " + i + " strong=" + (strongFirst ? 0 : 1) + " " + m);
      }
      won += m.winner == (strongFirst ? 0 : 1) ? 1 : 0;
      assertTrue(m.longestQuiet <= 10, m.toString());
      assertTrue(m.longestStuck <= 5, m.toString());
    }
    assertTrue(won >= Math.ceil(0.8 * MATCHES), "won=" + won + " of " + MATCHES);
  }

  private static Level level(String name) {
    try {
      return Level.builtIn(name);
    } catch (LevelException e) {
      throw new IllegalStateException(e);
    }
  }

  private void play(
      Level level,
      long seed,
      boolean strongFirst,
      double most,
      Function<Strength, BotBrain> brains,
      Judge judge) {
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      for (int i = 0; i < 2; i++) {
        Strength strength = strongFirst == (i == 0) ? Strength.STRONG : Strength.WEAK;
        stepper.add("b" + i, LINE.withSeed(i), new Bot(seed + i, brains.apply(strength)));
        stepper.run(0.3); // so that ids are in this order
      }
      stepper.clients().forEach(c -> c.game().ready(true));
      SimulationHost s = stepper.room().simulation();
      stepper.runUntil("the match begins", () -> MatchClock.isPlaying(s), 30);
      double begin = stepper.nowNs() / 1e9;
      double lastAt = begin;
      int last = judge.state(s);
      float[] x = new float[2];
      float[] y = new float[2];
      double[] movedAt = {begin, begin};
      int[] acts = {judge.acts(s.player(0)), judge.acts(s.player(1))};
      while (MatchClock.isPlaying(s) && seconds < most) {
        stepper.step(5);
        double now = stepper.nowNs() / 1e9;
        if (judge.state(s) != last) {
          happened++;
          last = judge.state(s);
          lastAt = now;
        }
        for (int i = 0; i < 2; i++) {
          HostPlayer p = s.player(i);
          boolean stays = !judge.mayStay(p) && judge.acts(p) == acts[i];
          acts[i] = judge.acts(p);
          if (!stays || Math.hypot(p.entity().x() - x[i], p.entity().y() - y[i]) > 1) {
            x[i] = p.entity() == null ? 0 : p.entity().x();
            y[i] = p.entity() == null ? 0 : p.entity().y();
            movedAt[i] = now;
          }
          longestStuck = Math.max(longestStuck, now - movedAt[i]);
        }
        longestQuiet = Math.max(longestQuiet, now - lastAt);
        seconds = now - begin;
      }
      isOver = !MatchClock.isPlaying(s);
      int ahead = judge.points(s.player(0)) - judge.points(s.player(1));
      winner = isOver ? winner(s) : ahead > 0 ? 0 : ahead < 0 ? 1 : -1;
    }
  }

  /** Returns the player who won, also as the only one of its team, or -1. */
  private static int winner(SimulationHost s) {
    int team = MatchClock.winningTeam(s);
    return team == 0 ? MatchClock.winner(s) : s.player(0).team() == team ? 0 : 1;
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "winner=%d over=%b seconds=%.0f events=%d quiet=%.1f stuck=%.1f",
        winner,
        isOver,
        seconds,
        happened,
        longestQuiet,
        longestStuck);
  }

  /**
   * Requires that clients predict medium bots well on a far line: 1, 2 and 4 of them for a minute,
   * or some of these for a while.
   *
   * @param least part that is right, in percent, for a number of players
   */
  static void requireGoodPrediction(
      String level,
      int players,
      Function<Strength, BotBrain> brains,
      ToIntFunction<Integer> least) {
    for (int count = MATCHES == 0 ? players : 1;
        count <= (MATCHES == 0 ? players : 4);
        count *= 2) {
      try (Stepper stepper = Stepper.of(level(level), ServerConfig.defaults())) {
        for (int i = 0; i < count; i++) {
          Bot bot = new Bot(Stepper.SEED + i, brains.apply(Strength.MEDIUM));
          stepper.add("b" + i, FAR.withSeed(Stepper.SEED + i), bot);
        }
        double seconds = MATCHES == 0 ? 20 : 60;
        stepper.run(seconds);
        double right = 100;
        long corrections = 0;
        for (SimulatedClient client : stepper.clients()) {
          right = Math.min(right, client.rightPercent());
          corrections += client.corrections();
        }
        String about =
            String.format(
                Locale.ROOT,
                "%s players=%d right>=%.2f %% corrections=%.1f/min",
                level,
                count,
                right,
                corrections * 60 / seconds / count);
        if (MATCHES > 0) {
          System.out.println(about);
        }
        assertTrue(right >= least.applyAsInt(count), about);
        assertTrue(stepper.findings().isEmpty(), () -> stepper.findings().toString());
      }
    }
  }
}
